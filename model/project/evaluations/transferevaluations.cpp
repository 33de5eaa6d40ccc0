// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/bounds.h"
#include "model/core/contains.h"
#include "model/core/message.h"
#include "model/evaluation/transfererrors.h"
#include "model/geometry/surfacevolume.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/evaluations/evaluationsteps.h"
#include "model/project/fields/writefields.h"
#include "model/project/media/sequencesettings.h"
#include "model/project/steps/performtransfer.h"
#include "model/project/steps/transferwork.h"
#include "model/project/store/tablebuilder.h"
#include "model/sequence/meshsequence.h"
#include "model/transfer/transferclip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace quadrille {

namespace {

constexpr double notKnown = std::numeric_limits<double>::quiet_NaN();

/// One way to make a transfer.
struct TransferKind
{
    FieldKind field;
    bool correctsPose;
    bool carriesStretch;
    bool marksSurroundings;

    std::string fieldWord() const { return field == FieldKind::Quaternions ? "quaternions" : "logarithms"; }
    std::string poseWord() const { return correctsPose ? "pose corrected" : "pose as it is"; }
    std::string stretchWord() const { return carriesStretch ? "stretched" : "turned only"; }
    std::string marksWord() const { return marksSurroundings ? "surroundings" : "triangles"; }
};

/// All that there are.
constexpr auto transferKinds = [] {
    std::array<TransferKind, 16> kinds{};
    for (std::size_t k = 0; k < kinds.size(); ++k)
        kinds[k] = {.field = (k & 8U) == 0 ? FieldKind::Quaternions : FieldKind::Logarithms,
                    .correctsPose = (k & 4U) == 0,
                    .carriesStretch = (k & 2U) == 0,
                    .marksSurroundings = (k & 1U) == 0};
    return kinds;
}();

/// What a transfer ought to be, metres.
struct TransferTruth
{
    MeshSequence sequence;      ///< stands when the clip does
    double height = 0;          ///< of the target in its own pose
    std::vector<double> volume; ///< of each frame, shares of the target's at rest; empty where it has none
    std::vector<double> slides; ///< as footSlides
};

/// \throws Error ProjectInvalid where it is of another mesh, or not as long.
void checkTruth(const TransferEntry& entry, const MeshSequence& truth, const TransferBodies& bodies)
{
    const Topology& mesh = *bodies.target().topology;
    if (truth.topology->vertexCount() != mesh.vertexCount() ||
        truth.topology->triangles().size() != mesh.triangles().size())
        throwInvalid("“" + entry.truth + "” is not of the mesh of “" + entry.target.sequence + "”",
                     QUADRILLE_MESSAGE("Name a clip of the target's own mesh as “truth”."));
    const std::int64_t frames = bodies.performed().frameCount();
    if (truth.frameCount() != frames)
        throwInvalid("“" + entry.truth + "” has " + std::to_string(truth.frameCount()) + " frames, “" +
                         entry.clip + "” has " + std::to_string(frames),
                     QUADRILLE_MESSAGE("Name a clip that shows the same frame by frame as “truth”."));
}

TransferTruth truthOf(const TransferWork& work, const TransferBodies& bodies, const Progress& progress)
{
    const auto opened = work.opener().openClip(work.entry().truth, Progress(progress.token()));
    checkTruth(work.entry(), opened->sequence, bodies);
    const auto metres = static_cast<float>(work.opener().project().settings.axes.metresPerUnit);
    const PosedMesh& target = bodies.target();
    TransferTruth truth{.sequence = transformed(opened->sequence, metres * Eigen::Matrix3f::Identity()),
                        .height = boundsOf(target.positions).size()[static_cast<Eigen::Index>(bodies.up())],
                        .volume = {},
                        .slides = {}};
    truth.sequence.contacts = bodies.performed().contacts;
    const SurfaceVolume volume(*target.topology);
    const double atRest = volume.of(target.positions).value_or(0);
    for (FrameIndex f(0); atRest != 0 && f.value < truth.sequence.frameCount(); ++f)
        truth.volume.push_back(*volume.of(truth.sequence.frame(f).positions()) / atRest);
    truth.slides = footSlides(truth.sequence, bodies.up(), progress);
    return truth;
}

/// The mean of those that are known.
double meanOf(const std::vector<double>& values)
{
    double sum = 0;
    double count = 0;
    for (const double value : values) {
        if (std::isnan(value))
            continue;
        sum += value;
        ++count;
    }
    return count > 0 ? sum / count : notKnown;
}

/// Both tables of transfer-error.
class TransferTables
{
public:
    TransferTables()
    {
        m_means.text("transfer").text("field").text("pose").text("stretch").text("marks").whole("frames");
        m_means.real("mean-share").real("worst-share").real("placed-mean-share").real("placed-worst-share");
        m_frames.text("transfer")
            .text("field")
            .text("pose")
            .text("stretch")
            .text("marks")
            .whole("frame", "frame");
        for (TableBuilder* table : {&m_means, &m_frames}) {
            table->real("mean-error", "m").real("worst-error", "m");
            table->real("placed-mean-error", "m").real("placed-worst-error", "m");
            table->real("volume").real("volume-of-truth").real("mark-error", "deg");
            table->real("skate", "m/s").real("skate-of-truth", "m/s");
        }
    }

