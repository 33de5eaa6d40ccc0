// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/playback/sequencestage.h"

#include "editor/jobs/jobrunner.h"
#include "editor/playback/survey.h"
#include "widgets/theme/theme.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace quadrille {

namespace {

using widgets::Theme;
using widgets::Viewport;

constexpr int surveyedFrames = 120;
constexpr std::int64_t maximalGhosts = 24;
constexpr int ghostAlpha = 70;

widgets::FigureMesh toFigureMesh(const Topology& topology)
{
    const TopologyData& data = topology.data();
    widgets::FigureMesh mesh;
    mesh.vertexCount = data.vertexCount;
    mesh.triangles.reserve(data.triangles.size());
    for (const Triangle& triangle : data.triangles)
        mesh.triangles.push_back({triangle[0].value, triangle[1].value, triangle[2].value});
    mesh.uvs.reserve(data.uvs.size());
    for (const Vec2f& uv : data.uvs)
        mesh.uvs.push_back({uv.x(), uv.y()});
    mesh.triangleUvs = data.triangleUvs;
    mesh.triangleMaterials = data.triangleMaterials;
    return mesh;
}

std::span<const float> toFloats(Positions positions)
{
    return {reinterpret_cast<const float*>(positions.data()), positions.size() * 3};
}

QVector3D toVector(const Vec3f& v)
{
    return {v.x(), v.y(), v.z()};
}

/// Positions of every `interval`-th frame.
std::vector<widgets::Ghost> makeGhosts(const MeshSequence& sequence, std::int64_t interval,
                                       const Progress& progress)
{
    std::vector<widgets::Ghost> ghosts;
    for (std::int64_t frame = 0; frame < sequence.frameCount(); frame += interval) {
        progress.report(frame, sequence.frameCount());
        const Frame loaded = sequence.frame(FrameIndex(frame));
        const auto floats = toFloats(loaded.positions());
        ghosts.push_back({{floats.begin(), floats.end()}, QColor()});
    }
    return ghosts;
}

} // namespace

SequenceStage::SequenceStage(Viewport& viewport, Source source, JobRunner& jobs, QObject* parent)
    : QObject(parent), m_viewport(viewport), m_source(std::move(source)), m_jobs(jobs)
{
    connect(&m_loader, &FrameLoader::loaded, this, &SequenceStage::applyFrame);
    connect(&Theme::instance(), &Theme::changed, this, &SequenceStage::colorFigures);
}

SequenceStage::~SequenceStage() = default;

void SequenceStage::show(const QStringList& names)
{
    if (names == m_names)
        return;
    const QStringList before = std::exchange(m_names, names);
    for (const QString& name : before) {
        if (!names.contains(name))
            removeActor(name);
    }
    m_frameNextFigure = true;
    for (const QString& name : names)
        update(name);
    colorFigures();
    emit changed();
}

void SequenceStage::update(const QString& name)
{
    if (!m_names.contains(name))
        return;
    const MeshSequence* sequence = m_source.clip(name, isComparing());
    Actor* actor = actorOf(name);
    if (actor != nullptr && (sequence == nullptr || sequence->topology != actor->sequence.topology)) {
        removeActor(name);
        actor = nullptr;
    }
    if (sequence == nullptr) {
        emit changed();
        return;
    }
    if (actor == nullptr) {
        addActor(name, *sequence);
    } else {
        const bool sameFrames = actor->sequence.source == sequence->source &&
                                actor->sequence.range == sequence->range &&
                                actor->sequence.fps == sequence->fps;
        actor->sequence = *sequence;
        actor->textureIndices.clear();
        actor->loaded = {.frame = FrameIndex(-1)};
        m_loader.setSequence(actor->stream, *sequence);
        if (!sameFrames)
            survey(*actor);
    }
    colorFigures();
    emit changed();
    showFrame(m_frame, m_step);
    updateGhosts();
}

