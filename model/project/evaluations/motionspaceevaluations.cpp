// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// IA4D Tables 1 to 3 and Fig. 4 for the motion spaces of a character.
#include "model/core/bounds.h"
#include "model/parametric/hybridblend.h"
#include "model/parametric/references.h"
#include "model/parametric/similarityerrors.h"
#include "model/project/document/findentry.h"
#include "model/project/evaluations/evaluationsteps.h"
#include "model/project/steps/motionspacesteps.h"
#include "model/project/store/tablebuilder.h"

#include <algorithm>
#include <array>
#include <map>

namespace quadrille {

namespace {

using SpaceWorks = std::vector<MotionSpaceWork>;

/// Of the paper: linear, and as many references.
constexpr std::array<int, 4> referenceCounts{0, 1, 3, 7};
/// Places along the way from one take to the other.
constexpr int weightSteps = 20;
/// Frames of the source, evenly over it, each with the frame of the target that is most like it.
constexpr std::size_t comparedFrames = 5;

SpaceWorks spacesOf(const CharacterInputs& work)
{
    SpaceWorks works;
    for (const MotionSpaceEntry& entry : work.opener->project().motionSpaces) {
        if (entry.takes.size() > 1 && characterNameOf(work.opener->project(), entry) == work.character)
            works.emplace_back(work.opener, entry);
    }
    return works;
}

/// The space without its references, then with so many, wherever they help most.
MotionSpace withReferences(const MotionSpace& space, int count, const Progress& progress)
{
    MotionSpace changed = space;
    std::vector<SpacePoint> places;
    for (std::size_t t = 0; t < space.takes.size(); ++t)
        places.push_back(space.weights.nodes()[t].place);
    changed.weights = WeightSpace(places, space.weights.dimension());
    changed.references.clear();
    MotionSpaceSettings settings;
    settings.tolerance = 1e-5; // never kept, so that there are as many as there may be
    settings.mostReferences = count;
    refine(changed, settings, progress);
    return changed;
}

/// Places along all edges between takes.
std::vector<SpacePoint> placesBetween(const MotionSpace& linear)
{
    std::vector<SpacePoint> places;
    for (const auto& [from, to] : linear.weights.edges()) {
        const SpacePoint& a = linear.weights.nodes()[static_cast<std::size_t>(from)].place;
        const SpacePoint& b = linear.weights.nodes()[static_cast<std::size_t>(to)].place;
        for (int step = 0; step <= weightSteps; ++step) {
            SpacePoint& place = places.emplace_back();
            const double share = static_cast<double>(step) / weightSteps;
            for (std::size_t d = 0; d < place.size(); ++d)
                place[d] = a[d] + share * (b[d] - a[d]);
        }
    }
    return places;
}

/// What is measured of one space with some references.
struct MeasuredBlends
{
    std::size_t memory = 0;
    double size = 0; ///< of the figure: the diagonal of its box in the first pose, metres
    std::vector<SpacePoint> places;
    std::vector<HybridError> errors; ///< at each place
};

MeasuredBlends measuredBlends(const MotionSpace& space, int references, const Progress& progress)
{
    const MotionSpace changed = withReferences(space, references, progress.part(0, 0.5));
    MeasuredBlends measured;
    for (const SpaceReference& reference : changed.references)
        measured.memory += reference.memory();
    measured.size = boundsOf(changed.takes.front().pose(0)).size().norm();
    measured.places = placesBetween(withReferences(space, 0, Progress(progress.token())));
    const NonLinearBlend nonLinear(changed);
    const Progress measuring = progress.part(0.5, 1);
    for (const SpacePoint& place : measured.places) {
        measuring.report(std::ssize(measured.errors), std::ssize(measured.places));
        measured.errors.push_back(hybridError(changed, changed.weights.at(place), nonLinear));
    }
    return measured;
}

/// Calls a function with each space and number of references.
template <typename Use>
void measureBlends(const SpaceWorks& works, const StepContext& context, const Progress& progress,
                   const Use& use)
{
    const auto share = 1 / static_cast<double>(works.size() * referenceCounts.size());
    double begin = 0;
    for (const MotionSpaceWork& work : works) {
        const auto space = sharedMotionSpace(work, context, Progress(progress.token()));
        for (const int count : referenceCounts) {
            use(space->name, count, measuredBlends(*space, count, progress.part(begin, begin + share)));
            begin += share;
        }
    }
}

/// A step about the motion spaces of a character, which it has as inputs.
BuildStep spacesStep(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    BuildStep step = evaluationStep(work, evaluation);
    for (const MotionSpaceWork& space : spacesOf(work)) {
        step.inputs.push_back(motionSpaceStepOf(space.entry().name));
        step.settings += space.entry().name + '\n'; // they are called so in tables
    }
    return step;
}

/// How two takes of a space blend, and move, in one frame; blends are made once.
class MovingBlends
{
public:
    explicit MovingBlends(const MotionSpace& space) : m_space(space), m_nonLinear(space) {}

