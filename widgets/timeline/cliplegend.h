// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/framekind.h"

#include <QWidget>
#include <vector>

namespace quadrille::widgets {

/// What the colours and patterns of a clip's strip stand for, in one line.
class ClipLegend : public QWidget
{
    Q_OBJECT

public:
    explicit ClipLegend(std::vector<FrameKind> kinds, QWidget* parent = nullptr);

    /// Where the sign of a kind is painted, in this widget's coordinates.
    QRectF signRect(FrameKind kind) const;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void updateText();

    std::vector<FrameKind> m_kinds;
};

} // namespace quadrille::widgets