void SequenceStage::addActor(const QString& name, const MeshSequence& sequence)
{
    Actor actor{.name = name, .sequence = sequence};
    actor.figure = m_viewport.addFigure(toFigureMesh(*sequence.topology), name);
    actor.stream = m_loader.addStream(sequence);
    m_actors.push_back(std::move(actor));
    std::ranges::sort(m_actors, {}, [this](const Actor& each) { return m_names.indexOf(each.name); });
    survey(*actorOf(name));
}

void SequenceStage::removeActor(const QString& name)
{
    const auto found = std::ranges::find(m_actors, name, &Actor::name);
    if (found == m_actors.end())
        return;
    m_loader.removeStream(found->stream);
    m_viewport.removeFigure(found->figure);
    m_actors.erase(found);
}

SequenceStage::Actor* SequenceStage::actorOf(const QString& name)
{
    const auto found = std::ranges::find(m_actors, name, &Actor::name);
    return found == m_actors.end() ? nullptr : &*found;
}

const SequenceStage::Actor* SequenceStage::actorOf(const QString& name) const
{
    const auto found = std::ranges::find(m_actors, name, &Actor::name);
    return found == m_actors.end() ? nullptr : &*found;
}

SequenceStage::Actor* SequenceStage::actorOfFigure(int figure)
{
    const auto found = std::ranges::find(m_actors, figure, &Actor::figure);
    return found == m_actors.end() ? nullptr : &*found;
}

int SequenceStage::figureOf(const QString& name) const
{
    const Actor* actor = actorOf(name);
    return actor == nullptr ? -1 : actor->figure;
}

QImage SequenceStage::textureOf(const QString& name) const
{
    const Actor* actor = actorOf(name);
    return actor == nullptr || actor->loaded.textures.empty() ? QImage()
                                                              : actor->loaded.textures.front().second;
}

const MeshSequence* SequenceStage::sequenceOf(const QString& name) const
{
    const Actor* actor = actorOf(name);
    return actor == nullptr ? nullptr : &actor->sequence;
}

const LoadedFrame* SequenceStage::loadedFrame(const QString& name) const
{
    const Actor* actor = actorOf(name);
    return actor == nullptr || actor->loaded.frame.value < 0 ? nullptr : &actor->loaded;
}

std::int64_t SequenceStage::frameCount() const
{
    std::int64_t count = 0;
    for (const Actor& actor : m_actors)
        count = std::max(count, actor.sequence.frameCount());
    return count;
}

void SequenceStage::showFrame(FrameIndex frame, int step)
{
    m_frame = frame;
    m_step = step;
    for (const Actor& actor : m_actors) {
        const std::int64_t last = actor.sequence.frameCount() - 1;
        m_loader.want(actor.stream, FrameIndex(std::clamp<std::int64_t>(frame.value, 0, last)), step);
    }
}

void SequenceStage::applyFrame(int stream, const LoadedFrame& loaded)
{
    const auto found = std::ranges::find(m_actors, stream, &Actor::stream);
    if (found == m_actors.end())
        return;
    Actor& actor = *found;
    if (loaded.error) {
        if (!std::exchange(actor.hasFailed, true))
            emit frameFailed(actor.name, *loaded.error);
    }
    if (loaded.positions) {
        m_viewport.setPositions(actor.figure, toFloats(loaded.positions->positions()));
        if (std::exchange(m_frameNextFigure, false))
            frameAll();
    }
    actor.textureIndices.resize(loaded.textures.size(), -2);
    for (std::size_t material = 0; material < loaded.textures.size(); ++material) {
        const auto& [index, image] = loaded.textures[material];
        if (actor.textureIndices[material] == index)
            continue;
        actor.textureIndices[material] = index;
        m_viewport.setTexture(actor.figure, image, static_cast<int>(material));
    }
    actor.loaded = loaded;
    actor.loaded.positions.reset();
    emit frameLoaded(actor.name);
    const bool complete = std::ranges::all_of(m_actors, [this](const Actor& each) {
        return each.loaded.frame.value == std::min(m_frame.value, each.sequence.frameCount() - 1);
    });
    if (complete)
        emit frameShown(m_frame);
}

