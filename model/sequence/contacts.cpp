// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/contacts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace quadrille {

namespace {

using Vertices = std::vector<std::uint32_t>;

/// What comes nearer to the ground than this belongs to a sole, body heights.
constexpr double soleHeight = 0.03;

class ContactFinder
{
public:
    ContactFinder(const MeshSequence& sequence, const ContactOptions& options)
        : m_sequence(sequence), m_options(options), m_up(static_cast<Eigen::Index>(options.up))
    {
    }

    std::vector<ContactSpan> run(const Progress& progress)
    {
        measure(progress.part(0, 0.4));
        const std::vector<Vertices> feet = findFeet();
        const std::vector<std::string> names = nameFeet(feet);
        std::vector<ContactSpan> spans;
        for (std::size_t i = 0; i < feet.size(); ++i) {
            const auto from = static_cast<double>(i) / static_cast<double>(feet.size());
            const auto to = static_cast<double>(i + 1) / static_cast<double>(feet.size());
            addSpans(feet[i], names[i], spans, progress.part(0.4 + 0.6 * from, 0.4 + 0.6 * to));
        }
        return spans;
    }

private:
    double heightOf(const Vec3f& point) const { return point[m_up]; }
    Frame frame(std::int64_t index) const { return m_sequence.frame(FrameIndex(index)); }

    /// Finds the ground, the body's height and how low each vertex comes.
    void measure(const Progress& progress)
    {
        const std::int64_t frames = m_sequence.frameCount();
        m_lowest.assign(m_sequence.topology->vertexCount(), std::numeric_limits<double>::infinity());
        std::vector<double> lows;
        std::vector<double> extents;
        for (std::int64_t f = 0; f < frames; ++f) {
            progress.report(f, frames);
            const Frame current = frame(f);
            double low = std::numeric_limits<double>::infinity();
            double high = -low;
            for (std::size_t v = 0; v < current.positions().size(); ++v) {
                const double height = heightOf(current.positions()[v]);
                m_lowest[v] = std::min(m_lowest[v], height);
                low = std::min(low, height);
                high = std::max(high, height);
            }
            lows.push_back(low);
            extents.push_back(high - low);
        }
        const auto part = [](std::vector<double>& values, double fraction) {
            const auto at = values.begin() +
                            static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
            std::nth_element(values.begin(), at, values.end());
            return *at;
        };
        // In a jump or a run the body leaves the ground for less than most of the time.
        m_ground = part(lows, 0.2);
        m_bodyHeight = part(extents, 0.8);
    }

    /// Connected parts of the surface that come near the ground.
    std::vector<Vertices> findFeet() const
    {
        const double limit = m_ground + soleHeight * m_bodyHeight;
        std::vector<std::uint32_t> parent(m_lowest.size());
        std::iota(parent.begin(), parent.end(), 0U);
        const auto root = [&parent](std::uint32_t v) {
            while (parent[v] != v)
                v = parent[v] = parent[parent[v]];
            return v;
        };
        const auto isLow = [&](VertexIndex v) { return m_lowest[v.value] < limit; };
        for (const Triangle& triangle : m_sequence.topology->triangles()) {
            for (std::size_t c = 0; c < 3; ++c) {
                const VertexIndex a = triangle[c];
                const VertexIndex b = triangle[(c + 1) % 3];
                if (isLow(a) && isLow(b))
                    parent[std::max(root(a.value), root(b.value))] = std::min(root(a.value), root(b.value));
            }
        }
        std::map<std::uint32_t, Vertices> parts;
        for (std::uint32_t v = 0; v < m_lowest.size(); ++v) {
            if (isLow(VertexIndex(v)))
                parts[root(v)].push_back(v);
        }
        std::size_t largest = 0;
        for (const auto& [first, vertices] : parts)
            largest = std::max(largest, vertices.size());
        std::vector<Vertices> feet;
        for (auto& [first, vertices] : parts) {
            // A fingertip that brushes the ground is no foot.
            if (vertices.size() >= 4 && vertices.size() * 4 >= largest)
                feet.push_back(std::move(vertices));
        }
        return feet;
    }

    Vec3d centroid(Positions positions, const Vertices& vertices) const
    {
        Vec3d sum = Vec3d::Zero();
        for (const std::uint32_t v : vertices)
            sum += positions[v].cast<double>();
        return sum / static_cast<double>(vertices.size());
    }

