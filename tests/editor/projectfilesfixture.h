// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/application/projectfiles.h"
#include "editor/application/projectstrips.h"
#include "editor/documents/projectpaths.h"
#include "editortest.h"

#include <QDir>
#include <QFile>
#include <memory>

namespace quadrille {

/// The window with a folder that projects are saved in.
class ProjectFilesFixture : public QObject
{
    Q_OBJECT

protected:
    EditorContext& context() { return m_window->context(); }
    ProjectDocument& document() { return context().document; }
    ProjectFiles& files() { return m_window->files(); }
    QString file() const { return m_folder->filePath("take.quadrille"); }

    static QByteArray contentOf(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    static void write(const QString& path, const QByteArray& content)
    {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
    }
    static QDir recoveryFolder()
    {
        const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
                          "/recovery");
        QDir().mkpath(folder.path());
        return folder;
    }

    void newWindow()
    {
        m_window.reset();
        m_window = std::make_unique<MainWindow>();
        files().guard().setInterval(50);
        m_window->strips().media().setInterval(50);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        QVERIFY(test::activate(*m_window));
    }
    /// A project with the take “walk”, saved and open.
    void openSaved()
    {
        m_window->open({m_folder->filePath("walk_1.obj")});
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        QVERIFY(files().saveTo(toPath(file())));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;

protected slots:
    void initTestCase() { test::isolate(); }
    void init()
    {
        recoveryFolder().removeRecursively();
        m_folder = std::make_unique<QTemporaryDir>();
        test::writeSeries(m_folder->path(), {1, 2, 3, 4, 5, 6});
        newWindow();
    }
    void cleanup()
    {
        m_window.reset();
        m_folder.reset();
    }
};

} // namespace quadrille
