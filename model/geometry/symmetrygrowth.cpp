// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/symmetrygrowth.h"

#include "model/geometry/indices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace quadrille {

namespace {

constexpr std::uint32_t unknown = ~std::uint32_t{0};

/// Maps of one connected component onto another, or itself.
class Growth
{
public:
    Growth(const FaceEdges& edges, const std::vector<std::int32_t>& components, Positions pose)
        : m_edges(edges), m_components(components), m_pose(pose), m_valences(pose.size(), 0)
    {
        for (std::int32_t h = 0; h < edges.count(); ++h)
            ++m_valences[edges.from(h)];
        m_faceImages.assign(edges.faceSizes.size(), -1);
        m_opposite.assign(pose.size(), unknown);
    }

    /// How well known counterparts and a map fit: the deviation of its edge lengths, and from the plane.
    struct Found
    {
        double misfit = 0;
        std::vector<std::uint32_t> vertices; ///< of the component
        std::vector<std::uint32_t> images;
    };
    /// The best map of a component onto another; nothing where there is none.
    std::optional<Found> best(std::int32_t component, std::int32_t image,
                              const std::optional<ReflectionPlane>& plane, const Progress& progress);

private:
    std::uint64_t signature(std::int32_t h, bool isReversed) const;
    std::vector<std::int32_t> halfEdgesOf(std::int32_t component) const;
    bool grow(std::int32_t seed, std::int32_t image);
    bool mapFace(std::int32_t h, std::int32_t image);
    bool isInvolution() const;
    double misfit(const std::optional<ReflectionPlane>& plane) const;
    void clear();
    double lengthOf(std::uint32_t a, std::uint32_t b) const
    {
        return static_cast<double>((m_pose[a] - m_pose[b]).norm());
    }

