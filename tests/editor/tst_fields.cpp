// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What all fields of the window have in common: the wheel, and undoing while one is edited.
#include "editor/fields/numberfield.h"
#include "editor/fields/verticalscroll.h"
#include "editor/workspaces/workspace.h"
#include "tests/qt/registry.h"
#include "variationsfixture.h"

#include <QAbstractSlider>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QTabBar>
#include <QTestEventList>
#include <QWheelEvent>
#include <memory>

namespace quadrille {

namespace {

/// Turns the wheel over a widget, as the window system does: Qt gives such events the keyboard first, and
/// hands them on to the widgets around.
void turnWheel(QWidget& widget, int notches)
{
    const QPointF place = widget.rect().center();
    QWheelEvent event(place, widget.mapToGlobal(place), {}, {0, 120 * notches}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&event);
    qApp->notify(&widget, &event);
}

/// What the wheel could change of a field; nothing of other widgets.
std::optional<QString> valueOf(const QWidget& widget)
{
    if (const auto* whole = qobject_cast<const QSpinBox*>(&widget))
        return whole->text();
    if (const auto* real = qobject_cast<const QDoubleSpinBox*>(&widget))
        return real->text();
    if (const auto* box = qobject_cast<const QComboBox*>(&widget))
        return QString::number(box->currentIndex());
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget))
        return QString::number(tabs->currentIndex());
    const auto* slider = qobject_cast<const QAbstractSlider*>(&widget);
    if (slider != nullptr && qobject_cast<const QScrollBar*>(&widget) == nullptr)
        return QString::number(slider->value());
    return std::nullopt;
}

} // namespace

class FieldsTest : public VariationsFixture
{
    Q_OBJECT

private:
    QList<QWidget*> fields()
    {
        QList<QWidget*> found;
        for (QWidget* widget : QApplication::allWidgets()) {
            if (valueOf(*widget) && m_window->isAncestorOf(widget))
                found += widget;
        }
        return found;
    }

private slots:
    void theWheelChangesNoFieldWithoutTheKeyboard()
    {
        open();
        QVERIFY(test::activate(*m_window));
        int turned = 0;
        for (const char* workspace : {"sequences", "graph", "animate", "variations"}) {
            m_window->workspaces().select(workspace);
            for (QWidget* field : fields()) {
                // Whoever shows fields polishes them; those that no panel shows now count, too.
                field->ensurePolished();
                m_window->setFocus();
                const auto before = valueOf(*field);
                for (const int notches : {1, -1}) {
                    turnWheel(*field, notches);
                    QVERIFY2(valueOf(*field) == before, qPrintable(field->objectName()));
                    QVERIFY2(!field->hasFocus(), qPrintable(field->objectName()));
                }
                ++turned;
            }
        }
        QVERIFY2(turned > 60, qPrintable(QString::number(turned)));
    }

    void theWheelOverAFieldScrollsThePanel()
    {
        open();
        QVERIFY(test::activate(*m_window));
        show("samplesPanel");
        auto* count = test::find<QDoubleSpinBox>("sampleCount");
        QScrollArea* area = nullptr;
        for (QWidget* at = count; area == nullptr && at != nullptr; at = at->parentWidget())
            area = qobject_cast<QScrollArea*>(at);
        QVERIFY(area != nullptr);
        area->setFixedHeight(160);
        QTRY_VERIFY(area->verticalScrollBar()->maximum() > 0);
        const int before = count->value();
        turnWheel(*count, -1);
        QVERIFY(area->verticalScrollBar()->value() > 0);
        QCOMPARE(count->value(), before);
        // Where the keyboard is, the wheel counts.
        count->setFocus();
        turnWheel(*count, 1);
        QCOMPARE(count->value(), before + 1);
    }

