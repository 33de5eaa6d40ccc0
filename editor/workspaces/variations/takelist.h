// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QTreeWidget>

namespace quadrille {

/// A list onto which takes can be dropped.
class TakeList : public QTreeWidget
{
    Q_OBJECT

public:
    explicit TakeList(QWidget* parent = nullptr);

signals:
    void takesDropped(const QStringList& takes);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
};

} // namespace quadrille
