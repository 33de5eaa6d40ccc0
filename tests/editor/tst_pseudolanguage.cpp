// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/language/pseudolanguage.h"
#include "tests/editor/editortest.h"
#include "tests/qt/registry.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QRegularExpression>
#include <QTabBar>
#include <QTableView>
#include <QTreeView>
#include <QTreeWidget>
#include <QUndoStack>
#include <QUrl>

using namespace quadrille;

namespace {

/// What no language translates: names of programs, languages, formats, units and files.
bool isProperName(const QString& word)
{
    static const QStringList names{"Quadrille", "cm",       "mm",     "km",   "in",     "ft",
                                   "English",   "Français", "fps",    "walk", "walk_1", "obj",
                                   "Ctrl",      "Shift",    "Alt",    "Del",  "Space",  "Home",
                                   "End",       "Esc",      "Return", "PgUp", "PgDown"};
    return names.contains(word);
}

/// The words of a text that did not pass through a translator.
QStringList untranslated(QString text)
{
    static const QRegularExpression markup(QStringLiteral("<[^<>]*>|&\\w+;|&"));
    static const QRegularExpression bracketed(QStringLiteral("\\[[^\\[\\]]*\\]"));
    static const QRegularExpression word(QStringLiteral("\\p{L}[\\p{L}\\d_]+"));
    // The user's own files and folders, as the tests name them.
    static const QRegularExpression files(
        QStringLiteral("[^\\s\\[\\]]*(/|####|quadrille-test-)[^\\s\\[\\]]*"));
    text.remove(markup);
    text.remove(files);
    while (text.contains(bracketed))
        text.remove(bracketed);
    QStringList words;
    for (auto matches = word.globalMatch(text); matches.hasNext();) {
        const QString found = matches.next().captured();
        if (!isProperName(found))
            words += found;
    }
    return words;
}

/// Collects what is not translated, with the widget that says it.
class Inspection
{
public:
    void inspect(QWidget& top)
    {
        for (QWidget* widget : top.findChildren<QWidget*>()) {
            // Qt's own catalogue names the buttons of its docks and of tabs that do not fit.
            const QString name = widget->objectName();
            const bool isQts = name.startsWith("qt_dockwidget_") ||
                               (name.startsWith("Scroll") && qobject_cast<QTabBar*>(widget->parentWidget()));
            if (widget->isVisible() && !isQts)
                visit(*widget);
        }
        visit(top);
    }

    QStringList complaints;

private:
    void check(const QString& text, const QObject& where, const char* what)
    {
        const QStringList words = untranslated(text);
        if (!words.isEmpty())
            complaints += QStringLiteral("%1 %2, %3: \"%4\"")
                              .arg(where.metaObject()->className(), where.objectName(), what, text);
    }

    void visit(QWidget& widget)
    {
        check(widget.toolTip(), widget, "tool tip");
        check(widget.statusTip(), widget, "status tip");
        check(widget.accessibleName(), widget, "accessible name");
        check(widget.accessibleDescription(), widget, "accessible description");
        if (widget.isWindow() || qobject_cast<QDockWidget*>(&widget) != nullptr)
            check(widget.windowTitle(), widget, "title");
        if (const auto* label = qobject_cast<QLabel*>(&widget))
            check(label->text(), widget, "text");
        if (const auto* button = qobject_cast<QAbstractButton*>(&widget))
            check(button->text(), widget, "text");
        if (const auto* box = qobject_cast<QGroupBox*>(&widget))
            check(box->title(), widget, "title");
        if (const auto* edit = qobject_cast<QLineEdit*>(&widget))
            check(edit->placeholderText(), widget, "placeholder");
        if (const auto* box = qobject_cast<QComboBox*>(&widget)) {
            for (int i = 0; i < box->count(); ++i)
                check(box->itemText(i), widget, "item");
        }
        if (const auto* tabs = qobject_cast<QTabBar*>(&widget)) {
            for (int i = 0; i < tabs->count(); ++i)
                check(tabs->tabText(i), widget, "tab");
        }
        if (const auto* header = qobject_cast<QHeaderView*>(&widget);
            header != nullptr && header->model() != nullptr) {
            for (int i = 0; i < header->count(); ++i)
                check(header->model()->headerData(i, header->orientation()).toString(), widget, "header");
        }
        for (const QAction* action : widget.actions()) {
            check(action->text(), *action, "text");
            check(action->toolTip(), *action, "tool tip");
            check(action->statusTip(), *action, "status tip");
            if (const QMenu* menu = action->menu()) {
                for (const QAction* entry : menu->actions()) {
                    check(entry->text(), *entry, "text");
                    check(entry->toolTip(), *entry, "tool tip");
                    check(entry->statusTip(), *entry, "status tip");
                }
            }
        }
    }
};

} // namespace

/// A language that nobody speaks shows which texts cannot be translated.
class PseudoLanguageTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { test::isolate(); }
    void textsGrowAndKeepTheirPlaceholders_data();
    void textsGrowAndKeepTheirPlaceholders();
    void untranslatedWordsAreFound();
    void welcomeSpeaksIt();
    void openSequenceSpeaksIt();
    void importPreviewSpeaksIt();
    void relinkDialogSpeaksIt();
    void everyActionSpeaksIt();

