// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QHash>
#include <QPalette>
#include <QProxyStyle>

namespace quadrille::widgets {

/// Fusion with outlines that can be seen: it darkens the window's colour for them, which leaves fields and
/// check boxes of a dark theme without any. Here they have ColorRole::Line. The buttons of dialogs have no
/// icons; tabs leave room for their words; a choice that is longer than its box ends in dots; a bar that has
/// more tools than room shows where they are.
class OutlineStyle : public QProxyStyle
{
    Q_OBJECT
public:
    OutlineStyle();

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
    QIcon standardIcon(StandardPixmap icon, const QStyleOption* option, const QWidget* widget) const override;
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* result) const override;

private:
    QPalette outlined(const QPalette& palette) const;

    /// By the key of the palette they were made of: Fusion caches pictures by the palette's identity.
    mutable QHash<qint64, QPalette> m_outlined;
};

} // namespace quadrille::widgets
