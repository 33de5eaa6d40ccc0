// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "variedproject.h"

#include <QAction>
#include <QTreeWidget>
#include <memory>

namespace quadrille {

/// The window with the takes of the swaying spire.
class VariationsFixture : public QObject
{
    Q_OBJECT

protected:
    EditorContext& context() { return m_window->context(); }
    ProjectDocument& document() { return context().document; }
    CurrentVariation& variation() { return m_window->variations().variation(); }
    const VariationEntry& entry() { return *document().variation("sways"); }
    const VariationResults::State& resultState() { return *context().variations.resultState("sways"); }
    QAction* action(const char* id) { return context().actions.action(QLatin1String(id)); }
    void show(const char* panel) { Workspace::showPanel(test::find<QWidget>(QLatin1String(panel))); }
    QStringList scene() { return m_window->variations().scene().shown(); }

    void open()
    {
        document().reset(test::variedProject(m_folder->path()));
        m_window->workspaces().select("variations");
        QVERIFY(test::waitForState(context(), "sways", test::isNotLearned));
    }
    void learn()
    {
        open();
        action("variations.learn")->trigger();
        QVERIFY(test::waitForVariations(context(), "sways"));
    }
    QTreeWidgetItem* row(const char* tree, int index)
    {
        return test::find<QTreeWidget>(QLatin1String(tree))->topLevelItem(index);
    }
    void clickBox(const char* tree, int index)
    {
        auto* view = test::find<QTreeWidget>(QLatin1String(tree));
        const QRect place = view->visualItemRect(view->topLevelItem(index));
        QTest::mouseClick(view->viewport(), Qt::LeftButton, {},
                          QPoint(place.left() + 10, place.center().y()));
    }

protected slots:
    void initTestCase() { test::isolate(); }

    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        test::writeSwayingTakes(m_folder->path());
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1000, 700);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
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
