// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walkimprovement.h"

#include "model/synthesis/walkexchanges.h"

namespace quadrille {

FoundRoute improvedRoute(const WalkTask& task, WalkCourse& course, FoundRoute route,
                         const FoundCallback& found, const Progress& progress)
{
    constexpr double least = 1e-6; ///< of the cost, that is worth an exchange
    progress.report(0);
    Walk walk = task.graph.walk(route.route);
    std::size_t place = 0;
    for (std::size_t inVain = 0; inVain < walk.transitionCount(); ++place) {
        const WalkExchanges exchanges(task.graph, walk, place % walk.transitionCount(), {},
                                      task.settings.leastRun);
        auto better = bestExchange(course.followed(), exchanges, route.cost * (1 - least), progress);
        ++inVain;
        if (!better)
            continue;
        inVain = 0;
        better->expansions = route.expansions;
        better->bound = route.bound;
        route = *std::move(better);
        found(route);
        walk = task.graph.walk(route.route);
    }
    return route;
}

} // namespace quadrille
