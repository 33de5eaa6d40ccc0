// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/bodysurface.h"

#include "editor/context/editorcontext.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "model/project/document/findentry.h"

#include <algorithm>

namespace quadrille {

BodySurface::BodySurface(CurrentVariation& variation, QObject* parent)
    : QObject(parent), m_variation(variation)
{
    connect(&variation, &CurrentVariation::bodyChanged, this, &BodySurface::update);
    connect(&variation.context().media, &SequenceMedia::changed, this, &BodySurface::update);
    update();
}

std::optional<NamedFrame> BodySurface::pose() const
{
    if (auto pose = m_variation.body().pose)
        return pose;
    const ProjectDocument& document = m_variation.context().document;
    for (const SequenceEntry& sequence : document.project().sequences) {
        const CharacterEntry* character = document.characterOf(sequence);
        if (character != nullptr && QString::fromStdString(character->name) == m_variation.character())
            return NamedFrame{.sequence = sequence.name, .frame = FrameIndex(0)};
    }
    return std::nullopt;
}

void BodySurface::update()
{
    const auto wanted = pose();
    const MeshSequence* sequence =
        wanted ? m_variation.context().media.sequence(QString::fromStdString(wanted->sequence)) : nullptr;
    Source source;
    if (sequence != nullptr) {
        const std::int64_t last = std::max<std::int64_t>(sequence->frameCount() - 1, 0);
        source = {.topology = sequence->topology,
                  .frames = sequence->source,
                  .frame = sequence->sourceFrame(
                      FrameIndex(std::clamp<std::int64_t>(wanted->frame.value, 0, last))),
                  .metresPerUnit = m_variation.context().document.project().settings.axes.metresPerUnit};
    }
    if (source == m_source)
        return;
    m_source = source;
    m_graph.reset();
    m_error.reset();
    if (m_job)
        m_job->cancel();
    if (sequence != nullptr)
        read(*sequence, FrameIndex(source.frame.value - sequence->range.first.value));
    emit changed();
}

void BodySurface::read(const MeshSequence& sequence, FrameIndex frame)
{
    m_job = m_variation.context().jobs.start(
        {.name = tr("Reading the pose that curves are drawn in"),
         .receiver = this,
         .stillStands = [this, source = m_source] { return source == m_source; },
         .failed =
             [this](const Error& error) {
                 m_error = error;
                 m_job.clear();
                 emit changed();
             },
         .background = true},
        [sequence, frame, metres = static_cast<float>(m_source.metresPerUnit)](const Progress&) {
            const Frame read = sequence.frame(frame);
            std::vector<Vec3f> pose(read.positions().begin(), read.positions().end());
            for (Vec3f& position : pose)
                position *= metres;
            return SurfaceGraph(sequence.topology, pose);
        },
        [this](SurfaceGraph graph) {
            m_graph = std::make_shared<const SurfaceGraph>(std::move(graph));
            m_job.clear();
            emit changed();
        });
}

} // namespace quadrille

#include "moc_bodysurface.cpp"
