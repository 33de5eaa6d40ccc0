// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/supports.h"

#include "model/sequence/contacts.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <set>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// Which vertices of a sequence may stand, whatever its frames.
struct Standing
{
    double ground = 0; ///< of most frames, metres
    double reach = 0;  ///< above the ground, metres
    double speed = 0;  ///< m/s
    std::vector<ContactSpan> spans;

    bool at(FrameIndex frame) const
    {
        return std::ranges::any_of(spans, [frame](const auto& span) { return span.frames.contains(frame); });
    }
};

Standing standingOf(const MeshSequence& sequence, UpAxis up, const Progress& progress)
{
    const ContactOptions options{.up = up};
    const auto upwards = static_cast<Eigen::Index>(up);
    std::vector<float> levels;
    float tallest = 0;
    for (std::int64_t f = 0; f < sequence.frameCount(); ++f) {
        const Frame frame = sequence.frame(FrameIndex(f));
        const auto [low, high] = std::ranges::minmax(
            frame.positions(), {}, [upwards](const Vec3f& position) { return position[upwards]; });
        levels.push_back(low[upwards]);
        tallest = std::max(tallest, high[upwards] - low[upwards]);
    }
    std::ranges::sort(levels);
    // As detectContacts has it: most frames' lowest points lie at or just above the ground.
    return {.ground = levels[levels.size() / 5],
            .reach = options.leaveHeight * tallest,
            .speed = options.leaveSpeed * tallest,
            .spans =
                sequence.contacts.empty() ? detectContacts(sequence, options, progress) : sequence.contacts};
}

std::vector<std::uint32_t> standingVertices(const Standing& standing, const Ground& ground, Positions now,
                                            std::span<const Frame> neighbours, double fps)
{
    std::vector<std::uint32_t> vertices;
    // Who stands, stands on the lowest point, however far the capture has drifted up.
    const Vec3f& lowest = *std::ranges::min_element(
        now, {}, [&ground](const Vec3f& position) { return position[ground.upAxis()]; });
    const double greatest =
        std::max(standing.ground, static_cast<double>(lowest[ground.upAxis()])) + standing.reach;
    for (std::uint32_t v = 0; v < now.size(); ++v) {
        if (static_cast<double>(now[v][ground.upAxis()]) > greatest)
            continue;
        // The slower of before and after: the first and last frame of a contact count as standing.
        const bool isSlow = std::ranges::any_of(neighbours, [&](const Frame& neighbour) {
            return static_cast<double>((neighbour.positions()[v] - now[v]).norm()) * fps < standing.speed;
        });
        if (isSlow)
            vertices.push_back(v);
    }
    return vertices;
}

} // namespace

Vec2d Support::meanOf(std::span<const std::uint32_t> standing) const
{
    Vec2d sum = Vec2d::Zero();
    auto position = vertices.begin();
    for (const std::uint32_t vertex : standing) {
        while (*position < vertex) // a few steps, as both ascend
            ++position;
        sum += places[static_cast<std::size_t>(position - vertices.begin())];
    }
    return sum / static_cast<double>(standing.size());
}

std::vector<Support> findSupports(const CharacterFrames& character, UpAxis up, const Progress& progress)
{
    const Ground ground(up);
    const FrameLayout& layout = character.layout();
    std::vector<Support> supports(static_cast<std::size_t>(character.frameCount()));
    std::atomic<std::int64_t> done = 0;
    tbb::parallel_for(0, layout.sequenceCount(), [&](int s) {
        const MeshSequence& sequence = character.sequences()[static_cast<std::size_t>(s)];
        const Standing standing = standingOf(sequence, up, Progress(progress.token()));
        const NodeIndex first = layout.firstOf(s);
        const NodeIndex last = layout.lastOf(s);
        for (NodeIndex node = first; node <= last; ++node) {
            progress.report(done++, std::int64_t{character.frameCount()});
            if (!standing.at(FrameIndex(node - first)))
                continue;
            Support& support = supports[static_cast<std::size_t>(node)];
            const Frame now = character.frame(node);
            std::vector<Frame> neighbours;
            for (const NodeIndex other : {node - 1, node + 1}) {
                if (first <= other && other <= last)
                    neighbours.push_back(character.frame(other));
            }
            support.vertices = standingVertices(standing, ground, now.positions(), neighbours, sequence.fps);
            for (const std::uint32_t v : support.vertices)
                support.places.push_back(ground.of(now.positions()[v].cast<double>()));
        }
    });
    progress.report(1.0);
    return supports;
}

void thinSupports(std::vector<Support>& supports, std::size_t most)
{
    std::size_t greatest = 0;
    std::set<std::uint32_t> standing;
    for (const Support& support : supports) {
        greatest = std::max(greatest, support.vertices.size());
        standing.insert(support.vertices.begin(), support.vertices.end());
    }
    const std::size_t step = (greatest + most - 1) / most;
    if (step <= 1)
        return;
    std::set<std::uint32_t> kept;
    std::size_t index = 0;
    for (const std::uint32_t vertex : standing)
        if (index++ % step == 0)
            kept.insert(vertex);
    for (Support& support : supports) {
        Support thin;
        for (std::size_t i = 0; i < support.vertices.size(); ++i) {
            if (!kept.contains(support.vertices[i]))
                continue;
            thin.vertices.push_back(support.vertices[i]);
            thin.places.push_back(support.places[i]);
        }
        // Where hardly anything stands, all of it counts.
        if (!thin.vertices.empty())
            support = std::move(thin);
    }
}

std::vector<std::uint32_t> common(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b)
{
    std::vector<std::uint32_t> both;
    std::ranges::set_intersection(a, b, std::back_inserter(both));
    return both;
}

} // namespace quadrille
