// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/relinking/relinkdialog.h"

#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"
#include "editor/documents/projectpaths.h"
#include "editor/errors/errortext.h"
#include "editor/language/retranslate.h"
#include "editor/relinking/lostmediatable.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/theme/icons.h"

#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace quadrille {

RelinkDialog::RelinkDialog(EditorContext& context, const QString& folder, QWidget* parent)
    : QDialog(parent)
    , m_context(context)
    , m_summary(new QLabel)
    , m_folderLabel(new QLabel)
    , m_folder(new QLineEdit(QDir::toNativeSeparators(folder)))
    , m_chooseFolder(new QToolButton)
    , m_search(new QPushButton)
    , m_progress(new QProgressBar)
    , m_pages(new QStackedWidget)
    , m_table(new LostMediaTable)
    , m_empty(new QLabel)
    , m_note(new QLabel)
    , m_strip(new widgets::MessageStrip)
    , m_byHand(new QPushButton)
    , m_cancel(new QPushButton)
    , m_apply(new QPushButton)
{
    setObjectName(QStringLiteral("relinkDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(960, 520);
    makeControls();
    connectAll();
    retranslates(this, [this] { retranslate(); });
    survey();
}

RelinkDialog::~RelinkDialog() = default;

void RelinkDialog::makeControls()
{
    const auto name = [](QWidget* widget, const char* text) { widget->setObjectName(QLatin1String(text)); };
    name(m_summary, "relinkSummary");
    name(m_folder, "relinkFolder");
    name(m_chooseFolder, "relinkChooseFolder");
    name(m_search, "relinkSearch");
    name(m_progress, "relinkProgress");
    name(m_empty, "relinkEmpty");
    name(m_note, "relinkNote");
    name(m_byHand, "relinkByHand");
    name(m_cancel, "relinkCancel");
    name(m_apply, "relinkAccept");
    m_folderLabel->setBuddy(m_folder);
    m_chooseFolder->setIcon(widgets::icons::icon(QStringLiteral("folder")));
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(4);
    QSizePolicy keepsItsPlace = m_progress->sizePolicy();
    keepsItsPlace.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(keepsItsPlace);
    m_progress->hide();
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_note->setWordWrap(true);
    m_note->setForegroundRole(QPalette::PlaceholderText);
    m_pages->addWidget(m_empty);
    m_pages->addWidget(m_table);

    auto* where = new QHBoxLayout;
    where->setSpacing(8);
    where->addWidget(m_folderLabel);
    where->addWidget(m_folder, 1);
    where->addWidget(m_chooseFolder);
    where->addWidget(m_search);
    auto* middle = new QVBoxLayout;
    middle->setSpacing(4);
    middle->addWidget(m_progress);
    middle->addWidget(m_pages, 1);
    auto* about = new QHBoxLayout;
    about->setSpacing(16);
    about->addWidget(m_note, 1);
    about->addWidget(m_byHand, 0, Qt::AlignTop);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch();
    buttons->addWidget(m_cancel);
    buttons->addWidget(m_apply);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    column->addWidget(m_summary);
    column->addLayout(where);
    column->addWidget(m_strip);
    column->addLayout(middle, 1);
    column->addLayout(about);
    column->addLayout(buttons);
}

void RelinkDialog::connectAll()
{
    connect(m_folder, &QLineEdit::textEdited, this, [this] {
        m_hasSearched = false;
        showButtons();
    });
    connect(m_chooseFolder, &QToolButton::clicked, this, &RelinkDialog::chooseFolder);
    connect(m_search, &QPushButton::clicked, this, [this] {
        if (isBusy())
            m_job->cancel();
        else
            search();
    });
    connect(m_table, &QTreeWidget::currentItemChanged, this, &RelinkDialog::showMedium);
    connect(m_table, &QTreeWidget::itemDoubleClicked, this, &RelinkDialog::chooseByHand);
    connect(m_table, &LostMediaTable::ticked, this, [this] {
        for (std::size_t i = 0; i < m_plan.media.size(); ++i)
            m_plan.media[i].isWanted = m_table->isWanted(static_cast<int>(i));
        showButtons();
    });
    connect(m_byHand, &QPushButton::clicked, this, &RelinkDialog::chooseByHand);
    connect(m_cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_apply, &QPushButton::clicked, this, &RelinkDialog::apply);
}

QString RelinkDialog::folder() const
{
    return QDir::fromNativeSeparators(m_folder->text());
}

void RelinkDialog::survey()
{
    follow(m_context.jobs.start(
        {.name = tr("Looking for what is missing"),
         .receiver = this,
         .failed = [this](const Error& error) { fail(error); }},
        [project = m_context.document.project(), file = m_context.document.file()](const Progress&) {
            return planRelinking(project, file);
        },
        [this](RelinkPlan plan) { takeSurvey(std::move(plan)); }));
}

void RelinkDialog::takeSurvey(RelinkPlan plan)
{
    m_plan = std::move(plan);
    m_isSurveyed = true;
    m_focus = m_folder;
    finish();
    // The row of what is selected in the window is what the user came for.
    const QString selected = m_context.selection.current().name;
    for (std::size_t i = 0; i < m_plan.media.size(); ++i) {
        const auto& uses = m_plan.media[i].uses;
        if (std::ranges::any_of(uses, [&](const MediaUse& use) {
                return QString::fromStdString(use.owner).section(QLatin1Char('/'), 1) == selected;
            })) {
            m_table->selectMedium(static_cast<int>(i));
            break;
        }
    }
    m_folder->selectAll();
}

void RelinkDialog::chooseFolder()
{
    const QString chosen = QFileDialog::getExistingDirectory(this, tr("Folder to search"), folder());
    if (chosen.isEmpty())
        return;
    m_folder->setText(QDir::toNativeSeparators(chosen));
    search();
}

void RelinkDialog::search()
{
    m_strip->clear();
    m_hasSearched = true;
    follow(m_context.jobs.start(
        {.name = tr("Searching “%1”").arg(m_folder->text()),
         .receiver = this,
         .failed = [this](const Error& error) { fail(error); }},
        [search = m_plan.searchIn(toPath(QDir(folder()).absolutePath()))](const Progress& progress) {
            return findMedia(search, progress);
        },
        [this](const std::vector<FoundMedium>& found) { takeFound(found); }));
}

void RelinkDialog::takeFound(const std::vector<FoundMedium>& found)
{
    m_plan.take(found);
    const bool isVain =
        std::ranges::all_of(found, [](const FoundMedium& each) { return each.match == MediaMatch::Missing; });
    if (isVain) {
        m_strip->show(widgets::MessageStrip::Kind::Info,
                      tr("None of the missing files is in “%1”.").arg(m_folder->text()),
                      tr("Search another folder, or choose one file by hand."));
    }
    finish();
}

void RelinkDialog::chooseByHand()
{
    const int row = m_table->currentMedium();
    if (row < 0 || isBusy())
        return;
    const auto medium = static_cast<std::size_t>(row);
    const LostMedium& lost = m_plan.media[medium];
    const auto old = std::filesystem::path(lost.path);
    const QString title = tr("Where is “%1”?").arg(toQString(old.filename()));
    const QString start = lost.isFound() ? toQString(lost.found.file.parent_path()) : folder();
    const QString chosen =
        lost.isFolder() ? QFileDialog::getExistingDirectory(this, title, start)
                        : QFileDialog::getOpenFileName(
                              this, title, start,
                              tr("Files of this kind (*%1);;All files (*)").arg(toQString(old.extension())));
    if (chosen.isEmpty())
        return;
    m_strip->clear();
    follow(m_context.jobs.start(
        {.name = tr("Comparing “%1”").arg(QFileInfo(chosen).fileName()),
         .receiver = this,
         .failed = [this](const Error& error) { fail(error); }},
        [plan = m_plan, medium, file = toPath(chosen)](const Progress& progress) {
            return examineChoice(plan, medium, file, progress);
        },
        [this, medium](const ChosenMedium& choice) { takeChoice(medium, choice); }));
}

void RelinkDialog::takeChoice(std::size_t medium, const ChosenMedium& choice)
{
    m_plan.takeByHand(medium, choice.chosen);
    const std::size_t before = m_plan.foundCount();
    m_plan.take(choice.others);
    if (const std::size_t more = m_plan.foundCount() - before; more > 0) {
        m_strip->show(widgets::MessageStrip::Kind::Info,
                      tr("%n more were found from there.", nullptr, static_cast<int>(more)));
    }
    finish();
}

/// Shows how far a job is, and lets it be stopped.
void RelinkDialog::follow(Job* job)
{
    m_job = job;
    m_focus = focusWidget();
    m_progress->setRange(0, 0);
    connect(job, &Job::changed, this, [this, job] {
        if (job->fraction() > 0) {
            m_progress->setRange(0, 100);
            m_progress->setValue(static_cast<int>(100 * job->fraction()));
        }
    });
    connect(job, &Job::ended, this, [this, job] {
        if (m_job != job)
            return; // its result was shown
        finish();
        if (!m_isSurveyed)
            reject();
    });
    showPlan();
}

/// A job is over: shows what it brought and gives the keyboard back to where it was.
void RelinkDialog::finish()
{
    m_job.clear();
    showPlan();
    if (m_focus)
        m_focus->setFocus();
}

void RelinkDialog::fail(const Error& error)
{
    m_hasSearched = false;
    const ErrorText text = describe(error);
    const QString file = toQString(error.context().file);
    m_strip->show(widgets::MessageStrip::Kind::Error,
                  file.isEmpty() ? text.sentence : tr("%1 (%2)").arg(text.sentence, file),
                  tr("Choose another folder."));
}

void RelinkDialog::showPlan()
{
    const bool isEmpty = m_plan.media.empty();
    m_table->setPlan(m_plan);
    m_pages->setCurrentWidget(isEmpty ? static_cast<QWidget*>(m_empty) : m_table);
    m_empty->setText(m_isSurveyed ? tr("Nothing is missing: all files are where the project says.")
                                  : tr("Looking for what is missing…"));
    const auto lost = static_cast<int>(m_plan.media.size());
    const auto found = static_cast<int>(m_plan.foundCount());
    m_summary->setVisible(!isEmpty);
    if (found == 0)
        m_summary->setText(
            tr("%n file(s) are not where the project says. Search the folder where they are now.", nullptr,
               lost));
    else
        m_summary->setText(
            tr("%1 of %n missing file(s) were found. The project changes only when you apply this.", nullptr,
               lost)
                .arg(found));
    showMedium();
    showButtons();
}

void RelinkDialog::showButtons()
{
    const auto wanted = static_cast<int>(m_plan.newPaths().size());
    const bool isIdle = !isBusy();
    const bool canSearch = !m_plan.media.empty() && !m_folder->text().trimmed().isEmpty();
    for (QWidget* widget : std::initializer_list<QWidget*>{m_folder, m_chooseFolder})
        widget->setEnabled(isIdle && !m_plan.media.empty());
    m_search->setEnabled(!isIdle || canSearch);
    m_search->setText(isIdle ? tr("&Search") : tr("&Stop"));
    m_progress->setVisible(!isIdle);
    m_byHand->setEnabled(isIdle && !m_plan.media.empty());
    m_apply->setEnabled(isIdle && wanted > 0);
    m_apply->setText(wanted > 0 ? tr("Relink %n file(s)", nullptr, wanted) : tr("Relink"));
    (wanted > 0 && m_hasSearched ? m_apply : m_search)->setDefault(true);
}

void RelinkDialog::showMedium()
{
    const int row = m_table->currentMedium();
    m_note->setText(row < 0 ? QString()
                            : LostMediaTable::explanationOf(m_plan.media[static_cast<std::size_t>(row)]));
}

void RelinkDialog::apply()
{
    const auto paths = m_plan.newPaths();
    relinkMedia(m_context.document, paths);
    emit relinked(static_cast<int>(paths.size()));
    accept();
}

void RelinkDialog::retranslate()
{
    setWindowTitle(tr("Find missing files"));
    m_table->retranslate();
    m_folderLabel->setText(tr("Search &in"));
    m_folder->setAccessibleName(tr("Folder to search"));
    m_folder->setToolTip(tr("This folder is searched, and all folders in it"));
    m_chooseFolder->setToolTip(tr("Choose the folder and search it"));
    m_chooseFolder->setAccessibleName(tr("Choose the folder and search it"));
    m_search->setToolTip(tr("Look for the missing files by name and by content"));
    m_progress->setAccessibleName(tr("Progress of the search"));
    m_byHand->setText(tr("Choose by &hand…"));
    m_byHand->setToolTip(tr("Say where the file of this row is; others are looked for from there"));
    m_apply->setToolTip(tr("Use the files that are ticked; one step for undo"));
    m_cancel->setText(tr("Cancel"));
    showPlan();
}

} // namespace quadrille

#include "moc_relinkdialog.cpp"