    void steppingUpFromAnEmptyNumberLeadsToWhatCounts()
    {
        const std::unique_ptr<QDoubleSpinBox> field(makeNumberField(
            {.path = "transfer.scale", .step = 0.05, .automatic = [] { return QString(); }, .first = 1}));
        field->setSpecialValueText(QStringLiteral("by itself"));
        field->setValue(field->minimum());
        QCOMPARE(field->text(), QStringLiteral("by itself"));
        field->stepUp();
        QCOMPARE(field->value(), 1.0);
        field->stepUp();
        QCOMPARE(field->value(), 1.05);

        const double usual = *factsOf("search.dwell").usual;
        const std::unique_ptr<QDoubleSpinBox> dwell(
            makeNumberField({.path = "search.dwell", .automatic = [] { return QString(); }}));
        dwell->setSpecialValueText(QStringLiteral("usual"));
        dwell->setValue(dwell->minimum());
        dwell->stepUp();
        QCOMPARE(dwell->value(), usual);
    }

    void undoingInANumberFieldUndoesTheProject()
    {
        open();
        QVERIFY(test::activate(*m_window));
        show("samplesPanel");
        auto* count = test::find<QDoubleSpinBox>("sampleCount");
        count->setFocus();
        const int before = entry().samples[0].count;
        QTest::keyClick(count, Qt::Key_Up);
        QCOMPARE(entry().samples[0].count, before + 1);
        QTest::keySequence(count, QKeySequence::Undo);
        QCOMPARE(entry().samples[0].count, before);
        QCOMPARE(count->value(), before);
        QTest::keySequence(count, QKeySequence::Redo);
        QCOMPARE(entry().samples[0].count, before + 1);
        // A number that is typed and taken is one step of the project …
        count->selectAll();
        QTest::keyClicks(count, "7");
        QTest::keyClick(count, Qt::Key_Return);
        QCOMPARE(entry().samples[0].count, 7);
        QTest::keySequence(count, QKeySequence::Undo);
        QCOMPARE(entry().samples[0].count, before + 1);
        // … one that is not taken yet is undone first.
        count->selectAll();
        QTest::keyClicks(count, "9");
        QTest::keySequence(count, QKeySequence::Undo);
        QCOMPARE(entry().samples[0].count, before + 1);
        QCOMPARE(count->cleanText(), QString::number(before + 1));
        QTest::keySequence(count, QKeySequence::Undo);
        QCOMPARE(entry().samples[0].count, before);
    }

    void undoingInATextFieldUndoesWhatIsTypedFirst()
    {
        open();
        QVERIFY(test::activate(*m_window));
        m_window->workspaces().select("sequences");
        context().selection.selectSequences({"first"});
        auto* name = test::find<QLineEdit>("sequenceName");
        QTRY_VERIFY(name->isVisible());
        name->setFocus();
        name->selectAll();
        QTest::keyClicks(name, "hop");
        QTest::keySequence(name, QKeySequence::Undo);
        QVERIFY(document().sequence("first") != nullptr);
        QVERIFY(name->text() != "hop");
        name->selectAll();
        QTest::keyClicks(name, "hop");
        QTest::keyClick(name, Qt::Key_Return);
        QTRY_VERIFY(document().sequence("hop") != nullptr);
        name->setFocus();
        QTest::keySequence(name, QKeySequence::Undo);
        QTRY_VERIFY(document().sequence("first") != nullptr);
        QTRY_COMPARE(name->text(), QString("first"));
    }

    void formsAreNotCutOffAtTheirSides()
    {
        auto* form = new QWidget;
        auto* row = new QHBoxLayout(form);
        auto* name = new QLabel("Scale");
        row->addWidget(name);
        const std::unique_ptr<QScrollArea> area(verticalScroll(form));
        area->show();
        const auto needed = [&] {
            return form->minimumSizeHint().width() + area->verticalScrollBar()->sizeHint().width();
        };
        QTRY_COMPARE(area->minimumWidth(), needed());
        const int before = area->minimumWidth();
        name->setText("Échelle du chemin"); // as another language has it
        QTRY_COMPARE(area->minimumWidth(), needed());
        QVERIFY(area->minimumWidth() > before);
        name->setText(QString(300, 'w'));
        QTRY_VERIFY(area->horizontalScrollBar()->maximum() > 0);
        QVERIFY(area->minimumWidth() < needed());
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::FieldsTest);
#include "tst_fields.moc"
