// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Takes that become one movement, in the tree and in the properties.
#include "editor/context/editorcontext.h"
#include "editor/fields/measuretext.h"
#include "editor/fields/partlist.h"
#include "editortest.h"
#include "tests/model/project/spacesofwalks.h"
#include "tests/qt/registry.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QToolButton>
#include <memory>

namespace quadrille {

class MotionSpacesTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }
    ProjectDocument& document() { return context().document; }
    const MotionSpaceEntry& entry() { return document().project().motionSpaces.front(); }
    const MotionSpaceResults::State* state() { return context().motionSpaces.resultState("motion space"); }
    bool isReady() { return state() != nullptr && state()->phase == ResultPhase::Ready; }
    template <typename Widget>
    Widget* find(const char* name)
    {
        return test::find<Widget>(QLatin1String(name));
    }
    static QString row(const PartList* list, int row) { return list->item(row)->text(); }

    /// The project with a new motion space of both takes.
    void make()
    {
        context().selection.selectSequences({"slow", "fast"});
        context().actions.action("motionSpaces.new")->trigger();
        QCOMPARE(document().project().motionSpaces.size(), std::size_t{1});
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase() { test::isolate(); }

    void nothingHasNoSign()
    {
        QCOMPARE(measureText(-0.3, SpaceMeasure::Turning), QStringLiteral("0 °/s"));
        QCOMPARE(measureText(-0.001, SpaceMeasure::Speed), QStringLiteral("0.00 m/s"));
        QCOMPARE(measureText(-12.6, SpaceMeasure::Turning), QStringLiteral("-13 °/s"));
    }

    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        test::writeWalk(m_folder->filePath("slow").toStdString(), test::slowWalk);
        test::writeWalk(m_folder->filePath("fast").toStdString(), test::fastWalk);
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        Project project;
        for (const char* name : {"slow", "fast"}) {
            SequenceEntry& sequence = project.sequences.emplace_back();
            sequence.name = name;
            sequence.source = m_folder->filePath(name).toStdString();
        }
        document().reset(project);
        QVERIFY(test::waitForSequence(*m_window, "slow"));
        QVERIFY(test::waitForSequence(*m_window, "fast"));
    }
    void cleanup()
    {
        document().undoStack()->setClean();
        m_window.reset();
        m_folder.reset();
    }

    void selectedTakesBecomeASpaceThatIsMeasured()
    {
        make();
        QCOMPARE(entry().takes.size(), std::size_t{2});
        QCOMPARE(entry().parameters.size(), std::size_t{1});
        QCOMPARE(context().selection.current(), (EntryRef{Section::MotionSpaces, "motion space"}));
        QTRY_VERIFY(isReady());
        QTRY_VERIFY(find<QLabel>("motionSpaceState")->text().contains("repeats"));
        QCOMPARE(row(find<PartList>("motionSpaceTakes"), 0), QString("slow · 0.50 m/s"));
        QVERIFY(row(find<PartList>("motionSpaceParameters"), 0).startsWith("speed · 0.50 m/s to "));
        document().undo();
        QVERIFY(document().project().motionSpaces.empty());
        QTRY_VERIFY(state() == nullptr);
    }

    void theCurrentTakeIsEditedAndUndone()
    {
        make();
        const MotionSpaceEntry made = entry();
        auto* takes = find<PartList>("motionSpaceTakes");
        takes->setCurrentRow(1);
        find<QCheckBox>("motionSpaceReversed")->click();
        QVERIFY(!entry().takes[0].isReversed);
        QVERIFY(entry().takes[1].isReversed);
        QVERIFY(row(takes, 1).contains("reversed"));
        QCOMPARE(takes->currentRow(), 1);
        find<QCheckBox>("motionSpaceMirrored")->click();
        find<QDoubleSpinBox>("motionSpaceSpeed")->setValue(1.5);
        find<QSpinBox>("motionSpaceRangeLast")->setValue(30);
        auto* place = find<QLineEdit>("motionSpacePlace");
        place->setFocus();
        QTest::keyClicks(place, "0.75");
        QTest::keyClick(place, Qt::Key_Return);
        const SpaceTakeEntry& take = entry().takes[1];
        QVERIFY(take.isMirrored);
        QCOMPARE(take.speed, 1.5);
        QVERIFY(take.range == (FrameRange{FrameIndex(0), FrameIndex(30)}));
        QCOMPARE(take.place, std::vector<double>{0.75});
        for (int edits = 0; edits < 5; ++edits)
            document().undo();
        QVERIFY(entry() == made);
    }

    void takesAndParametersComeAndGo()
    {
        make();
        auto* takes = find<PartList>("motionSpaceTakes");
        auto* more = find<QComboBox>("motionSpaceNewTake");
        emit more->activated(more->findText("slow"));
        QCOMPARE(entry().takes.size(), std::size_t{3});
        QCOMPARE(takes->currentRow(), 2);
        find<QToolButton>("motionSpaceRemoveTake")->click();
        QCOMPARE(entry().takes.size(), std::size_t{2});
        find<QToolButton>("motionSpaceAddParameter")->click();
        QCOMPARE(entry().parameters.back().name, std::string("turning"));
        QCOMPARE(entry().parameters.back().measure, SpaceMeasure::Turning);
        find<PartList>("motionSpaceParameters")->setCurrentRow(1);
        find<QComboBox>("motionSpaceMeasure")->setCurrentIndex(static_cast<int>(SpaceMeasure::Height));
        QCOMPARE(entry().parameters[1].measure, SpaceMeasure::Height);
        QCOMPARE(entry().parameters[1].name, std::string("height"));
        find<QDoubleSpinBox>("motionSpaceVertex")->setValue(50);
        QCOMPARE(entry().parameters[1].vertex, std::optional<std::int64_t>(50));
        find<QToolButton>("motionSpaceRemoveParameter")->click();
        QCOMPARE(entry().parameters.size(), std::size_t{1});
    }

    void whatCannotBeComputedIsSaid()
    {
        make();
        find<PartList>("motionSpaceTakes")->setCurrentRow(1);
        auto* last = find<QSpinBox>("motionSpaceRangeLast");
        last->setValue(1);
        QTRY_VERIFY(state() != nullptr && state()->phase == ResultPhase::Failed);
        QTRY_VERIFY(find<QLabel>("motionSpaceState")->text().contains("fast"));
        document().undo();
        QTRY_VERIFY(isReady());
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::MotionSpacesTest);
#include "tst_motionspaces.moc"
