// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/project/document/findentry.h"
#include "model/project/document/lengthunit.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/fields/writefields.h"
#include "model/project/media/sequencesettings.h"
#include "model/project/steps/buildstep.h"
#include "model/project/store/clipresult.h"
#include "model/project/store/tablebuilder.h"
#include "model/sequence/contacts.h"
#include "model/synthesis/clips/stances.h"
#include "model/synthesis/finishing/contactcorrection.h"
#include "model/transfer/pairproposal.h"
#include "model/transfer/transferclip.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace quadrille {

namespace {

/// What an entry of “transfers” is computed from.
class TransferWork
{
public:
    TransferWork(std::shared_ptr<SequenceOpener> opener, TransferEntry entry)
        : m_opener(std::move(opener)), m_entry(std::move(entry))
    {
    }

    const TransferEntry& entry() const { return m_entry; }
    std::string clipName() const { return "transfers/" + m_entry.name; }
    std::string character() const { return characterOfClip(project(), clipName()); }

    std::vector<std::filesystem::path> files(const Progress& progress) const
    {
        std::vector<std::filesystem::path> all;
        for (const std::string& sequence : sequences()) {
            const auto own = m_opener->filesOf(sequence, progress);
            all.insert(all.end(), own.begin(), own.end());
        }
        return all;
    }

    /// All that the result depends on beside files and clips; what it is called by is not in it.
    std::string settings() const
    {
        TransferEntry entry = m_entry;
        entry.name.clear();
        entry.clip.clear();
        entry.target.sequence.clear();
        if (entry.reference)
            entry.reference->sequence.clear();
        std::string text = writeFields(entry).dump(-1, ' ', true, Json::error_handler_t::replace);
        for (const std::string& name : sequences()) {
            if (const SequenceEntry* sequence = findSequence(project(), name))
                text += sequenceSettings(project(), *sequence) + contactSettings(*sequence);
        }
        return text;
    }

    std::vector<std::string> inputs() const
    {
        std::vector<std::string> steps = clipStepsOf(project(), m_entry.clip);
        for (std::string& step : clipInputs(project(), sequences())) {
            if (std::ranges::find(steps, step) == steps.end())
                steps.push_back(std::move(step));
        }
        return steps;
    }

    Result compute(const StepContext& context, const Progress& progress) const;

private:
    const Project& project() const { return m_opener->project(); }
    UpAxis up() const { return project().settings.axes.up; }
    double metresPerUnit() const { return project().settings.axes.metresPerUnit; }

    /// The target's, the template's, and the clip's own.
    std::vector<std::string> sequences() const
    {
        std::vector<std::string> names{m_entry.target.sequence};
        const auto add = [&](const std::string& name) {
            if (std::ranges::find(names, name) == names.end())
                names.push_back(name);
        };
        for (const std::string& name : templateSequences(project(), m_entry))
            add(name);
        if (const auto name = nameOfClip(m_entry.clip, "sequences"))
            add(*name);
        return names;
    }

    MeshSequence inMetres(const MeshSequence& sequence) const
    {
        return transformed(sequence, static_cast<float>(metresPerUnit()) * Eigen::Matrix3f::Identity());
    }
    MeshSequence openInMetres(const std::string& sequence, const Progress& progress) const
    {
        return inMetres(m_opener->open(sequence, Progress(progress.token()))->sequence);
    }

    static PosedMesh poseOf(const MeshSequence& sequence, FrameIndex frame)
    {
        if (frame.value < 0 || frame.value >= sequence.frameCount())
            throwInvalid("“" + sequence.name + "” has no frame " + std::to_string(frame.value),
                         "Write a frame from 0 to " + std::to_string(sequence.frameCount() - 1) + ".");
        const Frame pose = sequence.frame(frame);
        return {sequence.topology, {pose.positions().begin(), pose.positions().end()}};
    }

    MeshSequence openClip(const Progress& progress) const;
    std::vector<MeshSequence> takesOfTemplate(const MeshSequence& clip, const Progress& progress) const;
    std::vector<ProposedPair> pairs(const std::vector<MeshSequence>& takes, const PosedMesh& target,
                                    const StepContext& context, const Progress& progress) const;
    PosedMesh referencePose(const std::vector<MeshSequence>& takes, const PosedMesh& target,
                            std::span<const TrianglePair> pairs, const StepContext& context,
                            const Progress& progress) const;
    Clip corrected(Clip clip, const MeshSequence& performed, const StepContext& context,
                   const Progress& progress) const;
    DataTable report(const Transferred& transferred, const Clip& clip, const MeshSequence& performed,
                     const Progress& progress) const;

