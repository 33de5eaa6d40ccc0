// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/findentry.h"
#include "model/project/document/framenote.h"
#include "tests/model/project/fulllive.h"
#include "tests/model/project/fullmotionspace.h"
#include "tests/model/project/fullprojection.h"
#include "tests/model/project/fulltransfer.h"
#include "tests/model/project/fullvariation.h"
#include "tests/model/project/testproject.h"

namespace quadrille::test {

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
    animation.search = {.budget = 5000,
                        .beta = 0.02,
                        .mu = 0.2,
                        .globalKeys = true,
                        .isPaper = true,
                        .dwell = 0.7,
                        .deadZone = 0.02,
                        .steering = 12};
    const NamedFrame from{"talk", FrameIndex(4)};
    const NamedFrame to{"talk", FrameIndex(30)};
    animation.junctions = {.banned = {{from, to}},
                           .locked = {{to, from}},
                           .chosen = {{from, from}},
                           .walk = {{"talk", {FrameIndex(2), FrameIndex(9)}}}};
    animation.walk = WalkEntry{
        .spans = {{"talk", {FrameIndex(0), FrameIndex(4)}}, {"talk", {FrameIndex(30), FrameIndex(38)}}},
        .turn = 90,
        .at = Vec2d(1, -2)};
    animation.interpolation = InterpolationMethod::Slerp;
    animation.gentleBlend = false;
    animation.post.variations = VariedRepeats{"chat", 0.3, {}};
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
    setNotes(animation.unknown, {{.frame = FrameIndex(12), .text = "the left hand slips", .unknown = {}}});
    return animation;
}

/// With every key that is known.
inline AppearanceEntry fullAppearance()
{
    AppearanceEntry entry;
    entry.name = "look";
    entry.character = "liam";
    entry.sequences = {"talk", "softly"};
    entry.components = 30;
    entry.warpShare = 0.25;
    entry.flow = FlowMethod::Dis;
    entry.reference = NamedFrame{"talk", FrameIndex(4)};
    entry.varied = VariedTextures::Nearest;
    CompletionEntry completion;
    completion.frame = {"softly", FrameIndex(7)};
    completion.mask = "masks/softly_7.png";
    MaskStrokeEntry stroke;
    stroke.points = {0.2, 0.3, 0.25, 0.31};
    stroke.radius = 0.04;
    stroke.erases = true;
    completion.strokes = {stroke};
    entry.completions = {completion};
    return entry;
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
    setNotes(talk.unknown, {{.frame = FrameIndex(5), .text = "blinks", .unknown = {}}});
    SequenceEntry again = sequenceOf("again", "clip:sequences/talk");
    again.character = "liam";
    SequenceEntry softly = sequenceOf("softly", "softly.pc2");
    softly.character = "liam";
    SequenceEntry softlyAgain = sequenceOf("softly again", "clip:sequences/softly");
    softlyAgain.character = "liam";
    project.sequences = {talk, again, softly, softlyAgain};
    GraphEntry graph;
    graph.character = "liam";
    graph.pose = {PoseMetric::Euclidean, 0.02};
    graph.cost = TransitionCost::Sum;
    graph.costScale = CostScale::None;
    graph.length = TransitionLength::Path;
    graph.steps = {.contacts = 0.3, .velocity = 0.02};
    graph.slope = 4;
    graph.durations = {0.5, 1.5};
    graph.alpha = 0.05;
    graph.smoothing = CostSmoothing::Mean5;
    graph.greatestDistance = 0.75;
    graph.pose.triangles = 1500;
    project.graphs = {graph};
    project.bodyParts = {fullBodyParts()};
    project.animations = {fullAnimation()};
    project.variations = {fullVariation()};
    project.motionSpaces = {fullMotionSpace()};
    project.lives = {fullLive()};
    project.appearances = {fullAppearance()};
    project.transfers = {fullTransfer()};
    project.projections = {fullProjection()};
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
