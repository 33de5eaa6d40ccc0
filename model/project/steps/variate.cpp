// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/variate.h"

#include "model/core/error.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/fields/writefields.h"
#include "model/project/media/sequencesettings.h"
#include "model/project/steps/bodypose.h"
#include "model/synthesis/clips/characterlegs.h"
#include "model/synthesis/finishing/contactcorrection.h"
#include "model/variation/posereach.h"

#include <algorithm>
#include <numeric>

namespace quadrille {

namespace {

std::vector<Vec3f> copied(Positions positions)
{
    return {positions.begin(), positions.end()};
}

std::size_t takeIndex(const VariationEntry& entry, const std::string& name)
{
    const auto& takes = entry.training;
    const auto found = std::find_if(takes.begin(), takes.end(),
                                    [&](const TrainingEntry& take) { return take.sequence == name; });
    if (found == takes.end())
        throwInvalid("“" + name + "” is none of the takes that “" + entry.name + "” learns from",
                     "Name it under “sequences”, too.");
    return static_cast<std::size_t>(found - takes.begin());
}

} // namespace

std::vector<MovementBlend> blendsOf(const VariationEntry& variation)
{
    std::vector<MovementBlend> all;
    for (const BlendEntry& entry : variation.blends) {
        MovementBlend& blend = all.emplace_back();
        blend.from = takeIndex(variation, entry.from);
        blend.to = takeIndex(variation, entry.to);
        blend.weights = entry.weights;
        if (const auto& across = entry.across)
            blend.across = {takeIndex(variation, across->from), takeIndex(variation, across->to),
                            across->weights};
    }
    return all;
}

VariationSubject subjectOf(const VariationEntry& entry, const SamplesEntry& samples)
{
    VariationSubject subject;
    subject.take = takeIndex(entry, samples.of);
    if (!samples.to.empty())
        subject.to = takeIndex(entry, samples.to);
    subject.weight = samples.weight;
    if (const auto& across = samples.across)
        subject.across = {takeIndex(entry, across->of), takeIndex(entry, across->to), across->weight};
    return subject;
}

VariationWork::VariationWork(std::shared_ptr<SequenceOpener> opener, VariationEntry entry,
                             std::shared_ptr<ResultSession> session)
    : m_opener(std::move(opener))
    , m_entry(std::move(entry))
    , m_session(std::move(session))
    , m_character(characterNameOf(m_opener->project(), m_entry))
{
    if (const BodyPartsEntry* parts = bodyPartsOf(m_opener->project(), m_character))
        m_parts = *parts;
}

std::vector<std::string> VariationWork::takeNames() const
{
    std::vector<std::string> names;
    for (const TrainingEntry& take : m_entry.training)
        names.push_back(take.sequence);
    const std::vector<std::string> takes = names;
    const std::vector<MovementBlend> all = blendsOf(m_entry);
    for (const Preblend& point : preblendsOf(all))
        names.push_back(preblendName(all[point.blend], point, takes));
    return names;
}

std::vector<TrainingTake> VariationWork::openTakes(const Progress& progress)
{
    const auto metres = static_cast<float>(project().settings.axes.metresPerUnit);
    std::vector<TrainingTake> opened;
    for (std::size_t i = 0; i < m_entry.training.size(); ++i) {
        progress.report(static_cast<std::int64_t>(i), static_cast<std::int64_t>(m_entry.training.size()));
        const TrainingEntry& take = m_entry.training[i];
        const auto source = m_opener->open(take.sequence, Progress(progress.token()));
        opened.push_back({transformed(source->sequence, metres * Eigen::Matrix3f::Identity()), take.range});
    }
    return opened;
}

BodyParts VariationWork::cutParts(const MeshSequence& first, const Progress& progress)
{
    const std::vector<Vec3f> pose = m_parts.pose ? poseInMetres(*m_opener, *m_parts.pose, progress)
                                                 : copied(first.frame(FrameIndex(0)).positions());
    return quadrille::cutParts(*first.topology, pose, m_parts);
}

VariationWork::Prepared& VariationWork::prepared(const Progress& progress)
{
    const std::scoped_lock lock(m_mutex);
    if (m_prepared)
        return *m_prepared;
    // Sequences that share their source are of the same frames; settings say what is taken of them.
    std::vector<std::shared_ptr<const OpenedSequence>> opened;
    const ProjectSettings& settings = project().settings;
    std::string name = movementSettings() + std::to_string(settings.fps) + ' ' +
                       std::to_string(settings.axes.metresPerUnit) + ' ' +
                       std::to_string(static_cast<int>(settings.axes.up));
    for (const std::string& sequence : sequences()) {
        opened.push_back(m_opener->open(sequence, Progress(progress.token())));
        name += ' ' + std::to_string(opened.back()->sequence.source->id().value());
    }
    const auto make = [&] {
        auto made = std::make_shared<Prepared>();
        made->sequences = opened;
        return made;
    };
    m_prepared = m_session ? m_session->shared<Prepared>(name, make) : make();
    return *m_prepared;
}

FrameLayout VariationWork::layout(const Progress& progress)
{
    return frames(progress).layout();
}

const CharacterFrames& VariationWork::frames(const Progress& progress)
{
    movement(progress);
    return *prepared(progress).frames;
}

std::shared_ptr<const Movement> VariationWork::movement(const Progress& progress)
{
    if (m_entry.training.empty())
        throwInvalid("The variations “" + m_entry.name + "” have no takes to learn from",
                     "Name them under “sequences”.");
    Prepared& own = prepared(progress);
    const std::scoped_lock lock(own.mutex);
    if (own.movement)
        return own.movement;
    constexpr double opening = 0.2;
    const std::vector<TrainingTake> takes = openTakes(progress.part(0, opening));
    MovementSettings settings;
    settings.alignment.up = project().settings.axes.up;
    settings.alignment.cycles = m_entry.cycles;
    settings.displacementShare = m_entry.displacementShare;
    const std::vector<Vec3f> pose = m_entry.templatePose
                                        ? poseInMetres(*m_opener, *m_entry.templatePose, progress)
                                        : std::vector<Vec3f>();
    const std::size_t reference = m_entry.reference.empty() ? 0 : takeIndex(m_entry, m_entry.reference);
    auto movement = std::make_shared<const Movement>(
        makeMovement(takes, reference, cutParts(takes.front().sequence, progress), blendsOf(m_entry),
                     settings, pose, progress.part(opening, 1)));
    std::vector<MeshSequence> sequences;
    sequences.reserve(takes.size());
    for (std::size_t t = 0; t < takes.size(); ++t) {
        sequences.push_back(takes[t].sequence);
        sequences.back().contacts = movement->alignment.reports[t].contacts;
    }
    own.frames.emplace(sequences);
    own.movement = std::move(movement);
    return own.movement;
}

std::shared_ptr<const LearnedMovement> VariationWork::learned(std::vector<GpdmState> states,
                                                              const Progress& progress)
{
    const auto made = movement(progress);
    const std::scoped_lock lock(m_mutex);
    if (!m_learned)
        m_learned = std::make_shared<const LearnedMovement>(made, std::move(states));
    return m_learned;
}

const VariationMeter& VariationWork::meter(const Progress& progress)
{
    const auto made = movement(progress.part(0, 0.5));
    Prepared& own = prepared(progress);
    const std::scoped_lock lock(own.mutex);
    if (!own.meter) {
        std::vector<int> varied(made->capturedCount());
        std::iota(varied.begin(), varied.end(), 0);
        own.meter.emplace(*own.frames, varied, made->alignment.takes, project().settings.axes.up, made->parts,
                          poseReaches(*made, progress.part(0.5, 0.6)), progress.part(0.6, 1));
    }
    return *own.meter;
}

VariationPoses VariationWork::poses(const VariationEntry& entry, const Progress& progress)
{
    movement(progress.part(0, 0.7));
    Prepared& own = prepared(progress);
    const std::scoped_lock lock(own.mutex);
    const UpAxis up = project().settings.axes.up;
    if (!own.standing)
        own.standing.emplace(
            CapturedStanding{*own.frames, findSupports(*own.frames, up, progress.part(0.7, 1))});
    if (!own.contacts && entry.correctsContacts)
        own.contacts.emplace(
            VariationContacts{*own.frames, legsOf(*own.frames, up, Progress(progress.token()))});
    return {.draw = entry.draw,
            .up = up,
            .standing = &*own.standing,
            .tempo = entry.extent.draw == TrajectoryDraw::Smooth ? entry.extent.spread : 0,
            .contacts = entry.correctsContacts ? &*own.contacts : nullptr};
}

Clip VariationWork::inProjectUnit(Clip clip) const
{
    const auto units = static_cast<float>(1 / project().settings.axes.metresPerUnit);
    for (Vec3f& position : clip.positions)
        position *= units;
    return clip;
}

std::vector<std::string> VariationWork::sequences() const
{
    std::vector<std::string> names;
    for (const TrainingEntry& take : m_entry.training)
        names.push_back(take.sequence);
    for (const auto& frame : {m_entry.templatePose, m_parts.pose}) {
        if (frame && std::find(names.begin(), names.end(), frame->sequence) == names.end())
            names.push_back(frame->sequence);
    }
    return names;
}

std::vector<std::filesystem::path> VariationWork::files(const Progress& progress) const
{
    std::vector<std::filesystem::path> all;
    for (const std::string& sequence : sequences()) {
        const auto own = m_opener->filesOf(sequence, progress);
        all.insert(all.end(), own.begin(), own.end());
    }
    return all;
}

std::string VariationWork::movementSettings() const
{
    // Only what the movement is made of.
    VariationEntry learned;
    learned.training = m_entry.training;
    learned.reference = m_entry.reference;
    learned.templatePose = m_entry.templatePose;
    learned.cycles = m_entry.cycles;
    learned.blends = m_entry.blends;
    learned.displacementShare = m_entry.displacementShare;
    BodyPartsEntry parts = m_parts;
    for (PartCurveEntry& curve : parts.curves)
        curve.points.clear();
    std::string settings = settingsText(learned) + settingsText(parts);
    for (const std::string& name : sequences()) {
        if (const SequenceEntry* sequence = findSequence(project(), name))
            settings += sequenceSettings(project(), *sequence) + contactSettings(*sequence);
    }
    return settings;
}

std::vector<std::string> VariationWork::clipSteps() const
{
    return clipInputs(project(), sequences());
}

} // namespace quadrille
