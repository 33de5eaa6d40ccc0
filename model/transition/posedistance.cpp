// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/posedistance.h"

#include "model/core/error.h"
#include "model/core/message.h"
#include "model/geometry/procrustes.h"
#include "model/geometry/spreadpoints.h"
#include "model/transition/posedistancetile.h"

#include <Eigen/LU>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

void requireValid(const PoseDistanceSettings& settings)
{
    if (!(settings.stretchWeight >= 0) || !std::isfinite(settings.stretchWeight))
        throw Error(ErrorCode::BadArgument,
                    {.values = {{"reason", "The weight of stretch must not be negative"},
                                {"remedy", "The paper's weight is 0.01."}}});
    if (settings.triangles.value_or(1) < 1)
        throw Error(ErrorCode::BadArgument,
                    {.values = {{"reason", "At least one triangle must be compared"},
                                {"remedy", "Leave the number out for the usual one."}}});
}

/// All pairs of frames are compared, and several tables of them are in memory at once.
void requireComparable(const CharacterFrames& character)
{
    constexpr NodeIndex mostFrames = 20'000;
    if (character.frameCount() <= mostFrames)
        return;
    throw Error(ErrorCode::BadArgument,
                {.values = {{"reason", "The takes have " + std::to_string(character.frameCount()) +
                                           " frames together; a graph compares at most " +
                                           std::to_string(mostFrames)},
                            {"remedy", QUADRILLE_MESSAGE("Leave some takes or parts of them out, or lower "
                                                         "the rate of the project.")}}});
}

/// Looks at every frame once: its centre, and the triangles that have no area in it.
PoseDistanceInputs survey(const CharacterFrames& character, std::span<const PoseDistanceSettings> metrics,
                          const Progress& progress)
{
    PoseDistanceInputs inputs{.character = character,
                              .metrics = {},
                              .ofCovariance = {},
                              .centres =
                                  std::vector<Vec3d>(static_cast<std::size_t>(character.frameCount()))};
    const std::span<const Triangle> triangles = character.triangles();
    using Marks = std::vector<std::uint8_t>;
    tbb::enumerable_thread_specific<Marks> marksOfThreads(Marks(triangles.size(), 0));
    std::atomic<std::int64_t> done = 0;
    tbb::parallel_for(NodeIndex{0}, character.frameCount(), [&](NodeIndex node) {
        progress.report(done.load(), std::int64_t{character.frameCount()});
        const Frame frame = character.frame(node);
        inputs.centres[static_cast<std::size_t>(node)] = centroid(frame.positions());
        if (!metrics.empty())
            markDegenerate(frame.positions(), triangles, marksOfThreads.local());
        ++done;
    });
    std::vector<Triangle> used;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (std::none_of(marksOfThreads.begin(), marksOfThreads.end(),
                         [t](const Marks& marks) { return marks[t] != 0; }))
            used.push_back(triangles[t]);
    }
    for (const PoseDistanceSettings& metric : metrics) {
        inputs.metrics.push_back({.settings = metric, .corners = {}, .triangleCount = 0, .vertices = {}});
        MetricInputs& compared = inputs.metrics.back();
        const auto most =
            static_cast<std::size_t>(metric.triangles.value_or(std::numeric_limits<std::int64_t>::max()));
        const std::vector<Triangle> some =
            used.size() > most ? spreadTriangles(used, character.frame(0).positions(), most) : used;
        compared.corners = cornerSlices(some);
        compared.triangleCount = static_cast<std::int64_t>(some.size());
        if (metric.metric == PoseMetric::Euclidean && character.frameCount() > 0)
            compared.vertices = spreadPoints(character.frame(0).positions(), most);
    }
    return inputs;
}

/// Frames along a tile: two runs of frames fit 48 MB, and even a small table gives several cores to do. It
/// depends on nothing else, and no value depends on it.
NodeIndex tileSize(NodeIndex frameCount, std::uint32_t vertexCount)
{
    constexpr std::size_t runBytes = std::size_t{24} << 20;
    const auto fitting = static_cast<NodeIndex>(
        std::clamp(runBytes / (sizeof(Vec3f) * std::max(vertexCount, 1U)), std::size_t{8}, std::size_t{512}));
    return std::clamp((frameCount + 9) / 10, std::min(NodeIndex{16}, fitting), fitting);
}

