// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QLabel;
class QTreeWidget;

namespace quadrille {

class CurrentTransfer;
class PairTool;

/// The pairs of a transfer as a list: where each is on the body and how alike its places are; and what is to
/// be said about all of them.
class PairsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit PairsPanel(PairTool& tool, QWidget* parent = nullptr);

private:
    void retranslate();
    void refresh();
    void showSelection();
    QString advice() const;

    CurrentTransfer& m_transfer;
    QTreeWidget* m_list;
    QLabel* m_advice;
    bool m_isShowing = false;
};

} // namespace quadrille
