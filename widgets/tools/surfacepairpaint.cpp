// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/surfacepairpaint.h"

#include "widgets/theme/theme.h"
#include "widgets/tools/toolpaint.h"

#include <QPainter>

namespace quadrille::widgets {

namespace {

constexpr double endRadius = 4.0;     // pixels
constexpr double pairLine = 1.5;      // pixels
constexpr double nameDistance = 22.0; // pixels above an end

void paintPairLine(QPainter& painter, const SurfacePairLayout& layout, int pair)
{
    const auto first = layout.pixelOf(PairEnd{pair, 0});
    const auto second = layout.pixelOf(PairEnd{pair, 1});
    const SurfacePair& shown = layout.content().pairs[static_cast<std::size_t>(pair)];
    if (first && second)
        paintToolLine(painter, QPolygonF{*first, *second}, shown.color, pairLine, Qt::DashLine);
}

void paintEnds(QPainter& painter, const SurfacePairLayout& layout, int pair, const PairEnd& hovered)
{
    const SurfacePair& shown = layout.content().pairs[static_cast<std::size_t>(pair)];
    const bool isSelected = pair == layout.content().selected;
    for (int side = 0; side < 2; ++side) {
        const PairEnd end{pair, side};
        const auto at = layout.pixelOf(end);
        if (!at || (!isSelected && !layout.isSeen(end)))
            continue;
        paintHandle(painter, *at,
                    {.form = shown.isDoubtful ? HandleLook::Form::Cross : HandleLook::Form::Circle,
                     .radius = endRadius,
                     .color = shown.color,
                     .isSelected = isSelected,
                     .isHovered = pair == hovered.pair});
    }
}

} // namespace

void paintSurfacePairs(QPainter& painter, const SurfacePairLayout& layout, const PairEnd& hovered)
{
    const SurfacePairContent& content = layout.content();
    const auto count = static_cast<int>(content.pairs.size());
    for (int pair = 0; pair < count; ++pair) {
        if (pair != content.selected && pair != hovered.pair)
            paintEnds(painter, layout, pair, hovered);
    }
    for (const int pair : {content.selected, hovered.pair}) {
        if (pair < 0 || pair >= count)
            continue;
        paintPairLine(painter, layout, pair);
        paintEnds(painter, layout, pair, hovered);
    }
    const PairEnd named = hovered.isNone() ? PairEnd{content.selected, 1} : hovered;
    if (named.isNone() || named.pair >= count)
        return;
    const auto at = layout.pixelOf(named);
    if (at)
        paintToolWords(painter, *at - QPointF(0.0, nameDistance),
                       content.pairs[static_cast<std::size_t>(named.pair)].name);
}

void paintBegunPair(QPainter& painter, const SurfacePairLayout& layout, const QPointF& pointer)
{
    const auto at = layout.pixelOf(*layout.content().begun);
    if (!at)
        return;
    const QColor color = Theme::color(ColorRole::Key);
    if (!pointer.isNull())
        paintToolLine(painter, QPolygonF{*at, pointer}, color, pairLine, Qt::DashLine);
    paintHandle(painter, *at, {.form = HandleLook::Form::Diamond, .color = color, .isSelected = true});
}

} // namespace quadrille::widgets
