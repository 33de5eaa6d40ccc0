// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/pathdrag.h"

#include "widgets/tools/handletool.h"
#include "widgets/tools/pathedits.h"

#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

PathDrag::PathDrag(const PathLayout& layout, const PathPart& part, const QPointF& pixel,
                   Qt::KeyboardModifiers modifiers)
    : m_part(part)
    , m_before(layout.shape())
    , m_pressedAt(pixel)
    , m_start(layout.placeOf(part).value_or(QVector3D()))
{
    const GroundView& view = layout.view();
    const bool isAnchor = part.kind == PathPart::Kind::Point && !isHandle(m_before.kind, part.at());
    m_isLifting = part.kind == PathPart::Kind::Lift ||
                  (isAnchor && m_before.inSpace && modifiers.testFlag(Qt::AltModifier));
    if (m_isLifting)
        m_grabbed[view.upIndex()] = view.heightAt(pixel, m_start);
    else
        m_grabbed = view.placeAt(pixel, m_start[view.upIndex()]).value_or(m_start);
    if (part.kind == PathPart::Kind::ObstacleRadius)
        m_start = m_grabbed;
}

std::optional<PathShape> PathDrag::moveTo(const PathLayout& layout, const QPointF& pixel,
                                          Qt::KeyboardModifiers modifiers)
{
    m_moved = m_moved || HandleTool::isDrag(m_pressedAt, pixel);
    if (!m_moved)
        return std::nullopt;
    const GroundView& view = layout.view();
    if (m_part.isStretchEnd()) {
        const auto length = layout.lengthAt(pixel);
        return length ? std::optional(withStretchEndAt(m_before, m_part, *length, view.ruler)) : std::nullopt;
    }
    QVector3D place = m_start;
    if (m_isLifting)
        place = lifted(view, pixel, modifiers);
    else if (const auto now = view.placeAt(pixel, m_start[view.upIndex()]))
        place = view.constrained(m_start, m_start + *now - m_grabbed, modifiers);
    return withPartAt(m_before, m_part, place, !modifiers.testFlag(Qt::AltModifier), view.ruler);
}

QVector3D PathDrag::lifted(const GroundView& view, const QPointF& pixel,
                           Qt::KeyboardModifiers modifiers) const
{
    QVector3D place = m_start;
    float& height = place[view.upIndex()];
    height = std::max(height + view.heightAt(pixel, m_start) - m_grabbed[view.upIndex()], view.ground);
    if (modifiers.testFlag(Qt::ControlModifier)) {
        const auto step = static_cast<float>(view.ruler.middle());
        height = std::round(height / step) * step;
    }
    return place;
}

} // namespace quadrille::widgets
