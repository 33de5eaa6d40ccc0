// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/similarity.h"

#include "model/core/badargument.h"
#include "model/parametric/hybridblend.h"
#include "model/parametric/similaritykernel.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// Rows of coordinates, one for each frame and node of a space; filled up by zeros to whole kernels.
struct CoordinateRows
{
    std::size_t count = 0;
    std::size_t stride = 0;
    std::vector<float> values;
    std::vector<double> squares; ///< ‖row‖²

    CoordinateRows(std::size_t rows, std::size_t vertices)
        : count(rows), stride((vertices * 3 + 7) / 8 * 8), values(rows * stride), squares(rows)
    {
    }
    float* row(std::size_t index) { return values.data() + index * stride; }
    const float* row(std::size_t index) const { return values.data() + index * stride; }
};

struct SpaceRows
{
    CoordinateRows poses;
    CoordinateRows velocities;
};

/// The rows of one node in all frames.
void fillNode(const MotionSpace& space, std::size_t node, SpaceRows& rows, const Progress& progress)
{
    const std::size_t nodes = space.weights.nodes().size();
    const std::size_t vertices = space.vertexCount();
    const Ground ground(space.up);
    progress.report(0);
    const BlendedMovement movement =
        blendedMovement(space, NodeWeights{.nodes = {static_cast<int>(node)}, .weights = {1}, .count = 1});
    const auto put = [](const Vec3d& value, float* to) {
        for (std::size_t d = 0; d < 3; ++d)
            to[d] = static_cast<float>(value[static_cast<Eigen::Index>(d)]);
    };
    for (std::size_t f = 0; f < space.frameCount(); ++f) {
        const Vec3f* pose = movement.poses.data() + f * vertices;
        for (std::size_t v = 0; v < vertices; ++v)
            put(pose[v].cast<double>(), rows.poses.row(f * nodes + node) + 3 * v);
        const bool isEnd = !space.isCyclic && f + 1 == space.frameCount();
        if (isEnd && f == 0)
            return; // a single frame does not move
        const std::size_t from = isEnd ? f - 1 : f;
        const Vec3f* other = movement.poses.data() + (isEnd ? from : space.next(f)) * vertices;
        const RigidMotion motion =
            (isEnd ? movement.steps[from].inverse() : movement.steps[from]).inSpace(ground);
        const Eigen::Matrix3d turn = motion.rotation.toRotationMatrix();
        // A warp that holds a pose for a while must not make what is left of its movement fast.
        const double frames = std::max(movement.seconds[from] * space.fps, 0.1);
        const double pace = (isEnd ? -1 : 1) / frames;
        for (std::size_t v = 0; v < vertices; ++v)
            put(pace * (turn * other[v].cast<double>() + motion.translation - pose[v].cast<double>()),
                rows.velocities.row(f * nodes + node) + 3 * v);
    }
}

SpaceRows rowsOf(const MotionSpace& space, const Progress& progress)
{
    const std::size_t nodes = space.weights.nodes().size();
    const std::size_t count = space.frameCount() * nodes;
    SpaceRows rows{{count, space.vertexCount()}, {count, space.vertexCount()}};
    tbb::parallel_for(std::size_t{0}, nodes, [&](std::size_t n) { fillNode(space, n, rows, progress); });
    return rows;
}

/// Takes the mean of all rows off, so that products of rows are not much greater than their differences.
void centre(CoordinateRows& source, CoordinateRows& target)
{
    constexpr std::size_t together = 512; // columns, so that a part of each row is read at once
    const std::size_t parts = (source.stride + together - 1) / together;
    tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
        const std::size_t from = part * together;
        const std::size_t to = std::min(from + together, source.stride);
        std::array<double, together> mean{};
        for (CoordinateRows* rows : {&source, &target})
            for (std::size_t r = 0; r < rows->count; ++r)
                for (std::size_t c = from; c < to; ++c)
                    mean[c - from] += static_cast<double>(rows->row(r)[c]);
        for (CoordinateRows* rows : {&source, &target})
            for (std::size_t r = 0; r < rows->count; ++r)
                for (std::size_t c = from; c < to; ++c)
                    rows->row(r)[c] =
                        static_cast<float>(static_cast<double>(rows->row(r)[c]) -
                                           mean[c - from] / static_cast<double>(source.count + target.count));
    });
    for (CoordinateRows* rows : {&source, &target}) {
        tbb::parallel_for(std::size_t{0}, rows->count, [&](std::size_t r) {
            const float* row = rows->row(r);
            double sum = 0;
            for (std::size_t c = 0; c < rows->stride; ++c)
                sum += static_cast<double>(row[c]) * static_cast<double>(row[c]);
            rows->squares[r] = sum;
        });
    }
}

