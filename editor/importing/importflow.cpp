// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/importing/importflow.h"

#include "editor/context/editorcontext.h"
#include "editor/documents/projectpaths.h"
#include "editor/importing/importdialog.h"
#include "editor/importing/importmessages.h"
#include "model/sequence/io/registry.h"

#include <QFileDialog>

namespace quadrille {

namespace {

std::vector<std::filesystem::path> toPaths(const QStringList& paths)
{
    std::vector<std::filesystem::path> result;
    for (const QString& path : paths)
        result.push_back(toPath(QFileInfo(path).absoluteFilePath()));
    return result;
}

QString fileFilter()
{
    QStringList patterns;
    for (const auto& importer : importers()) {
        for (const std::string& extension : importer->format().extensions)
            patterns += QLatin1Char('*') + QString::fromStdString(extension);
    }
    return ImportFlow::tr("Mesh sequences (%1);;All files (*)").arg(patterns.join(QLatin1Char(' ')));
}

/// What opening without a preview found.
struct Survey
{
    std::vector<SurveyedTake> takes;
    std::filesystem::path mesh;
};

} // namespace

ImportFlow::ImportFlow(EditorContext& context, QWidget* window)
    : QObject(window), m_context(context), m_window(window)
{
    const auto file = [] { return tr("File"); };
    context.actions.add({"file.import",
                         file,
                         [] { return tr("&Import sequences…"); },
                         [] { return tr("Look at mesh sequences and add them to the project"); },
                         "import",
                         {QKeySequence(Qt::CTRL | Qt::Key_I)}},
                        [this] { askFiles(); });
    context.actions.add({"file.importFolder",
                         file,
                         [] { return tr("Import a &folder…"); },
                         [] { return tr("Look at all takes of a folder and add them to the project"); },
                         "folder",
                         {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I)}},
                        [this] { askFolder(); });
}

void ImportFlow::askFiles()
{
    const QStringList files =
        QFileDialog::getOpenFileNames(m_window, tr("Import sequences"), m_folder, fileFilter());
    if (!files.isEmpty())
        preview(files);
}

void ImportFlow::askFolder()
{
    const QString folder = QFileDialog::getExistingDirectory(m_window, tr("Import a folder"), m_folder);
    if (!folder.isEmpty())
        preview({folder});
}

void ImportFlow::preview(const QStringList& paths)
{
    m_folder = QFileInfo(paths.front()).absolutePath();
    m_context.jobs.start(
        {.name = tr("Looking for sequences"),
         .receiver = this,
         .failed = [this](const Error& error) { emit failed(error); }},
        [chosen = toPaths(paths)](const Progress&) { return findSources(chosen); },
        [this](FoundSources found) {
            auto* dialog = new ImportDialog(m_context, std::move(found), m_window);
            connect(dialog, &ImportDialog::imported, this, &ImportFlow::imported);
            dialog->open();
        });
}

void ImportFlow::open(const QStringList& paths)
{
    m_context.jobs.start(
        {.name = tr("Opening %n file(s)", nullptr, static_cast<int>(paths.size())),
         .receiver = this,
         .failed = [this](const Error& error) { emit failed(error); }},
        [chosen = toPaths(paths),
         options = surveyOptions({}, m_context.document.project())](const Progress& progress) {
            const FoundSources found = findSources(chosen);
            SurveyOptions own = options;
            own.mesh = found.mesh;
            return Survey{surveySources(found.sources, own, progress), found.mesh};
        },
        [this](Survey survey) {
            const ImportPlan plan =
                planFor(std::move(survey.takes), survey.mesh, m_context.document.project());
            for (const PlannedTake& planned : plan.takes) {
                if (planned.take.error)
                    emit failed(*planned.take.error);
                const QString name = QString::fromStdString(planned.name);
                for (const Issue& issue : planned.take.issues) {
                    if (issue.code != Issue::Code::FpsAssumed)
                        m_context.issues.add(issue, name);
                }
                if (const auto rate = rateIssue(planned))
                    m_context.issues.add(*rate, name);
            }
            if (!plan.wanted().empty())
                emit imported(carryOut(plan, m_context.document));
        });
}

} // namespace quadrille

#include "moc_importflow.cpp"
