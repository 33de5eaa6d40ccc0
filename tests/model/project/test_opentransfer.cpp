// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/bounds.h"
#include "model/geometry/procrustes.h"
#include "model/project/results/opentransfer.h"
#include "model/project/steps/transferbodies.h"
#include "model/sample/sample.h"
#include "tests/model/codeof.h"
#include "tests/model/project/transferproject.h"

#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace {

std::vector<Vec3f> poseOf(const MeshSequence& sequence, std::int64_t frame)
{
    const Frame pose = sequence.frame(FrameIndex(frame));
    return {pose.positions().begin(), pose.positions().end()};
}

/// A mesh as the text of a file.
std::string objOf(const Topology& mesh, Positions positions)
{
    std::string text;
    for (const Vec3f& p : positions)
        text +=
            "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + "\n";
    for (const Triangle& t : mesh.triangles()) {
        text += "f";
        for (const VertexIndex corner : t)
            text += " " + std::to_string(corner.value + 1);
        text += "\n";
    }
    return text;
}

class OpenTransfer : public TransferProject
{
protected:
    TransferPreviewPointer preview(const TransferPreviewPointer& before = nullptr) const
    {
        return previewTransfer(ProjectResults({project, folder / "p.quadrille"}), "slowly", before);
    }
    /// The strips become the bodies of the sample: both have two arms and two legs.
    void takeBodies()
    {
        static const SampleCharacter sample = makeSampleCharacter({.textureSize = 64, .takesPerKind = 1});
        const MeshSequence& take = sample.takes.front().sequence;
        for (int f = 0; f < 2; ++f)
            folder.write("slow/f_" + std::to_string(f) + ".obj", objOf(*take.topology, poseOf(take, f)));
        for (int f = 2; f < 14; ++f)
            std::filesystem::remove(folder / ("slow/f_" + std::to_string(f) + ".obj"));
        folder.write("scan.obj", objOf(*sample.target.topology, sample.target.rest));
        project.sequences.erase(project.sequences.begin() + 1);
        transfer().pairs.clear();
    }
};

} // namespace

TEST_F(OpenTransfer, ShowsThePosesOfTheResult)
{
    project.settings.axes.metresPerUnit = 0.01;
    for (const FieldKind field : {FieldKind::Quaternions, FieldKind::Logarithms}) {
        transfer().field = field;
        transfer().pairs.resize(5);
        transfer().scale = 1.5; // which steps have a say in otherwise
        const TransferPreviewPointer shown = preview();
        ASSERT_FALSE(shown->failure) << shown->failure->what();
        const TransferResultPointer made =
            openTransfer(ProjectResults({project, folder / "p.quadrille"}), "slowly");
        ASSERT_EQ(shown->posed->frameCount(), 14);
        ASSERT_EQ(made->sequence.frameCount(), 14);
        for (std::int64_t f = 0; f < 14; ++f) {
            const std::vector<Vec3f> live = poseOf(*shown->posed, f);
            const std::vector<Vec3f> stored = poseOf(made->sequence, f);
            const float height = stored[0].y() - live[0].y(); // is evened over time
            for (std::size_t v = 0; v < live.size(); ++v)
                EXPECT_LT((live[v] + Vec3f(0, height, 0) - stored[v]).norm(), 1e-4F) << f;
        }
        EXPECT_EQ(made->entry, transfer());
        EXPECT_EQ(made->report.name, "report");
    }
}

TEST_F(OpenTransfer, ShowsBothBodiesInTheMiddleOfTheGround)
{
    transfer().reference = NamedFrame{"slow", FrameIndex(4)};
    const TransferPreviewPointer shown = preview();
    for (const MeshSequence* body : {&shown->rest, &shown->reference}) {
        ASSERT_EQ(body->frameCount(), 1);
        const Bounds bounds = boundsOf(poseOf(*body, 0));
        EXPECT_NEAR(bounds.center().x(), 0, 1e-6);
        EXPECT_NEAR(bounds.min.y(), 0, 1e-6);
        EXPECT_NEAR(bounds.center().z(), 0, 1e-6);
    }
    // A template that does not move is still in the pose of the entry.
    const std::vector<Vec3f> reference = poseOf(shown->reference, 0);
    const std::vector<Vec3f> captured = poseOf(shown->performed, 4);
    const Vec3f shift = captured[0] - reference[0];
    for (std::size_t v = 0; v < reference.size(); ++v)
        EXPECT_LT((reference[v] + shift - captured[v]).norm(), 1e-6F);
}

TEST_F(OpenTransfer, ShowsBothBodiesBeforeTheTargetIsPrepared)
{
    takeBodies();
    std::vector<TransferPreviewPointer> looks;
    const auto look = [&](const TransferPreviewPointer& before) {
        return previewTransfer(ProjectResults({project, folder / "p.quadrille"}), "slowly", before, {},
                               [&looks](TransferPreviewPointer seen) { looks.push_back(std::move(seen)); });
    };
    const TransferPreviewPointer whole = look(nullptr);
    ASSERT_EQ(looks.size(), 1U);
    EXPECT_FALSE(looks[0]->posed || looks[0]->failure || looks[0]->solid);
    EXPECT_THAT(looks[0]->pairs, IsEmpty());
    EXPECT_EQ(looks[0]->rest.source->vertexCount(), whole->rest.source->vertexCount());
    EXPECT_EQ(looks[0]->reference.source->vertexCount(), whole->reference.source->vertexCount());
    // Whoever was stopped there begins anew.
    const TransferPreviewPointer again = look(looks[0]);
    EXPECT_EQ(looks.size(), 2U);
    EXPECT_TRUE(again->posed && again->solid && again->targetPlaces && again->templatePlaces);
    look(again);
    EXPECT_EQ(looks.size(), 2U);
}

