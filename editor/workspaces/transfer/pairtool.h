// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/transfer/currenttransfer.h"
#include "widgets/tools/surfacepaireditor.h"

#include <QObject>

namespace quadrille {

/// Joins the pairs of a transfer with the view: what is clicked and dragged there becomes edits that can be
/// undone. Registers the actions of pairs.
class PairTool : public QObject
{
    Q_OBJECT

public:
    explicit PairTool(CurrentTransfer& transfer, QObject* parent = nullptr);

    CurrentTransfer& transfer() const { return m_transfer; }
    widgets::SurfacePairEditor& editor() const { return *m_editor; }
    void setActive(bool active);
    /// Pairs, figures or what can be done are others.
    void refresh();

private:
    void makeActions();
    void connectEditor();
    void propose();
    void mirrorAll();
    void addCounterpart();
    /// Says something about the last thing that was asked for, or takes it back.
    void tell(const QString& text);
    void showHint();
    void refreshActions();

    CurrentTransfer& m_transfer;
    widgets::SurfacePairEditor* m_editor;
    QString m_told;
    bool m_isActive = false;
};

} // namespace quadrille