    const FaceEdges& m_edges;
    const std::vector<std::int32_t>& m_components;
    Positions m_pose;
    std::vector<std::uint64_t> m_valences;
    std::vector<std::int32_t> m_faceImages;  ///< of the map that is being grown
    std::vector<std::uint32_t> m_opposite;   ///< likewise
    std::vector<std::uint32_t> m_mapped;     ///< vertices that have one
    std::vector<std::int32_t> m_mappedFaces; ///< likewise
    std::vector<std::array<std::int32_t, 2>> m_stack;
    std::int64_t m_work = 0; ///< faces that were mapped so far
};

/// What surrounds a half-edge; for its image under a reflection everything is turned round.
std::uint64_t Growth::signature(std::int32_t h, bool isReversed) const
{
    std::uint64_t hash = 14695981039346656037ULL;
    const auto add = [&hash](std::uint64_t value) { hash = (hash ^ value) * 1099511628211ULL; };
    const auto ahead = [&](std::int32_t e) {
        return isReversed ? m_edges.previous[at(e)] : m_edges.next[at(e)];
    };
    const auto begin = [&](std::int32_t e) { return isReversed ? m_edges.to(e) : m_edges.from(e); };
    const auto addFace = [&](std::int32_t e) {
        add(static_cast<std::uint64_t>(m_edges.faceSizes[at(m_edges.face[at(e)])]));
        for (std::int32_t k = 0, around = e; k < 4; ++k, around = ahead(around)) {
            add(m_valences[begin(around)]);
            const std::int32_t twin = m_edges.twin[at(around)];
            // The corner of the neighbouring face across the edge.
            add(twin < 0 ? 0 : m_valences[begin(ahead(ahead(twin)))]);
        }
    };
    addFace(h);
    const std::int32_t twin = m_edges.twin[at(h)];
    if (twin >= 0)
        addFace(twin);
    return hash;
}

std::vector<std::int32_t> Growth::halfEdgesOf(std::int32_t component) const
{
    std::vector<std::int32_t> found;
    for (std::int32_t h = 0; h < m_edges.count(); ++h) {
        if (m_components[m_edges.from(h)] == component)
            found.push_back(h);
    }
    return found;
}

bool Growth::mapFace(std::int32_t h, std::int32_t image)
{
    const std::int32_t face = m_edges.face[at(h)];
    const std::int32_t imageFace = m_edges.face[at(image)];
    if (m_edges.faceSizes[at(face)] != m_edges.faceSizes[at(imageFace)])
        return false;
    m_faceImages[at(face)] = imageFace;
    m_mappedFaces.push_back(face);
    ++m_work;
    for (std::int32_t k = 0; k < m_edges.faceSizes[at(face)]; ++k) {
        const std::uint32_t vertex = m_edges.from(h);
        const std::uint32_t opposite = m_edges.to(image);
        if (m_valences[vertex] != m_valences[opposite])
            return false;
        if (m_opposite[vertex] == unknown) {
            m_opposite[vertex] = opposite;
            m_mapped.push_back(vertex);
        } else if (m_opposite[vertex] != opposite) {
            return false;
        }
        const std::int32_t twin = m_edges.twin[at(h)];
        const std::int32_t imageTwin = m_edges.twin[at(image)];
        if ((twin < 0) != (imageTwin < 0))
            return false;
        if (twin >= 0)
            m_stack.push_back({twin, imageTwin});
        h = m_edges.next[at(h)];
        image = m_edges.previous[at(image)];
    }
    return true;
}

bool Growth::grow(std::int32_t seed, std::int32_t image)
{
    clear();
    m_stack.assign(1, {seed, image});
    while (!m_stack.empty()) {
        const auto [h, to] = m_stack.back();
        m_stack.pop_back();
        const std::int32_t known = m_faceImages[at(m_edges.face[at(h)])];
        if (known >= 0) {
            const bool fits = known == m_edges.face[at(to)] &&
                              m_opposite[m_edges.from(h)] == m_edges.to(to) &&
                              m_opposite[m_edges.to(h)] == m_edges.from(to);
            if (!fits)
                return false;
        } else if (!mapFace(h, to)) {
            return false;
        }
    }
    return isInvolution();
}

void Growth::clear()
{
    for (const std::uint32_t v : m_mapped)
        m_opposite[v] = unknown;
    for (const std::int32_t f : m_mappedFaces)
        m_faceImages[at(f)] = -1;
    m_mapped.clear();
    m_mappedFaces.clear();
}

/// Each vertex and its counterpart are each other's, or lie in different components.
bool Growth::isInvolution() const
{
    return std::ranges::all_of(m_mapped, [this](std::uint32_t v) {
        const std::uint32_t back = m_opposite[m_opposite[v]];
        return back == unknown ? m_components[v] != m_components[m_opposite[v]] : back == v;
    });
}

double Growth::misfit(const std::optional<ReflectionPlane>& plane) const
{
    double difference = 0;
    double whole = 0;
    for (const std::int32_t f : m_mappedFaces)
        whole += m_edges.faceSizes[at(f)];
    double squares = 0;
    for (std::int32_t h = 0; h < m_edges.count(); ++h) {
        const std::uint32_t a = m_edges.from(h);
        const std::uint32_t b = m_edges.to(h);
        if (m_opposite[a] == unknown || m_opposite[b] == unknown)
            continue;
        const double length = lengthOf(a, b);
        const double step = length - lengthOf(m_opposite[a], m_opposite[b]);
        difference += step * step;
        squares += length * length;
    }
    std::vector<Vec3f> points;
    std::vector<Vec3f> images;
    for (const std::uint32_t v : m_mapped) {
        points.push_back(m_pose[v]);
        images.push_back(m_pose[m_opposite[v]]);
    }
    const ReflectionPlane across = plane ? *plane : reflectionPlane(points, images);
    double off = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        off += (across.reflected(points[i].cast<double>()) - images[i].cast<double>()).squaredNorm();
    const double edgeLength = squares / std::max(whole, 1.0);
    // A bent pose is far from its reflection, but its edges keep their lengths.
    const double fromPlane =
        off / static_cast<double>(std::max<std::size_t>(points.size(), 1)) / std::max(edgeLength, 1e-30);
    return difference / std::max(squares, 1e-30) + (plane ? 1e-2 : 1e-6) * fromPlane;
}

std::optional<Growth::Found> Growth::best(std::int32_t component, std::int32_t image,
                                          const std::optional<ReflectionPlane>& plane,
                                          const Progress& progress)
{
    const std::vector<std::int32_t> own = halfEdgesOf(component);
    const std::vector<std::int32_t> others = component == image ? own : halfEdgesOf(image);
    std::map<std::uint64_t, std::vector<std::int32_t>> bySignature;
    for (const std::int32_t h : others)
        bySignature[signature(h, true)].push_back(h);
    // The seed is the half-edge with the fewest possible images.
    std::int32_t seed = -1;
    std::vector<std::int32_t> images;
    for (const std::int32_t h : own) {
        const auto found = bySignature.find(signature(h, false));
        if (found == bySignature.end())
            return {};
        if (seed < 0 || found->second.size() < images.size()) {
            seed = h;
            images = found->second;
        }
    }
    if (seed < 0)
        return {};
    const double length = lengthOf(m_edges.from(seed), m_edges.to(seed));
    std::ranges::stable_sort(images, {}, [&](std::int32_t h) {
        return std::abs(lengthOf(m_edges.from(h), m_edges.to(h)) - length);
    });
    std::optional<Found> best;
    const std::int64_t budget = m_work + 500 * static_cast<std::int64_t>(own.size());
    for (const std::int32_t h : images) {
        progress.report(0.0);
        if (m_work > budget)
            break;
        if (!grow(seed, h))
            continue;
        const double misfitOfThis = misfit(plane);
        if (best && best->misfit <= misfitOfThis)
            continue;
        best = Found{.misfit = misfitOfThis, .vertices = m_mapped, .images = {}};
        for (const std::uint32_t v : m_mapped)
            best->images.push_back(m_opposite[v]);
    }
    clear();
    return best;
}

/// Vertices of each component, and the order of the components by size.
struct Components
{
    std::vector<std::int64_t> sizes;
    std::vector<std::int32_t> order;
};

Components componentsOf(const Topology& topology)
{
    Components result;
    result.sizes.assign(static_cast<std::size_t>(topology.statistics().components), 0);
    for (const std::int32_t c : topology.components()) {
        if (c >= 0)
            ++result.sizes[at(c)];
    }
    for (std::int32_t c = 0; at(c) < result.sizes.size(); ++c)
        result.order.push_back(c);
    std::ranges::stable_sort(result.order, std::greater(),
                             [&](std::int32_t c) { return result.sizes[at(c)]; });
    return result;
}

/// How much edges differ in length from their counterparts, root mean square, shares of their own.
double lengthError(const FaceEdges& edges, const std::vector<VertexIndex>& opposite, Positions pose)
{
    double difference = 0;
    double squares = 0;
    for (std::int32_t h = 0; h < edges.count(); ++h) {
        const std::uint32_t a = edges.from(h);
        const std::uint32_t b = edges.to(h);
        const float own = (pose[a] - pose[b]).norm();
        const float other = (pose[opposite[a].value] - pose[opposite[b].value]).norm();
        difference += static_cast<double>((own - other) * (own - other));
        squares += static_cast<double>(own * own);
    }
    return squares > 0 ? std::sqrt(difference / squares) : 0;
}

} // namespace

