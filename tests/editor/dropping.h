// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editortest.h"

#include <QDragEnterEvent>
#include <QListView>
#include <QMimeData>
#include <memory>

namespace quadrille::test {

/// Drags data onto a place of a widget and drops it there.
inline void drop(const QMimeData& data, QWidget& target, const QPoint& where)
{
    QDragEnterEvent enter(where, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&target, &enter);
    QVERIFY(enter.isAccepted());
    QDragMoveEvent move(where, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&target, &move);
    QDropEvent end(where, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&target, &end);
}

/// Drags the card of a take onto a place of a widget.
inline void dropCard(const QString& take, QWidget& target, const QPoint& where)
{
    const QAbstractItemModel* cards = find<QListView>("cards")->model();
    QModelIndex card;
    for (int row = 0; row < cards->rowCount(); ++row) {
        if (cards->index(row, 0).data().toString() == take)
            card = cards->index(row, 0);
    }
    QVERIFY(card.isValid());
    const std::unique_ptr<QMimeData> data(cards->mimeData({card}));
    drop(*data, target, where);
}

} // namespace quadrille::test
