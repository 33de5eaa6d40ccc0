// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QString>
#include <QVector3D>
#include <vector>

namespace quadrille::widgets {

/// One movement in the latent space of a model: a place for each of its frames.
struct LatentPath
{
    QString name;
    QColor color;
    bool isSample = false; ///< drawn thinner, as it was not learned from
    std::vector<QVector3D> points;
    /// How sure the model is at each point, in the unit of the range that colours mean; or none.
    std::vector<double> values;
    bool isNamed = true; ///< beside its start, where it is no sample

    bool operator==(const LatentPath&) const = default;
};

/// How sure a model is at places of its latent space.
struct LatentCloud
{
    std::vector<QVector3D> points;
    std::vector<double> values;

    bool operator==(const LatentCloud&) const = default;
};

} // namespace quadrille::widgets
