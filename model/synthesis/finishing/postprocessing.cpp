// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/finishing/postprocessing.h"

#include "model/core/error.h"
#include "model/core/message.h"
#include "model/sequence/contacts.h"
#include "model/synthesis/clips/characterlegs.h"
#include "model/synthesis/finishing/contactcorrection.h"
#include "model/synthesis/finishing/mirror.h"
#include "model/synthesis/finishing/retime.h"

#include <algorithm>

namespace quadrille {

namespace {

std::vector<ContactSpan> contactsOf(const Clip& clip, const PostProcessingInputs& inputs,
                                    const Progress& progress)
{
    progress.report(0.0);
    if (inputs.contactsOf)
        return inputs.contactsOf(clip);
    ContactOptions options;
    options.up = inputs.method.up;
    const std::uint32_t vertices = clip.topology->vertexCount();
    return detectContacts(
        makeSequence({}, clip.topology, std::make_shared<MemoryFrames>(clip.positions, vertices), clip.fps),
        options, progress);
}

/// The correction, with the character's legs where the clip shows none.
Clip corrected(Clip clip, const std::vector<ContactSpan>& contacts, const ContactCorrectionSettings& settings,
               const PostProcessingInputs& inputs, std::optional<FrameRange> frames, const Progress& progress)
{
    const Legs legs =
        inputs.character ? legsOf(*inputs.character, inputs.method.up, progress.part(0, 0.2)) : Legs();
    return contactsCorrected(std::move(clip), contacts, settings,
                             {.up = inputs.method.up,
                              .frames = frames,
                              .legs = &legs,
                              .trustsLegs = static_cast<bool>(inputs.contactsOf)},
                             progress.part(0.2, 1));
}

/// The last playing before, all of them as they are, and the first one behind.
Clip withNeighbours(const LoopPlayings& playings, UpAxis up)
{
    const Loop& loop = playings.loop;
    const std::int64_t each = playings.framesOfEach();
    const std::int64_t all = loop.cycle.frameCount();
    const auto vertices = static_cast<std::ptrdiff_t>(loop.cycle.topology->vertexCount());
    Clip clip = loop.cycle;
    clip.positions.clear();
    clip.origins.clear();
    const auto add = [&](std::int64_t first, std::int64_t end, const GroundMotion& motion) {
        const std::size_t place = clip.positions.size();
        clip.origins.insert(clip.origins.end(), loop.cycle.origins.begin() + first,
                            loop.cycle.origins.begin() + end);
        clip.positions.insert(clip.positions.end(), loop.cycle.positions.begin() + first * vertices,
                              loop.cycle.positions.begin() + end * vertices);
        moveFrame(MutablePositions(clip.positions).subspan(place), motion, Ground(up));
    };
    add(all - each, all, loop.travel.inverse());
    add(0, all, {});
    add(0, each, loop.travel);
    return clip;
}

Symmetry symmetryOf(const Clip& clip, const PostProcessingInputs& inputs, const Progress& progress)
{
    return inputs.symmetry ? inputs.symmetry(progress)
                           : findSymmetry(*clip.topology, clip.frame(0), {}, progress);
}

/// The shares of the work of the steps that are asked for.
class Steps
{
public:
    Steps(const Progress& progress, int count) : m_progress(progress), m_count(std::max(count, 1)) {}
    Progress next()
    {
        const double from = m_done;
        m_done += 1.0 / m_count;
        return m_progress.part(from, std::min(m_done, 1.0));
    }

private:
    const Progress& m_progress;
    int m_count;
    double m_done = 0;
};

bool goesRound(const RetimeSettings& settings, const Clip& cycle)
{
    const std::vector<double> moments = retimedMoments(settings, cycle.frameCount(), cycle.fps);
    return moments.front() == 0 && moments.back() == static_cast<double>(cycle.frameCount());
}

PostProcessed processedLoop(const Clip& clip, const PostProcessing& settings,
                            const PostProcessingInputs& inputs, Steps& steps)
{
    const UpAxis up = inputs.method.up;
    LoopSettings travelling = *settings.loop;
    travelling.inPlace = false;
    Loop once = seamlessLoop(clip, travelling, inputs.method, inputs.asked, steps.next());
    const std::optional<Transition> closure = once.closure;
    const bool varies = inputs.playing && settings.repeats > 1;
    LoopPlayings playings;
    if (varies) {
        playings =
            playedAs(once, settings.repeats, inputs.playing, inputs.method, inputs.easeSeconds, steps.next());
    } else {
        playings.travels = {once.travel};
        playings.loop = std::move(once);
    }
    if (settings.contacts)
        playings = contactsCorrected(std::move(playings), *settings.contacts, inputs, steps.next());
    if (settings.mirror) {
        const Progress progress = steps.next();
        const Symmetry symmetry = symmetryOf(playings.loop.cycle, inputs, progress.part(0, 0.6));
        const MirrorLine line = mirrorLine(playings.loop.cycle, symmetry, up);
        playings.loop = mirrored(playings.loop, symmetry, line, up, progress.part(0.6, 1));
        for (GroundMotion& travel : playings.travels)
            travel = mirrored(travel, line);
    }
    if (settings.loop->inPlace)
        playings = inPlace(std::move(playings), up);
    Loop& loop = playings.loop;
    if (!varies) {
        loop.cycle = repeated(loop, settings.repeats, up);
        loop.travel = repeatedTravel(loop.travel, settings.repeats);
    }
    const std::int64_t frames = loop.cycle.frameCount();
    if (settings.retime && !goesRound(*settings.retime, loop.cycle))
        return {.clip = retimed(closedCycle(loop, up), *settings.retime, up, inputs.method.interpolation,
                                steps.next()),
                .travel = {},
                .closure = closure,
                .framesBeforeRetime = frames};
    if (settings.retime)
        loop = retimed(loop, *settings.retime, up, inputs.method.interpolation, steps.next());
    return {.clip = std::move(loop.cycle),
            .travel = loop.travel,
            .closure = closure,
            .framesBeforeRetime = frames};
}

} // namespace

PostProcessed postProcessed(Clip clip, const PostProcessing& settings, const PostProcessingInputs& inputs,
                            const Progress& progress)
{
    progress.report(0.0);
    Steps steps(progress, (settings.loop ? 2 : 0) + (settings.contacts ? 1 : 0) + (settings.mirror ? 1 : 0) +
                              (settings.retime ? 1 : 0));
    if (settings.loop)
        return processedLoop(clip, settings, inputs, steps);
    if (settings.repeats != 1)
        throw Error(ErrorCode::BadArgument,
                    {{},
                     {},
                     {{"reason", QUADRILLE_MESSAGE("Only a loop can be repeated")},
                      {"remedy", QUADRILLE_MESSAGE("Ask for a loop, too, or for one repeat.")}}});
    const UpAxis up = inputs.method.up;
    if (settings.contacts) {
        const Progress step = steps.next();
        const std::vector<ContactSpan> contacts = contactsOf(clip, inputs, step.part(0, 0.3));
        clip = corrected(std::move(clip), contacts, *settings.contacts, inputs, {}, step.part(0.3, 1));
    }
    if (settings.mirror) {
        const Progress step = steps.next();
        const Symmetry symmetry = symmetryOf(clip, inputs, step.part(0, 0.6));
        clip = mirrored(clip, symmetry, mirrorLine(clip, symmetry, up), up, step.part(0.6, 1));
    }
    const std::int64_t frames = std::max<std::int64_t>(clip.frameCount() - 1, 0);
    if (settings.retime)
        clip = retimed(clip, *settings.retime, up, inputs.method.interpolation, steps.next());
    return {.clip = std::move(clip), .travel = {}, .closure = {}, .framesBeforeRetime = frames};
}

Loop contactsCorrected(Loop loop, const ContactCorrectionSettings& settings,
                       const PostProcessingInputs& inputs, const Progress& progress)
{
    LoopPlayings once{.loop = {}, .travels = {loop.travel}};
    once.loop = std::move(loop);
    return contactsCorrected(std::move(once), settings, inputs, progress).loop;
}

LoopPlayings contactsCorrected(LoopPlayings playings, const ContactCorrectionSettings& settings,
                               const PostProcessingInputs& inputs, const Progress& progress)
{
    const UpAxis up = inputs.method.up;
    const std::int64_t before = playings.framesOfEach();
    const std::int64_t period = playings.loop.cycle.frameCount();
    const FrameRange middle{FrameIndex(before), FrameIndex(before + period - 1)};
    Clip cycles = withNeighbours(playings, up);
    std::vector<ContactSpan> contacts = contactsOf(cycles, inputs, progress.part(0, 0.3));
    const auto standsAllTheTime = [&](const ContactSpan& contact) {
        return contact.frames.first <= middle.first && contact.frames.last >= middle.last;
    };
    if (std::ranges::any_of(contacts, standsAllTheTime) && playings.loop.travel != GroundMotion()) {
        playings = inPlace(std::move(playings), up);
        cycles = withNeighbours(playings, up);
        contacts = contactsOf(cycles, inputs, progress.part(0.3, 0.4));
    }
    cycles = corrected(std::move(cycles), contacts, settings, inputs, middle, progress.part(0.4, 1));
    const auto vertices = static_cast<std::ptrdiff_t>(cycles.topology->vertexCount());
    std::copy_n(cycles.positions.begin() + before * vertices, period * vertices,
                playings.loop.cycle.positions.begin());
    return playings;
}

} // namespace quadrille
