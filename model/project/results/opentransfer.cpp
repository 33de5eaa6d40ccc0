// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/results/opentransfer.h"

#include "model/core/bounds.h"
#include "model/core/message.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/steps/transferbodies.h"
#include "model/transfer/livetransfer.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

const TransferEntry& entryOf(const Project& project, const std::string& name)
{
    const TransferEntry* entry = findTransfer(project, name);
    if (entry == nullptr)
        throwInvalid("There is no transfer “" + name + "”", QUADRILLE_MESSAGE("Correct the name."));
    return *entry;
}

/// One pose as a sequence, in the middle of the ground.
MeshSequence still(const MeshSequence& like, std::vector<Vec3f> metres, UpAxis up, double unitsPerMetre)
{
    const Bounds bounds = boundsOf(metres);
    const auto upward = static_cast<Eigen::Index>(up);
    Vec3d middle = bounds.center();
    middle[upward] = bounds.min[upward];
    for (Vec3f& p : metres)
        p = (p - middle.cast<float>()) * static_cast<float>(unitsPerMetre);
    MeshSequence sequence = makeSequence(
        like.name, like.topology,
        std::make_shared<MemoryFrames>(std::move(metres), like.topology->vertexCount()), like.fps);
    sequence.textures = like.textures;
    return sequence;
}

/// Null where no limbs are found.
std::shared_ptr<const BodyPlaces> placesOf(const PosedMesh& mesh, UpAxis up, const Progress& progress)
{
    try {
        return std::make_shared<const BodyPlaces>(mesh, up, ErrorCode::TransferNoLimbsOfTemplate, progress);
    } catch (const Error& error) {
        if (error.code() == ErrorCode::Cancelled)
            throw;
        return nullptr;
    }
}

/// By content: an edited project opens its sequences anew.
bool isOneMesh(const PosedMesh& a, const PosedMesh& b)
{
    return a.topology == b.topology || (a.positions.size() == b.positions.size() &&
                                        std::ranges::equal(a.topology->triangles(), b.topology->triangles()));
}

bool haveOneTarget(const TransferPreview& a, const TransferPreview& b)
{
    return a.up == b.up && a.targetPose.positions == b.targetPose.positions &&
           isOneMesh(a.targetPose, b.targetPose);
}

/// Whether limbs were found on the same template, or would not be found again.
bool haveOneTemplate(const TransferPreview& a, const TransferPreview& b)
{
    return a.up == b.up && isOneMesh(a.templatePose, b.templatePose) &&
           (a.templatePlaces || a.templatePose.positions == b.templatePose.positions);
}

std::vector<TrianglePair> pairsOf(const std::vector<ProposedPair>& proposed)
{
    std::vector<TrianglePair> pairs;
    pairs.reserve(proposed.size());
    for (const ProposedPair& each : proposed)
        pairs.push_back(each.pair);
    return pairs;
}

/// How alike the places of pairs by hand are, where that is known.
void rate(TransferPreview& preview)
{
    if (!preview.alignment)
        return;
    for (ProposedPair& each : preview.pairs) {
        if (std::isnan(each.quality))
            each.quality = preview.alignment->likeness(each.pair);
    }
}

std::shared_ptr<const BodyAlignment> alignmentOf(const TransferPreview& preview,
                                                 const TransferPreview* before, const Progress& progress)
{
    if (!preview.templatePlaces || !preview.targetPlaces)
        return nullptr;
    if (before != nullptr && before->alignment && before->templatePlaces == preview.templatePlaces &&
        before->targetPlaces == preview.targetPlaces &&
        before->templatePose.positions == preview.templatePose.positions)
        return before->alignment;
    return std::make_shared<const BodyAlignment>(preview.templatePose, *preview.templatePlaces,
                                                 preview.targetPose, *preview.targetPlaces, preview.up,
                                                 progress);
}

} // namespace

TransferPreviewPointer previewTransfer(const ProjectResults& results, const std::string& name,
                                       TransferPreviewPointer earlier, const Progress& progress,
                                       const std::function<void(TransferPreviewPointer)>& show)
{
    // `show` may put another one where it came from.
    const TransferPreviewPointer before = std::move(earlier);
    SequenceOpener& opener = *results.opener();
    const double unitsPerMetre = 1 / opener.project().settings.axes.metresPerUnit;
    const UpAxis up = opener.project().settings.axes.up;
    auto made = std::make_shared<TransferPreview>();
    TransferPreview& preview = *made;
    preview.entry = entryOf(results.project(), name);
    const TransferBodies bodies(opener, preview.entry, progress.part(0, 0.2));
    const PosedMesh& target = bodies.target();
    preview.target = bodies.targetSequence();
    preview.performed = opener.openClip(preview.entry.clip, Progress(progress.token()))->sequence;
    PosedMesh reference = bodies.anyPose();
    preview.targetPose = target;
    preview.up = up;
    const bool hasTarget = before != nullptr && before->solid && haveOneTarget(*before, preview);
    preview.rest = still(preview.target->sequence, target.positions, up, unitsPerMetre);
    if (show && !hasTarget) {
        preview.reference = still(preview.performed, reference.positions, up, unitsPerMetre);
        show(std::make_shared<const TransferPreview>(preview));
    }
    preview.targetPlaces = hasTarget ? before->targetPlaces : placesOf(target, up, progress.part(0.2, 0.3));
    try {
        const auto ignore = [](const std::string& /*text*/) {};
        preview.solid = hasTarget
                            ? before->solid
                            : std::make_shared<const TransferTarget>(*target.topology, target.positions);
        preview.pairs = bodies.pairs(ignore, progress.part(0.3, 0.5));
        const std::vector<TrianglePair> pairs = pairsOf(preview.pairs);
        reference = bodies.referencePose(pairs, ignore, progress.part(0.5, 0.6));
        PreparedTransfer prepared(bodies.performed(), reference, target, preview.solid, pairs,
                                  bodies.settings(), progress.part(0.6, 1));
        preview.rest =
            still(preview.target->sequence, turned(target.positions, prepared.turn(), up), up, unitsPerMetre);
        preview.sizeRatio = prepared.sizeRatio();
        preview.posed = makeSequence(
            name, target.topology,
            std::make_shared<LiveTransfer>(std::move(prepared), bodies.settings(), unitsPerMetre),
            preview.performed.fps);
        preview.posed->textures = preview.target->sequence.textures;
    } catch (const Error& error) {
        if (error.code() == ErrorCode::Cancelled)
            throw;
        preview.failure = error;
    }
    // In the pose that is most like the target's places are told best.
    preview.templatePose = reference;
    preview.templatePlaces = before != nullptr && haveOneTemplate(*before, preview)
                                 ? before->templatePlaces
                                 : placesOf(reference, up, Progress(progress.token()));
    preview.alignment = alignmentOf(preview, before.get(), Progress(progress.token()));
    rate(preview);
    preview.reference = still(preview.performed, std::move(reference.positions), up, unitsPerMetre);
    progress.report(1);
    return made;
}

TransferResultPointer openTransfer(const ProjectResults& results, const std::string& name,
                                   const Progress& progress)
{
    auto made = std::make_shared<TransferResult>();
    made->entry = entryOf(results.project(), name);
    const std::string clip = "transfers/" + name;
    const std::string step = clipStepOf(clip);
    const FreshResults fresh = results.get({step}, progress.part(0, 0.95));
    for (const DataTable& table : fresh.resultOf(step)->tables) {
        if (table.name == "report")
            made->report = table;
    }
    made->sequence = results.opener()->openClip(clip, progress.part(0.95, 1))->sequence;
    return made;
}

} // namespace quadrille