    MovingPose at(double share, std::size_t frame)
    {
        std::vector<double> shares(m_space.takes.size());
        shares[0] = 1 - share;
        shares[1] = share;
        auto& poses = m_blends[share];
        if (poses.empty())
            poses = m_nonLinear.blend(shares);
        const std::size_t vertices = m_space.vertexCount();
        const auto poseOf = [&](std::size_t f) { return Positions(poses).subspan(f * vertices, vertices); };
        // At the end of a space without a cycle it goes on as before.
        const bool isLast = m_space.next(frame) == frame;
        const std::size_t from = isLast && frame > 0 ? frame - 1 : frame;
        const NodeWeights weights{.nodes = {0, 1}, .weights = {1 - share, share}, .count = 2};
        const GroundMotion step = blendedStep(m_space, from, weights);
        const Ground ground(m_space.up);
        const Positions now = poseOf(from);
        const Positions next = poseOf(m_space.next(from));
        MovingPose moving;
        moving.pose.assign(poseOf(frame).begin(), poseOf(frame).end());
        for (std::size_t v = 0; v < vertices; ++v)
            moving.velocity.emplace_back(
                (step(next[v].cast<double>(), ground) - now[v].cast<double>()).cast<float>());
        return moving;
    }

private:
    const MotionSpace& m_space;
    NonLinearBlend m_nonLinear;
    std::map<double, std::vector<Vec3f>> m_blends; ///< by the share of the second take
};

/// By the number of bisections, the mean and the greatest over some pairs of frames.
std::vector<SimilarityError> errorsBetween(MovingBlends& source, MovingBlends& target,
                                           const SimilarityTable& table, const Progress& progress)
{
    std::vector<SimilarityError> all;
    for (std::size_t i = 0; i < comparedFrames; ++i) {
        progress.report(static_cast<std::int64_t>(i), std::int64_t{comparedFrames});
        const std::size_t from = i * table.sourceFrames / comparedFrames;
        const auto row = std::span(table.leasts).subspan(from * table.targetFrames, table.targetFrames);
        const auto to = static_cast<std::size_t>(std::ranges::min_element(row) - row.begin());
        const std::vector<SimilarityError> errors = similarityErrors(
            [&](double share) { return source.at(share, from); },
            [&](double share) { return target.at(share, to); }, {}, Progress(progress.token()));
        all.resize(errors.size());
        for (std::size_t e = 0; e < errors.size(); ++e) {
            all[e].bisections = errors[e].bisections;
            all[e].mean += errors[e].mean / comparedFrames;
            all[e].greatest = std::max(all[e].greatest, errors[e].greatest);
        }
    }
    return all;
}

/// Calls a function with each ordered pair of spaces.
template <typename Use>
void forPairs(const SpaceWorks& works, const Use& use)
{
    for (const MotionSpaceWork& source : works) {
        for (const MotionSpaceWork& target : works) {
            if (&source != &target)
                use(source, target);
        }
    }
}

Result resultOfTable(TableBuilder table)
{
    Result result;
    result.tables = {std::move(table).table()};
    return result;
}

} // namespace

BuildStep ia4dTable1Step(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    BuildStep step = spacesStep(work, evaluation);
    step.compute = [works = spacesOf(work)](const StepContext& context, const Progress& progress) {
        TableBuilder table("ia4d-table1",
                           "How far hybrid blends are from non-linear ones by the number of references, as "
                           "IA4D Table 1: of all vertices in all frames, at places between takes, in metres "
                           "and in shares of the figure's size; and what the references take.");
        table.text("space").whole("references").real("mean-error", "m").real("greatest-error", "m");
        table.real("mean-share", "%").real("greatest-share", "%").whole("memory", "byte");
        measureBlends(works, context, progress,
                      [&](const std::string& name, int count, const MeasuredBlends& measured) {
                          double mean = 0;
                          double greatest = 0;
                          for (const HybridError& error : measured.errors) {
                              mean += error.mean / static_cast<double>(measured.errors.size());
                              greatest = std::max(greatest, error.greatest);
                          }
                          table.add({name, std::int64_t{count}, mean, greatest, 100 * mean / measured.size,
                                     100 * greatest / measured.size,
                                     static_cast<std::int64_t>(measured.memory)});
                      });
        return resultOfTable(std::move(table));
    };
    return step;
}

BuildStep ia4dFig4Step(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    BuildStep step = spacesStep(work, evaluation);
    step.compute = [works = spacesOf(work)](const StepContext& context, const Progress& progress) {
        TableBuilder table("ia4d-fig4", "How far hybrid blends are from non-linear ones along the ways from "
                                        "take to take, by the number of references, as IA4D Fig. 4.");
        table.text("space").whole("references").whole("edge").real("weight");
        table.real("mean-error", "m").real("greatest-error", "m").real("greatest-share", "%");
        measureBlends(works, context, progress,
                      [&](const std::string& name, int count, const MeasuredBlends& measured) {
                          constexpr std::size_t along = weightSteps + 1;
                          for (std::size_t p = 0; p < measured.errors.size(); ++p)
                              table.add({name, std::int64_t{count}, static_cast<std::int64_t>(p / along),
                                         static_cast<double>(p % along) / weightSteps,
                                         measured.errors[p].mean, measured.errors[p].greatest,
                                         100 * measured.errors[p].greatest / measured.size});
                      });
        return resultOfTable(std::move(table));
    };
    return step;
}

BuildStep ia4dTable2Step(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    BuildStep step = evaluationStep(work, evaluation);
    const SpaceWorks works = spacesOf(work);
    std::vector<std::pair<std::string, std::string>> pairs;
    forPairs(works, [&](const MotionSpaceWork& source, const MotionSpaceWork& target) {
        pairs.emplace_back(source.entry().name, target.entry().name);
        step.inputs.push_back(transitionReportStepOf(source.entry().name, target.entry().name));
    });
    for (const auto& [source, target] : pairs) // they are called so in the table
        step.settings.append(source).append("\n").append(target).append("\n");
    step.compute = [pairs](const StepContext& context, const Progress& /*progress*/) {
        TableBuilder table("ia4d-table2",
                           "Transitions between motion spaces from random states, as IA4D Table 2: found "
                           "while they play, and the best of 1, 5 and 10 that are computed before.");
        table.text("source").text("target").text("kind").real("cost").real("dissimilarity");
        table.real("mean-latency", "s").real("median-latency", "s").real("latency-95", "s");
        table.real("worst-latency", "s").whole("missed");
        for (const auto& [source, target] : pairs) {
            const ResultPointer stored = context.resultOf(transitionReportStepOf(source, target));
            const DataTable& report = stored->tables.front();
            const std::vector<std::string> kinds = columnNamed<TextColumn>(report, "kind").list();
            const auto real = [&](const char* name, std::size_t row) {
                return columnNamed<std::vector<double>>(report, name)[row];
            };
            for (std::size_t row = 0; row < kinds.size(); ++row)
                table.add({source, target, kinds[row], real("cost", row), real("dissimilarity", row),
                           real("mean-latency", row), real("median-latency", row), real("latency-95", row),
                           real("worst-latency", row),
                           columnNamed<std::vector<std::int64_t>>(report, "missed")[row]});
        }
        return resultOfTable(std::move(table));
    };
    return step;
}

BuildStep ia4dTable3Step(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    BuildStep step = spacesStep(work, evaluation);
    forPairs(spacesOf(work), [&](const MotionSpaceWork& source, const MotionSpaceWork& target) {
        step.inputs.push_back(similarityStepOf(source.entry().name, target.entry().name));
    });
    step.compute = [works = spacesOf(work)](const StepContext& context, const Progress& progress) {
        TableBuilder table("ia4d-table3",
                           "How far distances that are interpolated between takes are from true ones, as "
                           "IA4D Table 3, by how often the ways from the first take to the second are "
                           "halved: of the range of the true ones, over five frames of the source.");
        table.text("source").text("target").whole("bisections");
        table.real("mean-error", "%").real("greatest-error", "%");
        const double share = 1 / static_cast<double>(works.size() * (works.size() - 1));
        double begin = 0;
        forPairs(works, [&](const MotionSpaceWork& source, const MotionSpaceWork& target) {
            const auto from = sharedMotionSpace(source, context, Progress(progress.token()));
            const auto to = sharedMotionSpace(target, context, Progress(progress.token()));
            const auto distances = sharedSimilarities(from->name, to->name, context);
            MovingBlends left(*from);
            MovingBlends right(*to);
            for (const SimilarityError& error :
                 errorsBetween(left, right, *distances, progress.part(begin, begin + share)))
                table.add({from->name, to->name, std::int64_t{error.bisections}, error.mean, error.greatest});
            begin += share;
        });
        return resultOfTable(std::move(table));
    };
    return step;
}

} // namespace quadrille
