// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/performtransfer.h"

#include "model/core/bounds.h"
#include "model/core/error.h"
#include "model/sequence/contacts.h"
#include "model/sequence/feet.h"
#include "model/synthesis/clips/stances.h"
#include "model/synthesis/finishing/contactcorrection.h"
#include "model/transfer/transferclip.h"

#include <algorithm>
#include <array>
#include <functional>
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

/// Which of two feet is the left one is told by toes, and they may mislead where a leg is high up: whether
/// the feet that stand by their names move more than they would by each other's.
/// \param frames  their number. \param placeOf  of a foot in a frame.
bool areExchanged(std::array<const std::string*, 2> names, std::span<const ContactSpan> contacts,
                  std::int64_t frames,
                  const std::function<Vec3d(std::size_t foot, std::int64_t frame)>& placeOf)
{
    double asNamed = 0;
    double exchanged = 0;
    for (const ContactSpan& contact : contacts) {
        for (std::size_t foot = 0; foot < 2; ++foot) {
            if (contact.foot != *names[foot])
                continue;
            const std::int64_t last = std::min(contact.frames.last.value, frames - 1);
            for (std::int64_t f = std::max<std::int64_t>(contact.frames.first.value, 0); f < last; ++f) {
                asNamed += (placeOf(foot, f + 1) - placeOf(foot, f)).norm();
                exchanged += (placeOf(1 - foot, f + 1) - placeOf(1 - foot, f)).norm();
            }
        }
    }
    return exchanged < asNamed;
}

/// Legs of a performance, its feet named as those that stand in its contacts.
Legs legsOf(const Clip& clip, const TransferBodies& bodies, std::span<const ContactSpan> contacts)
{
    Legs legs = findLegs(*clip.topology, upright(clip.positions, clip.topology->vertexCount(), bodies.up()),
                         ContactOptions().footShare);
    if (legs.feet.empty())
        legs = legsAtRest(bodies);
    if (legs.feet.size() == 2 &&
        areExchanged({&legs.feet[0].name, &legs.feet[1].name}, contacts, clip.frameCount(),
                     [&](std::size_t foot, std::int64_t f) -> Vec3d {
                         return meanOf(clip.frame(f), legs.feet[foot].vertices).cast<double>();
                     }))
        std::swap(legs.feet[0].name, legs.feet[1].name);
    return legs;
}

Clip withStandingFeet(Clip clip, const TransferBodies& bodies, const TransferBodies::Tell& tell,
                      const Progress& progress)
{
    const std::vector<ContactSpan>& contacts = bodies.performed().contacts;
    if (!bodies.entry().correctsContacts || contacts.empty())
        return clip;
    try {
        const Legs legs = legsOf(clip, bodies, contacts);
        return contactsCorrected(clip, contacts, {},
                                 {.up = bodies.up(), .frames = {}, .legs = &legs, .trustsLegs = true},
                                 progress);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::NoFeet)
            throw;
        tell("The target has no feet that could be kept standing.");
        return clip;
    }
}

/// Whether the pairs are all on one part of the template: an arm, say.
bool lieOnOnePart(std::span<const TrianglePair> pairs, const PosedMesh& reference)
{
    constexpr double part = 0.5; // of the extent of the whole; a leg has less, an arm and its shoulder too
    std::vector<Vec3f> middles;
    middles.reserve(pairs.size());
    for (const TrianglePair& pair : pairs)
        middles.push_back(
            middleOf(reference.topology->triangles()[pair.onTemplate.value], reference.positions)
                .cast<float>());
    return boundsOf(middles).size().norm() < part * boundsOf(reference.positions).size().norm();
}

} // namespace

TransferMarks transferMarks(const TransferBodies& bodies, const TransferBodies::Tell& tell,
                            const Progress& progress)
{
    TransferMarks marks{.chosen = bodies.pairs(tell, progress.part(0, 0.5)), .pairs = {}, .reference = {}};
    for (const ProposedPair& proposed : marks.chosen)
        marks.pairs.push_back(proposed.pair);
    marks.reference = bodies.referencePose(marks.pairs, tell, progress.part(0.5, 1));
    if (lieOnOnePart(marks.pairs, marks.reference))
        tell("All pairs lie on one part of the template: the rest of the target only turns with them. Add "
             "pairs on each part that turns.");
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

std::vector<LimbErrors> limbErrors(const TransferBodies& bodies, const PosedMesh& reference,
                                   const Clip& performance, const Progress& progress)
{
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    std::vector<LimbErrors> errors(static_cast<std::size_t>(performance.frameCount()), {unknown, unknown});
    try {
        const auto directionsOf = [&](const PosedMesh& mesh, ErrorCode withoutLimbs, const Progress& own) {
            return LimbDirections(BodyPlaces(mesh, bodies.up(), withoutLimbs, own), *mesh.topology);
        };
        const LimbDirections wanted =
            directionsOf(reference, ErrorCode::TransferNoLimbsOfTemplate, progress.part(0, 0.4));
        const LimbDirections made =
            directionsOf(bodies.target(), ErrorCode::TransferNoLimbsOfTarget, progress.part(0.4, 0.8));
        for (std::size_t f = 0; f < errors.size(); ++f) {
            const FrameIndex frame(static_cast<std::int64_t>(f));
            errors[f] = limbErrors(made.of(performance.frame(frame.value)),
                                   wanted.of(bodies.performed().frame(frame).positions()));
        }
    } catch (const Error& error) {
        if (error.code() != ErrorCode::TransferNoLimbsOfTemplate &&
            error.code() != ErrorCode::TransferNoLimbsOfTarget)
            throw;
    }
    return errors;
}

std::vector<double> footSlides(const MeshSequence& performance, UpAxis up, const Progress& progress)
{
    Stances stances = findStances(CharacterFrames(std::span(&performance, 1)), up, progress);
    if (stances.feet.size() == 2 &&
        areExchanged({&stances.feet[0].name, &stances.feet[1].name}, performance.contacts,
                     performance.frameCount(), [&](std::size_t foot, std::int64_t f) {
                         return stances.placeOf(static_cast<NodeIndex>(f), foot);
                     }))
        std::swap(stances.feet[0].vertices, stances.feet[1].vertices);
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