    std::vector<std::string> nameFeet(const std::vector<Vertices>& feet) const
    {
        std::vector<std::string> names(feet.size());
        for (std::size_t i = 0; i < feet.size(); ++i)
            names[i] = "foot " + std::to_string(i + 1);
        if (feet.size() != 2)
            return names;
        Vec3d up = Vec3d::Zero();
        up[m_up] = 1;
        // One frame may show a foot in the middle of rolling off; many do not.
        constexpr std::int64_t samples = 24;
        const std::int64_t step = std::max<std::int64_t>(1, m_sequence.frameCount() / samples);
        double side = 0;
        for (std::int64_t f = 0; f < m_sequence.frameCount(); f += step) {
            const Frame current = frame(f);
            const Vec3d first = centroid(current.positions(), feet[0]);
            const Vec3d second = centroid(current.positions(), feet[1]);
            side += up.cross(toes(current.positions(), first, second)).dot(second - first);
        }
        names[0] = side > 0 ? "right" : "left";
        names[1] = side > 0 ? "left" : "right";
        return names;
    }

    /// From the ankles to the soles: where the toes point.
    Vec3d toes(Positions positions, const Vec3d& first, const Vec3d& second) const
    {
        Vec3d direction = Vec3d::Zero();
        for (const Vec3d& sole : {first, second}) {
            Vec3d ankle = Vec3d::Zero();
            int count = 0;
            for (const Vec3f& p : positions) {
                const Vec3d point = p.cast<double>();
                const double above = (point[m_up] - sole[m_up]) / m_bodyHeight;
                const Vec3d& other = &sole == &first ? second : first;
                if (above > 0.05 && above < 0.1 && (point - sole).norm() < 0.2 * m_bodyHeight &&
                    (point - sole).squaredNorm() < (point - other).squaredNorm()) {
                    ankle += point;
                    ++count;
                }
            }
            if (count > 0)
                direction += sole - ankle / count;
        }
        direction[m_up] = 0;
        return direction;
    }

    bool stands(const Vertices& foot, std::int64_t f) const
    {
        const std::int64_t before = std::max<std::int64_t>(f - 1, 0);
        const std::int64_t after = std::min(f + 1, m_sequence.frameCount() - 1);
        const Frame now = frame(f);
        const Frame previous = frame(before);
        const Frame next = frame(after);
        Vertices lowest = foot;
        const std::size_t count = std::max<std::size_t>(3, foot.size() / 10);
        std::nth_element(lowest.begin(), lowest.begin() + static_cast<std::ptrdiff_t>(count - 1),
                         lowest.end(), [&](std::uint32_t a, std::uint32_t b) {
                             return heightOf(now.positions()[a]) < heightOf(now.positions()[b]);
                         });
        double height = 0;
        double way = 0;
        for (std::size_t i = 0; i < count; ++i) {
            height += heightOf(now.positions()[lowest[i]]);
            way += (next.positions()[lowest[i]] - previous.positions()[lowest[i]]).norm();
        }
        height = height / static_cast<double>(count) - m_ground;
        const double seconds =
            static_cast<double>(std::max<std::int64_t>(after - before, 1)) / m_sequence.fps;
        const double speed = way / static_cast<double>(count) / seconds;
        return height < m_options.height * m_bodyHeight && speed < m_options.speed * m_bodyHeight;
    }

    void addSpans(const Vertices& foot, const std::string& name, std::vector<ContactSpan>& spans,
                  const Progress& progress) const
    {
        const std::int64_t frames = m_sequence.frameCount();
        const auto shortest = static_cast<std::int64_t>(std::ceil(m_options.shortest * m_sequence.fps));
        std::vector<bool> contact(static_cast<std::size_t>(frames));
        for (std::int64_t f = 0; f < frames; ++f) {
            progress.report(f, frames);
            contact[static_cast<std::size_t>(f)] = stands(foot, f);
        }
        // One frame in the air between two on the ground is noise.
        for (std::size_t f = 1; f + 1 < contact.size(); ++f)
            contact[f] = contact[f] || (contact[f - 1] && contact[f + 1]);
        for (std::int64_t f = 0; f < frames; ++f) {
            const std::int64_t first = f;
            while (f < frames && contact[static_cast<std::size_t>(f)])
                ++f;
            if (f - first >= std::min(shortest, frames) && f > first)
                spans.push_back({name, {FrameIndex(first), FrameIndex(f - 1)}});
        }
    }

    const MeshSequence& m_sequence;
    const ContactOptions& m_options;
    Eigen::Index m_up;
    std::vector<double> m_lowest; ///< per vertex, over all frames
    double m_ground = 0;
    double m_bodyHeight = 0;
};

} // namespace

std::vector<ContactSpan> detectContacts(const MeshSequence& sequence, const ContactOptions& options,
                                        const Progress& progress)
{
    if (sequence.frameCount() == 0)
        return {};
    return ContactFinder(sequence, options).run(progress);
}

} // namespace quadrille
