// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/file.h"
#include "model/project/pictureoptions.h"
#include "model/project/project.h"

#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace quadrille::test {

/// A new empty folder for one test, removed with it.
class TemporaryFolder
{
public:
    TemporaryFolder()
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "quadrille-test-XXXXXX").string();
        m_path = ::mkdtemp(pattern.data());
    }
    ~TemporaryFolder()
    {
        std::error_code error;
        std::filesystem::remove_all(m_path, error);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return m_path; }
    std::filesystem::path operator/(const std::string& name) const { return m_path / name; }
    /// Writes a text file and returns its path.
    std::filesystem::path write(const std::string& name, std::string_view text) const
    {
        writeAtomically(m_path / name, text);
        return m_path / name;
    }

private:
    std::filesystem::path m_path;
};

inline std::string textOf(const std::filesystem::path& file)
{
    return std::string(readFile(file).text());
}

inline CharacterEntry characterOf(std::string name, std::string mesh)
{
    CharacterEntry character;
    character.name = std::move(name);
    character.mesh = std::move(mesh);
    return character;
}

inline SequenceEntry sequenceOf(std::string name, std::string source)
{
    SequenceEntry sequence;
    sequence.name = std::move(name);
    sequence.source = std::move(source);
    return sequence;
}

inline TextureReference textureOf(TextureReference::Kind kind, std::vector<std::string> paths)
{
    TextureReference texture;
    texture.kind = kind;
    texture.paths = std::move(paths);
    return texture;
}

/// An animation in which every known key has a value that is not the default. \pre z is up.
inline AnimationEntry fullAnimation()
{
    const auto choice = [](std::string label) {
        FrameChoice frames;
        frames.label = std::move(label);
        return frames;
    };
    AnimationEntry animation;
    animation.name = "tour";
    animation.character = "liam";
    animation.start = FrameChoice{"", "talk", FrameRange{FrameIndex(0), FrameIndex(9)}};
    PathEntry path;
    path.curve = PathCurve::Polyline;
    path.points = {{0, 0, 0}, {1, 2, 0}, {3, 2.5, 0}};
    path.spans = {{.from = 0.5, .to = 1.5, .frames = choice("nod"), .duration = 2}};
    path.obstacles = {{.corners = {Vec2d(1, 1)}, .radius = 0.3},
                      {.corners = {Vec2d(0, 0), Vec2d(1, 0), Vec2d(0, 1)}}};
    path.clearance = 0.25;
    KeyEntry key;
    key.sequence = "talk";
    key.frame = FrameIndex(7);
    key.time = 1.25;
    key.tolerance = 0.1;
    ActionEntry action;
    action.frames = {"", "talk", FrameRange{FrameIndex(3), FrameIndex(20)}};
    action.repeat = 2;
    action.duration = 3;
    action.leastShare = 0.75;
    animation.constraints = {path, key, action};
    animation.search = {.budget = 5000, .beta = 0.02, .mu = 0.2, .globalKeys = true};
    const NamedFrame from{"talk", FrameIndex(4)};
    const NamedFrame to{"talk", FrameIndex(30)};
    animation.junctions = {.banned = {{from, to}}, .locked = {{to, from}}, .chosen = {{from, from}}};
    animation.walk = WalkEntry{
        .spans = {{"talk", {FrameIndex(0), FrameIndex(4)}}, {"talk", {FrameIndex(30), FrameIndex(38)}}},
        .turn = 90,
        .at = Vec2d(1, -2)};
    animation.interpolation = InterpolationMethod::Slerp;
    animation.gentleBlend = true;
    animation.post.steps.loop = LoopSettings{Seconds{0.5}, Seconds{0.25}, true};
    animation.post.steps.contacts = ContactCorrectionSettings{0.5, 0.1, 0.05, 0.2, 0.01};
    animation.post.steps.mirror = true;
    animation.post.symmetry = "liam/opposite.csv";
    animation.post.steps.repeats = 3;
    animation.post.steps.retime =
        RetimeSettings{RetimeSettings::Curve{{Seconds{0}, Seconds{0}}, {Seconds{2}, Seconds{1}}}, true};
    AudioEntry audio;
    audio.file = "liam/song.wav";
    audio.offset = -0.5;
    audio.gain = -6;
    animation.audio = audio;
    CameraKeyEntry camera;
    camera.key = {.time = 1.5,
                  .target = {0, 0.25, 1},
                  .distance = 3.5,
                  .azimuth = 45,
                  .elevation = 10,
                  .fieldOfView = 40};
    animation.camera = {camera};
    return animation;
}

inline BodyPartsEntry fullBodyParts()
{
    const auto ring = [](std::string name, std::uint32_t first) {
        PartCurveEntry entry;
        entry.curve.name = std::move(name);
        entry.curve.vertices = {VertexIndex(first), VertexIndex(first + 1), VertexIndex(first + 2)};
        entry.points = {VertexIndex(first), VertexIndex(first + 2)};
        return entry;
    };
    const auto part = [](std::string name, std::string parent, std::vector<std::string> curves) {
        PartEntry entry;
        entry.part = {std::move(name), std::move(parent), std::move(curves)};
        return entry;
    };
    BodyPartsEntry parts;
    parts.character = "liam";
    parts.pose = NamedFrame{"talk", FrameIndex(3)};
    parts.curves = {ring("shoulder", 0), ring("upper arm", 10)};
    parts.parts = {part("torso", "", {}), part("arm", "torso", {"shoulder", "upper arm"})};
    return parts;
}

