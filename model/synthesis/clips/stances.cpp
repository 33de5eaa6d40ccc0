// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/stances.h"

#include "model/sequence/contacts.h"
#include "model/synthesis/clips/blendsteps.h"
#include "model/synthesis/clips/characterlegs.h"
#include "model/synthesis/clips/soles.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

std::size_t footNamed(Stances& stances, const std::string& name)
{
    const auto found = std::ranges::find(stances.feet, name, &Stances::Foot::name);
    if (found != stances.feet.end())
        return static_cast<std::size_t>(found - stances.feet.begin());
    if (stances.feet.size() < Stances::mostFeet)
        stances.feet.push_back({.name = name, .vertices = {}});
    return stances.feet.size() - 1;
}

/// \param contacts  of each sequence.
void setStanding(Stances& stances, const FrameLayout& layout,
                 std::span<const std::vector<ContactSpan>> contacts)
{
    stances.standing.resize(static_cast<std::size_t>(layout.frameCount()));
    for (int s = 0; s < layout.sequenceCount(); ++s) {
        const NodeIndex first = layout.firstOf(s);
        for (const ContactSpan& contact : contacts[static_cast<std::size_t>(s)]) {
            const std::uint32_t bit = 1U << footNamed(stances, contact.foot);
            for (NodeIndex node = first; node <= layout.lastOf(s); ++node)
                if (contact.frames.contains(FrameIndex(node - first)))
                    stances.standing[static_cast<std::size_t>(node)] |= bit;
        }
    }
}

/// Of each foot the one that is its mirror image.
std::vector<std::size_t> acrossOf(const Stances& stances)
{
    std::vector<std::size_t> across;
    across.reserve(stances.feet.size());
    for (std::size_t i = 0; i < stances.feet.size(); ++i) {
        const std::string& name = stances.feet[i].name;
        const std::string other = name == "left" ? "right" : name == "right" ? "left" : name;
        const auto found = std::ranges::find(stances.feet, other, &Stances::Foot::name);
        across.push_back(
            found == stances.feet.end() ? i : static_cast<std::size_t>(found - stances.feet.begin()));
    }
    return across;
}

std::uint32_t mirroredFeet(std::uint32_t feet, const std::vector<std::size_t>& across)
{
    std::uint32_t mirrored = 0;
    for (std::size_t i = 0; i < across.size(); ++i)
        mirrored |= (feet >> i & 1U) << across[i];
    return mirrored;
}

/// Lets feet stand on where they leave the ground for a moment only inside a blend, and are not carried far
/// then.
void closeGaps(std::vector<std::uint32_t>& standing, const Clip& clip, const Stances& stances)
{
    const std::vector<FrameProvenance>& origins = clip.origins;
    const auto longest = static_cast<std::size_t>(longestStanceGap * clip.fps);
    for (std::size_t foot = 0; foot < stances.feet.size(); ++foot) {
        const std::uint32_t bit = 1U << foot;
        for (std::size_t f = 1; f < standing.size(); ++f) {
            if ((standing[f] & bit) != 0 || (standing[f - 1] & bit) == 0)
                continue;
            std::size_t end = f;
            while (end < standing.size() && (standing[end] & bit) == 0 && !origins[end].isSingle())
                ++end;
            const bool standsBehind = end < standing.size() && (standing[end] & bit) != 0;
            if (!standsBehind || end - f > longest ||
                carriedWay(clip, stances, foot, f - 1, end) > longestCarry)
                continue;
            for (std::size_t g = f; g < end; ++g)
                standing[g] |= bit;
        }
    }
}

double heightOf(Positions pose, UpAxis up)
{
    const auto upwards = static_cast<Eigen::Index>(up);
    const auto [low, high] =
        std::ranges::minmax(pose, {}, [upwards](const Vec3f& position) { return position[upwards]; });
    return static_cast<double>(high[upwards] - low[upwards]);
}

} // namespace

Stances findStances(const CharacterFrames& character, UpAxis up, const Progress& progress)
{
    Stances stances;
    const auto count = static_cast<std::size_t>(character.layout().sequenceCount());
    std::vector<std::vector<ContactSpan>> contacts(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t s) {
        const MeshSequence& sequence = character.sequences()[s];
        contacts[s] = sequence.contacts.empty()
                          ? detectContacts(sequence, {.up = up}, Progress(progress.token()))
                          : sequence.contacts;
    });
    progress.report(0.8);
    const Legs legs = legsOf(character, up, progress.part(0.8, 1));
    stances.height = legs.feet.empty() ? heightOf(character.frame(0).positions(), up) : legs.height;
    stances.feet.reserve(legs.feet.size());
    for (const Foot& foot : legs.feet)
        stances.feet.push_back({.name = foot.name, .vertices = foot.vertices});
    setStanding(stances, character.layout(), contacts);
    for (Stances::Foot& foot : stances.feet) {
        if (!foot.vertices.empty())
            continue;
        foot.vertices.resize(character.vertexCount());
        std::iota(foot.vertices.begin(), foot.vertices.end(), 0U);
    }
    stances.places.resize(stances.standing.size() * stances.feet.size());
    tbb::parallel_for(std::size_t{0}, stances.standing.size(), [&](std::size_t node) {
        const Frame frame = character.frame(static_cast<NodeIndex>(node));
        for (std::size_t foot = 0; foot < stances.feet.size(); ++foot)
            stances.places[node * stances.feet.size() + foot] =
                meanOf(frame.positions(), stances.feet[foot].vertices).cast<double>();
    });
    progress.report(1.0);
    return stances;
}

