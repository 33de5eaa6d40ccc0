// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/variationentry.h"

#include <string>
#include <vector>

namespace quadrille {

/// Two takes with the weights of the second at which blends of them are learned.
struct BlendEdge
{
    std::string from;
    std::string to;
    std::vector<double> weights;

    /// Whether it lies between two takes, in either direction.
    bool isBetween(const std::string& one, const std::string& other) const;
};

/// The pair of a blend, or the four edges of a square.
std::vector<BlendEdge> edgesOf(const BlendEntry& blend);

} // namespace quadrille