/// Variations in which every known key has a value that is not the default.
inline VariationEntry fullVariation()
{
    VariationEntry variation;
    variation.name = "chat";
    variation.character = "liam";
    TrainingEntry talk;
    talk.sequence = "talk";
    talk.range = FrameRange{FrameIndex(0), FrameIndex(30)};
    TrainingEntry again;
    again.sequence = "again";
    variation.training = {talk, again};
    variation.reference = "again";
    variation.templatePose = NamedFrame{"talk", FrameIndex(5)};
    variation.cycles = false;
    BlendEntry blend;
    blend.from = "talk";
    blend.to = "again";
    blend.weights = {0.25, 0.75};
    variation.blends = {blend};
    variation.displacementShare = 3;
    variation.learning = {.dimensions = 4,
                          .restarts = 2,
                          .seed = 7,
                          .tolerance = 1e-5,
                          .window = 20,
                          .greatestIterations = 500};
    variation.chain.leapfrogSteps = 10;
    variation.chain.burnIn = 50;
    variation.chain.thinning = 5;
    variation.chain.leastAcceptance = 0.65;
    variation.chain.greatestAcceptance = 0.85;
    SamplesEntry samples;
    samples.of = "talk";
    samples.to = "again";
    samples.weight = 0.3;
    samples.count = 3;
    samples.seed = 2;
    samples.discarded = {2};
    variation.samples = {samples};
    variation.draw = PoseDraw::Sample;
    variation.limits = {.poseDistance = 0.1, .skate = 0.2, .intersections = 0.02, .volumeChange = 0.3};
    return variation;
}

/// A project in which every known key of the file has a value that is not the default.
inline Project fullProject()
{
    const CoordinateSystem zUpCentimetres{UpAxis::Z, 0.01};
    Project project;
    project.settings.fps = 30;
    project.settings.axes = zUpCentimetres;
    project.settings.cacheMegabytes = 256;
    project.characters = {characterOf("liam", "liam/mesh.obj"), characterOf("fox", "fox.obj")};
    project.characters[0].texture = textureOf(TextureReference::Kind::Single, {"liam/texture.png"});
    project.characters[0].notes = "talks";
    project.characters[1].texture = textureOf(TextureReference::Kind::PerMaterial, {"fur.png", "eyes.png"});
    SequenceEntry talk = sequenceOf("talk", "liam/talk_a.pc2");
    talk.character = "liam";
    talk.clip = "Take 1";
    talk.range = FrameRange{FrameIndex(2), FrameIndex(40)};
    talk.sourceFps = 29.97;
    talk.sourceAxes = CoordinateSystem{UpAxis::Y, 0.5};
    talk.texture = textureOf(TextureReference::Kind::PerFrame, {"liam/textures/talk_a"});
    talk.labels = {{"talk", {FrameIndex(0), FrameIndex(20)}}, {"nod", {FrameIndex(21), FrameIndex(38)}}};
    talk.contacts = {{"left", {FrameIndex(0), FrameIndex(38)}}};
    talk.jointAngles = "liam/talk_a.bvh";
    SequenceEntry again = sequenceOf("again", "clip:sequences/talk");
    again.character = "liam";
    project.sequences = {talk, again};
    GraphEntry graph;
    graph.character = "liam";
    graph.pose = {PoseMetric::Euclidean, 0.02};
    graph.cost = TransitionCost::Mean;
    graph.costScale = CostScale::Liveliness;
    graph.slope = 4;
    graph.durations = {0.5, 1.5};
    graph.alpha = 0.05;
    graph.greatestDistance = 0.75;
    project.graphs = {graph};
    project.bodyParts = {fullBodyParts()};
    project.animations = {fullAnimation()};
    project.variations = {fullVariation()};
    EvaluationEntry evaluation;
    evaluation.table = "fig9";
    evaluation.character = "liam";
    evaluation.sequences = {"talk", "again"};
    evaluation.alphas = {0.01, 0.1};
    evaluation.count = 7;
    evaluation.seed = 3;
    project.evaluations = {evaluation};
    ExportEntry entry;
    entry.name = "talk-ply";
    entry.what = "sequences/talk";
    entry.path = "out/talk.ply";
    entry.format = "ply";
    entry.range = FrameRange{FrameIndex(0), FrameIndex(3)};
    entry.fps = 12.5;
    entry.axes = CoordinateSystem{UpAxis::Y, 1.0};
    entry.textures = false;
    RenderSettings picture;
    picture.look.width = 640;
    picture.look.shading = RenderOptions::Shading::Clay;
    picture.camera = CameraMode::Follow;
    picture.view = Camera{};
    entry.picture = pictureToJson(picture);
    project.exports = {entry};
    return project;
}

} // namespace quadrille::test