/// θ + w/√2·‖log S‖ of one triangle.
double triangleDistance(const std::array<Vec3d, 3>& from, const std::array<Vec3d, 3>& to,
                        double stretchWeight)
{
    const auto edges = [](const std::array<Vec3d, 3>& corners) {
        Eigen::Matrix3d e;
        e.col(0) = corners[0] - corners[2];
        e.col(1) = corners[1] - corners[2];
        e.col(2) = e.col(0).cross(e.col(1)).normalized();
        return e;
    };
    // The in-plane map of the closed form, in orthonormal frames of both triangles.
    const auto frameOf = [](const Eigen::Matrix3d& e) {
        Eigen::Matrix3d f;
        f.col(0) = e.col(0).normalized();
        f.col(2) = e.col(2);
        f.col(1) = f.col(2).cross(f.col(0));
        return f;
    };
    const Eigen::Matrix3d a = edges(from);
    const Eigen::Matrix3d b = edges(to);
    const Eigen::Matrix3d frameA = frameOf(a);
    const Eigen::Matrix3d frameB = frameOf(b);
    const Eigen::Matrix2d planeA = (frameA.transpose() * a).topLeftCorner<2, 2>();
    const Eigen::Matrix2d planeB = (frameB.transpose() * b).topLeftCorner<2, 2>();
    const Eigen::Matrix2d m = planeB * planeA.inverse();
    const double phi = std::atan2(m(1, 0) - m(0, 1), m(0, 0) + m(1, 1));
    const Eigen::Quaterniond rotation(frameB * Eigen::AngleAxisd(phi, Vec3d::UnitZ()) * frameA.transpose());
    const double angle = 2 * std::atan2(rotation.vec().norm(), std::abs(rotation.w()));
    const double plus = std::hypot(m(0, 0) + m(1, 1), m(1, 0) - m(0, 1));
    const double minus = std::hypot(m(0, 0) - m(1, 1), m(0, 1) + m(1, 0));
    const double log1 = std::log((plus + minus) / 2);
    const double log2 = std::log(m.determinant()) - log1;
    return angle + stretchWeight / std::numbers::sqrt2 * std::hypot(log1, log2);
}

/// That of one triangle, once the second pose is turned as the first.
double alignedTriangleDistance(Positions a, Positions b, const RigidMotion& align, const Triangle& triangle,
                               double stretchWeight)
{
    std::array<Vec3d, 3> from;
    std::array<Vec3d, 3> to;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        from[corner] = a[triangle[corner].value].cast<double>();
        to[corner] = align.rotation * b[triangle[corner].value].cast<double>();
    }
    return triangleDistance(from, to, stretchWeight);
}

PoseDistanceInputs checkedInputs(const CharacterFrames& character,
                                 std::span<const PoseDistanceSettings> metrics, const Progress& progress)
{
    std::ranges::for_each(metrics, requireValid);
    PoseDistanceInputs inputs = survey(character, metrics, progress);
    const bool isWithout = std::ranges::any_of(inputs.metrics, [](const MetricInputs& metric) {
        return metric.settings.metric == PoseMetric::Surface && metric.triangleCount == 0;
    });
    if (isWithout && character.frameCount() > 0)
        throw Error(ErrorCode::NoUsableTriangles);
    return inputs;
}

/// \param store  (const PairTile&, std::span<const float> values), for several tiles at a time.
template <typename Store>
void computeTiles(const PoseDistanceInputs& inputs, const std::vector<PairTile>& tiles, const Store& store,
                  const Progress& progress, const Executor& executor)
{
    const auto tileOf = [&](std::int64_t task) -> const PairTile& {
        return tiles[static_cast<std::size_t>(task)];
    };
    executor.run(makeTasks<float>(
                     static_cast<std::int64_t>(tiles.size()),
                     [&](std::int64_t task, const Progress& own) {
                         return poseDistanceTile(inputs, tileOf(task), own);
                     },
                     [&](std::int64_t task, std::span<const float> values) { store(tileOf(task), values); }),
                 progress);
}

} // namespace

