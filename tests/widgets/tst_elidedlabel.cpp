// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/eventcounter.h"
#include "tests/qt/registry.h"
#include "widgets/controls/breakable.h"
#include "widgets/controls/elidedlabel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QTest>

namespace quadrille::widgets {

class ElidedLabelTest : public QObject
{
    Q_OBJECT

private:
    static QImage picture(const QString& text, int width)
    {
        ElidedLabel label;
        label.setText(text);
        label.resize(width, 24);
        return label.grab().toImage();
    }

private slots:
    void aLongTextEndsInAnEllipsis()
    {
        const QString text = QStringLiteral("Preparing the spaces of movement that are played");
        const ElidedLabel label;
        const int whole = label.fontMetrics().horizontalAdvance(text);
        const QString cut = label.fontMetrics().elidedText(text, Qt::ElideRight, whole / 2);
        QVERIFY(cut.endsWith(QChar(0x2026)));
        QCOMPARE(picture(text, whole / 2), picture(cut, whole / 2));
        QVERIFY(picture(text, whole + 4) != picture(cut, whole + 4));
        QVERIFY(picture(text, whole / 2) != picture({}, whole / 2));
    }

    void itTakesTheWidthThatItIsGiven()
    {
        QWidget bar;
        auto* row = new QHBoxLayout(&bar);
        auto* label = new ElidedLabel;
        row->addWidget(label, 1);
        const int before = bar.minimumSizeHint().width();
        label->setText(QString(200, 'x'));
        QCOMPARE(bar.minimumSizeHint().width(), before);
        QCOMPARE(label->text().size(), 200);
    }

    void anotherTextIsNoReasonToLayOutWhatIsAroundIt()
    {
        QWidget bar;
        auto* row = new QHBoxLayout(&bar);
        auto* label = new ElidedLabel;
        row->addWidget(label, 1);
        bar.show();
        QCoreApplication::sendPostedEvents();
        test::EventCounter layouts(bar, QEvent::LayoutRequest);
        for (int i = 0; i < 5; ++i) {
            label->setText(QString::number(1000 * i));
            QCoreApplication::sendPostedEvents();
        }
        QCOMPARE(layouts.count(), 0);
        QFont larger = label->font();
        larger.setPointSizeF(2 * larger.pointSizeF());
        label->setFont(larger);
        QCoreApplication::sendPostedEvents();
        QVERIFY(layouts.count() > 0);
    }

    void longNamesBreakInsteadOfWideningTheirLabel()
    {
        const QString name(90, 'x');
        QLabel label(breakable(name));
        label.setWordWrap(true);
        QVERIFY(label.minimumSizeHint().width() < label.fontMetrics().horizontalAdvance(name) / 2);
        QCOMPARE(breakable(name).remove(QChar(0x200B)), name);
        QCOMPARE(breakable("a/b_c\\d.pc2"), QString("a/\u200Bb_\u200Bc\\\u200Bd.\u200Bpc2"));
        QCOMPARE(breakable("Takes 1.25 s. Then it ends."), QString("Takes 1.25 s. Then it ends."));
    }

    void whatLooksLikeMarkupIsText()
    {
        QVERIFY(picture(QStringLiteral("<b>walk</b>"), 300) != picture(QStringLiteral("walk"), 300));
    }
};

} // namespace quadrille::widgets

QUADRILLE_QT_TEST(quadrille::widgets::ElidedLabelTest);
#include "tst_elidedlabel.moc"
