// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/digraph.h"
#include "model/graph/transitioncosts.h"
#include "model/synthesis/quality/junctionquality.h"

#include <optional>

namespace quadrille {

/// What might tell beforehand that a transition is bad.
enum class JunctionPredictor
{
    Sum,          ///< of the pose distances along the warp path
    Mean,         ///< of the pose distances along the warp path
    Acceleration, ///< the acceleration cost (SMCAS §3.3), m/s²
    Weight,       ///< of the edge
    Cost,         ///< D as the graph has it, with all of its parts and scales
};
constexpr std::size_t junctionPredictors = 5;

/// What transitions are drawn from.
enum class JunctionSource
{
    Graph,  ///< the transitions of the graph: what walks are made of
    Minima, ///< local minima of the cost that the graph leaves out (costMinima): what it has to tell apart
};

struct JunctionRow
{
    FramePair frames;
    JunctionSource source = JunctionSource::Graph;
    int length = 0; ///< L, frames
    int sourceWindow = 0;
    int destinationWindow = 0;
    std::array<double, junctionPredictors> predictors{}; ///< by JunctionPredictor
    JunctionMeasures measures;
};

/// How the transitions fare by one criterion; of the ratios, those of the measured ones.
struct CriterionSummary
{
    int measured = 0; ///< transitions where there is something to measure
    int good = 0;     ///< of these
    double median = 0;
    double ninetieth = 0; ///< percentile
    double greatest = 0;
};

/// How well a predictor tells good transitions from bad.
struct PredictorSummary
{
    std::optional<double> rankCorrelation; ///< with the worst ratio of a transition
    std::optional<double> area;            ///< under the curve, for transitions that are not good
    /// For each criterion, by JunctionCriterion, of the measured ones.
    std::array<std::optional<double>, junctionCriteria> areas;
};

struct JunctionReport
{
    /// Those of the graph, then the minima; by their frames.
    std::vector<JunctionRow> rows;
    int drawn = 0; ///< of the graph
    int good = 0;  ///< of these, good by every criterion
    /// Of the graph's.
    std::array<CriterionSummary, junctionCriteria> criteria;
    /// Of all rows: among the few that a good graph has amiss, nothing can be told.
    std::array<PredictorSummary, junctionPredictors> predictors;
    int bad = 0; ///< of all rows
};

/// What transitions of one character are judged by.
struct JunctionInputs
{
    const CharacterFrames& character;
    const RootPoses& roots; ///< with supports
    TableView<float> distances;
    TableView<float> accelerations; ///< of accelerationDifferences
    const TransitionTable& transitions;
    TransitionSettings settings; ///< of the transitions
    const Digraph& graph;        ///< whose transitions are drawn from
    const TransitionCosts& costs;
    double alpha = 0; ///< of the graph
};

struct JunctionOptions
{
    int count = 200;  ///< transitions of the graph, or all where there are fewer
    int minima = 200; ///< that the graph leaves out, likewise
    std::uint32_t seed = 1;
    JunctionLimits limits;
    int context = 8; ///< frames before and behind that count
    BlendSettings blend;
    std::optional<ContactCorrectionSettings> correction; ///< of contacts, before anything is measured
    InterpolationMethod method = InterpolationMethod::Poisson;
};

/// Blends some transitions of a graph, and some that it leaves out, and measures what shows. The same for any
/// number of threads. \throws Error BadArgument (numbers or context negative, no supports), what reading
/// frames throws, Cancelled.
JunctionReport judgeJunctions(const JunctionInputs& inputs, const JunctionOptions& options = {},
                              const Progress& progress = {});

/// So many of the pairs, in their order, each set of them as likely as any other; the same for the same seed.
std::vector<FramePair> drawPairs(std::vector<FramePair> pairs, int count, std::uint32_t seed);

} // namespace quadrille
