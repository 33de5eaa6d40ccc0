// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The pose distance of two compared sequences on their surface.
#include "editor/commands/projectedits.h"
#include "editor/playback/player.h"
#include "editor/playback/poseheatmap.h"
#include "editor/workspaces/sequences/posecomparison.h"
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "editortest.h"
#include "model/transition/posedistance.h"
#include "tests/qt/registry.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/viewport/viewport.h"

#include <QDir>
#include <QToolButton>

namespace quadrille {

namespace {

constexpr int frames = 20;

/// A pyramid whose tip leans further from frame to frame.
void writeLeaning(const QString& folder, double step, const char* faces)
{
    QDir().mkpath(folder);
    for (int f = 0; f < frames; ++f) {
        std::ofstream file(QStringLiteral("%1/m_%2.obj").arg(folder).arg(f).toStdString());
        file << "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0.5 1.7 " << 0.5 + step * f << '\n' << faces;
    }
}

} // namespace

class HeatMapTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }
    widgets::Viewport& viewport() { return m_window->sequences().viewport(); }
    const PoseHeatMap& heatMap() { return m_window->sequences().comparison().heatMap(); }
    widgets::MessageStrip& strip() { return *m_window->sequences().findChild<widgets::MessageStrip*>(); }
    double expected(const QString& first, int frameOfFirst, const QString& second, int frameOfSecond)
    {
        const MeshSequence& a = *context().media.sequence(first);
        const MeshSequence& b = *context().media.sequence(second);
        return surfaceDistance(a.frame(FrameIndex(frameOfFirst)).positions(),
                               b.frame(FrameIndex(frameOfSecond)).positions(), a.topology->triangles());
    }
    void compare(const QStringList& names)
    {
        context().selection.selectSequences(names);
        QVERIFY(test::activate(*m_window));
        viewport().setFocus();
        QTRY_COMPARE(viewport().figures().size(), static_cast<std::size_t>(names.size()));
    }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase()
    {
        test::isolate();
        writeLeaning(m_folder.filePath("upright"), 0, "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
        writeLeaning(m_folder.filePath("leaning"), 0.05, "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
        writeLeaning(m_folder.filePath("other"), 0.05, "f 1 2 5\nf 2 3 5\nf 3 4 5\n");
    }

    void init()
    {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        Project project;
        const auto path = [this](const char* name) { return m_folder.filePath(name).toStdString(); };
        project.characters = {{.name = "pyramid", .mesh = path("upright/m_0.obj")},
                              {.name = "open", .mesh = path("other/m_0.obj")}};
        project.sequences = {{.name = "upright", .character = "pyramid", .source = path("upright")},
                             {.name = "leaning", .character = "pyramid", .source = path("leaning")},
                             {.name = "other", .character = "open", .source = path("other")}};
        context().document.reset(project);
        for (const char* name : {"upright", "leaning", "other"})
            QVERIFY(test::waitForSequence(*m_window, name));
    }

    void cleanup()
    {
        context().document.reset({});
        m_window.reset();
    }

    void coloursTwoTakesByTheDistanceOfTheirPoses()
    {
        auto* button = m_window->sequences().findChild<QToolButton*>("tool.view.heatMap");
        QVERIFY(!button->isVisible());
        context().actions.action("view.wire")->trigger();
        compare({"upright", "leaning"});
        QTRY_VERIFY(button->isVisible());
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(viewport().shading() == widgets::Shading::Scalar);
        QTRY_VERIFY(heatMap().distance().has_value());
        QVERIFY(std::abs(*heatMap().distance() - expected("upright", 0, "leaning", 0)) < 1e-9);
        // Another frame, other colours and another number.
        QTest::keyClick(m_window.get(), Qt::Key_End);
        const double last = expected("upright", frames - 1, "leaning", frames - 1);
        QVERIFY(last > 0.1);
        QTRY_VERIFY(std::abs(*heatMap().distance() - last) < 1e-9);
        if (viewport().isWorking()) {
            const QImage coloured = viewport().snapshot({.annotations = false});
            context().actions.action("view.clay")->trigger();
            QVERIFY(coloured != viewport().snapshot({.annotations = false}));
            QVERIFY(!heatMap().distance().has_value());
        }
    }

    void followsPlaybackAndEndsWhereItShouldBe()
    {
        compare({"upright", "leaning"});
        QTest::keyClick(m_window.get(), Qt::Key_D, Qt::ShiftModifier);
        QTRY_VERIFY(heatMap().distance().has_value());
        context().settings.setLoopsPlayback(false);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(m_window->sequences().player().frame().value > 3);
        QTRY_VERIFY(!m_window->sequences().player().isPlaying());
        const double last = expected("upright", frames - 1, "leaning", frames - 1);
        QTRY_VERIFY(std::abs(*heatMap().distance() - last) < 1e-9);
        context().settings.setLoopsPlayback(true);
    }

    void comparesTheFramesThatTheProjectUses()
    {
        setSequenceRange(context().document, "leaning", FrameRange{FrameIndex(10), FrameIndex(15)});
        compare({"upright", "leaning"});
        QTest::keyClick(m_window.get(), Qt::Key_D, Qt::ShiftModifier);
        QTRY_VERIFY(heatMap().distance().has_value());
        QTRY_VERIFY(std::abs(*heatMap().distance() - expected("upright", 0, "leaning", 0)) < 1e-9);
        QVERIFY(*heatMap().distance() > 0.05);
        context().document.undo();
        QTRY_VERIFY(heatMap().distance().value_or(1) < 1e-6);
    }

    void triggeredAgainItGivesWayToTheShadingBefore()
    {
        context().actions.action("view.wire")->trigger();
        compare({"upright", "leaning"});
        QTest::keyClick(m_window.get(), Qt::Key_D, Qt::ShiftModifier);
        QVERIFY(viewport().shading() == widgets::Shading::Scalar);
        QTest::keyClick(m_window.get(), Qt::Key_D, Qt::ShiftModifier);
        QVERIFY(viewport().shading() == widgets::Shading::Wireframe);
        QVERIFY(context().actions.action("view.wire")->isChecked());
        QVERIFY(heatMap().state() == PoseHeatMap::State::Off);
        // It ends with the comparison too.
        QTest::keyClick(m_window.get(), Qt::Key_D, Qt::ShiftModifier);
        QVERIFY(viewport().shading() == widgets::Shading::Scalar);
        compare({"upright"});
        QTRY_VERIFY(viewport().shading() == widgets::Shading::Wireframe);
        QVERIFY(!context().actions.action("view.heatMap")->isEnabled());
    }

    void saysWhyItCannotBeShown()
    {
        compare({"upright", "other"});
        QTest::keyClick(m_window.get(), Qt::Key_D, Qt::ShiftModifier);
        QTRY_VERIFY(strip().isVisible());
        QVERIFY(strip().text().contains("different meshes"));
        compare({"upright", "other", "leaning"});
        QTRY_VERIFY(strip().text().contains("between two sequences"));
        compare({"upright", "leaning"});
        QTRY_VERIFY(heatMap().distance().has_value());
        QVERIFY(!strip().isVisible());
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::HeatMapTest);
#include "tst_heatmap.moc"
