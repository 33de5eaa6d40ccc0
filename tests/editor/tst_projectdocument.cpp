// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/projectedits.h"
#include "editor/documents/projectpaths.h"
#include "model/project/file/projectfile.h"
#include "tests/qt/registry.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace quadrille {

class TestProjectDocument : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_file = toPath(m_folder->filePath("show/act.quadrille"));
        m_project = {};
        m_project.characters = {{.name = "Ada", .mesh = path("media/ada.obj")}};
        m_project.sequences = {{.name = "walk", .character = "Ada", .source = path("media/walk_####.obj")}};
        m_project.exports = {
            {.name = "out", .what = "sequences/walk", .path = path("show/out/walk.glb"), .format = "glb"}};
    }

    void savingWritesPathsRelativeToTheFile()
    {
        ProjectDocument document;
        document.reset(m_project);
        QVERIFY(document.isUntitled());
        document.saveAs(m_file);
        QCOMPARE(document.title(), QStringLiteral("act"));
        const Project onDisk = loadProject(m_file);
        QCOMPARE(onDisk.characters[0].mesh, std::string("../media/ada.obj"));
        QCOMPARE(onDisk.sequences[0].source, std::string("../media/walk_####.obj"));
        QCOMPARE(onDisk.exports[0].path, std::string("out/walk.glb"));
    }

    void whatIsSavedIsWhatOpens()
    {
        ProjectDocument document;
        document.reset(m_project);
        document.saveAs(m_file);
        ProjectDocument other;
        other.load(m_file);
        QVERIFY(other.project() == document.project());
        QVERIFY(!other.isModified());
        QCOMPARE(other.file(), m_file);
    }

    void savingElsewhereKeepsMediaAndUndo()
    {
        ProjectDocument document;
        document.reset(m_project);
        document.saveAs(m_file);
        setCharacterNotes(document, "Ada", "x");
        document.saveAs(toPath(m_folder->filePath("act2.quadrille")));
        QCOMPARE(loadProject(document.file()).characters[0].mesh, std::string("media/ada.obj"));
        document.undo();
        QVERIFY(document.isModified());
        QVERIFY(document.project() == m_project);
    }

    void aFailedSaveLeavesTheOldFileAndTheDocument()
    {
        ProjectDocument document;
        document.reset(m_project);
        document.saveAs(m_file);
        QFile file(toQString(m_file));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray before = file.readAll();
        setCharacterNotes(document, "Ada", "x");
        // A folder where the file should go cannot be replaced, not even by root.
        const auto blocked = toPath(m_folder->filePath("blocked.quadrille"));
        std::filesystem::create_directories(blocked / "inside");
        QVERIFY_EXCEPTION_THROWN(document.saveAs(blocked), Error);
        QCOMPARE(document.file(), m_file);
        QVERIFY(document.isModified());
        file.seek(0);
        QCOMPARE(file.readAll(), before);
    }

    void aFileThatCannotBeReadLeavesTheDocument()
    {
        ProjectDocument document;
        document.reset(m_project);
        QSignalSpy changes(&document, &ProjectDocument::changed);
        QVERIFY_EXCEPTION_THROWN(document.load(toPath(m_folder->filePath("missing.quadrille"))), Error);
        QVERIFY(document.project() == m_project);
        QCOMPARE(changes.count(), 0);
    }

    void aRecoveredProjectIsModifiedUntilSaved()
    {
        ProjectDocument document;
        document.recover(m_project, m_file);
        QVERIFY(document.isModified());
        std::filesystem::create_directories(m_file.parent_path());
        document.save();
        QVERIFY(!document.isModified());
        QVERIFY(std::filesystem::exists(m_file));
    }

private:
    std::string path(const char* relative) const
    {
        return QString(m_folder->filePath(relative)).toStdString();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::filesystem::path m_file;
    Project m_project;
};

} // namespace quadrille

QUADRILLE_QT_TEST_IN(QCoreApplication, quadrille::TestProjectDocument);
#include "tst_projectdocument.moc"
