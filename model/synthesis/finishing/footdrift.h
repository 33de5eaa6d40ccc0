// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/synthesis/clips/rootposes.h"
#include "model/transition/transitiontable.h"

#include <memory>

namespace quadrille {

/// How far transitions drag feet over the ground: of the feet that stand in a transition by
/// stancesBeforeSteps, how far a gentle blend carries one away from where it is on average while it stands;
/// the greatest of all feet. What a correction of contacts has to take back, and cannot where it is much, or
/// a step. Feet are followed by their middles and by the windows alone, which both are taken to go on evenly.
/// \param roots  with turns and known stances; zeros where nothing is known of feet. \return frames × frames,
/// body heights; 0 where there is no transition.
/// Costs of transitions are not read. \throws Error Cancelled. Cost: O(frames² · L · feet).
Table<float> footDrifts(const RootPoses& roots, const FrameLayout& layout, const TransitionTable& transitions,
                        double fps, const Progress& progress = {});
class FeetOfFrames;

/// The same of single transitions. Refers to the root poses. Safe from several threads.
class FootDrifts
{
public:
    /// Cost: O(frames · feet).
    FootDrifts(const RootPoses& roots, const FrameLayout& layout, double fps);
    /// \param transition  without its cost. Cost: O(L · feet).
    float of(const KnownTransition& transition, const FramePair& pair) const;

private:
    const RootPoses& m_roots;
    double m_fps;
    std::shared_ptr<const FeetOfFrames> m_feet; ///< null where nothing is known of feet
};

} // namespace quadrille
