// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/costbar.h"

#include "widgets/theme/theme.h"

#include <QPainter>

namespace quadrille {

void CostBar::setParts(double deformation, double duration)
{
    m_deformation = deformation;
    m_duration = duration;
    update();
}

void CostBar::paintEvent(QPaintEvent* /*event*/)
{
    using widgets::ColorRole;
    using widgets::Theme;
    const double sum = m_deformation + m_duration;
    if (sum <= 0)
        return;
    QPainter painter(this);
    const QRectF all = QRectF(rect()).adjusted(0.5, 2.5, -0.5, -2.5);
    QRectF first = all;
    first.setWidth(all.width() * m_deformation / sum);
    QRectF second = all;
    second.setLeft(first.right());
    painter.fillRect(first, Theme::categorical(0));
    painter.fillRect(second, Theme::color(ColorRole::Raised));
    painter.fillRect(second, QBrush(Theme::color(ColorRole::TextMuted), Qt::BDiagPattern));
    painter.setPen(Theme::color(ColorRole::Line));
    painter.drawRect(all);
    painter.drawLine(first.topRight(), first.bottomRight());
}

} // namespace quadrille