private:
    /// Of every window that is open.
    static void expectTranslated();
};

void PseudoLanguageTest::textsGrowAndKeepTheirPlaceholders_data()
{
    QTest::addColumn<QString>("english");
    QTest::addColumn<QString>("pseudo");
    QTest::newRow("words") << "Hidden"
                           << "[Hîddéñ~~~]";
    QTest::newRow("placeholder") << "%1 of %n"
                                 << "[%1 öf %n~~]";
    QTest::newRow("named") << "{found} here"
                           << "[{found} héré~~]";
    QTest::newRow("mnemonic") << "&Open"
                              << "[&Opéñ~~]";
    QTest::newRow("filter") << "Mesh (*.obj *.ply)"
                            << "[Méšh (*.obj *.ply)~~]";
    QTest::newRow("markup") << "<b>go</b>"
                            << "[<b>gö</b>~]";
    QTest::newRow("nothing") << " "
                             << " ";
}

void PseudoLanguageTest::textsGrowAndKeepTheirPlaceholders()
{
    QFETCH(QString, english);
    QTEST(pseudoTranslated(english), "pseudo");
}

void PseudoLanguageTest::untranslatedWordsAreFound()
{
    QCOMPARE(untranslated("[Hîddéñ~~~] but plain"), QStringList({"but", "plain"}));
    QCOMPARE(untranslated("[Öné [îñšîdé~~] %1~~] 12 x 3 fps"), QStringList());
}

void PseudoLanguageTest::expectTranslated()
{
    Inspection inspection;
    for (QWidget* window : QApplication::topLevelWidgets()) {
        if (window->isVisible())
            inspection.inspect(*window);
    }
    QVERIFY2(inspection.complaints.isEmpty(),
             qPrintable(QStringLiteral("not translatable:\n") + inspection.complaints.join('\n')));
}

void PseudoLanguageTest::welcomeSpeaksIt()
{
    MainWindow window;
    window.resize(1500, 950);
    window.show();
    window.context().languages.setLanguage(pseudoLanguage());
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    expectTranslated();
}

void PseudoLanguageTest::openSequenceSpeaksIt()
{
    QTemporaryDir folder;
    test::writeSeries(folder.path(), {1, 2, 3, 4});
    MainWindow window;
    window.resize(1500, 950);
    window.show();
    window.context().languages.setLanguage(pseudoLanguage());
    window.open({folder.path()});
    QVERIFY(test::waitForSequence(window, "walk"));
    for (auto* dock : window.findChildren<QDockWidget*>())
        dock->show();
    window.context().issues.add(
        Error(ErrorCode::VertexCountMismatch, {.values = {{"found", "12"}, {"expected", "84"}}}), "walk");
    QCoreApplication::processEvents();
    expectTranslated();
    window.context().document.undoStack()->setClean();
}

void PseudoLanguageTest::importPreviewSpeaksIt()
{
    QTemporaryDir folder;
    test::writeSeries(folder.path(), {1, 2, 4});
    MainWindow window;
    window.show();
    window.context().languages.setLanguage(pseudoLanguage());
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(folder.path())});
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QDragEnterEvent enter(window.rect().center(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
    QDropEvent drop(window.rect().center(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &drop);
    auto importButton = [] {
        for (QWidget* widget : QApplication::allWidgets())
            if (widget->objectName() == "importAccept")
                return widget;
        return static_cast<QWidget*>(nullptr);
    };
    QTRY_VERIFY(importButton() != nullptr && importButton()->isVisible() && importButton()->isEnabled());
    expectTranslated();
}

void PseudoLanguageTest::relinkDialogSpeaksIt()
{
    QTemporaryDir folder;
    Project project;
    project.sequences.resize(1);
    project.sequences[0].name = "1";
    project.sequences[0].source = folder.filePath("2").toStdString();
    MainWindow window;
    window.show();
    window.context().languages.setLanguage(pseudoLanguage());
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.context().document.reset(project);
    auto* strip = window.findChild<QWidget*>("missingStrip");
    QTRY_VERIFY(strip->isVisible());
    QTest::mouseClick(strip->findChild<QPushButton*>(), Qt::LeftButton);
    auto* byHand = test::find<QPushButton>("relinkByHand");
    QTRY_VERIFY(byHand->isVisible() && byHand->isEnabled());
    // Folders are the user's words.
    auto* table = test::find<QTreeWidget>("relinkTable");
    QVERIFY(untranslated(table->topLevelItem(0)->text(2)).isEmpty());
    expectTranslated();
}

void PseudoLanguageTest::everyActionSpeaksIt()
{
    MainWindow window;
    window.context().languages.setLanguage(pseudoLanguage());
    QCoreApplication::processEvents();
    QStringList complaints;
    for (const QAction* action : window.findChildren<QAction*>()) {
        for (const QString& text :
             {action->text(), action->toolTip(), action->statusTip(), action->whatsThis()})
            if (!untranslated(text).isEmpty())
                complaints += action->objectName() + ": " + text;
    }
    QVERIFY2(complaints.isEmpty(), qPrintable(complaints.join('\n')));
}

QUADRILLE_QT_TEST(PseudoLanguageTest);
#include "tst_pseudolanguage.moc"
