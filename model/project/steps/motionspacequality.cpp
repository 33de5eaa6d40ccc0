// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/livesettings.h"
#include "model/live/movingplace.h"
#include "model/parametric/measureunit.h"
#include "model/parametric/precomputedtransitions.h"
#include "model/parametric/references.h"
#include "model/project/steps/charactersteps.h"
#include "model/project/steps/motionspaceresults.h"
#include "model/project/steps/motionspacework.h"
#include "model/project/store/tablebuilder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

/// In how many steps each axis is gone along, by the number of axes.
constexpr std::array<int, 4> errorSteps{1, 20, 6, 3};
constexpr std::size_t comparedRequests = 1000;
constexpr std::uint64_t requestSeed = 1;
constexpr double notKnown = std::numeric_limits<double>::quiet_NaN();

/// Transitions that were chosen for some states.
class ChosenTransitions
{
public:
    void add(const TransitionChoice& choice, double fps)
    {
        m_cost += choice.cost();
        m_dissimilarity += choice.dissimilarity;
        m_seconds.push_back((choice.sourceFrames + choice.targetFrames) / fps);
    }
    void missed() { ++m_missed; }

    void row(TableBuilder& table, const std::string& kind)
    {
        std::ranges::sort(m_seconds);
        if (m_seconds.empty()) {
            table.add({kind, notKnown, notKnown, notKnown, notKnown, notKnown, notKnown, m_missed});
            return;
        }
        const auto count = static_cast<double>(m_seconds.size());
        double sum = 0;
        for (const double seconds : m_seconds)
            sum += seconds;
        table.add({kind, m_cost / count, m_dissimilarity / count, sum / count, quantile(0.5), quantile(0.95),
                   quantile(1), m_missed});
    }

private:
    double quantile(double share) const
    {
        const double last = static_cast<double>(m_seconds.size()) - 1;
        return m_seconds[static_cast<std::size_t>(std::ceil(share * last))];
    }

    double m_cost = 0;
    double m_dissimilarity = 0;
    std::vector<double> m_seconds;
    std::int64_t m_missed = 0;
};

DataTable parameterTable(const MotionSpace& space)
{
    TableBuilder table("parameters", "What steers the space: from where to where the takes reach, and by how "
                                     "much a value that is asked for is missed, in its unit.");
    table.text("parameter").text("measure").text("unit").real("least").real("greatest");
    table.real("mean-residual").real("worst-residual");
    for (std::size_t d = 0; d < space.parameters.size(); ++d) {
        const SpaceParameter& parameter = space.parameters[d];
        table.add({parameter.name, toText(parameter.measure), unitOf(parameter.measure), space.map.least[d],
                   space.map.greatest[d], space.map.meanResidual[d], space.map.worstResidual[d]});
    }
    return std::move(table).table();
}

} // namespace

Result motionSpaceQuality(const MotionSpace& space, const Progress& progress)
{
    TableBuilder table("error", "How far the blends of the space are from the non-linear ones, at nodes and "
                                "evenly between them: of all vertices in all frames.");
    table.real("place-1").real("place-2").real("place-3").real("greatest", "m").real("mean", "m");
    table.whole("frame", "frame");
    const NonLinearBlend nonLinear(space);
    const TransitionPlaces places =
        transitionPlaces(space.weights, errorSteps.at(static_cast<std::size_t>(space.weights.dimension())));
    for (std::size_t p = 0; p < places.places.size(); ++p) {
        progress.report(static_cast<std::int64_t>(p), std::ssize(places.places));
        const HybridError error = hybridError(space, places.weights[p], nonLinear);
        const SpacePoint& place = places.places[p];
        table.add({place[0], place[1], place[2], error.greatest, error.mean,
                   static_cast<std::int64_t>(error.frame)});
    }
    Result result;
    result.tables = {std::move(table).table(), parameterTable(space)};
    return result;
}

