// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/jsonmembers.h"
#include "model/project/variationjson.h"

namespace quadrille {

namespace {

Json toJson(const std::vector<VertexIndex>& vertices)
{
    Json json = Json::array();
    for (const VertexIndex vertex : vertices)
        json.push_back(vertex.value);
    return json;
}

Json toJson(const NamedFrame& frame)
{
    Json json = Json::object();
    json["sequence"] = frame.sequence;
    json["frame"] = frame.frame.value;
    return json;
}

Json toJson(const PartCurveEntry& entry)
{
    Json json = Json::object();
    json["name"] = entry.curve.name;
    json["vertices"] = toJson(entry.curve.vertices);
    addFilled(json, "points", toJson(entry.points));
    addUnknown(json, entry.unknown);
    return json;
}

Json toJson(const PartEntry& entry)
{
    Json json = Json::object();
    json["name"] = entry.part.name;
    addText(json, "parent", entry.part.parent);
    addFilled(json, "curves", entry.part.curves);
    addUnknown(json, entry.unknown);
    return json;
}

/// The name alone where nothing else is given.
Json toJson(const TrainingEntry& entry)
{
    Json json = Json::object();
    json["sequence"] = entry.sequence;
    addRange(json, "range", entry.range);
    addUnknown(json, entry.unknown);
    return json.size() == 1 ? json["sequence"] : json;
}

/// What both pairs of a blend have in common.
template <typename Pair>
Json pairToJson(const Pair& pair)
{
    Json json = Json::object();
    json["from"] = pair.from;
    json["to"] = pair.to;
    json["weights"] = pair.weights;
    return json;
}

Json toJson(const BlendEntry& blend)
{
    Json json = pairToJson(blend);
    if (blend.across) {
        json["across"] = pairToJson(*blend.across);
        addUnknown(json["across"], blend.across->unknown);
    }
    addUnknown(json, blend.unknown);
    return json;
}

Json learningToJson(const VariationEntry& variation)
{
    const GpdmSettings usual;
    const GpdmSettings& learning = variation.learning;
    Json json = Json::object();
    addUnless(json, "dimensions", learning.dimensions, usual.dimensions);
    addUnless(json, "restarts", learning.restarts, usual.restarts);
    addUnless(json, "seed", learning.seed, usual.seed);
    addUnless(json, "tolerance", learning.tolerance, usual.tolerance);
    addUnless(json, "window", learning.window, usual.window);
    addUnless(json, "iterations", learning.greatestIterations, usual.greatestIterations);
    addUnknown(json, variation.unknownOfLearning);
    return json;
}

Json samplingToJson(const VariationEntry& variation)
{
    const HmcSettings usual;
    const HmcSettings& chain = variation.chain;
    Json json = Json::object();
    addUnless(json, "leapfrog_steps", chain.leapfrogSteps, usual.leapfrogSteps);
    addUnless(json, "burn_in", chain.burnIn, usual.burnIn);
    addUnless(json, "thinning", chain.thinning, usual.thinning);
    if (chain.leastAcceptance != usual.leastAcceptance ||
        chain.greatestAcceptance != usual.greatestAcceptance)
        json["acceptance"] = Json::array({chain.leastAcceptance, chain.greatestAcceptance});
    const TrajectoryLimits usualExtent;
    if (variation.extent.draw == TrajectoryDraw::Model)
        json["spread"] = "model";
    else
        addUnless(json, "spread", variation.extent.spread, usualExtent.spread);
    addUnless(json, "uncertainty", variation.extent.uncertainty, usualExtent.uncertainty);
    addUnknown(json, variation.unknownOfSampling);
    return json;
}

Json limitsToJson(const VariationEntry& variation)
{
    const VariationLimits usual;
    const VariationLimits& limits = variation.limits;
    Json json = Json::object();
    if (limits.poseDistance)
        json["pose_distance"] = *limits.poseDistance;
    addUnless(json, "skate", limits.skate, usual.skate);
    addUnless(json, "intersections", limits.intersections, usual.intersections);
    addUnless(json, "volume_change", limits.volumeChange, usual.volumeChange);
    addUnless(json, "collapse", limits.collapse, usual.collapse);
    addUnless(json, "sink", limits.sink, usual.sink);
    addUnknown(json, variation.unknownOfLimits);
    return json;
}

Json toJson(const AcrossSamplesEntry& across)
{
    Json json = Json::object();
    json["of"] = across.of;
    json["to"] = across.to;
    json["weight"] = across.weight;
    addUnknown(json, across.unknown);
    return json;
}

Json toJson(const SamplesEntry& samples)
{
    Json json = Json::object();
    json["of"] = samples.of;
    addText(json, "to", samples.to);
    if (!samples.to.empty() || samples.weight != 0)
        json["weight"] = samples.weight;
    if (samples.across)
        json["across"] = toJson(*samples.across);
    json["count"] = samples.count;
    json["seed"] = samples.seed;
    addFilled(json, "discarded", samples.discarded);
    addUnknown(json, samples.unknown);
    return json;
}

} // namespace

Json bodyPartsToJson(const BodyPartsEntry& parts)
{
    Json json = Json::object();
    addText(json, "character", parts.character);
    if (parts.pose)
        json["pose"] = toJson(*parts.pose);
    json["curves"] = Json::array();
    for (const PartCurveEntry& curve : parts.curves)
        json["curves"].push_back(toJson(curve));
    json["parts"] = Json::array();
    for (const PartEntry& part : parts.parts)
        json["parts"].push_back(toJson(part));
    addUnknown(json, parts.unknown);
    return json;
}

Json variationToJson(const VariationEntry& variation)
{
    const VariationEntry usual;
    Json json = Json::object();
    json["name"] = variation.name;
    addText(json, "character", variation.character);
    json["sequences"] = Json::array();
    for (const TrainingEntry& take : variation.training)
        json["sequences"].push_back(toJson(take));
    addText(json, "reference", variation.reference);
    if (variation.templatePose)
        json["template"] = toJson(*variation.templatePose);
    addUnless(json, "cycles", variation.cycles, usual.cycles);
    for (const BlendEntry& blend : variation.blends)
        json["blends"].push_back(toJson(blend));
    addUnless(json, "displacement_share", variation.displacementShare, usual.displacementShare);
    addFilled(json, "learning", learningToJson(variation));
    addFilled(json, "sampling", samplingToJson(variation));
    for (const SamplesEntry& samples : variation.samples)
        json["samples"].push_back(toJson(samples));
    if (variation.draw == PoseDraw::Sample)
        json["poses"] = "sample";
    addUnless(json, "contact_correction", variation.correctsContacts, usual.correctsContacts);
    addFilled(json, "limits", limitsToJson(variation));
    addUnknown(json, variation.unknown);
    return json;
}

} // namespace quadrille
