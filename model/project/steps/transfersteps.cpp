// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/project/document/findentry.h"
#include "model/project/document/lengthunit.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/fields/writefields.h"
#include "model/project/media/sequencesettings.h"
#include "model/project/steps/buildstep.h"
#include "model/project/steps/transferbodies.h"
#include "model/project/store/clipresult.h"
#include "model/project/store/tablebuilder.h"
#include "model/sequence/contacts.h"
#include "model/synthesis/clips/stances.h"
#include "model/synthesis/finishing/contactcorrection.h"
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

    Clip corrected(Clip clip, const MeshSequence& performed, const StepContext& context,
                   const Progress& progress) const;
    DataTable report(const Transferred& transferred, const Clip& clip, const MeshSequence& performed,
                     const Progress& progress) const;

    std::shared_ptr<SequenceOpener> m_opener;
    TransferEntry m_entry;
};

TransferBodies::Tell telling(const StepContext& context)
{
    return [tell = context.tell](std::string text) {
        tell({.severity = Issue::Severity::Info, .context = {.values = {{"text", std::move(text)}}}});
    };
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
        telling(context)("The target has no feet that could be kept standing.");
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
    const TransferBodies bodies(*m_opener, m_entry, progress.part(0, 0.1));
    const MeshSequence& performed = bodies.performed();
    const std::vector<ProposedPair> chosen = bodies.pairs(telling(context), progress.part(0.1, 0.2));
    std::vector<TrianglePair> marks;
    marks.reserve(chosen.size());
    for (const ProposedPair& proposed : chosen)
        marks.push_back(proposed.pair);
    const PosedMesh reference = bodies.referencePose(marks, telling(context), progress.part(0.2, 0.3));
    Transferred transferred = transferClip(performed, reference, bodies.target(), marks, bodies.settings(),
                                           progress.part(0.3, 0.7));

    const FrameLayout layout = CharacterFrames(std::span(&bodies.targetSequence()->sequence, 1)).layout();
    const FrameProvenance origin{
        .source = layout.firstOf(0) + static_cast<NodeIndex>(m_entry.target.frame.value),
        .destination = layout.firstOf(0) + static_cast<NodeIndex>(m_entry.target.frame.value)};
    Clip clip{.topology = bodies.target().topology,
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
        step.version = 3;
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
