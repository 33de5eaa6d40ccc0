// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/table.h"
#include "model/transition/costgrid.h"
#include "model/transition/framelayout.h"
#include "model/transition/framepair.h"
#include "model/transition/transitionsettings.h"
#include "model/transition/transitiontable.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// A transition with its warp path.
struct Transition
{
    FramePair frames;          ///< i and j
    int sourceWindow = 0;      ///< lᵢ, frames
    int destinationWindow = 0; ///< lⱼ, frames
    float cost = 0;            ///< D, as in TransitionTable
    /// From (i, j − lⱼ + 1) to (i + lᵢ − 1, j), both included: the frames that are blended, one after the
    /// other. Where the transition lasts less than the warp path has cells, evenly spread ones of these.
    std::vector<FramePair> path;

    /// L, frames.
    int length() const { return static_cast<int>(path.size()); }
};

/// Finds the warp paths of single transitions: the same as those of `transitionTable`, ties included; among
/// paths that are equal in cost, length and windows the one with its diagonal steps latest. Refers to its
/// distances. Safe from several threads.
class WarpPaths
{
public:
    /// Distances of a frame from as many that follow each other as there is room for.
    using DistanceRows = std::function<void(NodeIndex source, NodeIndex first, std::span<float> row)>;

    /// \param distances  as for transitionTable.
    /// \throws Error BadArgument from checkSettings. Cost: O(frames²), for the largest distance.
    WarpPaths(TableView<float> distances, FrameLayout layout, const TransitionSettings& settings);

    /// The same of distances that are known row by row. \param rows  called from several threads.
    /// \param largest  of all distances. \throws Error BadArgument from checkSettings.
    WarpPaths(DistanceRows rows, float largest, FrameLayout layout, const TransitionSettings& settings);

    /// The best transition between two frames over all windows; nothing where no windows fit, or i = j.
    /// \throws Error BadArgument where a frame does not exist. Cost: O(l_max²).
    std::optional<Transition> find(FramePair frames) const;
    /// As find. \throws Error NoTransition where no windows fit, BadArgument also where i = j.
    Transition get(FramePair frames) const;
    /// The best warp path of given windows; nothing where the slope lets no path span them.
    /// \pre They lie in their sequences, of 1 … l_max frames.
    std::optional<Transition> between(FramePair frames, int sourceWindow, int destinationWindow) const;
    /// That of which the rest is known, from the same distances and settings; nothing where there is none.
    std::optional<Transition> of(const KnownTransition& known, FramePair frames) const;
    std::optional<Transition> of(const TransitionTable& table, FramePair frames) const
    {
        return of(table.at(frames), frames);
    }
    /// That of a linear table: both windows advance together.
    std::optional<Transition> linear(FramePair frames) const;

private:
    int shortestOf(FramePair frames) const;
    int framesFrom(NodeIndex source) const;
    int framesTo(NodeIndex destination) const;
    /// A mean cost that is not far off, in steps of the grid.
    struct Mean
    {
        double steps = 0;
        double length = 1;
    };
    /// The best warp path of given windows.
    std::optional<Transition> solve(FramePair frames, int sourceWindow, int destinationWindow,
                                    Mean guess) const;

    DistanceRows m_rows;
    FrameLayout m_layout;
    TransitionSettings m_settings;
    CostGrid m_grid;
};

} // namespace quadrille
