// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/motionspacework.h"

#include "model/core/contains.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/fields/writefields.h"
#include "model/project/media/sequencesettings.h"
#include "model/project/steps/bodypose.h"
#include "model/project/steps/clippost.h"
#include "model/synthesis/finishing/mirror.h"

#include <algorithm>

namespace quadrille {

namespace {

/// The sequence with other positions, frames × vertices.
MeshSequence withFrames(const MeshSequence& sequence, std::vector<Vec3f> positions)
{
    MeshSequence changed = makeSequence(
        sequence.name, sequence.topology,
        std::make_shared<MemoryFrames>(std::move(positions), sequence.topology->vertexCount()), sequence.fps);
    changed.contacts = sequence.contacts;
    return changed;
}

/// Across any upright plane: where a take stands does not matter.
MeshSequence mirroredTake(const MeshSequence& sequence, const Symmetry& symmetry, UpAxis up,
                          const Progress& progress)
{
    Clip clip{.topology = sequence.topology,
              .fps = sequence.fps,
              .positions = loadFrames(sequence, progress.part(0, 0.5)),
              .origins = {}};
    clip.origins.resize(static_cast<std::size_t>(sequence.frameCount()));
    MeshSequence made =
        withFrames(sequence, mirrored(clip, symmetry, {}, up, progress.part(0.5, 1)).positions);
    made.name += " (mirrored)";
    for (ContactSpan& contact : made.contacts) {
        if (contact.foot == "left" || contact.foot == "right")
            contact.foot = contact.foot == "left" ? "right" : "left";
    }
    return made;
}

FrameRange reversedRange(FrameRange range, std::int64_t frames)
{
    return {FrameIndex(frames - 1 - range.last.value), FrameIndex(frames - 1 - range.first.value)};
}

MeshSequence reversedTake(const MeshSequence& sequence, const Progress& progress)
{
    const std::vector<Vec3f> forward = loadFrames(sequence, progress);
    const auto vertices = static_cast<std::ptrdiff_t>(sequence.topology->vertexCount());
    std::vector<Vec3f> backward;
    backward.reserve(forward.size());
    for (auto end = forward.end(); end != forward.begin(); end -= vertices)
        backward.insert(backward.end(), end - vertices, end);
    MeshSequence made = withFrames(sequence, std::move(backward));
    made.name += " (reversed)";
    for (ContactSpan& contact : made.contacts)
        contact.frames = reversedRange(contact.frames, sequence.frameCount());
    std::ranges::reverse(made.contacts);
    return made;
}

} // namespace

MotionSpaceWork::MotionSpaceWork(std::shared_ptr<SequenceOpener> opener, MotionSpaceEntry entry)
    : m_opener(std::move(opener))
    , m_entry(std::move(entry))
    , m_character(characterNameOf(m_opener->project(), m_entry))
{
    if (const BodyPartsEntry* parts = bodyPartsOf(m_opener->project(), m_character))
        m_parts = *parts;
}

SpaceTakeSource MotionSpaceWork::opened(const SpaceTakeEntry& take, const Progress& progress) const
{
    const auto metres = static_cast<float>(project().settings.axes.metresPerUnit);
    const auto source = m_opener->open(take.sequence, Progress(progress.token()));
    SpaceTakeSource made{
        .take = {.sequence = transformed(source->sequence, metres * Eigen::Matrix3f::Identity()),
                 .range = take.range,
                 .coefficients = {}},
        .speed = take.speed,
        .place = {}};
    if (take.isMirrored)
        made.take.sequence =
            mirroredTake(made.take.sequence, symmetryOf(*m_opener, m_character, source->sequence), up(),
                         progress.part(0, 0.5));
    if (take.isReversed) {
        const std::int64_t frames = made.take.sequence.frameCount();
        made.take.sequence = reversedTake(made.take.sequence, progress.part(0.5, 1));
        if (take.range)
            made.take.range = reversedRange(*take.range, frames);
    }
    if (take.place.empty())
        return made;
    if (take.place.size() != m_entry.parameters.size())
        throwInvalid("The place of “" + take.sequence + "” in the motion space “" + m_entry.name +
                         "” has another number of values than the space has parameters",
                     "Write one for each parameter, or leave it out.");
    made.place.emplace(SpacePoint{});
    std::ranges::copy(take.place, made.place->begin());
    return made;
}

std::vector<SpaceParameter> MotionSpaceWork::parameters(std::uint32_t vertices) const
{
    std::vector<SpaceParameter> all;
    for (const SpaceParameterEntry& entry : m_entry.parameters) {
        SpaceParameter& parameter =
            all.emplace_back(SpaceParameter{.name = entry.name, .measure = entry.measure, .vertex = {}});
        if (!isOfVertex(entry.measure))
            continue;
        if (!entry.vertex)
            throwInvalid("Nothing is said of which vertex the parameter “" + entry.name + "” measures",
                         "Write its number as “vertex”.");
        if (*entry.vertex < 0 || *entry.vertex >= std::int64_t{vertices})
            throwInvalid("The parameter “" + entry.name + "” measures vertex " +
                             std::to_string(*entry.vertex) + ", which the character has not",
                         "Write a number from 0 to " + std::to_string(vertices - 1) + ".");
        parameter.vertex = VertexIndex(static_cast<std::uint32_t>(*entry.vertex));
    }
    return all;
}

MotionSpace MotionSpaceWork::make(const Progress& progress) const
{
    std::vector<SpaceTakeSource> takes;
    const auto count = static_cast<double>(m_entry.takes.size());
    for (const SpaceTakeEntry& take : m_entry.takes) {
        const auto done = static_cast<double>(takes.size());
        takes.push_back(opened(take, progress.part(0.1 * done / count, 0.1 * (done + 1) / count)));
    }
    const Topology& topology = *takes.front().take.sequence.topology;
    const std::vector<Vec3f> pose = poseInMetres(*m_opener, templateFrame(), progress);
    MotionSpaceSettings settings;
    settings.alignment.up = up();
    settings.alignment.cycles = m_entry.cycles;
    if (pose.size() == topology.vertexCount())
        settings.alignment.anchor = anchorVertices(cutParts(topology, pose, m_parts));
    settings.tolerance = m_entry.tolerance;
    settings.mostReferences = m_entry.mostReferences;
    return makeMotionSpace(m_entry.name, takes, referenceOf(m_entry), parameters(topology.vertexCount()),
                           pose, settings, progress.part(0.1, 1));
}

std::shared_ptr<const Topology> MotionSpaceWork::topology(const Progress& progress) const
{
    return m_opener->open(m_entry.takes.front().sequence, progress)->sequence.topology;
}

NamedFrame MotionSpaceWork::templateFrame() const
{
    if (m_parts.pose)
        return *m_parts.pose;
    for (const SequenceEntry& sequence : project().sequences) {
        const CharacterEntry* of = characterOf(project(), sequence);
        // Clips may be made of the space itself.
        if ((of ? of->name : "") == m_character && !clipOfSource(sequence.source))
            return {sequence.name, FrameIndex(0)};
    }
    return {m_entry.takes.front().sequence, FrameIndex(0)};
}

std::vector<std::string> MotionSpaceWork::sequences() const
{
    std::vector<std::string> names;
    const auto add = [&](const std::string& name) {
        if (!contains(names, name))
            names.push_back(name);
    };
    for (const SpaceTakeEntry& take : m_entry.takes)
        add(take.sequence);
    add(templateFrame().sequence);
    return names;
}

std::vector<std::filesystem::path> MotionSpaceWork::files(const Progress& progress) const
{
    std::vector<std::filesystem::path> all;
    for (const std::string& sequence : sequences()) {
        const auto own = m_opener->filesOf(sequence, progress);
        all.insert(all.end(), own.begin(), own.end());
    }
    return all;
}

std::string MotionSpaceWork::settings() const
{
    MotionSpaceEntry entry = m_entry;
    entry.name.clear();
    entry.character.clear();
    BodyPartsEntry parts = m_parts;
    parts.character.clear();
    for (PartCurveEntry& curve : parts.curves)
        curve.points.clear();
    std::string text = settingsText(entry) + settingsText(parts);
    text += templateFrame().sequence + ' ' + std::to_string(templateFrame().frame.value);
    for (const std::string& name : sequences()) {
        if (const SequenceEntry* sequence = findSequence(project(), name))
            text += sequenceSettings(project(), *sequence) + contactSettings(*sequence);
    }
    return text;
}

std::vector<std::string> MotionSpaceWork::inputs() const
{
    return clipInputs(project(), sequences());
}

std::string toText(SpaceMeasure measure)
{
    switch (measure) {
    case SpaceMeasure::Speed:
        return "speed";
    case SpaceMeasure::Turning:
        return "turning";
    case SpaceMeasure::JumpHeight:
        return "jump-height";
    case SpaceMeasure::JumpLength:
        return "jump-length";
    case SpaceMeasure::Height:
        return "height";
    case SpaceMeasure::Forward:
        return "forward";
    case SpaceMeasure::Side:
        return "side";
    case SpaceMeasure::ByHand:
        return "by-hand";
    }
    return {};
}

} // namespace quadrille
