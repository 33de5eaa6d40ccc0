// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/help/helptopics.h"

#include <QObject>

class QMainWindow;

namespace quadrille {

class ActionRegistry;

/// Opens the manual: at its contents, or by F1 at what somebody points at, in dialogs too.
class HelpFlow : public QObject
{
    Q_OBJECT

public:
    HelpFlow(ActionRegistry& actions, QMainWindow& window);

    void show(const HelpTopic& topic);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QMainWindow& m_window;
};

} // namespace quadrille