/// Some rows of the source with some of the target.
class DistanceTile
{
public:
    DistanceTile(std::size_t firstSource, std::size_t firstTarget)
        : m_firstSource(firstSource)
        , m_firstTarget(firstTarget)
        , m_scratch(2 * productRows * productColumns)
        , m_products(productRows * productRows)
        , m_distances(productRows * productRows)
    {
    }

    void add(const CoordinateRows& source, const CoordinateRows& target, double weight)
    {
        std::fill(m_products.begin(), m_products.end(), 0.0);
        const std::size_t sourceRows = std::min(productRows, source.count - m_firstSource);
        const std::size_t targetRows = std::min(productRows, target.count - m_firstTarget);
        for (std::size_t c = 0; c < source.stride; c += productColumns) {
            const std::size_t columns = std::min(productColumns, source.stride - c);
            addRowProducts({source.row(m_firstSource) + c, sourceRows, columns, source.stride},
                           {target.row(m_firstTarget) + c, targetRows, columns, target.stride},
                           m_scratch.data(), m_products.data());
        }
        for (std::size_t s = 0; s < sourceRows; ++s)
            for (std::size_t t = 0; t < targetRows; ++t)
                m_distances[s * productRows + t] +=
                    weight *
                    std::sqrt(std::max(source.squares[m_firstSource + s] + target.squares[m_firstTarget + t] -
                                           2 * m_products[s * productRows + t],
                                       0.0));
    }

    void store(SimilarityTable& table) const
    {
        const std::size_t sourceEnd =
            std::min(m_firstSource + productRows, table.sourceFrames * table.sourceNodes);
        const std::size_t targetEnd =
            std::min(m_firstTarget + productRows, table.targetFrames * table.targetNodes);
        for (std::size_t s = m_firstSource; s < sourceEnd; ++s) {
            for (std::size_t t = m_firstTarget; t < targetEnd; ++t) {
                const std::size_t pair = table.pairOf(s / table.sourceNodes, t / table.targetNodes);
                const std::size_t inBlock = s % table.sourceNodes * table.targetNodes + t % table.targetNodes;
                table.distances[pair * table.sourceNodes * table.targetNodes + inBlock] =
                    static_cast<float>(m_distances[(s - m_firstSource) * productRows + t - m_firstTarget]);
            }
        }
    }

private:
    std::size_t m_firstSource;
    std::size_t m_firstTarget;
    std::vector<double> m_scratch;
    std::vector<double> m_products;
    std::vector<double> m_distances;
};

} // namespace

SimilarityTable similarities(const MotionSpace& source, const MotionSpace& target,
                             const SimilaritySettings& settings, const Progress& progress)
{
    if (!(settings.velocityWeight >= 0) || !std::isfinite(settings.velocityWeight))
        refuse("The weight of velocities must not be negative", "The paper's weight is 1.");
    SpaceRows sourceRows = rowsOf(source, progress);
    SpaceRows targetRows = rowsOf(target, progress);
    centre(sourceRows.poses, targetRows.poses);
    centre(sourceRows.velocities, targetRows.velocities);

    SimilarityTable table{.sourceFrames = source.frameCount(),
                          .targetFrames = target.frameCount(),
                          .sourceNodes = source.weights.nodes().size(),
                          .targetNodes = target.weights.nodes().size()};
    table.leasts.resize(table.sourceFrames * table.targetFrames);
    table.distances.resize(table.leasts.size() * table.sourceNodes * table.targetNodes);
    const std::size_t down = (sourceRows.poses.count + productRows - 1) / productRows;
    const std::size_t across = (targetRows.poses.count + productRows - 1) / productRows;
    const double share = 1 / static_cast<double>(source.vertexCount());
    std::atomic<std::int64_t> done = 0;
    tbb::parallel_for(std::size_t{0}, down * across, [&](std::size_t task) {
        progress.report(done, static_cast<std::int64_t>(down * across));
        DistanceTile tile(task / across * productRows, task % across * productRows);
        tile.add(sourceRows.poses, targetRows.poses, share);
        tile.add(sourceRows.velocities, targetRows.velocities, share * settings.velocityWeight);
        tile.store(table);
        ++done;
    });
    for (std::size_t s = 0; s < table.sourceFrames; ++s)
        for (std::size_t t = 0; t < table.targetFrames; ++t)
            table.leasts[table.pairOf(s, t)] = std::ranges::min(table.block(s, t));
    table.greatest = std::ranges::max(table.distances);
    progress.report(1);
    return table;
}

} // namespace quadrille
