// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/finishing/contactcorrection.h"

#include "model/core/error.h"
#include "model/core/message.h"
#include "model/sequence/contacts.h"
#include "model/synthesis/finishing/footpath.h"
#include "model/synthesis/finishing/legdeformation.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

void checkSettings(const ContactCorrectionSettings& s)
{
    const auto isSize = [](double value) { return value >= 0 && std::isfinite(value); };
    const bool isGood = isSize(s.strength) && s.strength <= 1 && isSize(s.easeSeconds) &&
                        isSize(s.greatestShift) && isSize(s.greatestTurn) && isSize(s.greatestLift);
    if (!isGood)
        throw Error(ErrorCode::BadArgument,
                    {{},
                     {},
                     {{"reason", QUADRILLE_MESSAGE("Limits and times of contact corrections must not be "
                                                   "negative, and the strength must be 0 to 1")},
                      {"remedy", QUADRILLE_MESSAGE("Correct the settings.")}}});
}

FrameRange inside(const Clip& clip, const FrameRange& span)
{
    return {std::max(span.first, FrameIndex(0)), std::min(span.last, FrameIndex(clip.frameCount() - 1))};
}

/// The foot that a name of contacts means: the one that has it, or that moves least during all of them.
std::size_t footNamed(const std::string& name, const Clip& clip, const std::vector<Foot>& feet,
                      std::span<const ContactSpan> contacts)
{
    const auto named = std::ranges::find(feet, name, &Foot::name);
    if (named != feet.end())
        return static_cast<std::size_t>(named - feet.begin());
    std::vector<float> ways(feet.size(), 0);
    for (const ContactSpan& contact : contacts) {
        if (contact.foot != name)
            continue;
        const FrameRange span = inside(clip, contact.frames);
        for (std::int64_t f = span.first.value; f < span.last.value; ++f) {
            for (std::size_t i = 0; i < feet.size(); ++i)
                ways[i] +=
                    (meanOf(clip.frame(f + 1), feet[i].vertices) - meanOf(clip.frame(f), feet[i].vertices))
                        .norm();
        }
    }
    return static_cast<std::size_t>(std::ranges::min_element(ways) - ways.begin());
}

/// Spans that touch or overlap become one.
std::vector<FrameRange> joined(std::vector<FrameRange> spans)
{
    std::ranges::sort(spans, {}, &FrameRange::first);
    std::vector<FrameRange> apart;
    for (const FrameRange& span : spans) {
        if (!apart.empty() && span.first.value <= apart.back().last.value + 1)
            apart.back().last = std::max(apart.back().last, span.last);
        else
            apart.push_back(span);
    }
    return apart;
}

std::vector<FootContacts> contactsByFoot(const Clip& clip, const std::vector<Foot>& feet,
                                         std::span<const ContactSpan> contacts)
{
    std::vector<FootContacts> byFoot;
    byFoot.reserve(feet.size());
    for (const Foot& foot : feet)
        byFoot.push_back({.vertices = foot.vertices, .spans = {}});
    for (const ContactSpan& contact : contacts) {
        const FrameRange span = inside(clip, contact.frames);
        if (span.count() > 0)
            byFoot[footNamed(contact.foot, clip, feet, contacts)].spans.push_back(span);
    }
    for (FootContacts& foot : byFoot)
        foot.spans = joined(std::move(foot.spans));
    return byFoot;
}

/// One leg and how its foot is moved.
struct MovedLeg
{
    std::unique_ptr<const LegDeformation> deformation;
    std::vector<FootShift> shifts; ///< per frame
};

} // namespace

Clip contactsCorrected(Clip clip, std::span<const ContactSpan> contacts,
                       const ContactCorrectionSettings& settings, const ContactScope& scope,
                       const Progress& progress)
{
    progress.report(0.0);
    checkSettings(settings);
    const Topology& topology = *clip.topology;
    Legs legs = scope.trustsLegs && scope.legs ? *scope.legs : Legs();
    if (legs.feet.empty())
        legs = findLegs(topology, upright(clip.positions, topology.vertexCount(), scope.up),
                        ContactOptions().footShare);
    if (legs.feet.empty() && scope.legs)
        legs = *scope.legs;
    if (legs.feet.empty())
        throw Error(ErrorCode::NoFeet);
    progress.report(0.1);
    const std::vector<FootContacts> byFoot = contactsByFoot(clip, legs.feet, contacts);
    const Ground ground(scope.up);
    std::vector<MovedLeg> moved;
    moved.reserve(byFoot.size());
    for (std::size_t i = 0; i < byFoot.size(); ++i) {
        progress.report(0.1 + 0.2 * static_cast<double>(i) / static_cast<double>(byFoot.size()));
        if (!byFoot[i].spans.empty())
            moved.push_back({std::make_unique<const LegDeformation>(topology, legs.vertices[i],
                                                                    byFoot[i].vertices, legs.reference),
                             footShifts(clip, byFoot[i], settings, legs.height, ground)});
    }
    const FrameRange range = scope.frames.value_or(FrameRange::all(clip.frameCount()));
    std::atomic<std::int64_t> done = 0;
    tbb::parallel_for(range.first.value, range.last.value + 1, [&](std::int64_t f) {
        for (const MovedLeg& leg : moved) {
            const FootShift& shift = leg.shifts[static_cast<std::size_t>(f)];
            if (!shift.isNothing())
                leg.deformation->apply(shift, ground, clip.frame(f));
        }
        progress.part(0.3, 1).report(++done, range.count());
    });
    progress.report(1.0);
    return clip;
}

} // namespace quadrille
