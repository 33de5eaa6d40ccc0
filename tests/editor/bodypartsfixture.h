// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "bodyfixture.h"
#include "editor/context/editorcontext.h"
#include "editor/workspaces/variations/bodysurface.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "editor/workspaces/variations/partcurvetool.h"
#include "editor/workspaces/variations/partedits.h"
#include "editor/workspaces/variations/variationsworkspace.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/viewport/vtkview.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <memory>

namespace quadrille {

using widgets::MessageStrip;
using Mode = widgets::SurfaceCurveEditor::Mode;
using PartKind = widgets::SurfaceCurvePart::Kind;

/// The window with a figure whose parts are shown.
class BodyPartsFixture : public QObject
{
    Q_OBJECT

protected:
    ProjectDocument& document() { return m_window->context().document; }
    widgets::Viewport& viewport() { return m_window->variations().viewport(); }
    PartCurveTool& tool() { return m_window->variations().parts(); }
    const BodyPartsEntry& body() { return tool().body(); }
    QUndoStack& history() { return *document().undoStack(); }

    /// Where a place of the figure is in the view.
    QPoint pixel(float x, float y, float z)
    {
        QPointF at;
        viewport().camera().project({x, y, z}, viewport().view()->size(), &at);
        return at.toPoint();
    }
    void click(const QPoint& at, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseClick(viewport().view(), Qt::LeftButton, modifiers, at);
        QTest::qWait(0);
    }
    void key(int code, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(viewport().view(), static_cast<Qt::Key>(code), modifiers);
    }
    void look(float yaw)
    {
        widgets::Turntable camera;
        camera.target = {0, 0.95F, 0};
        camera.yaw = yaw;
        camera.pitch = 0;
        camera.distance = 4.5F;
        viewport().setCamera(camera);
    }
    void run(const char* action)
    {
        QAction* found = m_window->context().actions.action(QLatin1String(action));
        QVERIFY2(found->isEnabled(), action);
        found->trigger();
        QTRY_VERIFY(!tool().isBusy());
    }
    /// A curve around the left arm, by a click on its front.
    void drawOnArm(float x)
    {
        run("variations.curve.draw");
        QCOMPARE(tool().editor().mode(), Mode::Draw);
        click(pixel(x, 1.4F, 0.1F));
        key(Qt::Key_Return);
        QCOMPARE(tool().editor().mode(), Mode::Edit);
    }
    /// What redo and undo make of the last edit.
    void checkHistory(const Project& before)
    {
        const Project after = document().project();
        QVERIFY(!(after == before));
        history().undo();
        QVERIFY(document().project() == before);
        history().redo();
        QVERIFY(document().project() == after);
        history().undo();
        QVERIFY(document().project() == before);
        history().redo();
    }
    QTreeWidgetItem* item(const QString& name)
    {
        const auto found =
            test::find<QTreeWidget>("bodyPartsTree")->findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
        return found.isEmpty() ? nullptr : found.front();
    }
    static QString said(const char* strip) { return test::find<MessageStrip>(QLatin1String(strip))->text(); }

private slots:
    void initTestCase()
    {
        test::isolate();
        QVERIFY(widgets::VtkView::openGlAvailable());
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = test::figureProject(m_folder->path());
    }

    void init()
    {
        m_window = std::make_unique<MainWindow>();
        document().reset(m_project);
        m_window->resize(1280, 900);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->context().actions.action("workspace.variations")->trigger();
        auto* dock = test::find<QDockWidget>("bodyPartsDock");
        dock->show();
        dock->raise();
        QTRY_VERIFY(viewport().isVisible());
        QTRY_VERIFY(tool().surface().graph() != nullptr);
        QTRY_VERIFY(tool().editor().figure() >= 0);
        QTRY_VERIFY(tool().editor().isActive());
        m_window->variations().scene().keepCamera();
        look(0);
        QTRY_VERIFY(viewport().pick(pixel(0.45F, 1.4F, 0.1F)).has_value());
    }

    void cleanup()
    {
        history().setClean();
        m_window.reset();
    }

protected:
    std::unique_ptr<QTemporaryDir> m_folder;
    Project m_project;
    std::unique_ptr<MainWindow> m_window;
};

} // namespace quadrille
