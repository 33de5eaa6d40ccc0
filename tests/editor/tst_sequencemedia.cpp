// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/projectedits.h"
#include "editor/documents/sequencemedia.h"
#include "editor/jobs/jobrunner.h"
#include "editortest.h"
#include "model/project/results/rebuild.h"
#include "tests/qt/registry.h"

#include <numeric>

namespace quadrille {

/// Sequences that show clips of others and of animations.
class SequenceMediaTest : public QObject
{
    Q_OBJECT

private:
    /// A walk of 16 frames, the animation “stroll” of eight of them, and a sequence of the same name that
    /// shows it.
    Project project() const
    {
        Project project;
        project.settings.fps = 12;
        project.sequences.resize(3);
        project.sequences[0].name = "walk";
        project.sequences[0].source = m_folder->filePath(QStringLiteral("walk_*.obj")).toStdString();
        project.sequences[1].name = "stroll";
        project.sequences[1].source = "clip:animations/stroll";
        project.sequences[2].name = "part";
        project.sequences[2].source = "clip:sequences/stroll";
        project.sequences[2].range = FrameRange{FrameIndex(2), FrameIndex(4)};
        AnimationEntry stroll;
        stroll.name = "stroll";
        stroll.walk = WalkEntry{.spans = {{"walk", {FrameIndex(4), FrameIndex(11)}}}};
        project.animations = {stroll};
        return project;
    }
    void compute() const
    {
        const auto report = rebuild(m_document->project(), m_document->file(), {.targets = {"animations"}});
        for (const StepReport& step : report.steps)
            QVERIFY2(!step.error, step.error ? step.error->what() : "");
    }
    ResultPhase state(const char* name) const { return m_media->resultState(QLatin1String(name))->phase; }
    std::int64_t frames(const char* name) const
    {
        const MeshSequence* sequence = m_media->sequence(QLatin1String(name));
        return sequence == nullptr ? -1 : sequence->frameCount();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<JobRunner> m_jobs;
    std::unique_ptr<ProjectDocument> m_document;
    std::unique_ptr<SequenceMedia> m_media;

private slots:
    void initTestCase() { test::isolate(); }
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QList<int> numbers(16);
        std::iota(numbers.begin(), numbers.end(), 1);
        test::writeSeries(m_folder->path(), numbers);
        m_jobs = std::make_unique<JobRunner>();
        m_document = std::make_unique<ProjectDocument>();
        m_media = std::make_unique<SequenceMedia>(*m_document, *m_jobs);
        m_document->reset(project());
    }
    void cleanup()
    {
        m_media.reset();
        m_document.reset();
        m_jobs.reset();
    }

    void aClipThatIsNotComputedSaysSo()
    {
        QTRY_COMPARE(state("stroll"), ResultPhase::Failed);
        QVERIFY(QString(m_media->resultState(QStringLiteral("stroll"))->error->what())
                    .contains(QStringLiteral("not computed yet")));
        QTRY_COMPARE(state("part"), ResultPhase::Failed);
        QTRY_COMPARE(frames("walk"), 16);
    }

    void aComputedClipIsShownAndFollowsWhatIsComputed()
    {
        m_document->saveAs(m_folder->filePath(QStringLiteral("p.quadrille")).toStdString());
        QTRY_COMPARE(state("stroll"), ResultPhase::Failed);
        compute();
        m_media->refresh();
        QTRY_COMPARE(frames("stroll"), 8);
        QTRY_COMPARE(frames("part"), 3);

        Project longer = m_document->project();
        longer.animations[0].walk->spans[0].frames.last = FrameIndex(14);
        m_document->recover(longer, m_document->file());
        QTRY_COMPARE(frames("stroll"), 8); // as it was computed
        compute();
        m_media->refresh();
        QTRY_COMPARE(frames("stroll"), 11);
    }

    void nothingIsOpenedAgainWithoutNeed()
    {
        m_document->saveAs(m_folder->filePath(QStringLiteral("p.quadrille")).toStdString());
        compute();
        m_media->refresh();
        QTRY_COMPARE(frames("stroll"), 8);
        ExportEntry entry;
        entry.name = "e";
        entry.path = "e.ply";
        addExport(*m_document, entry);
        m_document->save();
        m_media->refresh();
        QCOMPARE(frames("stroll"), 8);
        setSequenceContacts(*m_document, QStringLiteral("part"), {});
        QCOMPARE(frames("stroll"), 8);
    }

    void aCircleOfClipsFailsAndLeavesTheProgramAlive()
    {
        Project circle = project();
        circle.sequences[1].source = "clip:sequences/part";
        m_document->reset(circle);
        QTRY_COMPARE(frames("walk"), 16);
        QTRY_COMPARE(state("stroll"), ResultPhase::Failed);
        QTRY_COMPARE(state("part"), ResultPhase::Failed);
    }

    void canBeOpenedAgainAfterItWasStopped()
    {
        QTRY_COMPARE(state("walk"), ResultPhase::Ready);
        Project project = m_document->project();
        project.settings.axes.up = UpAxis::Z; // all are opened anew
        m_document->reset(project);
        m_jobs->cancelAll();
        QTRY_COMPARE(state("walk"), ResultPhase::Failed);
        QCOMPARE(m_media->resultState("walk")->error->code(), ErrorCode::Cancelled);
        QVERIFY(m_media->sequence("walk") == nullptr);
        m_media->retry("walk");
        QTRY_COMPARE(state("walk"), ResultPhase::Ready);
        QVERIFY(!m_media->resultState("walk")->error);
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::SequenceMediaTest);
#include "tst_sequencemedia.moc"
