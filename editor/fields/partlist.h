// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QListWidget>

namespace quadrille {

/// A short list of parts of something, as high as its rows; Delete asks to take the current one away.
class PartList : public QListWidget
{
    Q_OBJECT

public:
    explicit PartList(const QString& name, QWidget* parent = nullptr);

    void fill(const QStringList& texts);
    /// Without telling anybody; −1 for none.
    void showRow(int row);

signals:
    void deletionRequested(int row);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
};

} // namespace quadrille
