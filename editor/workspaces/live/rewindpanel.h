// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QLabel;
class QTreeWidget;

namespace quadrille {

class LiveSession;

/// The transitions that were made, each with the ways that were found for it: what was chosen, what going on
/// would have cost, the next best, and what their costs are made of. Choosing one goes there.
class RewindPanel : public QWidget
{
    Q_OBJECT

public:
    explicit RewindPanel(LiveSession& session, QWidget* parent = nullptr);

private:
    void retranslate();
    void refresh();

    LiveSession& m_session;
    QTreeWidget* m_tree;
    QLabel* m_hint;
};

} // namespace quadrille
