// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/context/editorcontext.h"
#include "editor/playback/clipscene.h"
#include "editor/playback/player.h"
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "editor/workspaces/workspacetabs.h"
#include "editortest.h"
#include "widgets/theme/theme.h"

#include <QDir>
#include <QDockWidget>

namespace quadrille::test {

inline const QStringList workspaceNames{"sequences", "graph", "animate", "variations", "appearance"};

/// Tests of the window: a fresh one for each, and a take of six frames to open.
class WindowFixture : public QObject
{
    Q_OBJECT

protected:
    EditorContext& context() { return m_window->context(); }
    QAction* action(const char* id) { return context().actions.action(id); }
    Player& player() { return m_window->sequences().player(); }
    QDockWidget* dock(const char* name) const { return m_window->findChild<QDockWidget*>(name); }
    void openTake()
    {
        m_window->open({m_folder.filePath("walk_1.obj")});
        QVERIFY(waitForSequence(*m_window, "walk"));
        QTRY_VERIFY(m_window->sequences().scene().frameCount() == 6);
        QTRY_VERIFY(player().isPlaying());
        player().pause();
    }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase()
    {
        isolate();
        widgets::Theme::instance().install();
        writeSeries(m_folder.path(), {1, 2, 3, 4, 5, 6});
    }
    void init()
    {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        QVERIFY(activate(*m_window));
    }
    void cleanup()
    {
        context().document.undoStack()->setClean();
        m_window.reset();
        QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)).removeRecursively();
    }
};

} // namespace quadrille::test
