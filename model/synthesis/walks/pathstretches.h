// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/walks/movemotions.h"

#include <vector>

namespace quadrille {

/// Every few of the captured frames: where a coarse look along a path may stop.
class FrameGrid
{
public:
    FrameGrid(const FrameLayout& layout, NodeIndex stride);

    NodeIndex stride() const { return m_stride; }
    std::size_t count() const { return m_frames.size(); }
    NodeIndex frame(std::size_t index) const { return m_frames[index]; }
    /// The last frame of the grid that is not behind a frame of the same sequence.
    std::size_t before(NodeIndex node) const;

private:
    const FrameLayout& m_layout;
    NodeIndex m_stride;
    std::vector<NodeIndex> m_frames;
    std::vector<std::size_t> m_firstOf; ///< of each sequence
};

/// Frames that are played on, or a transition with the frames that are played around it, from one frame of
/// a grid to another.
struct Stretch
{
    /// Where it passes.
    struct Sample
    {
        Vec3d point; ///< from where it begins, as the take that it begins in lies captured; height absolute
        double walked = 0;    ///< metres since it began
        double way = 0;       ///< metres that the sample stands for
        double frames = 0;    ///< output frames that it stands for
        NodeIndex source = 0; ///< what is shown there
        NodeIndex destination = 0;
    };
    std::size_t to = 0;          ///< index in the grid
    bool leadsOn = true;         ///< otherwise its take ends before it has come to the grid
    double weight = 0;           ///< of its moves
    double turn = 0;             ///< how the take that it ends in is turned against how it begins
    std::vector<Sample> samples; ///< the last at its end
};

/// What stretches are made of.
struct StretchMaterial
{
    const WalkGraph& graph;
    const FrameGrid& grid;
    MoveMotions& motions;
    int leastRun = 0;      ///< captured frames between two transitions
    double leastWay = 0.3; ///< metres that a stretch leads on at least
};

/// The stretches that begin at each frame of the grid: the one that plays on, and of the transitions soon
/// after it the lightest to each part of each take, at most some dozens; what does not lead on is left out.
std::vector<std::vector<Stretch>> stretchesOf(const StretchMaterial& material);

} // namespace quadrille
