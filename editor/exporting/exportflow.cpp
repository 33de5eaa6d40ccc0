// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/exporting/exportflow.h"

#include "editor/context/editorcontext.h"
#include "editor/documents/projectpaths.h"
#include "editor/exporting/exportdialog.h"

#include <QDir>
#include <QFileInfo>
#include <array>
#include <utility>

namespace quadrille {

ExportFlow::ExportFlow(EditorContext& context, std::function<SceneView*()> view,
                       std::function<QString()> shownClip, QWidget* window)
    : QObject(window)
    , m_context(context)
    , m_view(std::move(view))
    , m_shownClip(std::move(shownClip))
    , m_window(window)
{
    context.actions.add({"file.export",
                         [] { return tr("File"); },
                         [] { return tr("&Export…"); },
                         [] {
                             return tr("Write the selected sequences, animation or variations in another "
                                       "format, or as pictures or video");
                         },
                         "export",
                         {QKeySequence(Qt::CTRL | Qt::Key_E)}},
                        [this] { exportSelection(); });
    connect(&context.selection, &Selection::changed, this, &ExportFlow::updateAction);
    connect(&context.document, &ProjectDocument::changed, this, &ExportFlow::updateAction);
    updateAction();
}

std::optional<SeenCamera> ExportFlow::seen(const QString& name, const MeshSequence& clip) const
{
    SceneView* view = m_view();
    return view == nullptr ? std::nullopt : seenCamera(*view, name, clip);
}

void ExportFlow::updateAction()
{
    const bool isExport = m_context.selection.current().section == Section::Exports &&
                          !m_context.selection.current().name.isEmpty();
    m_context.actions.action("file.export")->setEnabled(isExport || !selectedClips().isEmpty());
}

void ExportFlow::exportSelection()
{
    const EntryRef& current = m_context.selection.current();
    if (current.section == Section::Exports && !current.name.isEmpty()) {
        editExport(current.name);
        return;
    }
    exportClips(selectedClips());
}

QStringList ExportFlow::selectedClips() const
{
    const Selection& selection = m_context.selection;
    const std::array<std::pair<Section, const char*>, 5> made{{{Section::Animations, "animations/"},
                                                               {Section::Lives, "live/"},
                                                               {Section::Variations, "variations/"},
                                                               {Section::Transfers, "transfers/"},
                                                               {Section::Projections, "projections/"}}};
    for (const auto& [section, prefix] : made) {
        if (selection.current().section == section && !selection.current().name.isEmpty())
            return {QLatin1String(prefix) + selection.current().name};
    }
    if (const QString clip = m_shownClip(); !clip.isEmpty())
        return {clip};
    QStringList names = selection.sequences();
    if (names.isEmpty() && !selection.shownSequence().isEmpty())
        names = {selection.shownSequence()};
    for (QString& name : names)
        name.prepend(QStringLiteral("sequences/"));
    const auto& animations = m_context.document.project().animations;
    if (names.isEmpty() && !animations.empty())
        names = {QStringLiteral("animations/") + QString::fromStdString(animations.front().name)};
    return names;
}

void ExportFlow::exportClips(const QStringList& clips)
{
    QString folder = m_folder;
    if (folder.isEmpty()) {
        folder = m_context.document.isUntitled()
                     ? QDir::homePath()
                     : toQString(m_context.document.file().parent_path() / "exports");
    }
    auto* dialog = new ExportDialog(
        m_context, planExport(clips, m_format.toStdString(), folder),
        [this](const QString& name, const MeshSequence& clip) { return seen(name, clip); }, m_window);
    connect(dialog, &ExportDialog::exported, this, [this, dialog](const QStringList& files) {
        m_format = QString::fromStdString(dialog->plan().format().id);
        m_folder = QFileInfo(QString::fromStdString(dialog->plan().entry.path)).path();
        emit exported(files);
    });
    dialog->open();
}

void ExportFlow::editExport(const QString& name)
{
    ExportPlan plan;
    plan.entry = *m_context.document.exportEntry(name);
    plan.edited = name;
    plan.clips = {QString::fromStdString(plan.entry.what)};
    auto* dialog = new ExportDialog(
        m_context, std::move(plan),
        [this](const QString& shown, const MeshSequence& clip) { return seen(shown, clip); }, m_window);
    connect(dialog, &ExportDialog::exported, this, &ExportFlow::exported);
    dialog->open();
}

} // namespace quadrille

#include "moc_exportflow.cpp"
