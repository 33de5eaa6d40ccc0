// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/projectpage.h"

#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"
#include "editor/documents/projectpaths.h"
#include "editor/fields/axesfields.h"

namespace quadrille {

ProjectPage::ProjectPage(EditorContext& context)
    : m_context(context)
    , m_fields(*this, [this](const QString& /*text*/, const char* /*property*/, const auto& change) {
        edit(change);
    })
{
    m_fields.addNumber(
        {"projectFps", [] { return tr("Rate"); },
         [] {
             return tr("Frames a second at which everything runs; sequences with another rate are resampled");
         }},
        &ProjectSettings::fps, rateLook("settings.fps"));
    auto* axes = new AxesFields;
    connect(axes, &AxesFields::edited, this,
            [this, axes] { edit([axes](ProjectSettings& settings) { settings.axes = axes->axes(); }); });
    m_fields.addOther({"projectAxes", [] { return tr("Axes"); },
                       [] { return tr("Up axis and unit that all sequences are converted to"); }},
                      axes, [axes](const ProjectSettings& settings) { axes->setAxes(settings.axes); });
    m_fields.addNumber(
        {"projectCache", [] { return tr("Cache"); },
         [] { return tr("Memory for frames and textures of this project"); }},
        &ProjectSettings::cacheMegabytes,
        {.path = "settings.cache_megabytes", .step = 64, .decimals = 0, .unit = [] { return tr(" MB"); }});
    m_content = addFact("projectContent", [] { return tr("Holds"); });
    m_file = addFact("projectFile", [] { return tr("File"); });
    m_fields.retranslate();
}

void ProjectPage::show(const QString& /*name*/)
{
    const Project& project = m_context.document.project();
    m_fields.show(project.settings);
    const QStringList parts{tr("%n characters", nullptr, static_cast<int>(project.characters.size())),
                            tr("%n sequences", nullptr, static_cast<int>(project.sequences.size())),
                            tr("%n exports", nullptr, static_cast<int>(project.exports.size()))};
    m_content->setText(parts.join(QStringLiteral(" · ")));
    m_file->setText(m_context.document.isUntitled() ? tr("not saved yet")
                                                    : toQString(m_context.document.file()));
}

/// Others of the settings stay as they are, be they beyond what a field shows.
void ProjectPage::edit(const std::function<void(ProjectSettings&)>& change)
{
    ProjectSettings settings = m_context.document.project().settings;
    change(settings);
    setSettings(m_context.document, settings);
}

void ProjectPage::retranslate()
{
    m_fields.retranslate();
}

} // namespace quadrille

#include "moc_projectpage.cpp"