    std::shared_ptr<SequenceOpener> m_opener;
    TransferEntry m_entry;
};

void tellInfo(const StepContext& context, std::string text)
{
    context.tell({.severity = Issue::Severity::Info, .context = {.values = {{"text", std::move(text)}}}});
}

MeshSequence TransferWork::openClip(const Progress& progress) const
{
    MeshSequence clip = inMetres(m_opener->openClip(m_entry.clip, Progress(progress.token()))->sequence);
    if (clip.contacts.empty())
        clip.contacts = detectContacts(clip, {.up = up()}, progress);
    return clip;
}

/// The clip, and the captured takes of its mesh, or the one that the reference pose is in.
std::vector<MeshSequence> TransferWork::takesOfTemplate(const MeshSequence& clip,
                                                        const Progress& progress) const
{
    std::vector<MeshSequence> takes{clip};
    for (const std::string& name : templateSequences(project(), m_entry)) {
        MeshSequence sequence = openInMetres(name, progress);
        if (sequence.topology->vertexCount() == clip.topology->vertexCount() &&
            sequence.topology->triangles().size() == clip.topology->triangles().size())
            takes.push_back(std::move(sequence));
        else if (m_entry.reference)
            throwInvalid("“" + name + "” is not of the mesh of “" + m_entry.clip + "”",
                         "Name a frame of a take of the same character.");
    }
    return takes;
}

std::vector<ProposedPair> TransferWork::pairs(const std::vector<MeshSequence>& takes, const PosedMesh& target,
                                              const StepContext& context, const Progress& progress) const
{
    if (!m_entry.pairs.empty()) {
        checkPairs(*takes.front().topology, *target.topology, m_entry.pairs);
        std::vector<ProposedPair> given;
        for (const TrianglePair& pair : m_entry.pairs)
            given.push_back({pair, std::numeric_limits<double>::quiet_NaN()});
        return given;
    }
    // Limbs may touch the body where a take begins; then another may do.
    for (auto take = takes.rbegin(); take != takes.rend(); ++take) {
        try {
            const FrameIndex frame = m_entry.reference && take->name == m_entry.reference->sequence
                                         ? m_entry.reference->frame
                                         : FrameIndex(0);
            std::vector<ProposedPair> proposed =
                proposePairs(poseOf(*take, frame), target, up(), usualPairs, progress);
            tellInfo(context, std::to_string(proposed.size()) + " pairs of triangles were proposed.");
            return proposed;
        } catch (const Error& error) {
            if (error.code() != ErrorCode::TransferNoLimbsOfTemplate || take + 1 == takes.rend())
                throw;
        }
    }
    throw Error(ErrorCode::TransferNoPairs);
}

PosedMesh TransferWork::referencePose(const std::vector<MeshSequence>& takes, const PosedMesh& target,
                                      std::span<const TrianglePair> pairs, const StepContext& context,
                                      const Progress& progress) const
{
    if (m_entry.reference)
        return poseOf(takes.back(), m_entry.reference->frame);
    double least = std::numeric_limits<double>::infinity();
    PosedMesh best;
    std::string where;
    for (std::size_t t = 0; t < takes.size(); ++t) {
        const MeshSequence& take = takes[t];
        for (FrameIndex f(0); f.value < take.frameCount(); ++f) {
            const double difference =
                poseDifference(*take.topology, take.frame(f).positions(), target, pairs, up());
            if (difference < least) {
                least = difference;
                best = poseOf(take, f);
                where = "frame " + std::to_string(f.value) + " of “" + take.name + "”";
            }
            progress.report(static_cast<double>(t) / static_cast<double>(takes.size()));
        }
    }
    tellInfo(context, "The pose most like the target's is " + where + ".");
    return best;
}

Clip TransferWork::corrected(Clip clip, const MeshSequence& performed, const StepContext& context,
                             const Progress& progress) const
{
    if (!m_entry.correctsContacts || performed.contacts.empty())
        return clip;
    try {
        return contactsCorrected(clip, performed.contacts, {}, {.up = up()}, progress);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::NoFeet)
            throw;
        tellInfo(context, "The target has no feet that could be kept standing.");
        return clip;
    }
}

