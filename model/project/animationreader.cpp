// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/animationjson.h"
#include "model/project/framenote.h"
#include "model/project/groundpoint.h"
#include "model/project/projectkeys.h"

#include <algorithm>

namespace quadrille {

namespace {

constexpr auto twoCoordinates = "two coordinates on the ground, in the project's unit";

std::optional<Vec2d> readGroundPoint(const ObjectReader& reader, std::string_view key)
{
    const auto numbers = reader.numbers(key, 2, twoCoordinates);
    return numbers ? std::optional(Vec2d((*numbers)[0], (*numbers)[1])) : std::nullopt;
}

/// Points of two numbers each, or of three where `inSpace` comes out true.
std::vector<Vec3d> readPoints(const ObjectReader& reader, std::string_view key, bool& inSpace)
{
    std::vector<Vec3d> points;
    reader.each(key, [&](const Json& json, const std::string& pointer) {
        const bool isPoint =
            json.is_array() && (json.size() == 2 || json.size() == 3) &&
            std::all_of(json.begin(), json.end(), [](const Json& number) { return number.is_number(); });
        if (!isPoint) {
            reader.invalid(pointer, "A point in brackets is expected here",
                           "Write two coordinates on the ground, or three in space, in the project's unit.");
            return;
        }
        if (points.empty())
            inSpace = json.size() == 3;
        else if (inSpace != (json.size() == 3))
            reader.invalid(pointer, "The points of a path must all have two coordinates, or all three");
        points.emplace_back(json[0].get<double>(), json[1].get<double>(),
                            json.size() == 3 ? json[2].get<double>() : 0.0);
    });
    return points;
}

/// "label", or "sequence" with or without "range"; nothing where neither is there.
std::optional<FrameChoice> readChoice(const ObjectReader& reader)
{
    FrameChoice choice{
        .label = reader.text("label"), .sequence = reader.text("sequence"), .range = reader.range("range")};
    if (!choice.label.empty() && !choice.sequence.empty())
        reader.invalid(reader.pointer("sequence"), "“label” and “sequence” stand together here",
                       "Keep one of them.");
    if (choice.range && choice.sequence.empty())
        reader.invalid(reader.pointer("range"), "The range belongs to no sequence", "Name the “sequence”.");
    return choice == FrameChoice() ? std::nullopt : std::optional(choice);
}

KeyEntry readKey(const ObjectReader& reader)
{
    KeyEntry key{.sequence = reader.requiredText("sequence")};
    const auto frame = reader.wholeNumber("frame");
    if (!frame)
        reader.missing("frame");
    key.frame = FrameIndex(frame.value_or(0));
    const auto time = reader.number("time");
    if (!time)
        reader.missing("time");
    key.time = time.value_or(0);
    key.tolerance = reader.number("tolerance");
    key.unknown = reader.unknown(projectkeys::key);
    return key;
}

PathSpanEntry readPathSpan(const ObjectReader& reader)
{
    PathSpanEntry span;
    span.from = reader.number("from").value_or(0);
    if (reader.find("to") == nullptr)
        reader.missing("to");
    span.to = reader.number("to").value_or(0);
    span.frames = readChoice(reader);
    span.duration = reader.number("duration");
    span.unknown = reader.unknown(projectkeys::pathSpan);
    return span;
}

ObstacleEntry readObstacle(const ObjectReader& reader)
{
    ObstacleEntry obstacle;
    if (reader.find("polygon") != nullptr) {
        bool inSpace = false;
        for (const Vec3d& corner : readPoints(reader, "polygon", inSpace))
            obstacle.corners.emplace_back(corner.head<2>());
        if (inSpace)
            reader.wrongType("polygon", "a list of points with " + std::string(twoCoordinates));
    } else {
        const auto centre = readGroundPoint(reader, "centre");
        if (!centre)
            reader.missing("centre");
        obstacle.corners = {centre.value_or(Vec2d::Zero())};
        const auto radius = reader.number("radius");
        if (!radius)
            reader.missing("radius");
        obstacle.radius = radius.value_or(0);
    }
    obstacle.unknown = reader.unknown(projectkeys::obstacle);
    return obstacle;
}

PathEntry readPath(const ObjectReader& reader, UpAxis up)
{
    PathEntry path;
    reader.word("curve", path.curve,
                {{"catmull-rom", PathCurve::CatmullRom},
                 {"polyline", PathCurve::Polyline},
                 {"bezier", PathCurve::Bezier}});
    if (reader.find("points") == nullptr)
        reader.missing("points");
    path.points = readPoints(reader, "points", path.inSpace);
    if (!path.inSpace) {
        for (Vec3d& point : path.points)
            point = pointOnGround(point.head<2>(), up);
    }
    reader.each("spans", [&](const Json& json, const std::string& pointer) {
        path.spans.push_back(readPathSpan({json, pointer, reader.problems()}));
    });
    reader.each("obstacles", [&](const Json& json, const std::string& pointer) {
        path.obstacles.push_back(readObstacle({json, pointer, reader.problems()}));
    });
    path.clearance = reader.number("clearance").value_or(path.clearance);
    path.unknown = reader.unknown(projectkeys::path);
    return path;
}

ActionEntry readAction(const ObjectReader& reader)
{
    ActionEntry action;
    const auto frames = readChoice(reader);
    if (!frames)
        reader.invalid(reader.pointer(), "The action names no movement", "Give a “label” or a “sequence”.");
    action.frames = frames.value_or(FrameChoice());
    action.repeat = static_cast<int>(reader.wholeNumber("repeat").value_or(action.repeat));
    action.duration = reader.number("duration");
    action.leastShare = reader.number("least_share");
    action.unknown = reader.unknown(projectkeys::action);
    return action;
}

enum class ConstraintKind
{
    None,
    Key,
    Path,
    Action,
};

void readConstraint(const ObjectReader& reader, UpAxis up, std::vector<ConstraintEntry>& constraints)
{
    auto kind = ConstraintKind::None;
    if (reader.find("kind") == nullptr)
        reader.missing("kind");
    reader.word(
        "kind", kind,
        {{"key", ConstraintKind::Key}, {"path", ConstraintKind::Path}, {"action", ConstraintKind::Action}});
    switch (kind) {
    case ConstraintKind::Key:
        constraints.emplace_back(readKey(reader));
        break;
    case ConstraintKind::Path:
        constraints.emplace_back(readPath(reader, up));
        break;
    case ConstraintKind::Action:
        constraints.emplace_back(readAction(reader));
        break;
    case ConstraintKind::None:
        break;
    }
}

SearchEntry readSearch(const ObjectReader& reader)
{
    SearchEntry search{.budget = reader.wholeNumber("budget"),
                       .beta = reader.number("beta"),
                       .mu = reader.number("mu"),
                       .globalKeys = reader.boolean("global", false)};
    reader.word("style", search.isPaper, {{"calm", false}, {"paper", true}});
    search.dwell = reader.number("dwell");
    search.deadZone = reader.number("dead_zone");
    search.steering = reader.number("steering");
    search.unknown = reader.unknown(projectkeys::search);
    return search;
}

/// [[["walk", 12], ["kick", 40]], …]
std::vector<JunctionEntry> readJunctionList(const ObjectReader& reader, const char* key)
{
    const auto isFrame = [](const Json& json) {
        return json.is_array() && json.size() == 2 && json[0].is_string() && json[1].is_number_integer();
    };
    const auto frameOf = [](const Json& json) {
        return NamedFrame{json[0].get<std::string>(), FrameIndex(json[1].get<std::int64_t>())};
    };
    std::vector<JunctionEntry> junctions;
    reader.each(key, [&](const Json& json, const std::string& pointer) {
        if (json.is_array() && json.size() == 2 && isFrame(json[0]) && isFrame(json[1]))
            junctions.push_back({frameOf(json[0]), frameOf(json[1])});
        else
            reader.invalid(pointer, "A junction is expected here",
                           "Write [[\"SEQUENCE\", FRAME], [\"SEQUENCE\", FRAME]].");
    });
    return junctions;
}

std::vector<WalkSpanEntry> readWalkSpans(const ObjectReader& reader, const char* key)
{
    std::vector<WalkSpanEntry> spans;
    reader.each(key, [&](const Json& json, const std::string& pointer) {
        const ObjectReader span(json, pointer, reader.problems());
        WalkSpanEntry entry{.sequence = span.requiredText("sequence")};
        const auto frames = span.range("frames");
        if (span.find("frames") == nullptr)
            span.missing("frames");
        entry.frames = frames.value_or(FrameRange{});
        spans.push_back(std::move(entry));
    });
    return spans;
}

JunctionsEntry readJunctions(const ObjectReader& reader)
{
    return {.banned = readJunctionList(reader, "banned"),
            .locked = readJunctionList(reader, "locked"),
            .chosen = readJunctionList(reader, "chosen"),
            .walk = readWalkSpans(reader, "walk"),
            .unknown = reader.unknown(projectkeys::junctions)};
}

WalkEntry readWalk(const ObjectReader& reader)
{
    WalkEntry walk{.spans = readWalkSpans(reader, "spans")};
    walk.turn = reader.number("turn").value_or(0);
    walk.at = readGroundPoint(reader, "at");
    walk.unknown = reader.unknown(projectkeys::walk);
    return walk;
}

std::optional<Seconds> readSeconds(const ObjectReader& reader, const char* key)
{
    const auto number = reader.number(key);
    return number ? std::optional(Seconds{*number}) : std::nullopt;
}

/// A step that stands as true, or as an object of its settings; nothing where it is not there.
template <typename Settings, typename Read>
std::optional<Settings> readStep(const ObjectReader& reader, const char* key, const Read& read,
                                 bool isUsual = false)
{
    const Json* json = reader.find(key);
    if (json != nullptr && json->is_object())
        return read(ObjectReader(*json, reader.pointer(key), reader.problems()));
    return reader.boolean(key, isUsual) ? std::optional(Settings()) : std::nullopt;
}

LoopSettings readLoop(const ObjectReader& reader, UnknownKeys& unknown)
{
    unknown = reader.unknown(projectkeys::loop);
    return {.cutStart = readSeconds(reader, "cut_start"),
            .cutEnd = readSeconds(reader, "cut_end"),
            .inPlace = reader.boolean("in_place", false)};
}

ContactCorrectionSettings readContactCorrection(const ObjectReader& reader, UnknownKeys& unknown)
{
    unknown = reader.unknown(projectkeys::contactCorrection);
    ContactCorrectionSettings settings;
    settings.strength = reader.number("strength").value_or(settings.strength);
    settings.easeSeconds = reader.number("ease").value_or(settings.easeSeconds);
    settings.greatestShift = reader.number("greatest_shift").value_or(settings.greatestShift);
    settings.greatestTurn = reader.number("greatest_turn").value_or(settings.greatestTurn);
    settings.greatestLift = reader.number("greatest_lift").value_or(settings.greatestLift);
    return settings;
}

VariedRepeats readVariedRepeats(const ObjectReader& reader)
{
    VariedRepeats repeats;
    repeats.from = reader.text("from");
    repeats.ease = reader.number("ease").value_or(repeats.ease);
    repeats.unknown = reader.unknown(projectkeys::variedRepeats);
    return repeats;
}

RetimeSettings readRetime(const ObjectReader& reader, UnknownKeys& unknown)
{
    RetimeSettings settings;
    int ways = 0;
    if (const auto factor = reader.number("factor")) {
        settings.time = RetimeFactor{*factor};
        ++ways;
    }
    if (const auto duration = readSeconds(reader, "duration")) {
        settings.time = *duration;
        ++ways;
    }
    if (reader.find("curve") != nullptr) {
        bool inSpace = false;
        RetimeSettings::Curve curve;
        for (const Vec3d& point : readPoints(reader, "curve", inSpace))
            curve.push_back({Seconds{point.x()}, Seconds{point.y()}});
        settings.time = std::move(curve);
        ++ways;
    }
    if (ways > 1)
        reader.invalid(reader.pointer(), "The time is given in several ways",
                       "Keep one of “factor”, “duration” and “curve”.");
    settings.keepsRootSpeed = reader.boolean("keep_root_speed", false);
    unknown = reader.unknown(projectkeys::retime);
    return settings;
}

PostProcessingEntry readPost(const ObjectReader& reader)
{
    PostProcessingEntry post;
    post.variations = readStep<VariedRepeats>(reader, "variations", readVariedRepeats);
    post.steps.loop = readStep<LoopSettings>(
        reader, "loop", [&](const ObjectReader& own) { return readLoop(own, post.unknownOfLoop); });
    post.steps.contacts = readStep<ContactCorrectionSettings>(
        reader, "contact_correction",
        [&](const ObjectReader& own) { return readContactCorrection(own, post.unknownOfContacts); }, true);
    post.steps.mirror = reader.boolean("mirror", false);
    post.symmetry = reader.text("symmetry");
    post.steps.repeats = static_cast<int>(reader.wholeNumber("repeats").value_or(post.steps.repeats));
    if (const Json* retime = reader.find("retime"))
        post.steps.retime =
            readRetime({*retime, reader.pointer("retime"), reader.problems()}, post.unknownOfRetime);
    post.unknown = reader.unknown(projectkeys::post);
    return post;
}

} // namespace

AnimationEntry readAnimation(const ObjectReader& reader, UpAxis up)
{
    AnimationEntry animation;
    animation.name = reader.requiredText("name");
    animation.character = reader.text("character");
    reader.each("constraints", [&](const Json& json, const std::string& pointer) {
        readConstraint({json, pointer, reader.problems()}, up, animation.constraints);
    });
    const auto member = [&](const char* key, const auto& read) {
        if (const Json* json = reader.find(key))
            read(ObjectReader(*json, reader.pointer(key), reader.problems()));
    };
    member("start", [&](const ObjectReader& own) {
        animation.start = readChoice(own);
        own.unknown(projectkeys::frameChoice);
    });
    member("search", [&](const ObjectReader& own) { animation.search = readSearch(own); });
    member("junctions", [&](const ObjectReader& own) { animation.junctions = readJunctions(own); });
    member("walk", [&](const ObjectReader& own) { animation.walk = readWalk(own); });
    reader.word("interpolation", animation.interpolation,
                {{"poisson", InterpolationMethod::Poisson},
                 {"slerp", InterpolationMethod::Slerp},
                 {"linear", InterpolationMethod::Linear}});
    reader.word("blend", animation.gentleBlend, {{"paper", false}, {"gentle", true}});
    member("post", [&](const ObjectReader& own) { animation.post = readPost(own); });
    member("audio", [&](const ObjectReader& own) { animation.audio = readAudio(own); });
    reader.each("camera", [&](const Json& json, const std::string& pointer) {
        animation.camera.push_back(readCameraKey({json, pointer, reader.problems()}));
    });
    animation.unknown = reader.unknown(projectkeys::animation);
    readNotes(reader, animation.unknown);
    return animation;
}

} // namespace quadrille