Stances givenStances(const CharacterFrames& character)
{
    std::vector<std::vector<ContactSpan>> contacts;
    contacts.reserve(character.sequences().size());
    for (const MeshSequence& sequence : character.sequences())
        contacts.push_back(sequence.contacts);
    Stances stances;
    setStanding(stances, character.layout(), contacts);
    return stances;
}

double carriedWay(const Clip& clip, const Stances& stances, std::size_t foot, std::size_t from,
                  std::size_t to)
{
    const std::vector<std::uint32_t>& vertices = stances.feet[foot].vertices;
    if (vertices.empty() || vertices.size() == clip.topology->vertexCount())
        return 0;
    const auto placeAt = [&](std::size_t frame) {
        return meanOf(clip.frame(static_cast<std::int64_t>(frame)), vertices);
    };
    return static_cast<double>((placeAt(to) - placeAt(from)).norm()) / stances.height;
}

std::vector<std::uint32_t> stancesBeforeSteps(const Clip& clip, const Stances& stances)
{
    const std::vector<std::size_t> across = acrossOf(stances);
    std::vector<std::uint32_t> standing;
    standing.reserve(clip.origins.size());
    for (const FrameProvenance& origin : clip.origins) {
        const std::uint32_t feet = stances.at(origin.nearest());
        standing.push_back(origin.mirrored ? mirroredFeet(feet, across) : feet);
    }
    closeGaps(standing, clip, stances);
    return standing;
}

std::vector<std::uint32_t> stancesOf(const Clip& clip, const Stances& stances)
{
    std::vector<std::uint32_t> standing = stancesBeforeSteps(clip, stances);
    addSteps(standing, clip, stances);
    return standing;
}

std::optional<double> slideOf(Positions before, Positions after, std::uint32_t feet, const Stances& stances,
                              UpAxis up, double fps)
{
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < stances.feet.size(); ++i) {
        const std::vector<std::uint32_t>& vertices = stances.feet[i].vertices;
        if ((feet >> i & 1U) == 0)
            continue;
        sum += fps * soleSlip(before, after, vertices, stances.height, Ground(up));
        ++count;
    }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

std::vector<std::optional<double>> capturedSlides(const CharacterFrames& character, const Stances& stances,
                                                  UpAxis up, const Progress& progress)
{
    const FrameLayout& layout = character.layout();
    std::vector<std::optional<double>> slides(static_cast<std::size_t>(character.frameCount()));
    std::atomic<std::int64_t> done = 0;
    tbb::parallel_for(0, character.frameCount(), [&](NodeIndex node) {
        progress.report(++done, std::int64_t{character.frameCount()});
        const int sequence = layout.sequenceOf(node);
        if (node == layout.lastOf(sequence))
            return;
        const std::uint32_t feet = stances.at(node) & stances.at(node + 1);
        if (feet != 0)
            slides[static_cast<std::size_t>(node)] =
                slideOf(character.frame(node).positions(), character.frame(node + 1).positions(), feet,
                        stances, up, character.sequences()[static_cast<std::size_t>(sequence)].fps);
    });
    return slides;
}

std::vector<bool> framesInAir(const Stances& stances, const FrameLayout& layout, double fps)
{
    constexpr double shortest = 0.06; // seconds
    if (std::ranges::all_of(stances.standing, [](std::uint32_t feet) { return feet == 0; }))
        return {};
    std::vector<bool> inAir(stances.standing.size(), false);
    for (int s = 0; s < layout.sequenceCount(); ++s) {
        const NodeIndex end = layout.lastOf(s) + 1;
        NodeIndex takeOff = layout.firstOf(s);
        for (NodeIndex node = takeOff; node <= end; ++node) {
            if (node < end && stances.at(node) == 0)
                continue;
            if (node - takeOff >= shortest * fps)
                std::fill(inAir.begin() + takeOff, inAir.begin() + node, true);
            takeOff = node + 1;
        }
    }
    return inAir;
}

std::vector<ContactSpan> contactsOf(const Clip& clip, const Stances& stances)
{
    return contactsOf(stancesOf(clip, stances), stances);
}

std::vector<ContactSpan> contactsOf(std::span<const std::uint32_t> standing, const Stances& stances)
{
    std::vector<ContactSpan> spans;
    for (std::size_t foot = 0; foot < stances.feet.size(); ++foot) {
        for (std::size_t f = 0; f < standing.size(); ++f) {
            if ((standing[f] >> foot & 1U) == 0)
                continue;
            const bool goesOn = f > 0 && (standing[f - 1] >> foot & 1U) != 0;
            if (!goesOn)
                spans.push_back({stances.feet[foot].name, {FrameIndex(f), FrameIndex(f)}});
            spans.back().frames.last = FrameIndex(f);
        }
    }
    std::ranges::stable_sort(spans, {}, [](const ContactSpan& span) { return span.frames.first; });
    return spans;
}

} // namespace quadrille