void SequenceStage::survey(const Actor& actor)
{
    m_jobs.start(
        {.name = tr("Reading the path of “%1”").arg(actor.name),
         .receiver = this,
         .failed = [](const Error&) { /* told when the frame is shown */ },
         .background = true},
        [sequence = actor.sequence, up = m_source.upAxis()](const Progress& progress) {
            return surveySequence(sequence, up, surveyedFrames, progress);
        },
        [this, figure = actor.figure](const Survey& survey) {
            Actor* surveyed = actorOfFigure(figure);
            if (surveyed == nullptr)
                return;
            surveyed->path.clear();
            for (Vec3f centroid : survey.centroids) {
                centroid[static_cast<int>(m_source.upAxis())] = survey.lowest;
                surveyed->path.push_back(toVector(centroid));
            }
            surveyed->lowest = survey.lowest;
            colorFigures();
            m_viewport.setFigureExtent(figure, toVector(survey.lower), toVector(survey.upper));
            setGround();
            // The first pose was framed before the whole take was known; who has moved the camera keeps it.
            if (m_framedView == m_viewport.camera())
                frameAll();
        });
}

void SequenceStage::frameAll()
{
    m_viewport.frameAll();
    m_framedView = m_viewport.camera();
}

void SequenceStage::keepCamera()
{
    m_frameNextFigure = false;
    m_framedView.reset();
}

void SequenceStage::setGround()
{
    float lowest = std::numeric_limits<float>::max();
    for (const Actor& actor : m_actors)
        lowest = std::min(lowest, actor.lowest);
    m_viewport.setGroundHeight(lowest);
}

void SequenceStage::setGhostInterval(int interval)
{
    m_ghostInterval = interval;
    updateGhosts();
}

void SequenceStage::updateGhosts()
{
    for (const Actor& actor : m_actors) {
        if (m_ghostInterval <= 0) {
            m_viewport.setGhosts(actor.figure, {});
            continue;
        }
        const std::int64_t interval =
            std::max<std::int64_t>(m_ghostInterval, actor.sequence.frameCount() / maximalGhosts);
        m_jobs.start(
            {.name = tr("Ghosts of “%1”").arg(actor.name),
             .receiver = this,
             .failed = [](const Error&) { /* told when the frame is shown */ },
             .background = true},
            [sequence = actor.sequence, interval](const Progress& progress) {
                return makeGhosts(sequence, interval, progress);
            },
            [this, figure = actor.figure, interval](std::vector<widgets::Ghost> ghosts) {
                const Actor* shown = actorOfFigure(figure);
                if (shown == nullptr || m_ghostInterval <= 0)
                    return;
                std::int64_t frame = 0;
                for (widgets::Ghost& ghost : ghosts) {
                    ghost.color = m_source.ghostColor ? m_source.ghostColor(shown->name, frame)
                                                      : Theme::color(widgets::ColorRole::Original);
                    ghost.color.setAlpha(ghostAlpha);
                    frame += interval;
                }
                m_viewport.setGhosts(figure, ghosts);
            });
    }
}

void SequenceStage::colorFigures()
{
    for (const Actor& actor : m_actors) {
        const auto index = static_cast<int>(m_names.indexOf(actor.name));
        QColor color;
        if (m_names.size() > 1)
            color = m_source.color ? m_source.color(actor.name) : Theme::categorical(index);
        m_viewport.setFigureColor(actor.figure, color);
        const bool isDrawn = m_source.drawsWay || m_names.size() > 1;
        m_viewport.setTrajectory(actor.figure, isDrawn ? actor.path : std::vector<QVector3D>(),
                                 color.isValid() ? color : Theme::color(widgets::ColorRole::Original));
    }
}

} // namespace quadrille
