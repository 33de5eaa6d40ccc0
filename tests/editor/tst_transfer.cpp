// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// A performance on another body: from the pairs of triangles to the clip.
#include "editor/context/editorcontext.h"
#include "editor/workspaces/transfer/currenttransfer.h"
#include "editor/workspaces/transfer/pairtool.h"
#include "editor/workspaces/transfer/transferworkspace.h"
#include "editor/workspaces/workspacetabs.h"
#include "editortest.h"
#include "tests/qt/registry.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/graph/linechart.h"
#include "widgets/viewport/vtkview.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QToolButton>
#include <QTreeWidget>
#include <cmath>
#include <memory>

namespace quadrille {

/// The window with a take of a strip that bends, and another strip that stands still.
class TransferTest : public QObject
{
    Q_OBJECT

private:
    static constexpr int frames = 7;
    static constexpr std::uint32_t triangles = 8;

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
        for (int row = 0; row < 5; ++row) {
            for (const int side : {0, 1})
                text +=
                    "v " + number(0.4 * row) + number(0.05 * bend * row * row) + number(width * side) + "\n";
        }
        for (int row = 1; row < 8; row += 2) {
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
        QTRY_VERIFY(pixel(0, 0) != pixel(0, 7) && pixel(1, 0) != pixel(1, 7));
        widgets::Turntable camera = workspace().viewport().camera();
        camera.pitch = 60; // strips lie on the ground
        workspace().viewport().setCamera(camera);
        workspace().viewport().frameAll();
    }
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

private slots:
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

    void theEmptyStateMakesATransferOntoTheOtherBody()
    {
        open(takes());
        QTRY_VERIFY(message().text().contains("another body"));
        QTest::mouseClick(message().findChild<QPushButton*>(), Qt::LeftButton);
        QCOMPARE(document().project().transfers.size(), std::size_t{1});
        QCOMPARE(entry().clip, std::string("sequences/dance"));
        QCOMPARE(entry().target, (NamedFrame{"stone", FrameIndex(0)}));
        // Strips have no limbs: nothing can be proposed, but both are there to be clicked on.
        QTRY_COMPARE(phase(), ResultPhase::Failed);
        QTRY_COMPARE(message().kind(), widgets::MessageStrip::Kind::Error);
        QTRY_VERIFY(advice().contains("Click on a place of the template"));
        QTRY_VERIFY(workspace().scene().figureOf(TransferWorkspace::targetName()) >= 0);
        document().undoStack()->undo();
        QVERIFY(document().project().transfers.empty());
        QTRY_VERIFY(workspace().scene().shown().isEmpty());
    }

    void theBodyDoesWhatTheTemplateDoes()
    {
        openReady();
        QCOMPARE(find<QLabel>("transferState")->text(), QStringLiteral("Ready: 7 frames"));
        const Frame made = transfer().result()->sequence.frame(FrameIndex(3));
        const Frame wanted = context().media.sequence("dance")->frame(FrameIndex(3));
        const auto rise = [](const Frame& frame) {
            return (frame.positions().back() - frame.positions().front()).normalized().y();
        };
        QVERIFY(std::abs(rise(made) - rise(wanted)) < 0.05F);
        QVERIFY(!find<widgets::LineChart>("transferChartLines")->isEmpty());
        QCOMPARE(find<widgets::LineChart>("transferChartLines")->marker(), std::optional(0.0));
        workspace().player().goTo(4);
        QCOMPARE(find<widgets::LineChart>("transferChartLines")->marker(), std::optional(4.0));
    }

    void clicksOnBothBodiesMakeAPairThatIsUndone()
    {
        openReady(6);
        const auto before = list()->topLevelItemCount();
        QCOMPARE(before, 6);
        click(0, 6);
        QVERIFY(editor().hint().contains("of the body"));
        click(1, 7);
        QCOMPARE(entry().pairs.size(), std::size_t{7});
        QCOMPARE(entry().pairs.back(), (TrianglePair{TriangleIndex(6), TriangleIndex(7)}));
        QCOMPARE(list()->topLevelItemCount(), 7);
        QCOMPARE(list()->indexOfTopLevelItem(list()->currentItem()), 6);
        QVERIFY(transfer().result() == nullptr); // it is of other pairs
        QTRY_VERIFY(transfer().result() != nullptr);
        // A triangle of the body moves as one of the template only.
        click(0, 7);
        click(1, 0);
        QCOMPARE(entry().pairs.size(), std::size_t{7});
        document().undoStack()->undo();
        QCOMPARE(entry().pairs.size(), std::size_t{6});
        QCOMPARE(list()->topLevelItemCount(), 6);
    }

    void listAndViewSelectTheSamePair()
    {
        openReady();
        list()->setCurrentItem(list()->topLevelItem(3));
        QCOMPARE(editor().selected(), 3);
        editor().setSelected(5);
        QCOMPARE(list()->indexOfTopLevelItem(list()->currentItem()), 5);
        QVERIFY(!action("transfer.mirror")->isEnabled()); // nothing tells sides of strips
        action("transfer.removePair")->trigger();
        QCOMPARE(entry().pairs.size(), std::size_t{7});
        QCOMPARE(transfer().selected(), -1);
        QVERIFY(!action("transfer.removePair")->isEnabled());
    }

