// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What an export dialog knows of its clips, and how it says it.
#include "editor/context/editorcontext.h"
#include "editor/documents/transferresults.h"
#include "editor/exporting/exportdialog.h"
#include "editor/exporting/picturefields.h"
#include "editor/fields/axesfields.h"
#include "editor/fields/clipchoice.h"
#include "editor/pictures/takepreview.h"
#include "model/project/document/findentry.h"
#include "model/project/results/openanimation.h"
#include "model/project/steps/livework.h"
#include "widgets/controls/messagestrip.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <algorithm>

namespace quadrille {

bool ExportDialog::isDataSet() const
{
    return m_plan.clips.front().startsWith(QLatin1String("variations/"));
}

bool ExportDialog::isLive() const
{
    return std::ranges::all_of(m_plan.clips,
                               [](const QString& clip) { return clip.startsWith(QLatin1String("live/")); });
}

const MeshSequence* ExportDialog::sequence() const
{
    const QString& clip = m_plan.clips.front();
    if (clip.startsWith(QLatin1String("sequences/")))
        return m_context.media.sequence(nameOfClip(clip));
    if (isDataSet())
        return m_context.variations.clip(nameOfClip(clip), 1);
    if (clip.startsWith(QLatin1String("transfers/"))) {
        const TransferResults::State* state = m_context.transfers.resultState(nameOfClip(clip));
        return state != nullptr && state->result ? &state->result->sequence : nullptr;
    }
    if (!clip.startsWith(QLatin1String("animations/")))
        return nullptr;
    const auto result = m_context.animations.result(nameOfClip(clip));
    return result && result->isFinal ? &result->sequence : nullptr;
}

std::optional<std::int64_t> ExportDialog::framesWritten() const
{
    const std::int64_t all = frameCount();
    if (all == 0)
        return std::nullopt;
    const std::int64_t frames = m_plan.entry.range ? m_plan.entry.range->count() : all;
    const MeshSequence* shown = sequence();
    const double fps = shown == nullptr ? m_context.document.project().settings.fps : shown->fps;
    return m_plan.entry.fps ? resampledFrames(frames, fps, *m_plan.entry.fps) : frames;
}

std::int64_t ExportDialog::frameCount() const
{
    if (const MeshSequence* shown = sequence())
        return shown->frameCount();
    // A performance is known before it is computed.
    const LiveEntry* live =
        isLive() ? findLive(m_context.document.project(), nameOfClip(m_plan.clips.front()).toStdString())
                 : nullptr;
    return live == nullptr ? 0 : performedFrames(*live);
}

void ExportDialog::showFacts()
{
    const ProjectSettings& settings = m_context.document.project().settings;
    const bool isPicture = m_plan.isPicture();
    m_picture->setVisible(isPicture);
    m_picture->setTransparencyPossible(m_plan.format().id == "png");
    m_axes->setEnabled(!isPicture && !m_plan.isPlayer());
    m_textures->setEnabled(!isPicture && !m_plan.format().needsMesh);
    m_textures->setText(m_plan.isPlayer() ? tr("Put the pictures into the file")
                                          : tr("Write the pictures beside"));
    const auto frames = framesWritten();
    QString text = m_plan.filesText(m_plan.entries().front(), frames.value_or(1));
    if (m_plan.clips.size() > 1)
        text = tr("%1, and %n more", nullptr, static_cast<int>(m_plan.clips.size() - 1)).arg(text);
    if (isDataSet()) {
        text = tr("%1 … · all variations that are kept, their latents, and a description").arg(text);
    } else if (m_plan.isPlayer()) {
        text = tr("%1 · motion spaces, transitions and the recording, to be steered in games").arg(text);
    } else if (frames) {
        const double seconds = static_cast<double>(*frames) / m_plan.entry.fps.value_or(settings.fps);
        text = tr("%1 · %n frame(s), %2 s", "files · frames, seconds", static_cast<int>(*frames))
                   .arg(text, QLocale().toString(seconds, 'f', 2));
    }
    m_files->setText(text);
    m_export->setEnabled(!m_job && !m_plan.entry.path.empty());
    warnOfTextures();
    if (const MeshSequence* shown = sequence()) {
        RenderOptions look = m_picture->settings().look;
        look.axes = settings.axes;
        if (isPicture)
            m_preview->draw(*shown, look);
        else
            m_preview->draw(shown, settings.axes);
    }
}

void ExportDialog::warnOfTextures()
{
    const MeshSequence* shown = sequence();
    const bool changes = shown != nullptr && m_plan.format().id == "gltf" && m_plan.entry.textures &&
                         shown->textures.kind() == TextureSet::Kind::PerFrame && shown->frameCount() > 1;
    const bool saysMore = !m_strip->isEmpty() && m_strip->kind() == widgets::MessageStrip::Kind::Error;
    if (m_job || m_isDone || saysMore)
        return;
    m_strip->clear();
    if (changes) {
        m_strip->show(
            widgets::MessageStrip::Kind::Info,
            tr("glTF shows the texture of the first frame; those of all frames are written beside."),
            tr("USD, OBJ and PLY show each in its frame."));
    }
}

void ExportDialog::retranslate()
{
    setWindowTitle(m_plan.edited.isEmpty() ? tr("Export") : tr("Export “%1”").arg(m_plan.edited));
    const QStringList labels{tr("Clip"),   tr("Format"), tr("File"), {},
                             tr("Frames"), tr("Rate"),   tr("Axes"), tr("Textures")};
    const QList<QWidget*> fields{m_clip, m_format, m_place, m_files, m_range, m_fps, m_axes, m_textures};
    for (int row = 0; row < labels.size(); ++row) {
        auto* item = m_form->itemAt(row, QFormLayout::LabelRole);
        auto* label = item == nullptr ? nullptr : qobject_cast<QLabel*>(item->widget());
        if (label == nullptr || labels[row].isEmpty())
            continue;
        label->setText(labels[row]);
        label->setBuddy(fields[row]);
        fields[row]->setAccessibleName(labels[row]);
    }
    m_choosePlace->setToolTip(tr("Choose the file"));
    m_choosePlace->setAccessibleName(tr("Choose the file"));
    m_fps->setSuffix(tr(" fps"));
    m_fps->setToolTip(tr("Another rate than the project's is resampled"));
    m_keep->setText(tr("Keep in the project, so that a rebuild repeats it"));
    m_progress->setAccessibleName(tr("How far the export is"));
    m_cancel->setText(m_isDone ? tr("Close") : tr("Cancel"));
    m_export->setText(m_isDone ? tr("Close") : m_job ? tr("Exporting…") : tr("Export"));
    showFacts();
}

} // namespace quadrille
