// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/results/resultsflow.h"

#include "editor/context/editorcontext.h"
#include "editor/documents/projectpaths.h"
#include "editor/language/retranslate.h"
#include "model/project/store/resultstore.h"
#include "widgets/controls/messagestrip.h"

#include <QDir>
#include <QFileDialog>
#include <QSettings>
#include <QUrl>
#include <utility>

namespace quadrille {

namespace {

constexpr int lookMilliseconds = 2000;

/// The setting that holds the folder of a project's results, which is of this computer alone.
QString settingOf(const QString& project)
{
    return QStringLiteral("resultFolders/") + QString::fromLatin1(QUrl::toPercentEncoding(project));
}

} // namespace

ResultsFlow::ResultsFlow(EditorContext& context, QWidget* window)
    : QObject(window), m_context(context), m_window(window), m_strip(new widgets::MessageStrip)
{
    m_strip->setObjectName(QStringLiteral("resultsStrip"));
    m_looker.setMaxThreadCount(1);
    context.actions.add({"file.resultFolder",
                         [] { return tr("File"); },
                         [] { return tr("Fo&lder of results…"); },
                         [] { return tr("Choose where the results of this project are stored"); },
                         "folder",
                         {}},
                        [this] { ask(); });
    connect(m_strip, &widgets::MessageStrip::actionTriggered, this, &ResultsFlow::ask);
    connect(&m_timer, &QTimer::timeout, this, &ResultsFlow::look);
    connect(&context.document, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
        if (event.kind == ChangeEvent::Kind::Reset || event.kind == ChangeEvent::Kind::File)
            followFile();
    });
    retranslates(m_strip, [this] { showStrip(); });
    m_timer.start(lookMilliseconds);
}

ResultsFlow::~ResultsFlow()
{
    m_looker.waitForDone();
}

/// Another project has a folder of its own, or none.
void ResultsFlow::followFile()
{
    if (m_context.document.workingFile() == m_seen.project)
        return;
    m_seen = {.project = m_context.document.workingFile(), .places = {}};
    showStrip();
    const QString file = toQString(m_context.document.file());
    const QString folder = QSettings().value(settingOf(file)).toString();
    if (!m_context.document.isUntitled() && !folder.isEmpty())
        chooseResultFolder(m_context.document.file(), toPath(folder));
    look();
}

ResultsFlow::Seen ResultsFlow::lookAt(const std::filesystem::path& project)
{
    Seen seen{.project = project, .places = resultPlaces(project)};
    if (seen.places.isElsewhere || !unstoredResults().empty()) {
        // The cause may be gone.
        recheckResultPlaces(project);
        storeUnstoredResults();
        seen.places = resultPlaces(project);
    }
    seen.unstored = static_cast<int>(unstoredResults().size());
    return seen;
}

void ResultsFlow::look()
{
    if (std::exchange(m_isLooking, true))
        return;
    m_looker.start([this, project = m_context.document.workingFile()] {
        Seen seen;
        try {
            seen = lookAt(project);
        } catch (...) {
            seen = {}; // tried again soon
        }
        QMetaObject::invokeMethod(
            this, [this, seen] { take(seen); }, Qt::QueuedConnection);
    });
}

void ResultsFlow::take(const Seen& seen)
{
    m_isLooking = false;
    if (seen.project != m_context.document.workingFile())
        return;
    m_seen = seen;
    showStrip();
}

void ResultsFlow::showStrip()
{
    using Kind = widgets::MessageStrip::Kind;
    m_strip->setAction(tr("Choose a folder…"));
    if (m_seen.unstored > 0)
        m_strip->show(
            Kind::Warning,
            tr("%n result(s) cannot be stored anywhere and are in memory only.", nullptr, m_seen.unstored),
            tr("Free some space, or choose another folder."));
    else if (m_seen.places.isElsewhere && !m_context.document.isUntitled())
        m_strip->show(
            Kind::Info,
            tr("The results of this project cannot be stored in their folder. They go to %1 until they can.")
                .arg(QDir::toNativeSeparators(toQString(m_seen.places.written))));
    else
        m_strip->clear();
}

void ResultsFlow::ask()
{
    const std::filesystem::path file = m_context.document.workingFile();
    const QString beside = toQString(file.parent_path());
    const QString folder = QFileDialog::getExistingDirectory(m_window, tr("Folder of results"), beside);
    if (folder.isEmpty())
        return;
    // Beside the project is where they go without a choice.
    const bool isBeside = QDir(folder) == QDir(beside);
    const QString chosen = QDir(folder).filePath(toQString(file.filename()) + QStringLiteral(".cache"));
    chooseResultFolder(file, isBeside ? std::filesystem::path() : toPath(chosen));
    if (!m_context.document.isUntitled()) {
        if (isBeside)
            QSettings().remove(settingOf(toQString(file)));
        else
            QSettings().setValue(settingOf(toQString(file)), chosen);
    }
    look();
}

} // namespace quadrille

#include "moc_resultsflow.cpp"