    void add(const std::string& transfer, const TransferKind& kind, const PerformedTransfer& made,
             const std::vector<double>& slides, const TransferTruth& truth)
    {
        const std::int64_t frames = truth.sequence.frameCount();
        TransferErrors all;
        for (std::int64_t f = 0; f < frames; ++f) {
            const Frame expected = truth.sequence.frame(FrameIndex(f));
            const auto [moved, placed] = transferErrors(made.clip.frame(f), expected.positions());
            for (const auto& [sum, each] : {std::pair(&all.moved, moved), {&all.placed, placed}}) {
                sum->mean += each.mean / static_cast<double>(frames);
                sum->worst = std::max(sum->worst, each.worst);
            }
            const auto at = static_cast<std::size_t>(f);
            m_frames.add({transfer, kind.fieldWord(), kind.poseWord(), kind.stretchWord(), kind.marksWord(),
                          f, moved.mean, moved.worst, placed.mean, placed.worst,
                          made.volume.empty() ? notKnown : made.volume[at],
                          truth.volume.empty() ? notKnown : truth.volume[at], degrees(made.markErrors[at]),
                          slides[at], truth.slides[at]});
        }
        const auto share = [&truth](double error) {
            return truth.height > 0 ? error / truth.height : notKnown;
        };
        m_means.add({transfer, kind.fieldWord(), kind.poseWord(), kind.stretchWord(), kind.marksWord(),
                     frames, share(all.moved.mean), share(all.moved.worst), share(all.placed.mean),
                     share(all.placed.worst), all.moved.mean, all.moved.worst, all.placed.mean,
                     all.placed.worst, meanOf(made.volume), meanOf(truth.volume),
                     degrees(meanOf(made.markErrors)), meanOf(slides), meanOf(truth.slides)});
    }

    Result result() &&
    {
        Result result;
        result.tables = {std::move(m_means).table(), std::move(m_frames).table()};
        return result;
    }

private:
    static double degrees(double radians) { return radians * 180 / std::numbers::pi; }

    TableBuilder m_means{"transfer-error",
                         "Transfers against what they ought to be, with both fields, with and without "
                         "correction of the pose, stretch and what is about marks: how far vertices are from "
                         "the truth with the body as a "
                         "whole moved onto it, mean and worst over all frames, in shares of the target's "
                         "height and in metres, and the same as they are placed; the mean volume against "
                         "the target's at rest, the mean angle that marked triangles miss, how fast feet "
                         "slide that stand."};
    TableBuilder m_frames{"transfer-error-frames", "The same, frame by frame."};
};

void measureTransfer(const TransferWork& work, TransferTables& tables, const Progress& progress)
{
    const auto ignore = [](const std::string& /*text*/) {};
    const TransferBodies bodies(work.opener(), work.entry(), progress.part(0, 0.1));
    const TransferTruth truth = truthOf(work, bodies, progress.part(0.1, 0.15));
    const TransferMarks marks = transferMarks(bodies, ignore, progress.part(0.15, 0.2));
    for (std::size_t i = 0; i < transferKinds.size(); ++i) {
        const TransferKind& kind = transferKinds[i];
        constexpr double share = 0.8 / transferKinds.size();
        const double begin = 0.2 + share * static_cast<double>(i);
        const Progress own = progress.part(begin, begin + share);
        TransferSettings settings = bodies.settings();
        settings.field = kind.field;
        settings.correctsPose = kind.correctsPose;
        settings.carriesStretch = kind.carriesStretch;
        settings.marksSurroundings = kind.marksSurroundings;
        const PerformedTransfer made = performTransfer(bodies, marks, settings, ignore, own.part(0, 0.9));
        const MeshSequence performance = standingAs(bodies.performed(), made.clip);
        tables.add(work.entry().name, kind, made, footSlides(performance, bodies.up(), own.part(0.9, 1)),
                   truth);
    }
}

/// What the sequence that is a truth is made of.
std::string truthSettings(const Project& project, const TransferEntry& entry)
{
    const auto name = nameOfClip(entry.truth, "sequences");
    const SequenceEntry* sequence = name ? findSequence(project, *name) : nullptr;
    return sequence ? sequenceSettings(project, *sequence) : "";
}

} // namespace

BuildStep transferErrorStep(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    const Project& project = work.opener->project();
    std::vector<TransferWork> transfers;
    BuildStep step = evaluationStep(work, evaluation);
    step.version = TransferWork::version;
    for (const TransferEntry* entry : transfersWithTruth(project, work.character)) {
        const TransferWork& own = transfers.emplace_back(work.opener, *entry);
        step.settings += settingsText(*entry) + own.settings() + truthSettings(project, *entry);
        for (const std::vector<std::string>& needed : {own.inputs(), clipStepsOf(project, entry->truth)}) {
            for (const std::string& input : needed) {
                if (!contains(step.inputs, input))
                    step.inputs.push_back(input);
            }
        }
    }
    step.files = [transfers](const Progress& progress) {
        std::vector<std::filesystem::path> all;
        for (const TransferWork& transfer : transfers) {
            const auto add = [&all](const std::vector<std::filesystem::path>& files) {
                all.insert(all.end(), files.begin(), files.end());
            };
            add(transfer.files(progress));
            if (const auto name = nameOfClip(transfer.entry().truth, "sequences"))
                add(transfer.opener().filesOf(*name, progress));
        }
        return all;
    };
    step.compute = [transfers](const StepContext& /*context*/, const Progress& progress) {
        TransferTables tables;
        for (std::size_t i = 0; i < transfers.size(); ++i) {
            const auto count = static_cast<double>(transfers.size());
            measureTransfer(
                transfers[i], tables,
                progress.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count));
        }
        return std::move(tables).result();
    };
    return step;
}

} // namespace quadrille
