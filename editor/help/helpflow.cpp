// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/help/helpflow.h"

#include "editor/application/standardkeys.h"
#include "editor/context/actionregistry.h"
#include "editor/help/helpviewer.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QMainWindow>

namespace quadrille {

HelpFlow::HelpFlow(ActionRegistry& actions, QMainWindow& window) : QObject(&window), m_window(window)
{
    const auto help = [] { return tr("Help"); };
    actions.add({"help.manual", help, [] { return tr("&Manual"); }, {}, "help", {}}, [this] { show({}); });
    actions.add({"help.here", help, [] { return tr("&Help on this"); },
                 [] { return tr("Opens the manual at what the mouse points at or has the focus"); }, "help",
                 standardKeys(QKeySequence::HelpContents)},
                [this] { show(helpTopicIn(m_window)); });
    qApp->installEventFilter(this);
}

void HelpFlow::show(const HelpTopic& topic)
{
    // A modal dialog keeps input from all windows but its own.
    QWidget* modal = QApplication::activeModalWidget();
    QWidget* parent = modal != nullptr ? modal : &m_window;
    auto* viewer = parent->findChild<HelpViewer*>(QString(), Qt::FindDirectChildrenOnly);
    if (viewer == nullptr)
        viewer = new HelpViewer(parent);
    viewer->showTopic(topic);
    viewer->show();
    viewer->raise();
    viewer->activateWindow();
}

/// In dialogs the window's shortcut does not work.
bool HelpFlow::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::KeyPress || static_cast<QKeyEvent*>(event)->key() != Qt::Key_F1)
        return false;
    const auto* dialog = qobject_cast<QDialog*>(watched);
    if (dialog == nullptr || qobject_cast<const HelpViewer*>(dialog) != nullptr)
        return false;
    show(helpTopicIn(*dialog));
    return true;
}

} // namespace quadrille

#include "moc_helpflow.cpp"
