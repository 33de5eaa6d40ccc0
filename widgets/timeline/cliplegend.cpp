// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/cliplegend.h"

#include "widgets/theme/theme.h"

#include <QEvent>
#include <QPainter>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr double gap = 8; // logical pixels
constexpr double signWidth = 24;

} // namespace

ClipLegend::ClipLegend(std::vector<FrameKind> kinds, QWidget* parent)
    : QWidget(parent), m_kinds(std::move(kinds))
{
    setObjectName(QStringLiteral("clipLegend"));
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
    updateText();
}

QSize ClipLegend::sizeHint() const
{
    return {200, static_cast<int>(std::ceil(QFontMetricsF(font()).height())) + 4};
}

QRectF ClipLegend::signRect(FrameKind kind) const
{
    const QFontMetricsF metrics(font());
    double left = gap;
    for (const FrameKind each : m_kinds) {
        if (each == kind)
            break;
        left += signWidth + gap / 2 + metrics.horizontalAdvance(frameKindName(each)) + 2 * gap;
    }
    return {left, (height() - metrics.ascent()) / 2, signWidth, metrics.ascent()};
}

void ClipLegend::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const FrameKind kind : m_kinds) {
        const QRectF sign = signRect(kind);
        const QColor color = frameKindColor(kind);
        painter.setPen(QPen(color.darker(130), 1.0));
        painter.setBrush(color);
        painter.drawRoundedRect(sign.adjusted(0.5, 0.5, -0.5, -0.5), 2, 2);
        paintFramePattern(painter, sign.adjusted(1, 1, -1, -1), kind, color);
        painter.setPen(Theme::color(ColorRole::TextMuted));
        painter.drawText(QRectF(sign.right() + gap / 2, 0, width(), height()),
                         Qt::AlignLeft | Qt::AlignVCenter, frameKindName(kind));
    }
}

void ClipLegend::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange) {
        updateText();
        updateGeometry();
        update();
    }
}

void ClipLegend::updateText()
{
    QStringList names;
    for (const FrameKind kind : m_kinds)
        names += frameKindName(kind);
    setAccessibleName(tr("Frames of the clip: %1").arg(names.join(QStringLiteral(", "))));
}

} // namespace quadrille::widgets

#include "moc_cliplegend.cpp"
