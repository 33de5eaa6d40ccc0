// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/surfacepairlayout.h"

#include "widgets/tools/pixeldistances.h"
#include "widgets/tools/surfacevisibility.h"

namespace quadrille::widgets {

namespace {

constexpr double catchRadius = 9.0; // pixels

} // namespace

SurfacePairLayout::SurfacePairLayout(const SurfacePairContent& content, std::array<SurfaceView, 2> views,
                                     SeenEnds& seen)
    : m_content(content), m_views(std::move(views)), m_seen(seen)
{
}

bool SurfacePairLayout::has(const PairPlace& place) const
{
    return place.triangle < m_views[static_cast<std::size_t>(place.side)].shape.mesh.triangles.size();
}

PairPlace SurfacePairLayout::placeOf(const PairEnd& end) const
{
    const SurfacePair& pair = m_content.pairs[static_cast<std::size_t>(end.pair)];
    return {end.side, pair.triangles[static_cast<std::size_t>(end.side)]};
}

std::optional<QPointF> SurfacePairLayout::pixelOf(const PairPlace& place) const
{
    if (!has(place))
        return std::nullopt;
    const SurfaceView& view = m_views[static_cast<std::size_t>(place.side)];
    QVector3D middle;
    for (const std::uint32_t vertex : view.shape.mesh.triangles[place.triangle])
        middle += view.place(vertex) / 3.0F;
    return view.project(middle);
}

std::optional<QPointF> SurfacePairLayout::pixelOf(const PairEnd& end) const
{
    return pixelOf(placeOf(end));
}

const std::vector<std::array<bool, 2>>& SurfacePairLayout::seen() const
{
    if (m_seen)
        return *m_seen;
    m_seen.emplace(m_content.pairs.size());
    for (int side = 0; side < 2; ++side) {
        const SurfaceView& view = m_views[static_cast<std::size_t>(side)];
        std::vector<std::uint32_t> vertices;
        for (int p = 0; p < static_cast<int>(m_content.pairs.size()); ++p) {
            const PairPlace place = placeOf({p, side});
            vertices.push_back(has(place) ? view.shape.mesh.triangles[place.triangle][0] : 0);
        }
        const std::vector<bool> visible = visibleVertices(view.shape, view.camera, view.size, vertices);
        for (std::size_t p = 0; p < m_content.pairs.size(); ++p)
            (*m_seen)[p][static_cast<std::size_t>(side)] =
                visible[p] && has(placeOf({static_cast<int>(p), side}));
    }
    return *m_seen;
}

bool SurfacePairLayout::isSeen(const PairEnd& end) const
{
    return seen()[static_cast<std::size_t>(end.pair)][static_cast<std::size_t>(end.side)];
}

PairEnd SurfacePairLayout::endAt(const QPointF& pixel) const
{
    PairEnd nearest;
    double least = catchRadius;
    for (int p = 0; p < static_cast<int>(m_content.pairs.size()); ++p) {
        for (int side = 0; side < 2; ++side) {
            const PairEnd end{p, side};
            if (!isSeen(end))
                continue;
            const auto at = pixelOf(end);
            if (at && distanceBetween(*at, pixel) < least) {
                least = distanceBetween(*at, pixel);
                nearest = end;
            }
        }
    }
    return nearest;
}

std::optional<PairPlace> SurfacePairLayout::placeAt(const QPointF& pixel) const
{
    std::optional<PairPlace> found;
    float least = 0.0F;
    for (int side = 0; side < 2; ++side) {
        const SurfaceView& view = m_views[static_cast<std::size_t>(side)];
        const auto place = view.placeAt(pixel, Qt::NoModifier);
        if (!place)
            continue;
        const float depth = (place->pick.point - view.camera.position()).length();
        if (!found || depth < least) {
            found = PairPlace{side, place->pick.triangle};
            least = depth;
        }
    }
    return found;
}

} // namespace quadrille::widgets
