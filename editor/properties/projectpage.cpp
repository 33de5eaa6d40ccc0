// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/projectpage.h"

#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"
#include "editor/documents/projectpaths.h"
#include "editor/fields/axesfields.h"
#include "editor/fields/numberfield.h"

#include <QDoubleSpinBox>

namespace quadrille {

ProjectPage::ProjectPage(EditorContext& context)
    : m_context(context), m_fps(makeRateField()), m_axes(new AxesFields), m_cache(new QSpinBox)
{
    m_cache->setRange(16, 1 << 20);
    m_cache->setSingleStep(64);
    m_cache->setKeyboardTracking(false);
    addField(
        "projectFps", [] { return tr("Rate"); }, m_fps,
        [] {
            return tr("Frames a second at which everything runs; sequences with another rate are resampled");
        });
    addField(
        "projectAxes", [] { return tr("Axes"); }, m_axes,
        [] { return tr("Up axis and unit that all sequences are converted to"); });
    addField(
        "projectCache", [] { return tr("Cache"); }, m_cache,
        [] { return tr("Memory for frames and textures of this project"); });
    m_content = addFact("projectContent", [] { return tr("Holds"); });
    m_file = addFact("projectFile", [] { return tr("File"); });
    connect(m_fps, &QDoubleSpinBox::valueChanged, this,
            [this](double fps) { edit([&](ProjectSettings& settings) { settings.fps = fps; }); });
    connect(m_axes, &AxesFields::edited, this,
            [this] { edit([&](ProjectSettings& settings) { settings.axes = m_axes->axes(); }); });
    connect(m_cache, &QSpinBox::valueChanged, this, [this](int megabytes) {
        edit([&](ProjectSettings& settings) { settings.cacheMegabytes = megabytes; });
    });
    retranslate();
}

void ProjectPage::show(const QString& /*name*/)
{
    const Project& project = m_context.document.project();
    const QSignalBlocker blocks[] = {QSignalBlocker(m_fps), QSignalBlocker(m_cache)};
    m_fps->setValue(project.settings.fps);
    m_axes->setAxes(project.settings.axes);
    m_cache->setValue(static_cast<int>(project.settings.cacheMegabytes));
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
    m_fps->setSuffix(tr(" fps"));
    m_cache->setSuffix(tr(" MB"));
}

} // namespace quadrille
