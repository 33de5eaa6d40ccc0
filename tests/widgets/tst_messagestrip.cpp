// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/controls/messagestrip.h"

#include <QLabel>
#include <QPushButton>
#include <QTest>

using namespace quadrille::widgets;

class TestMessageStrip : public QObject
{
    Q_OBJECT
private slots:
    void theButtonLeavesTheTextItsWidth();
};

void TestMessageStrip::theButtonLeavesTheTextItsWidth()
{
    MessageStrip strip;
    strip.show(MessageStrip::Kind::Info, QStringLiteral("What was decided changed single transitions only."));
    strip.setAction(QStringLiteral("Seek the walk again"));
    strip.setVisible(true);
    QVERIFY(QTest::qWaitForWindowExposed(&strip));
    const auto* text = strip.findChild<QLabel*>(QStringLiteral("messageStripText"));
    const auto* button = strip.findChild<QPushButton*>();
    strip.resize(900, 40);
    QTRY_VERIFY(button->geometry().left() >= text->geometry().right());
    strip.resize(240, 160);
    QTRY_VERIFY(button->geometry().top() >= text->geometry().bottom());
    QVERIFY(text->width() > 180);
}

QUADRILLE_QT_TEST(TestMessageStrip);
#include "tst_messagestrip.moc"
