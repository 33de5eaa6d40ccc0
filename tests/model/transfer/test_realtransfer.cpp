// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/bounds.h"
#include "model/sequence/contacts.h"
#include "model/sequence/io/registry.h"
#include "tests/model/transfer/transferfixture.h"

#include <array>
#include <gtest/gtest.h>
#include <limits>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Two bodies that perform the same takes in one order of vertices: what a transfer ought to give is known.
class TransferOfTakes : public testing::Test
{
protected:
    void SetUp() override
    {
        m_folder = std::filesystem::path(QUADRILLE_DATA_DIR) / "characters/mh_male";
        if (!std::filesystem::exists(m_folder))
            GTEST_SKIP() << "no real takes";
    }

    MeshSequence take(const std::string& body, const std::string& name) const
    {
        ImportOptions options;
        options.mesh = m_folder / ("rest_" + body + ".obj");
        options.fps = 30;
        MeshSequence sequence =
            openSequences(m_folder / (body + "__" + name + ".pc2"), options).sequences.front();
        sequence.contacts = detectContacts(sequence);
        return sequence;
    }

    static PosedMesh poseOf(const MeshSequence& sequence, FrameIndex frame)
    {
        const Frame pose = sequence.frame(frame);
        return {sequence.topology, {pose.positions().begin(), pose.positions().end()}};
    }

    /// Marks that lie far from each other, or all triangles.
    static std::vector<TrianglePair> pairsOn(const PosedMesh& mesh, std::size_t count)
    {
        std::vector<Vec3f> middles;
        for (const Triangle& t : mesh.topology->triangles())
            middles.emplace_back(
                (mesh.positions[t[0].value] + mesh.positions[t[1].value] + mesh.positions[t[2].value]) / 3);
        std::vector<TrianglePair> pairs;
        std::vector<float> distances(middles.size(), std::numeric_limits<float>::infinity());
        std::size_t next = 0;
        while (pairs.size() < std::min(count, middles.size())) {
            pairs.push_back({TriangleIndex(next), TriangleIndex(next)});
            for (std::size_t t = 0; t < middles.size(); ++t)
                distances[t] = std::min(distances[t], (middles[t] - middles[next]).squaredNorm());
            distances[next] = -1;
            next = static_cast<std::size_t>(std::ranges::max_element(distances) - distances.begin());
        }
        return pairs;
    }

    /// Mean distance of the vertices from where they ought to be, wherever the body as a whole is, averaged
    /// over a take; percent of the target's height. \param target  the body of the truth in some pose.
    static double meanError(const MeshSequence& clip, const PosedMesh& reference, const PosedMesh& target,
                            const MeshSequence& truth, std::size_t marks, const TransferSettings& settings)
    {
        return meanError(transferClip(clip, reference, target, pairsOn(target, marks), settings), clip,
                         target, truth);
    }
    static double meanError(const Transferred& result, const MeshSequence& clip, const PosedMesh& target,
                            const MeshSequence& truth)
    {
        double sum = 0;
        const std::size_t vertices = target.positions.size();
        for (FrameIndex f(0); f.value < clip.frameCount(); ++f) {
            const Frame expected = truth.frame(f);
            const Positions made =
                Positions(result.positions).subspan(static_cast<std::size_t>(f.value) * vertices, vertices);
            const Vec3d shift = centroid(expected.positions()) - centroid(made);
            for (std::size_t v = 0; v < vertices; ++v)
                sum += (made[v].cast<double>() + shift - expected.positions()[v].cast<double>()).norm();
        }
        const double height = boundsOf(truth.frame(FrameIndex(0)).positions()).size().y();
        return 100 * sum / static_cast<double>(vertices) / static_cast<double>(clip.frameCount()) / height;
    }
    /// Both bodies in one frame to begin with.
    static double meanError(const MeshSequence& clip, const MeshSequence& truth, std::size_t marks,
                            FieldKind kind, FrameIndex like)
    {
        return meanError(clip, poseOf(clip, like), poseOf(truth, like), truth, marks, {.field = kind});
    }

    std::filesystem::path m_folder;
};

} // namespace

