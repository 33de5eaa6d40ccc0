// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/procrustes.h"
#include "model/geometry/spreadpoints.h"
#include "model/project/document/findentry.h"
#include "tests/model/transition/posedistancetest.h"
#include "tests/model/transition/swayingtube.h"

#include <atomic>
#include <limits>
#include <optional>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

using namespace quadrille;
using namespace quadrille::test;

TEST(PoseDistances, DoesNotDependOnTilesThreadsAndSequences)
{
    // 60 frames make several tiles; the same frames come again among fewer, so in other tiles.
    const auto topology = tubeTopology(8, 20);
    const MeshSequence all = swayingTube(topology, 8, 60, 0.1);
    const MeshSequence head = all.cutTo({FrameIndex(0), FrameIndex(10)});
    const MeshSequence tail = all.cutTo({FrameIndex(11), FrameIndex(59)});
    const Table<float> whole = poseDistances(characterOf(all)).distances;
    const std::vector<MeshSequence> both{head, tail};
    const PoseDistances parts = poseDistances(CharacterFrames(both));
    EXPECT_TRUE((parts.distances == whole).all());
    EXPECT_EQ(parts.layout.sequenceCount(), 2);
    EXPECT_EQ(parts.layout.firstOf(1), 11);
    const Table<float> few = poseDistances(characterOf(tail)).distances;
    EXPECT_TRUE((few == whole.bottomRightCorner(49, 49)).all());
    tbb::task_arena(1).execute(
        [&] { EXPECT_TRUE((poseDistances(characterOf(all)).distances == whole).all()); });
    EXPECT_TRUE((whole == whole.transpose()).all());
}

TEST(PoseDistances, DoesNotDependOnHowManyColumnsATileHasAtOnce)
{
    // Tiles of 141 frames, of which 128 rows are aligned and 128 columns done before the others; then of 16.
    const MeshSequence all = swayingTube(tubeTopology(6, 6), 6, 1401, 0.01);
    const MeshSequence some = all.cutTo({FrameIndex(250), FrameIndex(310)});
    for (const PoseMetric metric : {PoseMetric::Surface, PoseMetric::Euclidean}) {
        const Table<float> whole = poseDistances(characterOf(all), {.metric = metric}).distances;
        const Table<float> few = poseDistances(characterOf(some), {.metric = metric}).distances;
        EXPECT_TRUE((few == whole.block(250, 250, 61, 61)).all());
        EXPECT_GT(few.maxCoeff(), 0);
    }
}

TEST(PoseDistances, OfTheFirstFramesAreTheFirstRowsOfAll)
{
    const CharacterFrames frames = characterOf(swayingTube(tubeTopology(8, 20), 8, 60, 0.1));
    for (const PoseMetric metric : {PoseMetric::Surface, PoseMetric::Euclidean}) {
        const Table<float> all = poseDistances(frames, {.metric = metric}).distances;
        for (const NodeIndex rows : {0, 1, 23, 60}) {
            const Table<float> first = poseDistancesOfFirst(frames, rows, {.metric = metric});
            ASSERT_EQ(first.rows(), rows);
            EXPECT_TRUE((first == all.topRows(rows)).all());
        }
    }
    EXPECT_THROW(poseDistancesOfFirst(frames, 5, {.stretchWeight = -1}), Error);
}

