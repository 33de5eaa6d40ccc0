// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/pairpreview.h"

#include "editor/jobs/jobrunner.h"
#include "model/synthesis/clips/makeclip.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille {

namespace {

constexpr double secondsAround = 0.6;                       // captured before and after a join
constexpr std::size_t knownBytes = std::size_t{192} << 20U; // of clips that are kept

std::size_t bytesOf(const TransitionClip& clip)
{
    return static_cast<std::size_t>(clip.sequence.frameCount()) * clip.sequence.topology->data().vertexCount *
           sizeof(Vec3f);
}

/// Takes a frame's centre to the origin of the ground.
GroundMotion toOrigin(const RootPoses& roots, NodeIndex node, double turn)
{
    const Vec3d& centre = roots.centres[static_cast<std::size_t>(node)];
    return GroundMotion::taking(Ground(roots.up).of(centre), Vec2d::Zero(), turn);
}

MeshSequence placedFrame(const OpenedCharacter& opened, NodeIndex node, double turn, const QString& name)
{
    const RootPoses& roots = opened.graph.roots();
    const RigidMotion motion = toOrigin(roots, node, turn).inSpace(Ground(roots.up));
    const Frame frame = opened.frames.frame(node);
    Clip clip;
    clip.topology = opened.frames.sequences().front().topology;
    clip.fps = opened.frames.sequences().front().fps;
    clip.origins.push_back({.source = node, .destination = node});
    for (const Vec3f& position : frame.positions())
        clip.positions.push_back(motion(position.cast<double>()).cast<float>());
    return toSequence(name.toStdString(), std::move(clip), opened.frames);
}

} // namespace

QString PairPreview::sourceName()
{
    return tr("From");
}

QString PairPreview::destinationName()
{
    return tr("To");
}

QString PairPreview::clipName()
{
    return tr("Transition");
}

PairPreview::PairPreview(JobRunner& jobs, QObject* parent) : QObject(parent), m_jobs(jobs) {}

PairPreview::~PairPreview() = default;

void PairPreview::setCharacter(std::shared_ptr<const OpenedCharacter> opened)
{
    m_opened = std::move(opened);
    ++m_generation;
    for (QPointer<Job>* job : {&m_framesJob, &m_clipJob}) {
        if (*job)
            (*job)->cancel();
        job->clear();
    }
    m_wantedFrames.reset();
    m_wantedClip.reset();
    m_frames.reset();
    m_clip.reset();
    m_known.clear();
    emit framesChanged();
    emit clipChanged();
}

void PairPreview::setGentle(bool gentle)
{
    if (gentle == m_isGentle)
        return;
    m_isGentle = gentle;
    if (m_clip)
        makeClip(m_clip->frames);
}

void PairPreview::showFrames(const FramePair& pair)
{
    m_wantedFrames = pair;
    startFrames();
}

void PairPreview::makeClip(const FramePair& pair)
{
    m_wantedClip = pair;
    startClip();
}

const MeshSequence* PairPreview::sequence(const QString& name) const
{
    if (name == clipName())
        return m_clip ? &m_clip->sequence : nullptr;
    if (!m_frames)
        return nullptr;
    return name == sourceName() ? &m_frames->source : &m_frames->destination;
}

PairPreview::Frames PairPreview::readFrames(const OpenedCharacter& opened, const FramePair& pair)
{
    const double turn = opened.graph.roots().turns(pair.source, pair.destination);
    return {pair, placedFrame(opened, pair.source, 0, sourceName()),
            placedFrame(opened, pair.destination, turn, destinationName())};
}

void PairPreview::startFrames()
{
    const bool isBusy = m_framesJob && !m_framesJob->isOver();
    if (isBusy || !m_opened || !m_wantedFrames || (m_frames && m_frames->pair == *m_wantedFrames))
        return;
    m_framesJob = m_jobs.start(
        {.name = tr("Reading two frames"),
         .receiver = this,
         .stillStands = [this, generation = m_generation] { return generation == m_generation; },
         .background = true},
        [opened = m_opened, pair = *m_wantedFrames](const Progress&) { return readFrames(*opened, pair); },
        [this](Frames frames) {
            m_framesJob.clear();
            m_frames = std::move(frames);
            emit framesChanged();
            startFrames();
        });
}

TransitionClip PairPreview::blend(const OpenedCharacter& opened, const FramePair& pair, bool isGentle,
                                  const Progress& progress)
{
    const CharacterGraph& graph = opened.graph;
    const FrameLayout& layout = graph.layout();
    const double fps = opened.frames.sequences().front().fps;
    const auto around = static_cast<NodeIndex>(std::lround(secondsAround * fps));
    const NodeIndex first = layout.firstOf(layout.sequenceOf(pair.source));
    const NodeIndex last = layout.lastOf(layout.sequenceOf(pair.destination));
    const Walk walk{{{std::max(first, pair.source - around), pair.source},
                     {pair.destination, std::min(last, pair.destination + around)}}};
    const PlanOptions options{.start = toOrigin(graph.roots(), pair.source, 0),
                              .blend = isGentle ? BlendSettings::gentle() : BlendSettings()};
    const ClipPlan plan = planClip(graph.roots(), layout, graph.paths(), walk, options);
    Clip made = quadrille::makeClip(opened.frames, plan, InterpolationMethod::Poisson, progress);
    made.fps = fps;
    return {pair, isGentle, toSequence(clipName().toStdString(), std::move(made), opened.frames),
            plan.junctions.front().first, plan.junctions.front().last};
}

void PairPreview::startClip()
{
    if ((m_clipJob && !m_clipJob->isOver()) || !m_opened || !m_wantedClip)
        return;
    const FramePair pair = *m_wantedClip;
    const auto known = std::find_if(m_known.begin(), m_known.end(), [&](const auto& clip) {
        return clip->frames == pair && clip->isGentle == m_isGentle;
    });
    if (known != m_known.end()) {
        const auto clip = *known;
        m_known.erase(known);
        take(clip);
        return;
    }
    m_clipJob = m_jobs.start(
        {.name = tr("Blending a transition"),
         .receiver = this,
         .stillStands = [this, generation = m_generation] { return generation == m_generation; },
         .failed =
             [this, opened = m_opened, pair](const Error& error) {
                 m_clipJob.clear();
                 if (m_wantedClip == pair)
                     m_wantedClip.reset();
                 emit clipFailed(opened->graph.named(error));
                 startClip();
             },
         .background = true},
        [opened = m_opened, pair, isGentle = m_isGentle](const Progress& progress) {
            return std::make_shared<const TransitionClip>(blend(*opened, pair, isGentle, progress));
        },
        [this](std::shared_ptr<const TransitionClip> clip) {
            m_clipJob.clear();
            take(std::move(clip));
        });
}

void PairPreview::take(std::shared_ptr<const TransitionClip> clip)
{
    m_clip = std::move(clip);
    m_known.push_front(m_clip);
    std::size_t bytes = 0;
    std::size_t count = 0;
    for (const auto& each : m_known) {
        bytes += bytesOf(*each);
        if (bytes <= knownBytes || count == 0)
            ++count;
    }
    m_known.resize(count);
    const bool isWanted = m_wantedClip == m_clip->frames && m_isGentle == m_clip->isGentle;
    if (isWanted)
        m_wantedClip.reset();
    emit clipChanged();
    if (!isWanted)
        startClip();
}

} // namespace quadrille

#include "moc_pairpreview.cpp"
