// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QAbstractButton>
#include <QDockWidget>
#include <QLabel>
#include <QTabBar>

namespace quadrille::test {

/// Words in a window that their widgets have no room for: labels, buttons, tabs and titles of panels.
inline QStringList wordsCutIn(const QWidget& window)
{
    QStringList cut;
    const auto check = [&cut](const QString& text, const QFontMetrics& metrics, int room) {
        if (metrics.size(Qt::TextShowMnemonic, text).width() > room)
            cut += text;
    };
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible())
            continue;
        if (const auto* label = qobject_cast<const QLabel*>(widget);
            label != nullptr && !label->wordWrap() && !Qt::mightBeRichText(label->text()))
            check(label->text(), label->fontMetrics(), label->contentsRect().width());
        if (const auto* button = qobject_cast<const QAbstractButton*>(widget);
            button != nullptr && !button->text().isEmpty() &&
            button->width() < button->minimumSizeHint().width())
            cut += button->text();
        if (const auto* dock = qobject_cast<const QDockWidget*>(widget);
            dock != nullptr && !dock->isFloating()) {
            constexpr int buttons = 60; // to float it and to close it, and what is between
            check(dock->windowTitle(), dock->fontMetrics(), dock->width() - buttons);
        }
        if (const auto* tabs = qobject_cast<const QTabBar*>(widget)) {
            for (int tab = 0; tab < tabs->count(); ++tab) {
                const QRect place = tabs->tabRect(tab);
                check(tabs->tabText(tab), tabs->fontMetrics(),
                      tabs->rect().contains(place) ? place.width() : 0);
            }
        }
    }
    return cut;
}

} // namespace quadrille::test
