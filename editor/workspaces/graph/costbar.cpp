// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/costbar.h"

#include "widgets/theme/theme.h"

#include <QPainter>
#include <numeric>

namespace quadrille {

void CostBar::setParts(const std::array<double, 3>& deformation, double duration)
{
    m_deformation = deformation;
    m_duration = duration;
    update();
}

void CostBar::paintEvent(QPaintEvent* /*event*/)
{
    using widgets::ColorRole;
    using widgets::Theme;
    const double sum = std::accumulate(m_deformation.begin(), m_deformation.end(), m_duration);
    if (sum <= 0)
        return;
    QPainter painter(this);
    const QRectF all = QRectF(rect()).adjusted(0.5, 2.5, -0.5, -2.5);
    painter.setPen(Theme::color(ColorRole::Line));
    QRectF part = all;
    for (std::size_t p = 0; p < m_deformation.size(); ++p) {
        part.setWidth(all.width() * m_deformation[p] / sum);
        painter.fillRect(part, Theme::categorical(static_cast<int>(p)));
        painter.drawLine(part.topRight(), part.bottomRight());
        part.setLeft(part.right());
    }
    part.setRight(all.right());
    painter.fillRect(part, Theme::color(ColorRole::Raised));
    painter.fillRect(part, QBrush(Theme::color(ColorRole::TextMuted), Qt::BDiagPattern));
    painter.drawRect(all);
}

} // namespace quadrille

#include "moc_costbar.cpp"
