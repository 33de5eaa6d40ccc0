// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/exporting/pictureflow.h"

#include "editor/context/editorcontext.h"
#include "editor/documents/projectpaths.h"
#include "editor/pictures/pictures.h"
#include "model/core/stagedfiles.h"
#include "model/project/media/projectguard.h"
#include "widgets/viewport/viewport.h"

#include <QClipboard>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>

namespace quadrille {

PictureFlow::PictureFlow(EditorContext& context, ViewportInFront viewport, QWidget* window)
    : QObject(window), m_context(context), m_viewport(std::move(viewport)), m_window(window)
{
    const auto view = [] { return tr("View"); };
    context.actions.add({"view.copy",
                         view,
                         [] { return tr("Copy the &picture"); },
                         [] { return tr("Puts the view as it is now onto the clipboard"); },
                         "copy",
                         {Qt::CTRL | Qt::SHIFT | Qt::Key_C}},
                        [this] { copy(); });
    context.actions.add({"view.savePicture",
                         view,
                         [] { return tr("Save the pict&ure…"); },
                         [] { return tr("Writes the view as it is now into a picture file"); },
                         "snapshot",
                         {Qt::Key_F12}},
                        [this] { askAndSave(); });
}

void PictureFlow::copy()
{
    QGuiApplication::clipboard()->setImage(picture());
}

QImage PictureFlow::picture() const
{
    widgets::Viewport* viewport = m_viewport();
    return viewport == nullptr ? QImage() : viewport->snapshot();
}

void PictureFlow::askAndSave()
{
    const QString folder = m_folder.isEmpty() ? QDir::homePath() : m_folder;
    const QString name = m_context.selection.shownSequence();
    QString file = QFileDialog::getSaveFileName(
        m_window, tr("Save the picture"),
        QDir(folder).filePath((name.isEmpty() ? m_context.document.title() : name) + QStringLiteral(".png")),
        tr("Pictures (*.png *.jpg *.jpeg *.tif *.tiff)"));
    if (file.isEmpty())
        return;
    if (QFileInfo(file).suffix().isEmpty())
        file += QStringLiteral(".png");
    m_folder = QFileInfo(file).path();
    save(file);
}

void PictureFlow::save(const QString& file)
{
    m_context.jobs.start(
        {.name = tr("Saving %1").arg(QFileInfo(file).fileName()), .receiver = this},
        [picture = picture(), path = toPath(file), project = m_context.document.snapshot(),
         projectFile = m_context.document.workingFile()](const Progress&) {
            // Whether a file may be replaced was asked where its name was chosen.
            const auto guard = projectGuard(project, projectFile, {.overwrite = true, .outside = true});
            const WrittenNote note(*guard, projectFile);
            const auto write = [&](const std::filesystem::path& to) { writeImage(toImage(picture), to); };
            writeGuarded(path, write, guard.get());
        },
        [this, file] { emit saved({file}); });
}

} // namespace quadrille

#include "moc_pictureflow.cpp"