TEST_F(OpenTransfer, TakesPartsThatStillHoldAgain)
{
    takeBodies();
    const TransferPreviewPointer first = preview();
    ASSERT_FALSE(first->failure) << first->failure->what();
    ASSERT_TRUE(first->solid && first->templatePlaces && first->targetPlaces);
    ASSERT_GT(first->pairs.size(), 50U);
    EXPECT_FALSE(std::isnan(first->pairs.front().quality));

    for (const ProposedPair& proposed : first->pairs)
        transfer().pairs.push_back(proposed.pair);
    transfer().pairs.pop_back();
    const TransferPreviewPointer edited = preview(first);
    EXPECT_EQ(edited->solid, first->solid);
    EXPECT_EQ(edited->templatePlaces, first->templatePlaces);
    EXPECT_EQ(edited->targetPlaces, first->targetPlaces);
    ASSERT_EQ(edited->pairs.size() + 1, first->pairs.size());
    // Those by hand are rated as those that are proposed.
    for (std::size_t i = 0; i < edited->pairs.size(); ++i)
        EXPECT_NEAR(edited->pairs[i].quality, first->pairs[i].quality, 1e-9);
    ASSERT_TRUE(edited->posed);
    EXPECT_EQ(poseOf(*edited->posed, 1), poseOf(*preview()->posed, 1)) << "parts make a difference";

    // Another frame, or another mesh, is another target; the template is the same.
    transfer().target = {"slow", FrameIndex(1)};
    transfer().pairs.clear();
    transfer().reference = NamedFrame{"slow", FrameIndex(1)};
    const TransferPreviewPointer other = preview(edited);
    EXPECT_NE(other->solid, first->solid);
    EXPECT_NE(other->targetPlaces, first->targetPlaces);
    EXPECT_EQ(other->templatePlaces, first->templatePlaces);
    EXPECT_FALSE(other->failure) << other->failure->what();
    transfer().target.frame = FrameIndex(0);
    const TransferPreviewPointer last = preview(other);
    EXPECT_NE(last->solid, other->solid);

    // The template is another one as well; it has no limbs.
    folder.write("strip.obj", bentStrip(0.2));
    project.characters.push_back(characterOf("limbless", ""));
    project.sequences.push_back(sequenceOf("strip", "strip.obj"));
    project.sequences.back().character = "limbless";
    transfer().clip = "sequences/strip";
    transfer().reference.reset();
    const TransferPreviewPointer strip = preview(last);
    EXPECT_EQ(strip->templatePlaces, nullptr);
    EXPECT_EQ(strip->solid, last->solid);
}

TEST_F(OpenTransfer, SaysWhyNothingIsPosed)
{
    const TransferPreviewPointer whole = preview();
    ASSERT_TRUE(whole->posed);
    EXPECT_EQ(whole->templatePlaces, nullptr); // a strip has no limbs
    transfer().pairs.clear();
    const TransferPreviewPointer shown = preview(whole);
    ASSERT_TRUE(shown->failure);
    EXPECT_EQ(shown->failure->code(), ErrorCode::TransferNoLimbsOfTemplate);
    EXPECT_FALSE(shown->posed);
    EXPECT_THAT(shown->pairs, IsEmpty());
    EXPECT_EQ(shown->rest.frameCount(), 1);
    EXPECT_EQ(shown->reference.frameCount(), 1);
    EXPECT_EQ(shown->performed.frameCount(), 14);
    transfer().pairs = whole->entry.pairs;
    EXPECT_FALSE(preview(shown)->failure);
}

TEST_F(OpenTransfer, RefusesWhatCannotBeOpened)
{
    transfer().target.frame = FrameIndex(3);
    EXPECT_EQ(codeOf([&] { preview(); }), ErrorCode::ProjectInvalid);
    transfer().name = "quickly";
    EXPECT_EQ(codeOf([&] { preview(); }), ErrorCode::ProjectInvalid);
}

/// Of long takes not every frame is compared at first; the best is found all the same.
TEST_F(OpenTransfer, FindsTheMostAlikePoseOfManyFrames)
{
    constexpr int frames = 1250;
    constexpr double bend = 0.0005;
    for (int f = 0; f < frames; ++f)
        folder.write("long/f_" + std::to_string(f) + ".obj", bentStrip(bend * f));
    project.characters = {characterOf("strip", ""), characterOf("scan", "")};
    project.sequences[0].source = "long";
    for (SequenceEntry& sequence : project.sequences)
        sequence.character = sequence.name == "scan" ? "scan" : "strip";
    // With the other take these are some 1260 frames, of which every third is compared.
    for (const int like : {400, 401, 402, frames - 1}) {
        folder.write("scan.obj", bentStrip(bend * like, 2));
        SequenceOpener opened = opener();
        const TransferBodies bodies(opened, transfer(), {});
        std::string told;
        const PosedMesh found =
            bodies.referencePose(transfer().pairs, [&](const std::string& text) { told += text; }, {});
        EXPECT_THAT(told, HasSubstr("frame " + std::to_string(like) + " of “slow”"));
        EXPECT_EQ(found.positions, poseOf(bodies.performed(), like));
    }
}
