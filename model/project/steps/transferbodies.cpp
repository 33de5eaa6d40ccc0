// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/transferbodies.h"

#include "model/core/bounds.h"
#include "model/core/error.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/document/throwinvalid.h"
#include "model/sequence/contacts.h"
#include "model/sequence/io/registry.h"

#include <algorithm>
#include <limits>

namespace quadrille {

namespace {

/// So many frames are compared with a target's pose at first; then those around the best.
constexpr std::int64_t comparedFrames = 400;

MeshSequence inMetres(const MeshSequence& sequence, double metresPerUnit)
{
    return transformed(sequence, static_cast<float>(metresPerUnit) * Eigen::Matrix3f::Identity());
}

PosedMesh poseOf(const MeshSequence& sequence, FrameIndex frame)
{
    if (frame.value < 0 || frame.value >= sequence.frameCount())
        throwInvalid("“" + sequence.name + "” has no frame " + std::to_string(frame.value),
                     "Write a frame from 0 to " + std::to_string(sequence.frameCount() - 1) + ".");
    const Frame pose = sequence.frame(frame);
    return {sequence.topology, {pose.positions().begin(), pose.positions().end()}};
}

/// Whether two bodies are as large as each other but for their poses: feet and metres are further apart.
bool areOfOneUnit(const MeshSequence& a, const MeshSequence& b)
{
    constexpr double most = 3;
    const auto extent = [](const MeshSequence& sequence) {
        return boundsOf(sequence.frame(FrameIndex(0)).positions()).size().norm();
    };
    const double ratio = extent(a) / extent(b);
    return ratio > 1 / most && ratio < most;
}

/// A frame of several takes, numbered one after the other, and how unlike a target it is.
struct ComparedFrame
{
    std::size_t take = 0;
    FrameIndex frame{0};
    double difference = std::numeric_limits<double>::infinity();
};

} // namespace

TransferBodies::TransferBodies(SequenceOpener& opener, TransferEntry entry, const Progress& progress)
    : m_entry(std::move(entry))
    , m_up(opener.project().settings.axes.up)
    , m_metresPerUnit(opener.project().settings.axes.metresPerUnit)
    , m_takes{openClip(opener, progress)}
    , m_targetSequence(opener.open(m_entry.target.sequence, Progress(progress.token())))
    , m_target(poseOf(inMetres(m_targetSequence->sequence, m_metresPerUnit), m_entry.target.frame))
{
    openTakes(opener, progress);
}

MeshSequence TransferBodies::openClip(SequenceOpener& opener, const Progress& progress) const
{
    MeshSequence clip =
        inMetres(opener.openClip(m_entry.clip, Progress(progress.token()))->sequence, m_metresPerUnit);
    if (clip.contacts.empty())
        clip.contacts = detectContacts(clip, {.up = m_up}, progress);
    return clip;
}

void TransferBodies::openTakes(SequenceOpener& opener, const Progress& progress)
{
    for (const std::string& name : templateSequences(opener.project(), m_entry)) {
        MeshSequence sequence =
            inMetres(opener.open(name, Progress(progress.token()))->sequence, m_metresPerUnit);
        if (isOfMesh(sequence))
            m_takes.push_back(std::move(sequence));
        else if (m_entry.reference)
            throwInvalid("“" + name + "” is not of the mesh of “" + m_entry.clip + "”",
                         "Name a frame of a take of the same character.");
    }
    if (!m_entry.reference)
        openMesh(opener, progress);
}

void TransferBodies::openMesh(const SequenceOpener& opener, const Progress& progress)
{
    const Project& project = opener.project();
    const std::vector<std::string> takes = templateSequences(project, m_entry);
    const SequenceEntry* take = takes.empty() ? nullptr : findSequence(project, takes.front());
    const CharacterEntry* character = take == nullptr ? nullptr : characterOf(project, *take);
    if (character == nullptr || character->mesh.empty())
        return;
    ImportOptions options;
    options.from = take->sourceAxes; // as a rule both lie in one space
    options.to = project.settings.axes;
    MeshSequence mesh = inMetres(
        openSequences(resolvePath(character->mesh, opener.folder()), options, Progress(progress.token()))
            .sequences.front(),
        m_metresPerUnit);
    if (!isOfMesh(mesh) || !areOfOneUnit(mesh, performed()))
        return;
    mesh.name = character->mesh;
    m_takes.insert(m_takes.begin() + 1, std::move(mesh));
}

bool TransferBodies::isOfMesh(const MeshSequence& sequence) const
{
    const Topology& mesh = *performed().topology;
    return sequence.topology->vertexCount() == mesh.vertexCount() &&
           sequence.topology->triangles().size() == mesh.triangles().size();
}

PosedMesh TransferBodies::anyPose() const
{
    return m_entry.reference ? poseOf(m_takes.back(), m_entry.reference->frame)
                             : poseOf(performed(), FrameIndex(0));
}

TransferSettings TransferBodies::settings() const
{
    return {.field = m_entry.field,
            .up = m_up,
            .correctsPose = m_entry.correctsPose,
            .carriesStretch = m_entry.carriesStretch,
            .marksSurroundings = m_entry.marksSurroundings,
            .scale = m_entry.scale};
}

std::vector<ProposedPair> TransferBodies::pairs(const Tell& tell, const Progress& progress) const
{
    if (!m_entry.pairs.empty()) {
        checkPairs(*performed().topology, *m_target.topology, m_entry.pairs);
        std::vector<ProposedPair> given;
        for (const TrianglePair& pair : m_entry.pairs)
            given.push_back({pair, std::numeric_limits<double>::quiet_NaN()});
        return given;
    }
    std::vector<ProposedPair> proposed = anyPairs(progress.part(0, 0.5));
    if (!m_entry.reference)
        proposed = pairsOfAlikePoses(std::move(proposed), progress.part(0.5, 1));
    tell(std::to_string(proposed.size()) + " pairs of triangles were proposed.");
    return proposed;
}

std::vector<std::vector<Vec3f>> TransferBodies::performedPoses() const
{
    constexpr std::int64_t most = 12;
    const std::int64_t frames = performed().frameCount();
    const std::int64_t count = std::min(frames, most);
    std::vector<std::vector<Vec3f>> poses;
    for (std::int64_t i = 0; i < count; ++i)
        poses.push_back(
            poseOf(performed(), FrameIndex(count > 1 ? i * (frames - 1) / (count - 1) : 0)).positions);
    return poses;
}

std::vector<ProposedPair> TransferBodies::pairsOfAlikePoses(std::vector<ProposedPair> proposed,
                                                            const Progress& progress) const
{
    std::vector<TrianglePair> pairs;
    pairs.reserve(proposed.size());
    for (const ProposedPair& each : proposed)
        pairs.push_back(each.pair);
    const PosedMesh alike = referencePose(
        pairs, [](const std::string& /*text*/) {}, progress.part(0, 0.3));
    try {
        return proposePairs(alike, m_target, m_up, performedPoses(), usualPairs, progress.part(0.3, 1));
    } catch (const Error& error) {
        if (error.code() != ErrorCode::TransferNoLimbsOfTemplate)
            throw;
        return proposed;
    }
}

std::vector<ProposedPair> TransferBodies::anyPairs(const Progress& progress) const
{
    // Limbs may touch the body where a take begins; then another may do.
    for (auto take = m_takes.rbegin(); take != m_takes.rend(); ++take) {
        try {
            const FrameIndex frame = m_entry.reference && take->name == m_entry.reference->sequence
                                         ? m_entry.reference->frame
                                         : FrameIndex(0);
            return proposePairs(poseOf(*take, frame), m_target, m_up, performedPoses(), usualPairs, progress);
        } catch (const Error& error) {
            if (error.code() != ErrorCode::TransferNoLimbsOfTemplate || take + 1 == m_takes.rend())
                throw;
        }
    }
    throw Error(ErrorCode::TransferNoPairs);
}

PosedMesh TransferBodies::referencePose(std::span<const TrianglePair> pairs, const Tell& tell,
                                        const Progress& progress) const
{
    if (m_entry.reference)
        return poseOf(m_takes.back(), m_entry.reference->frame);
    std::int64_t all = 0;
    for (const MeshSequence& take : m_takes)
        all += take.frameCount();
    const std::int64_t step = std::max<std::int64_t>(1, all / comparedFrames);
    ComparedFrame best;
    const auto compare = [&](std::size_t t, std::int64_t first, std::int64_t last, std::int64_t each) {
        const MeshSequence& take = m_takes[t];
        for (std::int64_t f = std::max<std::int64_t>(first, 0); f <= std::min(last, take.frameCount() - 1);
             f += each) {
            const double difference =
                poseDifference(*take.topology, take.frame(FrameIndex(f)).positions(), m_target, pairs, m_up);
            if (difference < best.difference)
                best = {t, FrameIndex(f), difference};
            progress.report(static_cast<double>(t) / static_cast<double>(m_takes.size()));
        }
    };
    for (std::size_t t = 0; t < m_takes.size(); ++t)
        compare(t, 0, m_takes[t].frameCount() - 1, step);
    if (step > 1)
        compare(best.take, best.frame.value - step + 1, best.frame.value + step - 1, 1);
    const MeshSequence& take = m_takes[best.take];
    tell("The pose most like the target's is frame " + std::to_string(best.frame.value) + " of “" +
         take.name + "”.");
    return poseOf(take, best.frame);
}

} // namespace quadrille
