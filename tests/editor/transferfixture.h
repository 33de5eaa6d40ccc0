// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/context/editorcontext.h"
#include "editor/workspaces/transfer/currenttransfer.h"
#include "editor/workspaces/transfer/pairtool.h"
#include "editor/workspaces/transfer/transferworkspace.h"
#include "editor/workspaces/workspacetabs.h"
#include "editortest.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/viewport/vtkview.h"

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QScopeGuard>
#include <QScrollArea>
#include <QToolButton>
#include <QTreeWidget>
#include <cmath>
#include <memory>

namespace quadrille {

/// The window with a take of a strip that bends, and another strip that stands still.
class TransferFixture : public QObject
{
    Q_OBJECT

protected:
    static constexpr int frames = 7;
    static constexpr int rows = 7;
    static constexpr std::uint32_t triangles = 2 * (rows - 1);

    EditorContext& context() { return m_window->context(); }
    ProjectDocument& document() { return context().document; }
    TransferWorkspace& workspace() { return m_window->transfer(); }
    CurrentTransfer& transfer() { return workspace().transfer(); }
    widgets::SurfacePairEditor& editor() { return workspace().tool().editor(); }
    widgets::MessageStrip& message() { return workspace().view().message(); }
    const TransferEntry& entry() { return document().project().transfers.front(); }
    QAction* action(const char* id) { return context().actions.action(QLatin1String(id)); }
    template <typename Widget>
    Widget* find(const char* name)
    {
        return test::find<Widget>(QLatin1String(name));
    }
    QString advice() { return find<QLabel>("pairsAdvice")->text(); }
    QTreeWidget* list() { return find<QTreeWidget>("pairsList"); }
    ResultPhase phase()
    {
        const auto* state = transfer().state();
        return state == nullptr ? ResultPhase::Idle : state->phase;
    }

    static std::string strip(double bend, double width)
    {
        std::string text;
        const auto number = [](double value) { return std::to_string(value) + " "; };
        for (int row = 0; row < rows; ++row) {
            for (const int side : {0, 1})
                text +=
                    "v " + number(0.3 * row) + number(0.03 * bend * row * row) + number(width * side) + "\n";
        }
        for (int row = 1; row < 2 * (rows - 1); row += 2) {
            const auto corner = [&](int i) { return std::to_string(row + i) + " "; };
            text +=
                "f " + corner(0) + corner(1) + corner(3) + "\nf " + corner(0) + corner(3) + corner(2) + "\n";
        }
        return text;
    }
    void write(const QString& file, const std::string& text)
    {
        std::ofstream(QDir(m_folder->path()).filePath(file).toStdString()) << text;
    }
    Project takes()
    {
        Project project;
        project.characters = {{.name = "dancer"}, {.name = "scan"}};
        const QDir folder(m_folder->path());
        project.sequences = {
            {.name = "dance", .character = "dancer", .source = folder.filePath("dance").toStdString()},
            {.name = "stone", .character = "scan", .source = folder.filePath("stone.obj").toStdString()}};
        return project;
    }
    Project transferred(std::uint32_t pairs = triangles)
    {
        Project project = takes();
        TransferEntry entry;
        entry.name = "stone dances";
        entry.clip = "sequences/dance";
        entry.target = {"stone", FrameIndex(0)};
        entry.correctsContacts = false;
        for (std::uint32_t t = 0; t < pairs; ++t)
            entry.pairs.push_back({TriangleIndex(t), TriangleIndex(t)});
        project.transfers = {entry};
        return project;
    }
    void open(Project project)
    {
        document().reset(std::move(project));
        m_window->workspaces().select("transfer");
    }
    void openReady(std::uint32_t pairs = triangles)
    {
        open(transferred(pairs));
        QTRY_COMPARE(phase(), ResultPhase::Ready);
        QTRY_COMPARE(workspace().scene().frameCount(), std::int64_t{frames});
        lookDown();
    }
    /// Strips lie on the ground. Waits until both show.
    void lookDown()
    {
        QTRY_VERIFY(pixel(0, 0) != pixel(0, 7) && pixel(1, 0) != pixel(1, 7));
        widgets::Turntable camera = workspace().viewport().camera();
        camera.pitch = 60;
        workspace().viewport().setCamera(camera);
        workspace().viewport().frameAll();
    }
    QString place(const QString& name) const { return m_folder->filePath(name); }
    QPoint pixel(int side, std::uint32_t triangle)
    {
        const auto shape = workspace().viewport().figureShape(workspace().scene().figureOf(
            side == 0 ? TransferWorkspace::templateName() : TransferWorkspace::targetName()));
        QVector3D middle;
        for (const std::uint32_t vertex : shape->mesh.triangles[triangle])
            middle += shape->place(vertex) / 3.0F;
        QPointF at;
        workspace().viewport().camera().project(middle, workspace().viewport().view()->size(), &at);
        return at.toPoint();
    }
    void mouse(QEvent::Type type, const QPoint& at)
    {
        QWidget* view = workspace().viewport().view();
        const bool isMove = type == QEvent::MouseMove;
        const bool isRelease = type == QEvent::MouseButtonRelease;
        QMouseEvent event(type, at, view->mapToGlobal(at), isMove ? Qt::NoButton : Qt::LeftButton,
                          isRelease ? Qt::NoButton : Qt::LeftButton, {});
        QApplication::sendEvent(view, &event);
    }
    void click(int side, std::uint32_t triangle)
    {
        const QPoint at = pixel(side, triangle);
        mouse(QEvent::MouseButtonPress, at);
        mouse(QEvent::MouseButtonRelease, at);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;

protected slots:
    void initTestCase() { test::isolate(); }
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QDir(m_folder->path()).mkdir("dance");
        for (int f = 0; f < frames; ++f)
            write(QStringLiteral("dance/f_%1.obj").arg(f), strip(std::sin(0.5 * f), 0.5));
        write("stone.obj", strip(0.1, 0.4));
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1400, 900);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        QVERIFY(test::activate(*m_window));
    }
    void cleanup()
    {
        document().undoStack()->setClean();
        m_window.reset();
        m_folder.reset();
    }
};

} // namespace quadrille
