// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The window under a window manager, from start to start: filling the screen, beside another, in every
// workspace, at every scale, and with what is left of damaged sessions.
#include "desktopprogram.h"
#include "desktopwindows.h"
#include "editor/application/session.h"
#include "editor/application/startguard.h"
#include "editor/context/windowplace.h"
#include "editor/workspaces/workspacetabs.h"
#include "editortest.h"
#include "tests/qt/registry.h"

#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QJsonDocument>
#include <QLabel>
#include <QProcess>
#include <QScreen>
#include <algorithm>
#include <functional>

namespace quadrille {

namespace {

const QStringList workspaceNames{"sequences", "graph", "animate", "variations"};

using Damage = std::function<QByteArray(const QByteArray&)>;

enum class Fill
{
    Nothing,
    Maximised,
    FullScreen,
    Half
};

QByteArray contentsOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void write(const QString& path, const QByteArray& contents)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(contents);
}

} // namespace

class DesktopTest : public QObject
{
    Q_OBJECT

private:
    QString project() const { return m_folder.filePath("take.quadrille"); }
    WorkspaceTabs& workspaces() { return m_window->workspaces(); }

    void newWindow()
    {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }
    void leave()
    {
        QVERIFY(m_window->close());
        m_window.reset();
    }
    void openProject()
    {
        m_window->open({project()});
        QVERIFY(test::waitForSequence(*m_window, "walk"));
    }
    /// Waits until the window manager has given the window its size.
    void fill(Fill how)
    {
        const QRect screen = m_window->screen()->availableGeometry();
        switch (how) {
        case Fill::Nothing:
            return;
        case Fill::Maximised:
            m_window->showMaximized();
            QTRY_COMPARE(m_window->width(), screen.width());
            return;
        case Fill::FullScreen:
            m_window->showFullScreen();
            QTRY_COMPARE(m_window->size(), m_window->screen()->size());
            return;
        case Fill::Half: {
            const QRect half(screen.center().x(), 40, screen.width() / 2, screen.height() - 80);
            m_window->setGeometry(half);
            QTRY_COMPARE(m_window->size(), half.size());
            return;
        }
        }
    }
    QString placeText() const
    {
        const QRect place = m_window->frameGeometry();
        return QStringLiteral("%1 × %2 at %3, %4")
            .arg(place.width())
            .arg(place.height())
            .arg(place.x())
            .arg(place.y());
    }
    QMap<QString, QSize> shownDocks() const
    {
        QMap<QString, QSize> sizes;
        for (const auto* dock : m_window->findChildren<QDockWidget*>()) {
            if (dock->isVisible() &&
                dock->geometry().left() >= 0) // those behind others are beside the window
                sizes[dock->objectName()] = dock->size();
        }
        return sizes;
    }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase()
    {
        test::isolate();
        test::writeSeries(m_folder.path(), {1, 2, 3, 4, 5, 6});
        newWindow();
        m_window->open({m_folder.filePath("walk_1.obj")});
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        m_window->context().document.saveAs(project().toStdString());
        leave();
        forgetSessions();
    }
    void cleanup()
    {
        m_window.reset();
        forgetSessions();
    }
    static void forgetSessions() { QDir(QFileInfo(sessionFile({})).path()).removeRecursively(); }

    void theWindowStartsAgainAsItWasLeft_data()
    {
        QTest::addColumn<QString>("workspace");
        QTest::addColumn<int>("fill");
        for (const QString& name : workspaceNames) {
            const std::string id = name.toStdString();
            QTest::addRow("%s as it is", id.c_str()) << name << int(Fill::Nothing);
            QTest::addRow("%s maximised", id.c_str()) << name << int(Fill::Maximised);
            QTest::addRow("%s on the full screen", id.c_str()) << name << int(Fill::FullScreen);
            QTest::addRow("%s on half the screen", id.c_str()) << name << int(Fill::Half);
        }
    }
    void theWindowStartsAgainAsItWasLeft()
    {
        QFETCH(QString, workspace);
        QFETCH(int, fill);
        newWindow();
        openProject();
        workspaces().select(workspace);
        this->fill(static_cast<Fill>(fill));
        QCoreApplication::processEvents();
        const QSize size = m_window->size();
        const auto docks = shownDocks();
        leave();
        for (int start = 0; start < 2; ++start) {
            newWindow();
            openProject();
            QTRY_COMPARE(m_window->size(), size);
            QCOMPARE(workspaces().current(), workspace);
            QTRY_COMPARE(shownDocks(), docks);
            leave();
        }
    }

