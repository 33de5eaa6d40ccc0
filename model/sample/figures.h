// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sample/sample.h"

#include <string>
#include <vector>

namespace quadrille {

/// A body at rest as it was made.
struct SampleFigure
{
    std::string name;
    std::vector<Vec3d> points;
    TopologyData faces;
    Image texture;
};

/// The character and the body beside it, with what moves the character.
struct SampleFigures
{
    SampleFigure character;
    SampleFigure target;
    Skeleton skeleton;                  ///< of the character
    std::vector<VertexWeights> weights; ///< of the character
    std::vector<LandmarkPair> landmarks;
};

/// Those that are built in; resources/sample/README.md tells how they are made. Some tens of milliseconds.
SampleFigures shippedFigures();

} // namespace quadrille
