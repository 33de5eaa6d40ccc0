// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/playback/player.h"
#include "editor/playback/sequencestage.h"
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "editortest.h"
#include "model/sample/sample.h"

#include <QStandardPaths>

namespace quadrille {

class MainWindowTest : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase() { test::isolate(); }
    void init()
    {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }
    void cleanup() { m_window.reset(); }
    void cleanupTestCase()
    {
        QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)).removeRecursively();
    }

    void theSampleOpensPlaying()
    {
        m_window->openSample();
        const EditorContext& context = m_window->context();
        QTRY_VERIFY_WITH_TIMEOUT(!context.document.project().sequences.empty(), 60000);
        const QString first = QString::fromStdString(context.document.project().sequences.front().name);
        QCOMPARE(context.selection.shownSequence(), first);
        QVERIFY(test::waitForSequence(*m_window, first));
        for (const SequenceEntry& entry : context.document.project().sequences) {
            const QString name = QString::fromStdString(entry.name);
            QVERIFY2(test::waitForSequence(*m_window, name), entry.name.c_str());
        }
        SequencesWorkspace& workspace = m_window->sequences();
        QTRY_VERIFY(workspace.player().isPlaying());
        QTRY_VERIFY(workspace.player().frame() > FrameIndex(3));
        QTRY_VERIFY(!workspace.stage().textureOf(first).isNull());
    }
};

} // namespace quadrille

QTEST_MAIN(quadrille::MainWindowTest)
#include "tst_mainwindow.moc"
