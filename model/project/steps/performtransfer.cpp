// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/performtransfer.h"

#include "model/core/error.h"
#include "model/sequence/contacts.h"
#include "model/sequence/feet.h"
#include "model/synthesis/clips/stances.h"
#include "model/synthesis/finishing/contactcorrection.h"
#include "model/transfer/transferclip.h"

#include <limits>

namespace quadrille {

namespace {

/// In its own pose a target is more likely to stand on both than where a clip shows it tallest: in the middle
/// of a kick, say.
Legs legsAtRest(const TransferBodies& bodies)
{
    const PosedMesh& target = bodies.target();
    return findLegs(*target.topology, upright(target.positions, target.positions.size(), bodies.up()),
                    ContactOptions().footShare);
}

Clip withStandingFeet(Clip clip, const TransferBodies& bodies, const TransferBodies::Tell& tell,
                      const Progress& progress)
{
    const std::vector<ContactSpan>& contacts = bodies.performed().contacts;
    if (!bodies.entry().correctsContacts || contacts.empty())
        return clip;
    try {
        const Legs legs = legsAtRest(bodies);
        return contactsCorrected(clip, contacts, {}, {.up = bodies.up(), .legs = &legs}, progress);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::NoFeet)
            throw;
        tell("The target has no feet that could be kept standing.");
        return clip;
    }
}

} // namespace

TransferMarks transferMarks(const TransferBodies& bodies, const TransferBodies::Tell& tell,
                            const Progress& progress)
{
    TransferMarks marks{.chosen = bodies.pairs(tell, progress.part(0, 0.5)), .pairs = {}, .reference = {}};
    for (const ProposedPair& proposed : marks.chosen)
        marks.pairs.push_back(proposed.pair);
    marks.reference = bodies.referencePose(marks.pairs, tell, progress.part(0.5, 1));
    return marks;
}

PerformedTransfer performTransfer(const TransferBodies& bodies, const TransferMarks& marks,
                                  const TransferSettings& settings, const TransferBodies::Tell& tell,
                                  const Progress& progress)
{
    const MeshSequence& performed = bodies.performed();
    Transferred transferred = transferClip(performed, marks.reference, bodies.target(), marks.pairs, settings,
                                           progress.part(0, 0.6));
    const auto shown = static_cast<NodeIndex>(bodies.entry().target.frame.value);
    Clip clip{.topology = bodies.target().topology,
              .fps = performed.fps,
              .positions = std::move(transferred.positions),
              .origins = std::vector(transferred.markErrors.size(),
                                     FrameProvenance{.source = shown, .destination = shown})};
    return {.clip = withStandingFeet(std::move(clip), bodies, tell, progress.part(0.6, 1)),
            .volume = std::move(transferred.volume),
            .markErrors = std::move(transferred.markErrors)};
}

std::vector<double> footSlides(const MeshSequence& performance, UpAxis up, const Progress& progress)
{
    const Stances stances = findStances(CharacterFrames(std::span(&performance, 1)), up, progress);
    std::vector<double> slides;
    for (FrameIndex f(0); f.value < performance.frameCount(); ++f) {
        const auto node = static_cast<NodeIndex>(f.value);
        std::optional<double> slide;
        if (f.value + 1 < performance.frameCount())
            slide = slideOf(performance.frame(f).positions(),
                            performance.frame(FrameIndex(f.value + 1)).positions(),
                            stances.at(node) & stances.at(node + 1), stances, up, performance.fps);
        slides.push_back(slide.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    return slides;
}

MeshSequence standingAs(const MeshSequence& performed, const Clip& clip)
{
    MeshSequence sequence =
        makeSequence(performed.name, clip.topology,
                     std::make_shared<MemoryFrames>(clip.positions, clip.topology->vertexCount()), clip.fps);
    sequence.contacts = performed.contacts;
    return sequence;
}

} // namespace quadrille
