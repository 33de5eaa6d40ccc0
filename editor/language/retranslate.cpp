// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/language/retranslate.h"

#include <QEvent>
#include <QObject>
#include <utility>

namespace quadrille {

namespace {

class Retranslator : public QObject
{
public:
    Retranslator(QWidget* widget, std::function<void()> setTexts)
        : QObject(widget), m_setTexts(std::move(setTexts))
    {
        widget->installEventFilter(this);
    }
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (watched == parent() && event->type() == QEvent::LanguageChange)
            m_setTexts();
        return false;
    }

private:
    std::function<void()> m_setTexts;
};

} // namespace

void retranslates(QWidget* widget, std::function<void()> setTexts)
{
    setTexts();
    new Retranslator(widget, std::move(setTexts));
}

} // namespace quadrille
