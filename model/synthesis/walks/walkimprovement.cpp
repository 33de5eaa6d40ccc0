// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/walkimprovement.h"

#include "model/synthesis/walks/walkexchanges.h"

namespace quadrille {

FoundRoute improvedRoute(const WalkTask& task, WalkCourse& course, FoundRoute route,
                         const FoundCallback& found, const Progress& progress)
{
    constexpr double least = 1e-6; ///< of the cost, that is worth an exchange
    progress.report(0);
    Walk walk = task.graph.walk(route.route);
    std::size_t tried = 0;
    for (std::size_t place = 0; tried < walk.transitionCount(); ++tried) {
        const WalkExchanges exchanges(task.graph, walk, place, {}, task.settings.leastRun);
        auto better = bestExchange(course.followed(), exchanges, route.cost * (1 - least), progress);
        if (better) {
            better->expansions = route.expansions;
            better->bound = route.bound;
            route = *std::move(better);
            found(route);
            walk = task.graph.walk(route.route);
            tried = 0;
        }
        place = walk.transitionCount() > 0 ? (place + 1) % walk.transitionCount() : 0;
    }
    return route;
}

} // namespace quadrille
