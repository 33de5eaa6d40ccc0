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

    /// The current row stays where there still is one; nobody is told. An empty list hides itself.
    void fill(const QStringList& texts);
    /// Without telling anybody; −1 for none.
    void showRow(int row);

signals:
    /// The list itself takes nothing away.
    void deletionRequested(int row);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();
};

} // namespace quadrille