bool hasTwins(const Topology& topology)
{
    const Components components = componentsOf(topology);
    return components.order.size() > 1 &&
           components.sizes[at(components.order[0])] == components.sizes[at(components.order[1])];
}

std::optional<GrownSymmetry> grownSymmetry(const Topology& topology, const FaceEdges& edges, Positions pose,
                                           const std::optional<ReflectionPlane>& plane,
                                           const Progress& progress)
{
    const Components components = componentsOf(topology);
    Growth growth(edges, topology.components(), pose);
    std::vector<VertexIndex> opposite;
    for (std::uint32_t v = 0; v < topology.vertexCount(); ++v)
        opposite.emplace_back(v);
    std::vector<bool> isMapped(components.order.size(), false);
    std::vector<Vec3f> points;
    std::vector<Vec3f> images;
    for (const std::int32_t component : components.order) {
        if (isMapped[at(component)])
            continue;
        const std::optional<ReflectionPlane> across =
            points.empty() ? plane : std::optional(reflectionPlane(points, images));
        std::optional<Growth::Found> best;
        for (const std::int32_t other : components.order) {
            if (isMapped[at(other)] || components.sizes[at(other)] != components.sizes[at(component)])
                continue;
            auto found = growth.best(component, other, across, progress);
            if (found && (!best || found->misfit < best->misfit))
                best = std::move(found);
        }
        if (!best)
            return {};
        for (std::size_t i = 0; i < best->vertices.size(); ++i) {
            const std::uint32_t a = best->vertices[i];
            const std::uint32_t b = best->images[i];
            opposite[a] = VertexIndex(b);
            opposite[b] = VertexIndex(a);
            isMapped[at(topology.components()[a])] = true;
            isMapped[at(topology.components()[b])] = true;
            points.push_back(pose[a]);
            images.push_back(pose[b]);
        }
    }
    const double error = lengthError(edges, opposite, pose);
    return GrownSymmetry{std::move(opposite), error};
}

} // namespace quadrille
