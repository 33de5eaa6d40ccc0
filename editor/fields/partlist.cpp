// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/partlist.h"

#include "editor/fields/ownkeys.h"
#include "widgets/theme/theme.h"

#include <QKeyEvent>
#include <QResizeEvent>
#include <QSignalBlocker>
#include <algorithm>

namespace quadrille {

namespace {

constexpr int partHeight = 24; // pixels
constexpr int mostRows = 6;
constexpr int textMargin = 8; // pixels

} // namespace

PartList::PartList(const QString& name, QWidget* parent) : QListWidget(parent)
{
    setObjectName(name);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFont(widgets::Theme::tabularFont(font()));
    setWordWrap(true);
}

void PartList::fill(const QStringList& texts)
{
    const QSignalBlocker quiet(this);
    const int row = currentRow();
    clear();
    addItems(texts);
    setCurrentRow(row < count() ? row : -1);
    setVisible(count() > 0);
    arrange();
}

/// Long texts have as many lines as they need.
void PartList::arrange()
{
    int height = 2 * frameWidth();
    for (int i = 0; i < count(); ++i) {
        const QRect room(0, 0, std::max(1, viewport()->width() - 2 * textMargin), 0);
        const int text =
            fontMetrics().boundingRect(room, Qt::TextWordWrap | Qt::AlignLeading, item(i)->text()).height();
        const int row = std::max(partHeight, text + partHeight - fontMetrics().height());
        item(i)->setSizeHint({0, row});
        if (i < mostRows)
            height += row;
    }
    setFixedHeight(height);
}

void PartList::resizeEvent(QResizeEvent* event)
{
    QListWidget::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        arrange();
}

void PartList::showRow(int row)
{
    const QSignalBlocker quiet(this);
    setCurrentRow(row);
}

bool PartList::event(QEvent* event)
{
    return takesOwnKeys(*event, {Qt::Key_Delete}) || QListWidget::event(event);
}

void PartList::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Delete && currentRow() >= 0)
        emit deletionRequested(currentRow());
    else
        QListWidget::keyPressEvent(event);
}

} // namespace quadrille

#include "moc_partlist.cpp"