TEST(PoseDistances, AreTheSameInOnePassWithOthers)
{
    const CharacterFrames frames = characterOf(swayingTube(tubeTopology(8, 20), 8, 60, 0.1));
    const std::vector<PoseDistanceSettings> metrics{
        {}, {.metric = PoseMetric::Euclidean}, {.stretchWeight = 0.5}};
    const OfCovariance trace = [](const Eigen::Matrix3d& covariance) { return covariance.trace(); };
    const PosePairs all = posePairs(frames, metrics, trace);
    ASSERT_EQ(all.distances.size(), metrics.size());
    for (std::size_t m = 0; m < metrics.size(); ++m) {
        const PoseDistances own = poseDistances(frames, metrics[m]);
        EXPECT_TRUE((all.distances[m].distances == own.distances).all()) << m;
        EXPECT_EQ(all.distances[m].trianglesUsed, own.trianglesUsed);
    }
    EXPECT_FALSE((all.distances[0].distances == all.distances[2].distances).all());
    ASSERT_EQ(all.centres.size(), 60U);
    EXPECT_TRUE((posePairs(frames, {}, trace).ofCovariances == all.ofCovariances).all());
    EXPECT_EQ(posePairs(frames, metrics).ofCovariances.size(), 0);
    const auto centred = [&](NodeIndex node) {
        const Frame frame = frames.frame(node);
        Eigen::Matrix3Xd points(3, frame.positions().size());
        for (std::size_t v = 0; v < frame.positions().size(); ++v)
            points.col(static_cast<Eigen::Index>(v)) = frame.positions()[v].cast<double>();
        const Vec3d mean = points.rowwise().mean();
        EXPECT_LT((mean - all.centres[static_cast<std::size_t>(node)]).norm(), 1e-6);
        return Eigen::Matrix3Xd(points.colwise() - mean);
    };
    for (const auto& [i, j] : {std::pair<NodeIndex, NodeIndex>{0, 1}, {3, 40}, {17, 59}}) {
        const double expected = (centred(i).array() * centred(j).array()).sum();
        EXPECT_NEAR(all.ofCovariances(i, j), expected, 1e-5 * std::abs(expected));
        EXPECT_EQ(all.ofCovariances(i, j), all.ofCovariances(j, i));
    }
}

TEST(PoseDistances, AreMeansOverSomeTrianglesWhereSoManyAreCompared)
{
    const MeshSequence tube = swayingTube(tubeTopology(12, 60), 12, 40, 0.1);
    const CharacterFrames frames = characterOf(tube);
    const auto all = static_cast<std::int64_t>(frames.triangles().size());
    const std::vector<PoseDistanceSettings> metrics{{}, {.triangles = 300}, {.triangles = all}};
    const PosePairs pairs = posePairs(frames, metrics);
    const PoseDistances& whole = pairs.distances[0];
    const PoseDistances& some = pairs.distances[1];
    EXPECT_EQ(some.trianglesUsed, 300);
    EXPECT_EQ(some.trianglesLeftOut, all - 300);
    const auto compared = spreadTriangles(frames.triangles(), frames.frame(0).positions(), 300);
    const auto pose = [&](NodeIndex node) { return frames.frame(node); };
    for (const auto& [i, j] : {std::pair<NodeIndex, NodeIndex>{0, 1}, {3, 39}, {17, 20}})
        EXPECT_NEAR(some.distances(i, j), surfaceDistance(pose(i).positions(), pose(j).positions(), compared),
                    1e-5);
    // A fifth of the triangles says nearly the same.
    EXPECT_LT((some.distances - whole.distances).abs().maxCoeff(), 0.02F * whole.distances.maxCoeff());
    EXPECT_FALSE((some.distances == whole.distances).all());
    EXPECT_TRUE((pairs.distances[2].distances == whole.distances).all());
}

TEST(PoseDistances, AreMeansOverAsManyVertices)
{
    const CharacterFrames frames = characterOf(swayingTube(tubeTopology(12, 60), 12, 40, 0.1));
    const std::vector<PoseDistanceSettings> metrics{
        {.metric = PoseMetric::Euclidean},
        {.metric = PoseMetric::Euclidean, .triangles = 200},
        {.metric = PoseMetric::Euclidean, .triangles = frames.vertexCount()}};
    const PosePairs pairs = posePairs(frames, metrics);
    const Table<float>& whole = pairs.distances[0].distances;
    const Table<float>& some = pairs.distances[1].distances;
    const std::vector<std::size_t> compared = spreadPoints(frames.frame(0).positions(), 200);
    ASSERT_EQ(compared.size(), 200U);
    for (const auto& [i, j] : {std::pair<NodeIndex, NodeIndex>{0, 1}, {3, 39}, {17, 20}}) {
        const Frame a = frames.frame(i);
        const Frame b = frames.frame(j);
        // The whole bodies are laid onto each other.
        const RigidMotion align = rigidProcrustes(b.positions(), a.positions());
        double sum = 0;
        for (const std::size_t v : compared)
            sum += (a.positions()[v].cast<double>() - align(b.positions()[v].cast<double>())).norm();
        EXPECT_NEAR(some(i, j), sum / 200, 1e-6);
    }
    EXPECT_LT((some - whole).abs().maxCoeff(), 0.03F * whole.maxCoeff());
    EXPECT_FALSE((some == whole).all());
    EXPECT_TRUE((pairs.distances[2].distances == whole).all());
}

