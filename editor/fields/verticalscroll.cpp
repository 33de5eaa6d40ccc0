// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/verticalscroll.h"

#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <algorithm>

namespace quadrille {

namespace {

/// Keeps an area as wide as what is in it needs, whatever language that speaks by now.
class WidthKeeper : public QObject
{
public:
    WidthKeeper(QScrollArea* area, QWidget* content) : QObject(area), m_area(area), m_content(content)
    {
        content->installEventFilter(this);
        keep();
    }

    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Polish)
            keep();
        return QObject::eventFilter(watched, event);
    }

private:
    void keep()
    {
        constexpr int mostCharacters = 50; // beyond that it scrolls to the side: the middle needs room, too
        const int needed =
            m_content->minimumSizeHint().width() + m_area->verticalScrollBar()->sizeHint().width();
        m_area->setMinimumWidth(
            std::min(needed, mostCharacters * m_content->fontMetrics().averageCharWidth()));
    }

    QScrollArea* m_area;
    QWidget* m_content;
};

} // namespace

QScrollArea* verticalScroll(QWidget* content)
{
    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidget(content);
    new WidthKeeper(area, content);
    return area;
}

} // namespace quadrille
