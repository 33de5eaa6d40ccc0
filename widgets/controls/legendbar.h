// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/theme/colormap.h"

#include <QWidget>

namespace quadrille::widgets {

/// The size a legend wants: an upright bar with its numbers beside it and title and unit above.
QSizeF legendSize(const QFont& font, const ScalarRange& range);
/// \param place  at least as large as legendSize() says.
void paintLegend(QPainter& painter, const QRectF& place, const ScalarRange& range, const QColor& text);

/// Explains the colours of a scalar.
class LegendBar : public QWidget
{
    Q_OBJECT
public:
    explicit LegendBar(QWidget* parent = nullptr);
    void setRange(const ScalarRange& range);
    const ScalarRange& range() const { return m_range; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    ScalarRange m_range;
};

} // namespace quadrille::widgets
