// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/relinking/relinkflow.h"

#include "editor/context/editorcontext.h"
#include "editor/documents/projectpaths.h"
#include "editor/language/retranslate.h"
#include "editor/relinking/relinkdialog.h"
#include "widgets/controls/messagestrip.h"

#include <QDir>
#include <QGuiApplication>
#include <algorithm>

namespace quadrille {

RelinkFlow::RelinkFlow(EditorContext& context, QWidget* window)
    : QObject(window), m_context(context), m_window(window), m_strip(new widgets::MessageStrip)
{
    m_strip->setObjectName(QStringLiteral("missingStrip"));
    m_timer.setSingleShot(true);
    m_timer.setInterval(100);
    context.actions.add({"file.findMissing",
                         [] { return tr("File"); },
                         [] { return tr("Find &missing files…"); },
                         [] { return tr("Look for files that moved, and relink them"); },
                         "relink",
                         {}},
                        [this] { ask(); });
    connect(m_strip, &widgets::MessageStrip::actionTriggered, this, &RelinkFlow::ask);
    connect(&m_timer, &QTimer::timeout, this, &RelinkFlow::look);
    connect(&context.document, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
        if (event.kind == ChangeEvent::Kind::Reset)
            m_folder.clear();
        if (event.kind != ChangeEvent::Kind::File)
            m_timer.start();
    });
    // Files come back and go while the user is elsewhere.
    connect(qGuiApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (state == Qt::ApplicationActive)
            m_timer.start();
    });
    retranslates(m_strip, [this] { showStrip(); });
}

void RelinkFlow::look()
{
    if (m_looking)
        m_looking->cancel();
    m_looking = m_context.jobs.start(
        {.name = tr("Looking for what is missing"),
         .receiver = this,
         .stillStands = [this] { return !m_timer.isActive(); }, // else it is looked at again
         .failed = [](const Error&) { /* opening the sequences tells it */ },
         .background = true},
        [project = m_context.document.project()](const Progress&) { return missingMedia(project); },
        [this](const std::vector<MediaUse>& missing) { takeMissing(missing); });
}

void RelinkFlow::takeMissing(const std::vector<MediaUse>& missing)
{
    std::set<std::string> paths;
    for (const MediaUse& use : missing)
        paths.insert(use.path);
    const bool cameBack = !std::ranges::includes(paths, m_missing);
    m_missing = std::move(paths);
    showStrip();
    if (!cameBack)
        return;
    for (const SequenceEntry& sequence : m_context.document.project().sequences)
        m_context.media.retry(QString::fromStdString(sequence.name));
}

void RelinkFlow::showStrip()
{
    m_strip->setAction(tr("Find missing files…"));
    if (m_missing.empty()) {
        m_strip->clear();
        return;
    }
    m_strip->show(widgets::MessageStrip::Kind::Warning,
                  tr("%n file(s) of the project are missing. They may have been moved or renamed.", nullptr,
                     static_cast<int>(m_missing.size())));
}

void RelinkFlow::ask()
{
    if (m_folder.isEmpty())
        m_folder = m_context.document.isUntitled() ? QDir::homePath()
                                                   : toQString(m_context.document.file().parent_path());
    auto* dialog = new RelinkDialog(m_context, m_folder, m_window);
    connect(dialog, &RelinkDialog::relinked, this, [this, dialog](int media) {
        m_folder = dialog->folder();
        emit relinked(media);
    });
    dialog->open();
}

void RelinkFlow::noteContents()
{
    if (m_noting)
        m_noting->cancel();
    const std::filesystem::path file = m_context.document.file();
    m_noting = m_context.jobs.start(
        {.name = tr("Noting the contents of files"),
         .receiver = this,
         .failed = [](const Error&) { /* they can still be found by name */ },
         .background = true},
        [project = withRelativePaths(m_context.document.project(), file.parent_path()),
         file](const Progress& progress) { noteMedia(project, file, progress); },
        [] {});
}

} // namespace quadrille

#include "moc_relinkflow.cpp"
