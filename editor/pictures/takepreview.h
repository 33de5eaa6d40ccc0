// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/render/rendersettings.h"
#include "model/sequence/axes.h"
#include "model/sequence/meshsequence.h"

#include <QLabel>

namespace quadrille {

class JobRunner;

/// A square picture of a take as it will stand in the project, drawn in a job.
class TakePreview : public QLabel
{
    Q_OBJECT

public:
    static constexpr int side = 280; ///< logical pixels

    explicit TakePreview(JobRunner& jobs, QWidget* parent = nullptr);

    /// Draws a take on the theme's background; empties the picture without one. The picture of before stays
    /// until it is there; an error stands in its place.
    /// \param axes what its positions are in.
    void draw(const MeshSequence* sequence, const CoordinateSystem& axes = {});
    /// Draws a take as a picture will look; its size is brought into the square.
    void draw(const MeshSequence& sequence, RenderOptions look);

private:
    JobRunner& m_jobs;
    int m_generation = 0; ///< counts pictures, so that one that comes too late is dropped
};

} // namespace quadrille
