// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/essentialgraph.h"
#include "model/synthesis/clips/rootposes.h"
#include "model/synthesis/walks/constraints.h"
#include "model/transition/transitiontable.h"

#include <map>

namespace quadrille::test {

/// Takes of rb_m04 with all that walks are made from.
struct RealCharacter
{
    static constexpr double alpha = 0.01;

    TransitionSettings settings{.fps = 30};
    std::map<std::string, WalkSpan> takes;
    Table<float> distances;
    FrameLayout layout;
    TransitionTable table;
    TransitionCosts costs;
    EssentialGraph essential;
    RootPoses roots;

    /// The frames of takes whose names begin so, as a label would name them.
    FrameSet framesOf(const std::string& name) const;
};

/// Of the takes that walks are asked for in tests, and some to turn by. Computed once, in some seconds; null
/// where the data are missing.
const RealCharacter* realCharacter();
/// The same of all of the takes.
const RealCharacter* wholeRealCharacter();

} // namespace quadrille::test