    void aMaximisedWindowWithoutAProjectStartsAgain_data()
    {
        QTest::addColumn<int>("fill");
        QTest::newRow("as it is") << int(Fill::Nothing);
        QTest::newRow("maximised") << int(Fill::Maximised);
        QTest::newRow("on the full screen") << int(Fill::FullScreen);
        QTest::newRow("on half the screen") << int(Fill::Half);
    }
    void aMaximisedWindowWithoutAProjectStartsAgain()
    {
        QFETCH(int, fill);
        newWindow();
        const QSize usual = m_window->size();
        this->fill(static_cast<Fill>(fill));
        QCoreApplication::processEvents();
        const QSize size = m_window->size();
        const auto docks = shownDocks();
        leave();
        for (int start = 0; start < 3; ++start) {
            newWindow();
            QTRY_COMPARE(m_window->size(), size);
            QTRY_COMPARE(shownDocks(), docks);
            leave();
        }
        if (static_cast<Fill>(fill) == Fill::Half)
            return;
        newWindow();
        m_window->showNormal();
        QTRY_COMPARE(m_window->size(), usual);
    }

    void aSessionThatCannotBeRestoredIsPutAside_data()
    {
        QTest::addColumn<Damage>("damage");
        QTest::newRow("nothing") << Damage([](const QByteArray&) { return QByteArray(); });
        QTest::newRow("garbage") << Damage(
            [](const QByteArray& all) { return QByteArray(all.size(), '\x9c'); });
        QTest::newRow("cut off") << Damage([](const QByteArray& all) { return all.left(all.size() / 2); });
        QTest::newRow("other docks") << Damage([](const QByteArray& all) {
            QJsonObject stored = QJsonDocument::fromJson(all).object();
            QJsonObject docks = stored["docks"].toObject();
            QByteArray state = QByteArray::fromBase64(docks["sequences"].toString().toLatin1());
            for (qsizetype at = 20; at < state.size(); at += 7)
                state[at] = '\xff';
            docks["sequences"] = QString::fromLatin1(state.toBase64());
            stored["docks"] = docks;
            return QJsonDocument(stored).toJson();
        });
        QTest::newRow("newer version") << Damage([](const QByteArray& all) {
            QJsonObject stored = QJsonDocument::fromJson(all).object();
            stored["format"] = 1000;
            return QJsonDocument(stored).toJson();
        });
    }
    void aSessionThatCannotBeRestoredIsPutAside()
    {
        QFETCH(Damage, damage);
        newWindow();
        openProject();
        fill(Fill::Maximised);
        leave();
        for (const QString& file : {sessionFile({}), sessionFile(project().toStdString())}) {
            const QByteArray damaged = damage(contentsOf(file));
            write(file, damaged);
            newWindow();
            if (file != sessionFile({}))
                openProject();
            QTRY_VERIFY(test::find<QLabel>("message")->text().contains(file + ".aside"));
            QCOMPARE(contentsOf(file + ".aside"), damaged);
            QVERIFY(!QFile::exists(file));
            leave();
            newWindow();
            QVERIFY(test::find<QLabel>("message")->text().isEmpty());
            leave();
        }
    }

    void aWindowFromElsewhereComesOntoTheScreen_data()
    {
        QTest::addColumn<QRect>("place");
        QTest::newRow("larger screen") << QRect(100, 100, 5000, 3000);
        QTest::newRow("screen at the left") << QRect(-3000, 200, 1280, 800);
        QTest::newRow("screen below") << QRect(300, 4000, 1280, 800);
        QTest::newRow("no size") << QRect(0, 0, 0, 0);
    }
    void aWindowFromElsewhereComesOntoTheScreen()
    {
        QFETCH(QRect, place);
        for (const bool isMaximised : {false, true}) {
            QWidget left;
            left.setGeometry(place);
            if (isMaximised)
                left.setWindowState(Qt::WindowMaximized);
            Session session;
            session.windowPlace = placeOf(left);
            saveSession(session, {});
            newWindow();
            // The title bar and all that is in the window; an edge of a few pixels may be cut.
            const QRect screen = m_window->screen()->availableGeometry().marginsAdded({8, 0, 8, 8});
            QTRY_VERIFY2(screen.contains(m_window->frameGeometry()), qPrintable(placeText()));
            QCOMPARE(m_window->isMaximized(), isMaximised);
            m_window->showNormal();
            QTRY_VERIFY(!m_window->isMaximized() && screen.contains(m_window->frameGeometry()));
            leave();
        }
    }

