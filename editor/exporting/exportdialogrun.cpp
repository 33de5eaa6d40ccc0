// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Questions before an export, writing it, and what comes after.
#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"
#include "editor/documents/projectpaths.h"
#include "editor/errors/errortext.h"
#include "editor/exporting/exportdialog.h"
#include "editor/exporting/outsideplaces.h"
#include "editor/exporting/picturefields.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/exports/exportclaims.h"
#include "model/project/fields/pictureoptions.h"
#include "widgets/controls/messagestrip.h"

#include <QCheckBox>
#include <QDesktopServices>
#include <QFileInfo>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QUrl>

namespace quadrille {

namespace {

/// Asks one thing; Return and Escape are the safe answer.
bool isAgreed(QWidget* parent, const char* name, const QString& title, const QString& text,
              const QString& more, const QString& agree)
{
    QMessageBox box(QMessageBox::Warning, title, text, QMessageBox::Cancel, parent);
    box.setObjectName(QLatin1String(name));
    box.setInformativeText(more);
    QPushButton* yes = box.addButton(agree, QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == yes;
}

/// The picture with the camera of its first frame, taken from what the view shows.
void placeCamera(ExportEntry& entry, const SeenCamera& seen, const MeshSequence& clip, UpAxis up,
                 const Progress& progress)
{
    ProjectProblems ignored;
    RenderSettings settings = pictureFromJson(entry.picture, "/picture", ignored);
    const MeshSequence film = entry.range ? clip.cutTo(*entry.range) : clip;
    const std::int64_t first = entry.range ? entry.range->first.value : 0;
    settings.view = firstCamera(seen, settings.camera, film, seen.frame.value - first, up, progress);
    entry.picture = pictureToJson(settings);
}

} // namespace

void ExportDialog::reject()
{
    if (m_job)
        hide(); // it comes back with an error, and goes when all is well
    else
        QDialog::reject();
}

void ExportDialog::setBusy(bool busy)
{
    m_strip->clear();
    m_strip->setAction({});
    m_fields->setEnabled(!busy);
    m_export->setEnabled(!busy);
    m_progress->setVisible(busy);
    m_progress->setValue(0);
    m_isDone = false;
    m_cancel->show();
    m_export->setText(busy ? tr("Exporting…") : tr("Export"));
}

bool ExportDialog::mayTakePlaces()
{
    m_replaced.clear();
    const Project& project = m_context.document.project();
    const auto folder = projectFolder(m_context.document.workingFile());
    QStringList taken;
    for (const ExportEntry& entry : m_plan.entries()) {
        QString replaced = m_plan.edited;
        for (const ExportEntry& other : project.exports) {
            const QString name = QString::fromStdString(other.name);
            if (name == m_plan.edited || (!m_plan.isKept && m_plan.edited.isEmpty()) ||
                resolvedPlace(resolvePath(other.path, folder)) !=
                    resolvedPlace(resolvePath(entry.path, folder)))
                continue;
            if (!m_plan.edited.isEmpty()) {
                m_strip->show(widgets::MessageStrip::Kind::Error,
                              tr("The export “%1” of this project writes there.").arg(name),
                              tr("Choose another file."));
                return false;
            }
            replaced = name;
            taken += name;
        }
        m_replaced += replaced;
    }
    return taken.isEmpty() || isAgreed(this, "exportTaken", tr("Replace an export?"),
                                       tr("The export “%1” of this project writes there already.")
                                           .arg(taken.join(QStringLiteral("”, “"))),
                                       tr("This one takes its place in the project."), tr("Replace"));
}

bool ExportDialog::mayReplace(const OutputQuestions& questions)
{
    const auto& files = m_plan.edited.isEmpty() ? questions.existing : questions.foreign;
    if (files.empty())
        return true;
    const QString first = toQString(files.front().filename());
    const auto more = static_cast<int>(files.size()) - 1;
    const QString what = more == 0 ? tr("“%1” is there already.").arg(first)
                                   : tr("“%1” and %n more are there already.", nullptr, more).arg(first);
    const QString whose = questions.foreign.empty()
                              ? tr("An earlier export wrote it.")
                              : tr("It was not written by this project, or was changed since. What is "
                                   "replaced is lost.");
    return isAgreed(this, "exportOverwrite", tr("Write over files?"), what, whose, tr("Write over"));
}

bool ExportDialog::mayWriteOutside(const OutputQuestions& questions)
{
    const QString project = toQString(m_context.document.file());
    const bool isChosenHere = m_plan.entry.path != m_ownPath;
    OutsidePlaces places;
    for (const auto& folder : questions.outside) {
        const QString place = toQString(folder);
        if (project.isEmpty() || places.isAllowed(project, place))
            continue;
        if (!isChosenHere &&
            !isAgreed(this, "exportOutside", tr("Write outside of the project?"),
                      tr("This export writes into %1.").arg(place),
                      tr("That is outside of the project's folder. If the project is not your own, make sure "
                         "that you want it to write there. You are not asked again about this folder."),
                      tr("Write there")))
            return false;
        places.allow(project, place);
    }
    return true;
}

void ExportDialog::start()
{
    readControls();
    setBusy(false);
    if (!mayTakePlaces())
        return;
    setBusy(true);
    const MeshSequence* clip = sequence();
    const bool placesCamera = m_view && m_plan.isPicture() && m_picture->takesView() && clip != nullptr;
    Job* job = m_context.jobs.start(
        {.name = tr("Preparing the export"),
         .receiver = this,
         .failed = [this](const Error& error) { fail(error); },
         .background = true},
        [project = m_context.document.snapshot(), file = m_context.document.workingFile(),
         entries = m_plan.entries(), clip = placesCamera ? std::optional(*clip) : std::nullopt,
         view = m_view](const Progress& progress) {
            Preparation prepared{entries, outputQuestions(project, file, entries, progress)};
            if (clip)
                placeCamera(prepared.entries.front(), *view, *clip, project.settings.axes.up, progress);
            return prepared;
        },
        [this](const Preparation& prepared) {
            if (mayWriteOutside(prepared.questions) && mayReplace(prepared.questions))
                write(prepared);
            else
                setBusy(false);
        });
    follow(job);
}

void ExportDialog::follow(Job* job)
{
    m_job = job;
    connect(job, &Job::changed, this, [this, job] {
        if (m_job == job)
            m_progress->setValue(static_cast<int>(job->fraction() * m_progress->maximum()));
    });
    connect(job, &Job::ended, this, [this, job](Job::State state) {
        if (m_job != job)
            return; // writing went on with another
        m_job = nullptr;
        if (state == Job::State::Cancelled)
            setBusy(false);
        if (!isVisible() && state == Job::State::Cancelled)
            deleteLater();
    });
}

void ExportDialog::write(const Preparation& prepared)
{
    // Others may be worked on meanwhile.
    if (windowModality() != Qt::NonModal) {
        hide();
        setWindowModality(Qt::NonModal);
        show();
    }
    const QString project = toQString(m_context.document.workingFile());
    Job* job = m_context.jobs.start(
        {.name = tr("Exporting %1").arg(toQString(std::filesystem::path(m_plan.entry.path).filename())),
         .receiver = this,
         .failed = [this](const Error& error) { fail(error); }},
        [working = m_context.document.working(), entries = prepared.entries](const Progress& progress) {
            return runExports(working, entries, progress, {.overwrite = true, .outside = true});
        },
        [this, project, entries = prepared.entries](const std::vector<ExportResult>& results) {
            const bool isSame = toQString(m_context.document.workingFile()) == project;
            finish(isSame ? entries : std::vector<ExportEntry>(), results);
        });
    follow(job);
}

void ExportDialog::fail(const Error& error)
{
    m_job = nullptr;
    setBusy(false);
    const ErrorText text = describe(error);
    m_strip->show(widgets::MessageStrip::Kind::Error, text.placed(), text.remedy);
    show();
}

void ExportDialog::keep(const std::vector<ExportEntry>& entries)
{
    const auto hasClip = [this](const std::string& what) {
        const QString clip = QString::fromStdString(what);
        const QString name = clip.section(QLatin1Char('/'), 1, 1);
        const ProjectDocument& document = m_context.document;
        if (clip.startsWith(QLatin1String("sequences/")))
            return document.sequence(name) != nullptr;
        if (clip.startsWith(QLatin1String("animations/")))
            return document.animation(name) != nullptr;
        if (clip.startsWith(QLatin1String("variations/")))
            return document.variation(name) != nullptr;
        return liveOfClip(document.project(), what) != nullptr ||
               transferOfClip(document.project(), what) != nullptr ||
               projectionOfClip(document.project(), what) != nullptr;
    };
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const QString replaced = m_replaced.value(static_cast<qsizetype>(i));
        ExportEntry entry = entries[i];
        if (!replaced.isEmpty() && m_context.document.exportEntry(replaced) != nullptr) {
            entry.name = replaced.toStdString();
            setExport(m_context.document, replaced, entry);
        } else if (m_plan.edited.isEmpty() && m_plan.isKept && hasClip(entry.what)) {
            addExport(m_context.document, std::move(entry));
        }
    }
}

void ExportDialog::finish(const std::vector<ExportEntry>& entries, const std::vector<ExportResult>& results)
{
    m_job = nullptr;
    m_context.media.refresh();
    QStringList files;
    QStringList remarks;
    bool hasWarnings = false;
    for (const ExportResult& result : results) {
        for (const auto& file : result.files)
            files += toQString(file);
        for (const Issue& issue : result.issues) {
            m_context.issues.add(issue, QString::fromStdString(m_plan.entry.name));
            remarks += describe(issue).sentence;
            hasWarnings = hasWarnings || issue.severity == Issue::Severity::Warning;
        }
    }
    keep(entries);
    const bool isWatched = isVisible();
    setBusy(false);
    m_isDone = true;
    m_folder = files.isEmpty() ? QString() : QFileInfo(files.front()).absolutePath();
    const QString first = QFileInfo(files.value(0)).fileName();
    const QString written =
        files.size() == 1
            ? tr("“%1” is written.").arg(first)
            : tr("%n file(s) written, “%1” the first.", nullptr, static_cast<int>(files.size())).arg(first);
    m_strip->show(hasWarnings ? widgets::MessageStrip::Kind::Warning : widgets::MessageStrip::Kind::Info,
                  written, remarks.join(QLatin1Char(' ')));
    m_strip->setAction(tr("Show in folder"));
    m_cancel->hide();
    m_export->setText(tr("Close"));
    m_export->setFocus();
    emit exported(files);
    if (!isWatched)
        deleteLater();
}

void ExportDialog::showInFolder()
{
    if (!m_folder.isEmpty())
        QDesktopServices::openUrl(QUrl::fromLocalFile(m_folder));
}

} // namespace quadrille
