// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/animationjson.h"
#include "model/project/framenote.h"
#include "model/project/groundpoint.h"
#include "model/project/jsonmembers.h"

namespace quadrille {

namespace {

Json pairJson(const Vec2d& point)
{
    return Json::array({point.x(), point.y()});
}

Json pairsJson(const std::vector<Vec2d>& points)
{
    Json json = Json::array();
    for (const Vec2d& point : points)
        json.push_back(pairJson(point));
    return json;
}

void addChoice(Json& json, const FrameChoice& choice)
{
    addText(json, "label", choice.label);
    addText(json, "sequence", choice.sequence);
    addRange(json, "range", choice.range);
}

Json toJson(const KeyEntry& key, UpAxis)
{
    Json json = Json::object();
    json["kind"] = "key";
    json["sequence"] = key.sequence;
    json["frame"] = key.frame.value;
    json["time"] = key.time;
    addOptional(json, "tolerance", key.tolerance);
    addUnknown(json, key.unknown);
    return json;
}

Json toJson(const PathSpanEntry& span)
{
    Json json = Json::object();
    json["from"] = span.from;
    json["to"] = span.to;
    if (span.frames)
        addChoice(json, *span.frames);
    addOptional(json, "duration", span.duration);
    addUnknown(json, span.unknown);
    return json;
}

Json toJson(const ObstacleEntry& obstacle)
{
    Json json = Json::object();
    if (obstacle.isDisc()) {
        json["centre"] = pairJson(obstacle.corners.front());
        json["radius"] = obstacle.radius;
    } else {
        json["polygon"] = pairsJson(obstacle.corners);
    }
    addUnknown(json, obstacle.unknown);
    return json;
}

Json toJson(const PathEntry& path, UpAxis up)
{
    Json json = Json::object();
    json["kind"] = "path";
    if (path.curve != PathCurve::CatmullRom)
        json["curve"] = path.curve == PathCurve::Polyline ? "polyline" : "bezier";
    json["points"] = Json::array();
    for (const Vec3d& point : path.points)
        json["points"].push_back(path.inSpace ? Json::array({point.x(), point.y(), point.z()})
                                              : pairJson(pointOfFile(point, up)));
    for (const PathSpanEntry& span : path.spans)
        json["spans"].push_back(toJson(span));
    for (const ObstacleEntry& obstacle : path.obstacles)
        json["obstacles"].push_back(toJson(obstacle));
    addUnless(json, "clearance", path.clearance, 0);
    addUnknown(json, path.unknown);
    return json;
}

Json toJson(const ActionEntry& action, UpAxis)
{
    Json json = Json::object();
    json["kind"] = "action";
    addChoice(json, action.frames);
    addUnless(json, "repeat", action.repeat, 1);
    addOptional(json, "duration", action.duration);
    addOptional(json, "least_share", action.leastShare);
    addUnknown(json, action.unknown);
    return json;
}

Json toJson(const SearchEntry& search)
{
    Json json = Json::object();
    addOptional(json, "budget", search.budget);
    addOptional(json, "beta", search.beta);
    addOptional(json, "mu", search.mu);
    addUnless(json, "global", search.globalKeys, false);
    if (search.isPaper)
        json["style"] = "paper";
    addOptional(json, "dwell", search.dwell);
    addOptional(json, "dead_zone", search.deadZone);
    addOptional(json, "steering", search.steering);
    addUnknown(json, search.unknown);
    return json;
}

void addJunctions(Json& json, const char* key, const std::vector<JunctionEntry>& junctions)
{
    const auto frameJson = [](const NamedFrame& frame) {
        return Json::array({frame.sequence, frame.frame.value});
    };
    for (const JunctionEntry& junction : junctions)
        json[key].push_back(Json::array({frameJson(junction.from), frameJson(junction.to)}));
}

Json toJson(const std::vector<WalkSpanEntry>& spans)
{
    Json json = Json::array();
    for (const WalkSpanEntry& span : spans) {
        Json item = Json::object();
        item["sequence"] = span.sequence;
        item["frames"] = rangeToJson(span.frames);
        json.push_back(std::move(item));
    }
    return json;
}

Json toJson(const JunctionsEntry& junctions)
{
    Json json = Json::object();
    addJunctions(json, "banned", junctions.banned);
    addJunctions(json, "locked", junctions.locked);
    addJunctions(json, "chosen", junctions.chosen);
    if (!junctions.walk.empty())
        json["walk"] = toJson(junctions.walk);
    addUnknown(json, junctions.unknown);
    return json;
}

Json toJson(const WalkEntry& walk)
{
    Json json = Json::object();
    json["spans"] = toJson(walk.spans);
    addUnless(json, "turn", walk.turn, 0);
    if (walk.at)
        json["at"] = pairJson(*walk.at);
    addUnknown(json, walk.unknown);
    return json;
}

void addSeconds(Json& json, const char* key, const std::optional<Seconds>& seconds)
{
    if (seconds)
        json[key] = seconds->value;
}

Json toJson(const LoopSettings& loop, const UnknownKeys& unknown)
{
    Json json = Json::object();
    addSeconds(json, "cut_start", loop.cutStart);
    addSeconds(json, "cut_end", loop.cutEnd);
    addUnless(json, "in_place", loop.inPlace, false);
    addUnknown(json, unknown);
    return json.empty() ? Json(true) : json;
}

Json toJson(const ContactCorrectionSettings& contacts, const UnknownKeys& unknown)
{
    const ContactCorrectionSettings usual;
    Json json = Json::object();
    addUnless(json, "strength", contacts.strength, usual.strength);
    addUnless(json, "ease", contacts.easeSeconds, usual.easeSeconds);
    addUnless(json, "greatest_shift", contacts.greatestShift, usual.greatestShift);
    addUnless(json, "greatest_turn", contacts.greatestTurn, usual.greatestTurn);
    addUnless(json, "greatest_lift", contacts.greatestLift, usual.greatestLift);
    addUnknown(json, unknown);
    return json.empty() ? Json(true) : json;
}

Json toJson(const RetimeSettings& retime, const UnknownKeys& unknown)
{
    Json json = Json::object();
    if (const auto* factor = std::get_if<RetimeFactor>(&retime.time))
        json["factor"] = factor->value;
    else if (const auto* duration = std::get_if<Seconds>(&retime.time))
        json["duration"] = duration->value;
    else
        for (const RetimePoint& point : std::get<RetimeSettings::Curve>(retime.time))
            json["curve"].push_back(Json::array({point.output.value, point.clip.value}));
    addUnless(json, "keep_root_speed", retime.keepsRootSpeed, false);
    addUnknown(json, unknown);
    return json;
}

Json toJson(const VariedRepeats& repeats)
{
    Json json = Json::object();
    addText(json, "from", repeats.from);
    addUnless(json, "ease", repeats.ease, VariedRepeats().ease);
    addUnknown(json, repeats.unknown);
    return json.empty() ? Json(true) : json;
}

Json toJson(const PostProcessingEntry& post)
{
    Json json = Json::object();
    if (post.variations)
        json["variations"] = toJson(*post.variations);
    if (post.steps.loop)
        json["loop"] = toJson(*post.steps.loop, post.unknownOfLoop);
    if (!post.steps.contacts)
        json["contact_correction"] = false;
    else if (Json contacts = toJson(*post.steps.contacts, post.unknownOfContacts); contacts != true)
        json["contact_correction"] = std::move(contacts);
    addUnless(json, "mirror", post.steps.mirror, false);
    addText(json, "symmetry", post.symmetry);
    addUnless(json, "repeats", post.steps.repeats, 1);
    if (post.steps.retime)
        json["retime"] = toJson(*post.steps.retime, post.unknownOfRetime);
    addUnknown(json, post.unknown);
    return json;
}

Json toJson(const AudioEntry& audio)
{
    Json json = Json::object();
    json["file"] = audio.file;
    addUnless(json, "offset", audio.offset, 0);
    addUnless(json, "gain", audio.gain, 0);
    addUnknown(json, audio.unknown);
    return json;
}

Json toJson(const CameraKeyEntry& entry)
{
    const CameraKey& key = entry.key;
    Json json = Json::object();
    json["time"] = key.time;
    json["target"] = Json::array({key.target.x(), key.target.y(), key.target.z()});
    json["distance"] = key.distance;
    json["azimuth"] = key.azimuth;
    json["elevation"] = key.elevation;
    json["fov"] = key.fieldOfView;
    addUnknown(json, entry.unknown);
    return json;
}

} // namespace

Json animationToJson(const AnimationEntry& animation, UpAxis up)
{
    Json json = Json::object();
    json["name"] = animation.name;
    addText(json, "character", animation.character);
    if (animation.start)
        addChoice(json["start"], *animation.start);
    for (const ConstraintEntry& constraint : animation.constraints)
        json["constraints"].push_back(
            std::visit([up](const auto& entry) { return toJson(entry, up); }, constraint));
    addFilled(json, "search", toJson(animation.search));
    addFilled(json, "junctions", toJson(animation.junctions));
    if (animation.walk)
        json["walk"] = toJson(*animation.walk);
    if (animation.interpolation != InterpolationMethod::Poisson)
        json["interpolation"] = animation.interpolation == InterpolationMethod::Slerp ? "slerp" : "linear";
    if (!animation.gentleBlend)
        json["blend"] = "paper";
    addFilled(json, "post", toJson(animation.post));
    if (animation.audio)
        json["audio"] = toJson(*animation.audio);
    for (const CameraKeyEntry& key : animation.camera)
        json["camera"].push_back(toJson(key));
    addNotes(json, animation.unknown);
    addUnknown(json, animation.unknown);
    return json;
}

std::string animationSettings(const AnimationEntry& animation, UpAxis up)
{
    AnimationEntry shown = animation;
    shown.audio.reset();
    shown.camera.clear();
    setNotes(shown.unknown, {});
    return animationToJson(shown, up).dump(-1, ' ', true, Json::error_handler_t::replace);
}

} // namespace quadrille