TEST(PoseDistances, AreByTheUsualTrianglesInGraphsOfManyFramesAlone)
{
    EXPECT_EQ(ofGraph({}, mostFramesByAll).triangles, std::nullopt);
    EXPECT_EQ(ofGraph({}, mostFramesByAll + 1).triangles, usualTriangles);
    EXPECT_EQ(ofGraph({.triangles = 7}, mostFramesByAll + 1).triangles, 7);
    const CharacterFrames many = characterOf(swayingTube(tubeTopology(20, 52), 20, mostFramesByAll + 1, 0.1));
    ASSERT_GT(many.vertexCount(), usualTriangles);
    for (const PoseMetric metric : {PoseMetric::Surface, PoseMetric::Euclidean}) {
        const auto ofFirst = [&](std::optional<std::int64_t> triangles) {
            return poseDistancesOfFirst(many, 2, {.metric = metric, .triangles = triangles});
        };
        EXPECT_FALSE((ofFirst({}) == ofFirst(usualTriangles)).all());
        EXPECT_TRUE((ofFirst({}) == ofFirst(1'000'000)).all());
    }
}

TEST(PoseDistances, SeldomReadsFramesAgainThatTheCacheDoesNotHold)
{
    /// Counts how often a frame is read.
    class CountedFrames : public FrameSource
    {
    public:
        explicit CountedFrames(MeshSequence sequence) : m_sequence(std::move(sequence)) {}
        std::int64_t frameCount() const override { return m_sequence.frameCount(); }
        std::uint32_t vertexCount() const override { return m_sequence.topology->vertexCount(); }
        void read(FrameIndex frame, MutablePositions out) const override
        {
            ++reads;
            m_sequence.source->read(frame, out);
        }
        mutable std::atomic<int> reads = 0;

    private:
        MeshSequence m_sequence;
    };
    const auto topology = tubeTopology(6, 6);
    const auto source = std::make_shared<CountedFrames>(swayingTube(topology, 6, 1600, 0.01));
    MediaCache& cache = *MediaCache::shared();
    const std::size_t budget = cache.statistics().budget;
    cache.setBudget(800 * topology->vertexCount() * sizeof(Vec3f)); // half of the frames
    tbb::task_arena(1).execute(
        [&] { poseDistances(characterOf(makeSequence("take", topology, source, 25))); });
    cache.setBudget(budget);
    // All frames once to look at them; then 55 tiles of 160 frames, each with a run of frames of its own if
    // it came row by row.
    EXPECT_LT(source->reads, 1600 + 55 * 160 * 6 / 10);
}

TEST(PoseDistances, LeavesOutTrianglesThatLoseTheirAreaInAnyFrame)
{
    const auto topology = topologyOf(5, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 4}});
    Pose first = corners;
    first.emplace_back(0.5F, -0.5F, 0.2F);
    Pose collapsed = moved(first, someMotion());
    collapsed[4] = collapsed[0];
    const PoseDistances result = poseDistances(characterOf(sequenceOf(topology, {first, first, collapsed})));
    EXPECT_EQ(result.trianglesUsed, 4);
    EXPECT_EQ(result.trianglesLeftOut, 1);
    EXPECT_TRUE(result.distances.isFinite().all());
    const Frame a(first, {});
    const auto& triangles = topology->triangles();
    EXPECT_NEAR(result.distances(0, 2), surfaceDistance(first, collapsed, std::span(triangles).first(4)),
                1e-6);
}

TEST(PoseDistances, RefusesACharacterWhoseTrianglesHaveNoArea)
{
    const MeshSequence sequence = sequenceOf(tetrahedron(), {corners, Pose(4, Vec3f(1, 2, 3))});
    EXPECT_EQ(codeOf([&] { poseDistances(characterOf(sequence)); }), ErrorCode::NoUsableTriangles);
    // The vertices still have distances: those of the corners from their mean.
    const double expected = (std::sqrt(3.0) / 4 + 3 * std::sqrt(11.0) / 4) / 4;
    EXPECT_NEAR(poseDistances(characterOf(sequence), {.metric = PoseMetric::Euclidean}).distances(0, 1),
                expected, 1e-6);
}

