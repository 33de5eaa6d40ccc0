// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/context/editorcontext.h"
#include "editor/workspaces/live/livesession.h"
#include "editor/workspaces/live/liveworkspace.h"
#include "editor/workspaces/workspacetabs.h"
#include "editortest.h"
#include "tests/model/project/spacesofwalks.h"

#include <QTemporaryDir>
#include <memory>

namespace quadrille {

/// The window with a saved project of two takes of a tube that walks, and two motion spaces of them.
class LiveFixture : public QObject
{
    Q_OBJECT

protected:
    EditorContext& context() { return m_window->context(); }
    ProjectDocument& document() { return context().document; }
    LiveWorkspace& workspace() { return m_window->live(); }
    LiveSession& session() { return workspace().session(); }
    QAction* action(const char* id) { return context().actions.action(QLatin1String(id)); }

    void writeTake(const QString& name, const test::TubeWalk& walk)
    {
        test::writeWalk(m_folder->filePath(name).toStdString(), walk);
    }
    static MotionSpaceEntry spaceOf(const std::string& name, const std::vector<std::string>& takes)
    {
        return test::spaceOf(name, takes, 0.02);
    }
    void play(int ticks)
    {
        for (int t = 0; t < ticks; ++t)
            session().step();
    }
    void open()
    {
        m_window->open({m_folder->filePath("p.quadrille")});
        QVERIFY(test::waitForSequence(*m_window, "slow"));
        m_window->workspaces().select("live");
        QTRY_VERIFY(session().isReady());
        QTRY_VERIFY(workspace().scene().figureOf(LiveWorkspace::figureName()) >= 0);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;

protected slots:
    void initTestCase()
    {
        test::isolate();
        m_folder = std::make_unique<QTemporaryDir>();
        writeTake("slow", test::slowWalk);
        writeTake("fast", test::fastWalk);
        const QString file = m_folder->filePath("p.quadrille");
        m_window = std::make_unique<MainWindow>();
        Project project;
        for (const char* name : {"slow", "fast"}) {
            SequenceEntry& sequence = project.sequences.emplace_back();
            sequence.name = name;
            sequence.source = m_folder->filePath(name).toStdString();
        }
        project.motionSpaces = {spaceOf("walk", {"slow", "fast"}), spaceOf("steady", {"slow"})};
        document().reset(project);
        document().saveAs(file.toStdString());
        m_window.reset();
    }
    void init()
    {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }
    void cleanup()
    {
        if (m_window)
            document().undoStack()->setClean();
        m_window.reset();
    }
};

} // namespace quadrille
