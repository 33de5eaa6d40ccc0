// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/partlist.h"

#include "editor/fields/ownkeys.h"
#include "widgets/theme/theme.h"

#include <QKeyEvent>
#include <QSignalBlocker>
#include <algorithm>

namespace quadrille {

namespace {

constexpr int partHeight = 24; // pixels
constexpr int mostRows = 6;

} // namespace

PartList::PartList(const QString& name, QWidget* parent) : QListWidget(parent)
{
    setObjectName(name);
    setUniformItemSizes(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFont(widgets::Theme::tabularFont(font()));
}

void PartList::fill(const QStringList& texts)
{
    const QSignalBlocker quiet(this);
    const int row = currentRow();
    clear();
    addItems(texts);
    for (int i = 0; i < count(); ++i)
        item(i)->setSizeHint({0, partHeight});
    setCurrentRow(row < count() ? row : -1);
    setVisible(count() > 0);
    setFixedHeight(std::min(count(), mostRows) * partHeight + 2 * frameWidth());
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