    void theProgramStartsAgain_data()
    {
        QTest::addColumn<QStringList>("scales");
        QTest::newRow("100 %") << QStringList{"1", "1", "1"};
        QTest::newRow("150 %") << QStringList{"1.5", "1.5", "1.5"};
        QTest::newRow("200 %") << QStringList{"2", "2", "2"};
        QTest::newRow("from scale to scale") << QStringList{"2", "1", "1.5"};
    }
    void theProgramStartsAgain()
    {
        QFETCH(QStringList, scales);
        for (const test::WindowWish wish : {test::WindowWish::Maximise, test::WindowWish::FillScreen}) {
            const QTemporaryDir folder;
            QSize size;
            for (const QString& scale : scales) {
                test::DesktopProgram program(folder.path());
                program.setScale(scale);
                program.start();
                QTRY_VERIFY(program.window().id != 0 || program.hasEnded());
                QVERIFY2(!program.hasEnded(), "it crashed");
                const test::DesktopWindow window = program.window();
                if (size.isEmpty()) {
                    const QSize usual = test::sizeOf(window);
                    test::ask(wish, window);
                    QTRY_VERIFY(test::sizeOf(window).width() > usual.width());
                    size = test::sizeOf(window);
                }
                QTRY_COMPARE(test::sizeOf(window), size);
                // A start counts as one that did not fail as soon as the window has stood for a while.
                QTRY_VERIFY(QDir(program.settings()).entryList({"starting-*"}).isEmpty());
                test::ask(test::WindowWish::Close, window);
                QTRY_VERIFY(!program.isRunning());
                QCOMPARE(program.process().exitStatus(), QProcess::NormalExit);
                QCOMPARE(program.process().exitCode(), 0);
            }
        }
    }

    void threeFailedStartsOfferDefaultSettings()
    {
        const QTemporaryDir folder;
        // A start that has shown its window before it is killed did not fail, and takes those before it
        // along.
        int failed = 0;
        for (int start = 0; failed < StartGuard::patience && start < 20; ++start) {
            test::DesktopProgram program(folder.path());
            program.start();
            QTRY_VERIFY(program.markers() != failed || program.window().id != 0);
            program.kill();
            failed = program.markers();
        }
        QCOMPARE(failed, StartGuard::patience);
        test::DesktopProgram program(folder.path());
        write(program.settings() + "/quadrille.conf", "[General]\ntheme=light\nlanguage=en\n");
        program.start();
        QTRY_VERIFY(program.window("did not start").id != 0);
        // Escape and the window's cross start as before; the settings stay.
        test::ask(test::WindowWish::Close, program.window("did not start"));
        QTRY_VERIFY(program.window("Untitled").id != 0);
        QTRY_VERIFY(QDir(program.settings()).entryList({"starting-*"}).isEmpty());
        QVERIFY(contentsOf(program.settings() + "/quadrille.conf").contains("theme=light"));
        test::ask(test::WindowWish::Close, program.window("Untitled"));
        QTRY_VERIFY(!program.isRunning());
    }

    void settingsThatCannotBeReadArePutAside()
    {
        const QTemporaryDir folder;
        test::DesktopProgram program(folder.path());
        QDir().mkpath(program.settings());
        const QByteArray garbage("\x00\x9c]]\n[[[=\n\xff\xfe", 12);
        write(program.settings() + "/quadrille.conf", garbage);
        program.start();
        QTRY_VERIFY(program.window("Untitled").id != 0);
        QCOMPARE(contentsOf(program.settings() + "/quadrille.conf.aside"), garbage);
        test::ask(test::WindowWish::Close, program.window("Untitled"));
        QTRY_VERIFY(!program.isRunning());
        QCOMPARE(program.process().exitCode(), 0);
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::DesktopTest);
#include "tst_desktop.moc"
