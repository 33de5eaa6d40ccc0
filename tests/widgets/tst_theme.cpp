// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QRadioButton>
#include <QSpinBox>
#include <QTest>

using namespace quadrille::widgets;

class TestTheme : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { Theme::instance().install(); }
    void textAndControlsHaveContrast_data();
    void textAndControlsHaveContrast();
    void controlsHaveAnOutline_data();
    void controlsHaveAnOutline();
    void aChoiceThatIsTooLongEndsInDots();
    void switchingTakesEffectAtOnce();
    void iconsFollowTheTheme();
    void everyIconDrawsSomething();
};

void TestTheme::textAndControlsHaveContrast_data()
{
    QTest::addColumn<QString>("file");
    QTest::newRow("dark") << ":/themes/dark.json";
    QTest::newRow("light") << ":/themes/light.json";
}

void TestTheme::textAndControlsHaveContrast()
{
    QFETCH(QString, file);
    const auto colors = ThemeColors::fromFile(file);
    const auto check = [&](ColorRole front, ColorRole back, double least) {
        const double contrast = Theme::contrast(colors[front], colors[back]);
        QVERIFY2(contrast >= least, qPrintable(QStringLiteral("%1 on %2: %3")
                                                   .arg(ThemeColors::name(front), ThemeColors::name(back))
                                                   .arg(contrast)));
    };
    for (const ColorRole surface : {ColorRole::Window, ColorRole::Base, ColorRole::Raised}) {
        for (const ColorRole text : {ColorRole::Text, ColorRole::TextMuted, ColorRole::AccentText,
                                     ColorRole::ErrorText, ColorRole::WarningText, ColorRole::SuccessText})
            check(text, surface, 4.5);
        check(ColorRole::Line, surface, 3);
    }
    check(ColorRole::OnAccent, ColorRole::Accent, 4.5);
    check(ColorRole::OnSelection, ColorRole::Selection, 4.5);
    check(ColorRole::ViewportText, ColorRole::ViewportTop, 4.5);
    check(ColorRole::ViewportText, ColorRole::ViewportBottom, 4.5);
    for (const ColorRole mark :
         {ColorRole::Original, ColorRole::Synthetic, ColorRole::Key, ColorRole::Demanded, ColorRole::Error})
        check(ColorRole::OnMark, mark, 4.5);
}

void TestTheme::controlsHaveAnOutline_data()
{
    QTest::addColumn<Theme::Mode>("mode");
    QTest::newRow("dark") << Theme::Mode::Dark;
    QTest::newRow("light") << Theme::Mode::Light;
}

void TestTheme::controlsHaveAnOutline()
{
    QFETCH(Theme::Mode, mode);
    Theme::instance().setMode(mode);
    QCheckBox check;
    QRadioButton radio;
    QLineEdit line;
    QSpinBox spin;
    QComboBox combo;
    for (QWidget* control : std::initializer_list<QWidget*>{&check, &radio, &line, &spin, &combo}) {
        control->resize(control->sizeHint());
        const QImage picture = control->grab().toImage();
        double highest = 1; // on the way in from the left, half way down
        for (int x = 0; x < std::min(12, picture.width()); ++x) {
            const QColor pixel = picture.pixelColor(x, picture.height() / 2);
            highest = std::max(highest, Theme::contrast(pixel, Theme::color(ColorRole::Window)));
        }
        QVERIFY2(highest >= 3,
                 qPrintable(QString("%1: %2").arg(control->metaObject()->className()).arg(highest)));
    }
}

void TestTheme::aChoiceThatIsTooLongEndsInDots()
{
    const auto pictureOf = [](const QString& choice) {
        QComboBox combo;
        combo.addItem(choice);
        combo.resize(100, combo.sizeHint().height());
        return combo.grab().toImage();
    };
    const QString longest = QStringLiteral("Choice that is much too long for it");
    bool isElided = false;
    for (int letters = 0; letters < longest.size(); ++letters) {
        const QImage dotted = pictureOf(longest.left(letters) + QChar(0x2026));
        const bool showsDots = dotted != pictureOf(longest.left(letters));
        isElided |= showsDots && pictureOf(longest) == dotted;
    }
    QVERIFY(isElided);
    QVERIFY(pictureOf(QStringLiteral("Choice")) != pictureOf(QStringLiteral("Choic") + QChar(0x2026)));
}

void TestTheme::switchingTakesEffectAtOnce()
{
    auto& theme = Theme::instance();
    theme.install();
    theme.setMode(Theme::Mode::Dark);
    QCOMPARE(qApp->palette().color(QPalette::WindowText), Theme::color(ColorRole::Text));
    const QColor dark = qApp->palette().color(QPalette::Window);
    theme.setMode(Theme::Mode::Light);
    QVERIFY(qApp->palette().color(QPalette::Window).lightness() > dark.lightness());
    QVERIFY(!theme.isDark());
}

void TestTheme::iconsFollowTheTheme()
{
    const QIcon icon = icons::icon(QStringLiteral("play"));
    Theme::instance().setMode(Theme::Mode::Light);
    const QImage light = icon.pixmap(24).toImage();
    Theme::instance().setMode(Theme::Mode::Dark);
    QVERIFY(icon.pixmap(24).toImage() != light);
}

void TestTheme::everyIconDrawsSomething()
{
    QVERIFY(icons::names().size() > 40);
    for (const QString& name : icons::names()) {
        const QImage image = icons::pixmap(name, 16, Qt::black, 2.0).toImage();
        QCOMPARE(image.size(), QSize(32, 32));
        int inked = 0;
        for (int y = 0; y < 32; ++y) {
            for (int x = 0; x < 32; ++x)
                inked += qAlpha(image.pixel(x, y)) > 128;
        }
        QVERIFY2(inked > 10, qPrintable(name));
    }
    QVERIFY(!icons::application().isNull());
}

QUADRILLE_QT_TEST(TestTheme);
#include "tst_theme.moc"