    void aDragIsOneStep()
    {
        openReady(4);
        const int steps = document().undoStack()->count();
        const QPoint from = pixel(1, 3);
        const QPoint to = pixel(1, 6);
        mouse(QEvent::MouseButtonPress, from);
        for (int step = 1; step <= 6; ++step)
            mouse(QEvent::MouseMove, from + (to - from) * step / 6);
        QCOMPARE(entry().pairs[3].onTarget, TriangleIndex(6));
        mouse(QEvent::MouseButtonRelease, to);
        QCOMPARE(entry().pairs[3].onTemplate, TriangleIndex(3));
        QCOMPARE(document().undoStack()->count(), steps + 1);
        document().undoStack()->undo();
        QCOMPARE(entry().pairs[3].onTarget, TriangleIndex(3));
    }

    void referencePosesStandStill()
    {
        openReady();
        action("transfer.reference")->trigger();
        QTRY_COMPARE(workspace().scene().frameCount(), std::int64_t{1});
        QVERIFY(!action("transfer.takeReference")->isEnabled());
        action("transfer.reference")->trigger();
        QTRY_COMPARE(workspace().scene().frameCount(), std::int64_t{frames});
        workspace().player().goTo(2);
        action("transfer.takeReference")->trigger();
        QCOMPARE(entry().reference, (NamedFrame{"dance", FrameIndex(2)}));
        QTRY_VERIFY(transfer().result() != nullptr);
    }

    void settingsAreEditedInPanelAndProperties()
    {
        openReady();
        find<QDockWidget>("transferSettingsDock")->raise();
        QTRY_VERIFY(find<QCheckBox>("transferPanelPoses")->isVisible());
        find<QCheckBox>("transferPanelPoses")->click();
        QCOMPARE(entry().correctsPose, false);
        find<QComboBox>("transferPanelField")->setCurrentIndex(1);
        QCOMPARE(entry().field, FieldKind::Logarithms);
        context().selection.select({Section::Transfers, "stone dances"});
        QCOMPARE(find<QComboBox>("transferField")->currentIndex(), 1);
        auto* truth = find<QComboBox>("transferPanelTruth");
        QCOMPARE(truth->count(), 2); // none, and the only take of the body
        truth->setCurrentIndex(truth->findText("stone"));
        QCOMPARE(entry().truth, std::string("sequences/stone"));
        QCOMPARE(find<QComboBox>("transferTruth")->currentText(), QStringLiteral("stone"));
        // Another body: its triangles are others.
        auto* target = find<QComboBox>("transferBarTarget");
        target->setCurrentIndex(target->findText("dance"));
        QCOMPARE(entry().target.sequence, std::string("dance"));
        QVERIFY(entry().pairs.empty());
        QVERIFY(entry().truth.empty());
    }

    void theClipBecomesATake()
    {
        openReady();
        action("transfer.addSequence")->trigger();
        QCOMPARE(document().project().sequences.size(), std::size_t{3});
        const SequenceEntry& added = document().project().sequences.back();
        QCOMPARE(added.source, std::string("clip:transfers/stone dances"));
        QCOMPARE(added.character, std::string("scan"));
        QVERIFY(test::waitForSequence(*m_window, QString::fromStdString(added.name)));
        QCOMPARE(context().media.sequence(QString::fromStdString(added.name))->frameCount(),
                 std::int64_t{frames});
    }

    void anotherNameKeepsTheResult()
    {
        openReady();
        QVERIFY(renameEntry(document(), {Section::Transfers, "stone dances"}, "statue"));
        QCOMPARE(transfer().name(), QStringLiteral("statue"));
        QTRY_VERIFY(transfer().result() != nullptr);
        QCOMPARE(transfer().result()->entry.name, std::string("statue"));
    }

    void picturesOfCamerasAreProjectedOntoIt()
    {
        openReady();
        context().selection.select({Section::Transfers, "stone dances"});
        const QString cameras = QDir(m_folder->path()).filePath("cameras.json");
        QCOMPARE(transfer().addProjection(cameras), QStringLiteral("stone dances, filmed"));
        const auto projection = [this]() -> const ProjectionEntry& {
            return document().project().projections.front();
        };
        QCOMPARE(projection().clip, std::string("transfers/stone dances"));
        QCOMPARE(QString::fromStdString(projection().cameras), cameras);
        find<QCheckBox>("projectionFills")->click();
        QCOMPARE(projection().fills, false);
        document().undoStack()->undo();
        QCOMPARE(projection().fills, true);
        // Of a take where that is what is selected.
        context().selection.selectSequences({"dance"});
        transfer().addProjection(cameras);
        QCOMPARE(document().project().projections.back().clip, std::string("sequences/dance"));
    }

    void nobodyLooksNothingIsComputed()
    {
        document().reset(transferred());
        m_window->workspaces().select("sequences");
        QTest::qWait(200);
        QVERIFY(context().transfers.resultState("stone dances") == nullptr);
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::TransferTest);
#include "tst_transfer.moc"
