// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/sequencemedia.h"
#include "editor/jobs/jobrunner.h"
#include "editor/pictures/framepictures.h"
#include "editortest.h"
#include "tests/qt/registry.h"

#include <numeric>

namespace quadrille {

class FramePicturesTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { test::isolate(); }

    void drawsTheOthersWhereAFrameCannotBeRead()
    {
        const QTemporaryDir folder;
        QList<int> numbers(100); // the ground is found by a few of them
        std::iota(numbers.begin(), numbers.end(), 1);
        test::writeSeries(folder.path(), numbers);
        JobRunner jobs;
        ProjectDocument document;
        SequenceMedia media(document, jobs);
        FramePictures pictures(document, media, jobs);
        Project project;
        project.sequences.resize(1);
        project.sequences[0].name = "walk";
        project.sequences[0].source = folder.filePath(QStringLiteral("walk_*.obj")).toStdString();
        document.reset(project);
        const QString walk = QStringLiteral("walk");
        QTRY_VERIFY(media.sequence(walk) != nullptr);
        std::ofstream(folder.filePath(QStringLiteral("walk_2.obj")).toStdString()) << "no mesh\n";

        const auto isDrawn = [&](int frame) { return !pictures.picture(walk, FrameIndex(frame)).isNull(); };
        QTRY_VERIFY(isDrawn(0) + isDrawn(2) + isDrawn(3) == 3);
        QVERIFY(!isDrawn(1));
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::FramePicturesTest);
#include "tst_framepictures.moc"