TEST(PoseDistances, OfOneFrameIsOneZero)
{
    const PoseDistances result = poseDistances(characterOf(sequenceOf(tetrahedron(), {corners})));
    ASSERT_EQ(result.distances.size(), 1);
    EXPECT_EQ(result.distances(0, 0), 0);
    EXPECT_EQ(result.trianglesUsed, 4);
    EXPECT_EQ(poseDistances(CharacterFrames({})).distances.size(), 0);
}

TEST(PoseDistances, RefusesTwoTopologies)
{
    const MeshSequence first = sequenceOf(tetrahedron(), {corners}, "walk");
    const auto expectRefusal = [&](const MeshSequence& other, const std::string& what) {
        const std::vector<MeshSequence> both{first, other};
        try {
            const CharacterFrames frames(both);
            FAIL() << "was taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::CharacterTopologyMismatch);
            EXPECT_NE(std::string(error.what()).find("“run” has another topology than “walk”: " + what),
                      std::string::npos)
                << error.what();
        }
    };
    expectRefusal(sequenceOf(topologyOf(3, {{0, 1, 2}}), {{corners[0], corners[1], corners[2]}}, "run"),
                  "3 vertices, not 4");
    expectRefusal(sequenceOf(topologyOf(4, {{0, 1, 2}}), {corners}, "run"), "1 triangles, not 4");
    expectRefusal(sequenceOf(topologyOf(4, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}), {corners}, "run"),
                  "its triangles have other corners");
    // Equal triangles are one topology, wherever they were read from.
    const std::vector<MeshSequence> same{first, sequenceOf(tetrahedron(), {corners}, "run")};
    EXPECT_EQ(CharacterFrames(same).frameCount(), 2);
}

TEST(PoseDistances, RefusesBadInput)
{
    Pose broken = corners;
    broken[2].y() = std::numeric_limits<float>::quiet_NaN();
    const MeshSequence sequence = sequenceOf(tetrahedron(), {corners, broken});
    EXPECT_EQ(codeOf([&] { poseDistances(characterOf(sequence)); }), ErrorCode::NonFiniteCoordinate);
    const CharacterFrames frames = characterOf(sequenceOf(tetrahedron(), {corners}));
    for (const double weight :
         {-0.1, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        EXPECT_EQ(codeOf([&] { poseDistances(frames, {.stretchWeight = weight}); }), ErrorCode::BadArgument);
    EXPECT_EQ(codeOf([&] { poseDistances(frames, {.triangles = 0}); }), ErrorCode::BadArgument);
    MeshSequence empty = sequenceOf(tetrahedron(), {corners});
    empty.range = {};
    EXPECT_EQ(codeOf([&] { characterOf(empty); }), ErrorCode::BadArgument);
}

TEST(PoseDistances, CanBeCancelledAtAnyTime)
{
    const CharacterFrames frames = characterOf(swayingTube(tubeTopology(8, 20), 8, 60, 0.1));
    for (const double when : {0.0, 0.01, 0.3, 0.9}) {
        CancelToken token;
        const Progress progress(token, [&](double fraction) {
            if (fraction >= when)
                token.cancel();
        });
        EXPECT_EQ(codeOf([&] { poseDistances(frames, {}, progress); }), ErrorCode::Cancelled);
    }
}

TEST(PoseDistances, ReportsItsProgressInSmallSteps)
{
    // Of several threads one may be held up between its work and its report, and others tell of both.
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const CharacterFrames frames = characterOf(swayingTube(tubeTopology(8, 20), 8, 60, 0.1));
    double before = 0;
    double largest = 0;
    poseDistances(frames, {}, Progress(CancelToken(), [&](double fraction) {
                      largest = std::max(largest, fraction - before);
                      before = fraction;
                  }));
    EXPECT_EQ(before, 1);
    EXPECT_LT(largest, 0.05);
}
