// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Blends of four takes: chosen, moved on the pad, learned, removed.
#include "editor/commands/variationedits.h"
#include "model/project/checks/validate.h"
#include "tests/qt/registry.h"
#include "variationsfixture.h"
#include "widgets/controls/weightspad.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

namespace quadrille {

class VariationSquareTest : public VariationsFixture
{
    Q_OBJECT

private:
    const SamplesEntry& samples() { return entry().samples.front(); }
    QComboBox* box(const char* name) { return test::find<QComboBox>(QLatin1String(name)); }
    widgets::WeightsPad* pad() { return test::find<widgets::WeightsPad>(QStringLiteral("acrossPad")); }
    QPushButton* learn() { return test::find<QPushButton>(QStringLiteral("acrossLearn")); }
    QTreeWidget* blends() { return test::find<QTreeWidget>(QStringLiteral("blends")); }
    static QString textOf(const std::string& text) { return QString::fromStdString(text); }

    /// As a user chooses: by the keyboard.
    void choose(const char* name, const QString& take)
    {
        QComboBox* field = box(name);
        const int index = field->findText(take);
        QVERIFY2(index >= 0, qPrintable(take));
        field->setFocus();
        QTest::keyClick(field, Qt::Key_Home);
        for (int i = 0; i < index; ++i)
            QTest::keyClick(field, Qt::Key_Down);
    }
    void makeSquare()
    {
        choose("sampleTo", "second");
        choose("acrossOf", "third");
        QVERIFY(samples().across);
        QTRY_COMPARE(pad()->height(), pad()->sizeHint().height());
    }

protected slots:
    void init()
    {
        VariationsFixture::init();
        m_window->resize(1400, 1000); // the pad is to be seen as a whole
        Project project = test::variedProject(m_folder->path());
        SequenceEntry fourth = project.sequences.front();
        fourth.name = "fourth";
        project.sequences.push_back(fourth);
        for (const char* take : {"third", "fourth"}) {
            TrainingEntry training = project.variations.front().training.front();
            training.sequence = take;
            project.variations.front().training.push_back(training);
        }
        document().reset(project);
        m_window->workspaces().select("variations");
        show("samplesPanel");
    }

private slots:
    void aSecondPairIsOfferedToABlendOnly()
    {
        QVERIFY(!box("acrossOf")->isVisible());
        choose("sampleTo", "second");
        QVERIFY(box("acrossOf")->isVisible());
        QVERIFY(!pad()->isVisible());
        // Neither of the two that are there already.
        QCOMPARE(box("acrossOf")->count(), 3);
        choose("acrossOf", "third");
        QVERIFY(pad()->isVisible());
        QCOMPARE(samples().across->of, std::string("third"));
        QCOMPARE(samples().across->to, std::string("fourth"));
        QCOMPARE(samples().across->weight, 0.5);
        QCOMPARE(pad()->corners()[3], QStringLiteral("fourth"));
        choose("acrossOf", "fourth");
        QCOMPARE(samples().across->to, std::string("third"));
        choose("sampleTo", box("sampleTo")->itemText(0));
        QVERIFY(!samples().across);
        QVERIFY(!pad()->isVisible());
    }

    void thePadMovesBothWeightsAsOneStep()
    {
        makeSquare();
        const int steps = document().undoStack()->index();
        const auto at = [this](double x, double y) { return pad()->positionOf({x, y}).toPoint(); };
        QTest::mousePress(pad(), Qt::LeftButton, {}, at(0.5, 0.5));
        QTest::mouseMove(pad(), at(0.4, 0.7));
        QTest::mouseMove(pad(), at(0.25, 0.8));
        QTest::mouseRelease(pad(), Qt::LeftButton, {}, at(0.25, 0.8));
        QVERIFY(std::abs(samples().weight - 0.25) < 0.02);
        QVERIFY(std::abs(samples().across->weight - 0.8) < 0.02);
        QCOMPARE(document().undoStack()->index(), steps + 1);
        document().undoStack()->undo();
        QCOMPARE(pad()->weights(), QPointF(0.5, 0.5));
        pad()->setFocus();
        QTest::keyClick(pad(), Qt::Key_Up, Qt::ShiftModifier);
        QCOMPARE(samples().across->weight, 0.6);
        QCOMPARE(test::find<QDoubleSpinBox>(QStringLiteral("acrossPercent"))->value(), 60);
    }

    void numbersMoveThePad()
    {
        makeSquare();
        test::find<QDoubleSpinBox>(QStringLiteral("acrossPercent"))->setValue(15);
        test::find<QSpinBox>(QStringLiteral("samplePercent"))->setValue(70);
        QCOMPARE(pad()->weights(), QPointF(0.7, 0.15));
    }

    void theSquareIsLearnedInPlaceOfItsEdges()
    {
        makeSquare();
        BlendEntry edge;
        edge.from = "third";
        edge.to = "first";
        VariationEntry before = entry();
        before.blends = {edge};
        setVariation(document(), "sways", "test", "blends", before);
        QVERIFY(learn()->isVisible());
        QTest::mouseClick(learn(), Qt::LeftButton);
        QCOMPARE(entry().blends.size(), 1U);
        QCOMPARE(entry().blends[0].across->to, std::string("fourth"));
        QVERIFY(!learn()->isVisible());
        QVERIFY(!hasErrors(validate(document().project())));
        QCOMPARE(blends()->topLevelItem(0)->text(0), QStringLiteral("first → second × third → fourth"));
        // Weights of both pairs are typed as they are shown.
        blends()->topLevelItem(0)->setText(1, "25, 75 % × 40");
        QCOMPARE(entry().blends[0].weights, (std::vector{0.25, 0.75}));
        QCOMPARE(entry().blends[0].across->weights, std::vector{0.4});
        blends()->topLevelItem(0)->setText(1, "25 %");
        QCOMPARE(entry().blends[0].weights.size(), 2U);
        blends()->setCurrentItem(blends()->topLevelItem(0));
        QTest::keyClick(blends(), Qt::Key_Delete);
        QVERIFY(entry().blends.empty());
    }

    void aTakeThatIsLeftOutTakesTheSquareWithIt()
    {
        makeSquare();
        Workspace::showPanel(test::find<QWidget>(QStringLiteral("movementPanel")));
        auto* takes = test::find<QTreeWidget>(QStringLiteral("trainingTakes"));
        const QRect place = takes->visualItemRect(takes->topLevelItem(2));
        QTest::mouseClick(takes->viewport(), Qt::LeftButton, {},
                          QPoint(place.left() + 10, place.center().y()));
        QCOMPARE(entry().training.size(), 3U);
        QVERIFY(entry().samples.empty());
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::VariationSquareTest);
#include "tst_variationsquare.moc"