TEST_F(TransferOfTakes, OntoTheTemplateItselfStaysUnderAHundredthOfItsHeight)
{
    const MeshSequence walk = take("m_avg", "walk");
    for (const FieldKind kind : {FieldKind::Quaternions, FieldKind::Logarithms}) {
        const double marks = meanError(walk, walk, 50, kind, FrameIndex(0));
        RecordProperty("percentWith50Marks", std::to_string(marks));
        EXPECT_LT(marks, 1);
    }
    // What rotations alone can say.
    EXPECT_LT(meanError(walk, walk, 1'000'000, FieldKind::Quaternions, FrameIndex(0)), 0.25);
}

TEST_F(TransferOfTakes, OntoAnotherBodyIsNearlyAsNear)
{
    for (const auto& [name, like, limit] : {std::tuple("walk", 0, 1.0), {"reach_high", 20, 1.0}}) {
        EXPECT_LT(meanError(take("m_avg", name), take("m_heavy", name), 50, FieldKind::Quaternions,
                            FrameIndex(like)),
                  limit)
            << name;
    }
}

TEST_F(TransferOfTakes, WalksAsFarAndAsHighAsTheOtherBody)
{
    const MeshSequence clip = take("m_avg", "walk");
    const MeshSequence truth = take("m_heavy", "walk");
    const PosedMesh target = poseOf(truth, FrameIndex(0));
    const Transferred result = transferClip(clip, poseOf(clip, FrameIndex(0)), target, pairsOn(target, 50));
    const std::size_t vertices = target.positions.size();
    const auto centreOf = [&](std::int64_t f) {
        return centroid(
            Positions(result.positions).subspan(static_cast<std::size_t>(f) * vertices, vertices));
    };
    const std::int64_t last = clip.frameCount() - 1;
    const Vec3d way = centreOf(last) - centreOf(0);
    const Vec3d expected = centroid(truth.frame(FrameIndex(last)).positions()) -
                           centroid(truth.frame(FrameIndex(0)).positions());
    // The feet of both bodies slide in these takes, so steps say no better how far it is.
    EXPECT_LT((way - expected).norm(), 0.1 * expected.norm());
}

/// Chosen on a walk onto frame 20 of reach_high; told here of others.
TEST_F(TransferOfTakes, PosesThatDifferAreCorrected)
{
    for (const auto& [performed, posed, frame] :
         {std::tuple("walk", "reach_high", 40), {"kick", "walk", 0}}) {
        const MeshSequence clip = take("m_avg", performed);
        const MeshSequence truth = take("m_heavy", performed);
        const PosedMesh target = poseOf(take("m_heavy", posed), FrameIndex(frame));
        const PosedMesh reference = poseOf(clip, FrameIndex(20));
        const double plain = meanError(clip, reference, target, truth, 60, {.correctsPose = false});
        const double corrected = meanError(clip, reference, target, truth, 60, {});
        RecordProperty(performed, std::to_string(plain) + " to " + std::to_string(corrected));
        EXPECT_LT(corrected, plain / 3) << performed;
    }
}

/// How far what is near a mark reaches was chosen on walk and reach_high; kick tells of others.
TEST_F(TransferOfTakes, StretchBringsBendsNearerToTheTruth)
{
    for (const auto& [name, like] : {std::pair("walk", 0), {"reach_high", 20}, {"kick", 0}}) {
        const MeshSequence clip = take("m_avg", name);
        const MeshSequence truth = take("m_heavy", name);
        const PosedMesh reference = poseOf(clip, FrameIndex(like));
        const PosedMesh target = poseOf(truth, FrameIndex(like));
        std::array<double, 2> errors{};
        std::array<double, 2> losses{};
        for (const bool carries : {false, true}) {
            const Transferred result =
                transferClip(clip, reference, target, pairsOn(target, 50), {.carriesStretch = carries});
            errors[carries ? 1 : 0] = meanError(result, clip, target, truth);
            for (const double volume : result.volume)
                losses[carries ? 1 : 0] += (1 - volume) / static_cast<double>(result.volume.size());
        }
        RecordProperty(name, std::to_string(errors[0]) + " to " + std::to_string(errors[1]) +
                                 ", volume lost " + std::to_string(losses[0]) + " to " +
                                 std::to_string(losses[1]));
        EXPECT_LT(errors[1], errors[0]) << name;
        EXPECT_LT(losses[1], 0.97 * losses[0]) << name;
        EXPECT_GT(losses[1], 0) << name;
    }
}