DataTable TransferWork::report(const Transferred& transferred, const Clip& clip,
                               const MeshSequence& performed, const Progress& progress) const
{
    TableBuilder table("report",
                       "How each frame came out: the target's volume against that at rest, the mean "
                       "angle that marked triangles miss, and how fast the feet that stand until the "
                       "next frame slide.");
    table.whole("frame", "frame").real("volume", "").real("mark-error", "deg").real("skate", "m/s");
    MeshSequence made =
        makeSequence(m_entry.name, clip.topology,
                     std::make_shared<MemoryFrames>(clip.positions, clip.topology->vertexCount()), clip.fps);
    made.contacts = performed.contacts;
    const Stances stances = findStances(CharacterFrames(std::span(&made, 1)), up(), progress);
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    for (std::int64_t f = 0; f < clip.frameCount(); ++f) {
        const auto node = static_cast<NodeIndex>(f);
        std::optional<double> slide;
        if (f + 1 < clip.frameCount())
            slide = slideOf(clip.frame(f), clip.frame(f + 1), stances.at(node) & stances.at(node + 1),
                            stances, up(), clip.fps);
        const auto at = static_cast<std::size_t>(f);
        table.add({f, transferred.volume.empty() ? unknown : transferred.volume[at],
                   transferred.markErrors[at] * 180 / std::numbers::pi, slide.value_or(unknown)});
    }
    return std::move(table).table();
}

/// Which triangles were paired.
DataTable pairTable(std::span<const ProposedPair> pairs)
{
    TableBuilder table("pairs", "Triangles that turn alike, and how alike the places of proposed ones are: 1 "
                                "where nothing tells them apart.");
    table.whole("template-triangle").whole("target-triangle").real("quality");
    for (const ProposedPair& proposed : pairs)
        table.add({static_cast<std::int64_t>(proposed.pair.onTemplate.value),
                   static_cast<std::int64_t>(proposed.pair.onTarget.value), proposed.quality});
    return std::move(table).table();
}

Result TransferWork::compute(const StepContext& context, const Progress& progress) const
{
    const MeshSequence performed = openClip(progress.part(0, 0.1));
    const auto opened = m_opener->open(m_entry.target.sequence, Progress(progress.token()));
    const PosedMesh target = poseOf(inMetres(opened->sequence), m_entry.target.frame);
    const std::vector<MeshSequence> takes = takesOfTemplate(performed, progress);
    const std::vector<ProposedPair> chosen = pairs(takes, target, context, progress.part(0.1, 0.2));
    std::vector<TrianglePair> marks;
    marks.reserve(chosen.size());
    for (const ProposedPair& proposed : chosen)
        marks.push_back(proposed.pair);
    const PosedMesh reference = referencePose(takes, target, marks, context, progress.part(0.2, 0.3));
    Transferred transferred = transferClip(
        performed, reference, target, marks,
        {.field = m_entry.field, .up = up(), .correctsPose = m_entry.correctsPose, .scale = m_entry.scale},
        progress.part(0.3, 0.7));

    const FrameLayout layout = CharacterFrames(std::span(&opened->sequence, 1)).layout();
    const FrameProvenance origin{
        .source = layout.firstOf(0) + static_cast<NodeIndex>(m_entry.target.frame.value),
        .destination = layout.firstOf(0) + static_cast<NodeIndex>(m_entry.target.frame.value)};
    Clip clip{.topology = target.topology,
              .fps = performed.fps,
              .positions = std::move(transferred.positions),
              .origins = std::vector(transferred.markErrors.size(), origin)};
    clip = corrected(std::move(clip), performed, context, progress.part(0.7, 0.95));
    DataTable frames = report(transferred, clip, performed, progress.part(0.95, 1));
    const auto unitsPerMetre = static_cast<float>(1 / metresPerUnit());
    for (Vec3f& p : clip.positions)
        p *= unitsPerMetre;
    Result result = clipResult(clip, layout, {m_entry.target.sequence}, unitText(metresPerUnit()));
    result.tables.push_back(std::move(frames));
    result.tables.push_back(pairTable(chosen));
    return result;
}

} // namespace

std::vector<BuildStep> makeTransferSteps(const StepMaking& making)
{
    std::vector<BuildStep> steps;
    for (const TransferEntry& entry : making.opener->project().transfers) {
        const auto work = std::make_shared<const TransferWork>(making.opener, entry);
        BuildStep step;
        step.name = clipStepOf(work->clipName());
        step.dataPrefix = work->clipName();
        step.version = 2;
        step.character = work->character();
        step.settings = work->settings();
        step.files = [work](const Progress& progress) { return work->files(progress); };
        step.inputs = work->inputs();
        step.compute = [work](const StepContext& context, const Progress& progress) {
            return work->compute(context, progress);
        };
        steps.push_back(std::move(step));
    }
    return steps;
}

} // namespace quadrille