PosePairs posePairs(const CharacterFrames& character, std::span<const PoseDistanceSettings> metrics,
                    const OfCovariance& ofCovariance, const Progress& progress, const Executor& executor)
{
    requireComparable(character);
    const NodeIndex frameCount = character.frameCount();
    PoseDistanceInputs inputs = checkedInputs(character, metrics, progress.part(0, 0.02));
    inputs.ofCovariance = ofCovariance;
    PosePairs pairs;
    for (const MetricInputs& metric : inputs.metrics)
        pairs.distances.push_back(
            {.layout = character.layout(),
             .distances = {},
             .trianglesUsed = metric.triangleCount,
             .trianglesLeftOut =
                 static_cast<std::int64_t>(character.triangles().size()) - metric.triangleCount});
    std::vector<Table<float>*> tables;
    for (PoseDistances& distances : pairs.distances)
        tables.push_back(&distances.distances);
    if (ofCovariance)
        tables.push_back(&pairs.ofCovariances);
    for (Table<float>* table : tables)
        table->setZero(frameCount, frameCount);
    computeTiles(
        inputs, pairTiles(frameCount, tileSize(frameCount, character.vertexCount())),
        [&](const PairTile& tile, std::span<const float> values) {
            const std::size_t count = values.size() / tables.size();
            for (std::size_t t = 0; t < tables.size(); ++t)
                storeSymmetric(tile, values.subspan(t * count, count), *tables[t]);
        },
        progress.part(0.02, 1), executor);
    pairs.centres = std::move(inputs.centres);
    return pairs;
}

PoseDistances poseDistances(const CharacterFrames& character, const PoseDistanceSettings& settings,
                            const Progress& progress, const Executor& executor)
{
    return std::move(posePairs(character, std::span(&settings, 1), {}, progress, executor).distances.front());
}

Table<float> poseDistancesOfFirst(const CharacterFrames& character, NodeIndex rows,
                                  const PoseDistanceSettings& settings, const Progress& progress,
                                  const Executor& executor)
{
    const NodeIndex frameCount = character.frameCount();
    const PoseDistanceInputs inputs =
        checkedInputs(character, std::span(&settings, 1), progress.part(0, 0.02));
    const NodeIndex size = tileSize(frameCount, character.vertexCount());
    std::vector<PairTile> tiles = pairTiles(rows, size);
    for (NodeIndex row = 0; row < rows; row += size) {
        for (NodeIndex column = rows; column < frameCount; column += size)
            tiles.push_back({row, std::min(size, rows - row), column, std::min(size, frameCount - column)});
    }
    Table<float> distances = Table<float>::Zero(rows, frameCount);
    computeTiles(
        inputs, tiles,
        [&](const PairTile& tile, std::span<const float> values) {
            if (tile.firstColumn < rows)
                storeSymmetric(tile, values, distances);
            else
                distances.block(tile.firstRow, tile.firstColumn, tile.rows, tile.columns) =
                    Eigen::Map<const Table<float>>(values.data(), tile.rows, tile.columns);
        },
        progress.part(0.02, 1), executor);
    return distances;
}

double surfaceDistance(Positions a, Positions b, std::span<const Triangle> triangles, double stretchWeight)
{
    if (triangles.empty())
        return 0;
    const RigidMotion align = rigidProcrustes(b, a);
    double sum = 0;
    for (const Triangle& triangle : triangles)
        sum += alignedTriangleDistance(a, b, align, triangle, stretchWeight);
    return sum / static_cast<double>(triangles.size());
}

std::vector<double> triangleDistances(Positions a, Positions b, std::span<const Triangle> triangles,
                                      double stretchWeight)
{
    std::vector<std::uint8_t> withoutArea(triangles.size(), 0);
    markDegenerate(a, triangles, withoutArea);
    markDegenerate(b, triangles, withoutArea);
    const RigidMotion align = rigidProcrustes(b, a);
    std::vector<double> distances(triangles.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (withoutArea[t] == 0)
            distances[t] = alignedTriangleDistance(a, b, align, triangles[t], stretchWeight);
    }
    return distances;
}

double euclideanDistance(Positions a, Positions b)
{
    const RigidMotion align = rigidProcrustes(b, a);
    double sum = 0;
    for (std::size_t v = 0; v < a.size(); ++v)
        sum += (a[v].cast<double>() - align(b[v].cast<double>())).norm();
    return sum / static_cast<double>(a.size());
}

} // namespace quadrille
