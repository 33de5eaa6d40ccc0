// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "animatedproject.h"
#include "editor/workspaces/animate/animateworkspace.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/pathtool.h"
#include "widgets/viewport/vtkview.h"

#include <QToolButton>
#include <memory>

namespace quadrille {

using widgets::PathPart;
using Kind = widgets::PathPart::Kind;

namespace test {

/// A window with its Animate workspace in front, and a look down onto its ground.
struct PathFixture
{
    ProjectDocument& document() { return m_window->context().document; }
    widgets::Viewport& viewport() { return m_window->animate().viewport(); }
    PathTool& tool() { return m_window->animate().path(); }
    const PathEntry& path() { return *tool().path(); }

    void open()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        writeSwayingTakes(m_folder->path());
        Project project = swayingProject(m_folder->path());
        project.animations.clear();
        project.sequences[1].labels = {{.label = "lean", .frames = {FrameIndex(5), FrameIndex(55)}}};
        m_window = std::make_unique<MainWindow>();
        document().reset(project);
        m_window->resize(900, 1000);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->context().actions.action("workspace.animate")->trigger();
        QTRY_VERIFY(viewport().isVisible());
        lookDown();
    }
    void close()
    {
        document().undoStack()->setClean();
        m_window.reset();
        m_folder.reset();
    }

    QPoint pixel(double x, double z)
    {
        QPointF at;
        const auto place = QVector3D(static_cast<float>(x), viewport().groundHeight(), static_cast<float>(z));
        viewport().camera().project(place, viewport().view()->size(), &at);
        return at.toPoint();
    }
    QPoint pixel(const PathPart& part) { return tool().editor().pixelOf(part).value_or(QPointF()).toPoint(); }
    void click(const QPoint& at) { QTest::mouseClick(viewport().view(), Qt::LeftButton, {}, at); }
    void press(const QString& button) { QTest::mouseClick(test::find<QToolButton>(button), Qt::LeftButton); }

    /// Looks down onto the ground about the origin.
    void lookDown()
    {
        widgets::Turntable camera;
        camera.target = {0, viewport().groundHeight(), 0.6F};
        camera.yaw = 0;
        camera.pitch = 60;
        camera.distance = 6;
        viewport().setCamera(camera);
    }

    void addPath(PathEntry path)
    {
        m_window->animate().animation().edit("path", "path", [&](AnimationEntry& animation) {
            animation.constraints = {std::move(path)};
            animation.search.budget = 3000;
        });
        m_window->animate().setActive(true);
        lookDown();
    }
    static PathEntry straight()
    {
        PathEntry path;
        path.points = {{0, 0, 0}, {0, 0, 0.5}, {0, 0, 1}};
        path.spans = {{.from = 0.25, .to = 0.75}};
        return path;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

} // namespace test

} // namespace quadrille