Result similarityResult(const SimilarityTable& table)
{
    Result result;
    result.arrays = {{.name = "similarity",
                      .description = "Source frames × target frames × source nodes × target nodes: how far "
                                     "poses and velocities are apart, of a vertex on average.",
                      .unit = "m",
                      .shape = {static_cast<std::int64_t>(table.sourceFrames),
                                static_cast<std::int64_t>(table.targetFrames),
                                static_cast<std::int64_t>(table.sourceNodes),
                                static_cast<std::int64_t>(table.targetNodes)},
                      .values = table.distances}};
    return result;
}

SimilarityTable similaritiesOf(const Result& stored)
{
    const DataArray& array = arrayOf(stored, "similarity");
    const auto size = [&](std::size_t d) { return static_cast<std::size_t>(array.shape[d]); };
    SimilarityTable table{.sourceFrames = size(0),
                          .targetFrames = size(1),
                          .sourceNodes = size(2),
                          .targetNodes = size(3),
                          .distances = std::get<std::vector<float>>(array.values),
                          .leasts = {}};
    for (std::size_t s = 0; s < table.sourceFrames; ++s) {
        for (std::size_t t = 0; t < table.targetFrames; ++t)
            table.leasts.push_back(std::ranges::min(table.block(s, t)));
    }
    table.greatest = std::ranges::max(table.distances);
    return table;
}

Result transitionReport(const MotionSpace& source, const MotionSpace& target,
                        const std::shared_ptr<const SimilarityTable>& table, const Progress& progress)
{
    TableBuilder report("report",
                        "Transitions from one motion space to another one between random states: found "
                        "while they play – and so where latency counts eight times as much –, and the "
                        "best of 1, 5 and 10 that are computed before. What they "
                        "cost, how unlike the poses are (0 to 1000), how long it takes until the target is "
                        "where it is wanted, and for how many states there is none.");
    report.text("kind").real("cost").real("dissimilarity").real("mean-latency", "s");
    report.real("median-latency", "s").real("latency-95", "s").real("worst-latency", "s").whole("missed");
    const std::vector<TransitionRequest> requests =
        randomRequests(source, target, comparedRequests, requestSeed);
    constexpr double share = 0.2;
    double begin = 0;
    // Places move as when they are played live.
    TransitionSearchSettings smooth;
    smooth.stepsAFrame =
        stepsAFrame(smooth.steps, LiveSettings().secondsAcross, std::max(source.fps, target.fps));
    TransitionSearchSettings responsive = smooth;
    responsive.latencyWeight = LiveSettings().responsiveWeight;
    for (const auto& [kind, settings] : {std::pair("online", smooth), std::pair("responsive", responsive)}) {
        ChosenTransitions online;
        TransitionSearch search(table, source, target, settings);
        const Progress searching = progress.part(begin, begin + share);
        for (std::size_t r = 0; r < requests.size(); ++r) {
            searching.report(static_cast<std::int64_t>(r), std::ssize(requests));
            online.add(search.search(requests[r].source, requests[r].goal).front(), source.fps);
        }
        online.row(report, kind);
        begin += share;
    }
    for (const std::size_t count : {1U, 5U, 10U}) {
        const PrecomputedTransitions fixed(*table, source, target,
                                           {.count = count, .stepsAFrame = smooth.stepsAFrame});
        const Progress choosing = progress.part(begin, begin + share);
        ChosenTransitions chosen;
        for (std::size_t r = 0; r < requests.size(); ++r) {
            choosing.report(static_cast<std::int64_t>(r), std::ssize(requests));
            if (const auto choice = fixed.choose(requests[r].source, requests[r].goal))
                chosen.add(*choice, source.fps);
            else
                chosen.missed();
        }
        chosen.row(report, std::to_string(count) + " computed before");
        begin += share;
    }
    Result result;
    result.tables = {std::move(report).table()};
    return result;
}

} // namespace quadrille
