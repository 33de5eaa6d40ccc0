// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "animatedproject.h"
#include "editor/commands/animationedits.h"
#include "editor/workspaces/graph/graphexplorer.h"
#include "editor/workspaces/graph/graphmap.h"
#include "editor/workspaces/graph/graphworkspace.h"
#include "widgets/graph/matrixview.h"

#include <QLabel>
#include <QPushButton>
#include <memory>

namespace quadrille {

/// The window with the Graph workspace in front and the takes of the swaying spire.
class GraphFixture : public QObject
{
    Q_OBJECT

protected:
    EditorContext& context() { return m_window->context(); }
    GraphWorkspace& workspace() { return *test::find<GraphWorkspace>("graphWorkspace"); }
    GraphExplorer& explorer() { return workspace().explorer(); }
    widgets::MatrixView& matrix() { return workspace().map().matrix(); }
    const CharacterGraph& graph() { return explorer().character()->graph; }
    static QString text(const char* label) { return test::find<QLabel>(label)->text(); }
    double projectAlpha() { return graphEntry(context().document.project(), "spire").alpha; }

    void compute()
    {
        auto* button = test::find<QPushButton>("graphStateButton");
        QTRY_VERIFY(context().graphs.resultState("spire") != nullptr);
        QTRY_VERIFY(context().graphs.resultState("spire")->phase == ResultPhase::Idle);
        QTest::mouseClick(button, Qt::LeftButton);
        QTRY_VERIFY(explorer().character() != nullptr);
        waitForPaths();
        QTRY_VERIFY(matrix().values().side == graph().layout().frameCount());
    }
    /// Until what shows is of the α that is set.
    void waitForPaths()
    {
        QTRY_VERIFY(explorer().measured() != nullptr &&
                    explorer().measured()->graphs->alpha == explorer().alpha());
    }
    QPoint placeOf(const FramePair& pair)
    {
        return matrix().cellRect({pair.source, pair.destination}).center().toPoint();
    }
    FramePair someTransition()
    {
        for (const Edge& edge : explorer().graphs()->essential.edges())
            if (edge.kind == EdgeKind::Transition && edge.from < 60 && edge.to > 70)
                return {edge.from, edge.to};
        return {};
    }

protected slots:
    void initTestCase()
    {
        test::isolate();
        QLocale::setDefault(QLocale::c());
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    }

    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        test::writeSwayingTakes(m_folder->path());
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1280, 800);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        context().document.reset(test::swayingProject(m_folder->path()));
        m_window->workspaces().select("graph");
        QVERIFY(test::activate(*m_window));
    }

    void cleanup()
    {
        m_window.reset();
        m_folder.reset();
    }

protected:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

} // namespace quadrille
