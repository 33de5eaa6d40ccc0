// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/projectionpage.h"

#include "editor/commands/projectedits.h"
#include "editor/commands/projectionedits.h"
#include "editor/context/editorcontext.h"
#include "editor/documents/projectpaths.h"
#include "editor/fields/clipchoice.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/results/projectresults.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QPushButton>

namespace quadrille {

namespace {

/// What cameras may have seen: takes and transfers.
std::vector<FieldItem<std::string>> seenClips(const Project& project, const ProjectionEntry& entry)
{
    std::vector<std::string> clips;
    for (const SequenceEntry& each : project.sequences)
        clips.push_back("sequences/" + each.name);
    for (const TransferEntry& each : project.transfers)
        clips.push_back("transfers/" + each.name);
    if (std::ranges::find(clips, entry.clip) == clips.end())
        clips.push_back(entry.clip);
    std::vector<FieldItem<std::string>> items;
    items.reserve(clips.size());
    for (const std::string& clip : clips)
        items.push_back({nameOfClip(QString::fromStdString(clip)), clip});
    return items;
}

} // namespace

ProjectionPage::ProjectionPage(EditorContext& context)
    : m_context(context)
    , m_nameField(new QLineEdit)
    , m_cameras(new QPushButton)
    , m_compute(new QPushButton)
    , m_add(new QPushButton)
    , m_form(new SettingForm)
    , m_fields(*m_form, [this](const QString& text, const char* property, const auto& change) {
        edit(text, property, change);
    })
{
    addField(
        "projectionName", [] { return tr("Name"); }, m_nameField, [] { return tr("Unique in the project"); });
    addField(
        "projectionCameras", [] { return tr("Cameras"); }, m_cameras,
        [] {
            return tr("The table of calibrated cameras and their pictures, JSON; a click chooses another");
        });
    addFields();
    addWide("projectionSettings", m_form);
    addWide("projectionCompute", m_compute);
    addWide("projectionAdd", m_add);
    connect(m_nameField, &QLineEdit::editingFinished, this, [this] {
        renameEntry(m_context.document, {Section::Projections, m_name}, m_nameField->text());
    });
    connect(m_cameras, &QPushButton::clicked, this, &ProjectionPage::chooseCameras);
    connect(m_compute, &QPushButton::clicked, this, &ProjectionPage::compute);
    connect(m_add, &QPushButton::clicked, this, &ProjectionPage::addSequence);
    retranslate();
}

void ProjectionPage::addFields()
{
    m_fields.addItems(
        {"projectionClip", [] { return tr("Clip"); },
         [] { return tr("What the cameras saw, frame by frame: a take or a transferred clip"); }},
        &ProjectionEntry::clip,
        [this](const ProjectionEntry& entry) { return seenClips(m_context.document.project(), entry); });
    m_fields.addNumber({"projectionSize", [] { return tr("Size"); },
                        [] {
                            return tr("Side of the textures, texels; where texels are smaller than the "
                                      "pictures’ pixels, textures get soft");
                        }},
                       &ProjectionEntry::size, {.path = "projection.size", .step = 256, .decimals = 0});
    m_fields.addNumber(
        {"projectionSharpness", [] { return tr("Sharpness"); },
         [] {
             return tr("How much more cameras count that see a surface from the front; 0 takes "
                       "all alike");
         }},
        &ProjectionEntry::sharpness, {.path = "projection.sharpness", .step = 0.5, .decimals = 1});
    m_fields.addSwitch({"projectionFills", [] { return tr("Fill what no camera sees"); },
                        [] {
                            return tr("From other frames, and else from what is beside it; otherwise it is "
                                      "black");
                        }},
                       &ProjectionEntry::fills);
}

void ProjectionPage::edit(const QString& text, const char* property,
                          const std::function<void(ProjectionEntry&)>& change)
{
    ProjectionEntry after = *findProjection(m_context.document.project(), m_name.toStdString());
    change(after);
    setProjection(m_context.document, m_name, text, QLatin1String(property), std::move(after));
}

void ProjectionPage::chooseCameras()
{
    const ProjectionEntry& entry = *findProjection(m_context.document.project(), m_name.toStdString());
    const QString file = QFileDialog::getOpenFileName(
        this, tr("Choose a table of cameras"), QString::fromStdString(entry.cameras), tr("Cameras (*.json)"));
    if (!file.isEmpty())
        edit(tr("Choose cameras"), "cameras",
             [&](ProjectionEntry& changed) { changed.cameras = toPath(file).generic_string(); });
}

/// Textures are computed when somebody asks: that takes about a second for each frame.
void ProjectionPage::compute()
{
    const std::string step = clipStepOf("projections/" + m_name.toStdString());
    m_job = m_context.jobs.start(
        {.name = tr("3D video “%1”").arg(m_name), .receiver = this},
        [working = m_context.document.working(), step](const Progress& progress) {
            ProjectResults(working).get({step}, progress);
        },
        [this] { m_context.media.refresh(); });
}

void ProjectionPage::addSequence()
{
    const ProjectionEntry& entry = *findProjection(m_context.document.project(), m_name.toStdString());
    SequenceEntry sequence;
    sequence.name = m_name.toStdString();
    sequence.source = "clip:projections/" + m_name.toStdString();
    sequence.character = characterOfClip(m_context.document.project(), entry.clip);
    std::vector<SequenceEntry> added;
    added.push_back(std::move(sequence));
    addSequences(m_context.document, std::move(added));
    compute();
}

void ProjectionPage::retranslate()
{
    m_fields.retranslate();
    m_compute->setText(tr("Compute the textures"));
    m_add->setText(tr("Add as a take"));
    m_add->setToolTip(tr("Computes the textures and adds the clip that wears them to the takes"));
}

void ProjectionPage::show(const QString& name)
{
    m_name = name;
    const ProjectionEntry& entry = *findProjection(m_context.document.project(), name.toStdString());
    showName(*m_nameField, name);
    const QString cameras = QString::fromStdString(entry.cameras);
    m_cameras->setText(QFileInfo(cameras).fileName());
    m_cameras->setToolTip(cameras);
    m_fields.show(entry);
}

} // namespace quadrille

#include "moc_projectionpage.cpp"
