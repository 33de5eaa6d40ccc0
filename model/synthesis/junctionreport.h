// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/digraph.h"
#include "model/synthesis/junctionquality.h"

#include <optional>

namespace quadrille {

/// What might tell beforehand that a transition is bad.
enum class JunctionPredictor
{
    Sum,          ///< of the pose distances along the warp path
    Mean,         ///< of the pose distances along the warp path
    Acceleration, ///< the acceleration cost (SMCAS §3.3), m/s²
    Weight,       ///< of the edge
    PerLiveliness ///< Mean, over the liveliness of the two takes (see costPerLiveliness)
};
constexpr std::size_t junctionPredictors = 5;

struct JunctionRow
{
    FramePair frames;
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
    std::vector<JunctionRow> rows; ///< by source, then destination
    int good = 0;                  ///< transitions that are good by every criterion
    std::array<CriterionSummary, junctionCriteria> criteria;
    std::array<PredictorSummary, junctionPredictors> predictors;
};

/// What transitions of one character are judged by.
struct JunctionInputs
{
    const CharacterFrames& character;
    const RootPoses& roots; ///< with supports
    const Table<float>& distances;
    const Table<float>& accelerations; ///< of accelerationDifferences
    const TransitionTable& transitions;
    TransitionSettings settings; ///< of the transitions
    const Digraph& graph;        ///< whose transitions are drawn from
};

struct JunctionOptions
{
    int count = 200; ///< transitions, or all where there are fewer
    std::uint32_t seed = 1;
    JunctionLimits limits;
    int context = 8; ///< frames before and behind that count
    BlendSettings blend;
    std::optional<ContactCorrectionSettings> correction; ///< of contacts, before anything is measured
    InterpolationMethod method = InterpolationMethod::Poisson;
};

/// Blends some transitions of a graph and measures what shows. The same for any
/// number of threads. \throws Error BadArgument (count or context negative, no supports), what reading frames
/// throws, Cancelled.
JunctionReport judgeJunctions(const JunctionInputs& inputs, const JunctionOptions& options = {},
                              const Progress& progress = {});

/// So many of the pairs, in their order, each set of them as likely as any other; the same for the same seed.
std::vector<FramePair> drawPairs(std::vector<FramePair> pairs, int count, std::uint32_t seed);

} // namespace quadrille
