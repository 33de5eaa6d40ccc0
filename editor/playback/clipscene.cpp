// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/playback/clipscene.h"

#include "editor/jobs/jobrunner.h"
#include "editor/playback/figureshadow.h"
#include "editor/playback/sequencebounds.h"
#include "widgets/theme/theme.h"

#include <QPointer>
#include <algorithm>
#include <limits>
#include <utility>

namespace quadrille {

namespace {

using widgets::Theme;
using widgets::Viewport;

constexpr int surveyedFrames = 120;

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

/// Whether one can take the place of the other without anything in the view moving.
bool haveOneMesh(const MeshSequence& a, const MeshSequence& b)
{
    return a.topology == b.topology || a.topology->data() == b.topology->data();
}

QVector3D toVector(const Vec3f& v)
{
    return {v.x(), v.y(), v.z()};
}

} // namespace

ClipScene::ClipScene(Viewport& viewport, Source source, JobRunner& jobs, QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_source(std::move(source))
    , m_jobs(jobs)
    , m_ghosts(viewport, jobs, [this](const QString& clip, std::int64_t frame) {
        return m_source.ghostColor ? m_source.ghostColor(clip, frame)
                                   : Theme::color(widgets::ColorRole::Original);
    })
{
    connect(&m_loader, &FrameLoader::loaded, this, &ClipScene::take);
    connect(&m_viewport, &Viewport::rendered, this, [this] {
        if (!std::exchange(m_isPainted, true))
            emit framePainted(m_frame);
    });
    connect(&Theme::instance(), &Theme::changed, this, &ClipScene::colorFigures);
    m_viewport.setShadowMaker([scene = QPointer(this)](const widgets::ShadowWish& wish) {
        const Actor* actor = scene ? scene->actorOfFigure(wish.figure) : nullptr;
        return actor == nullptr ? widgets::GroundShadow()
                                : figureShadow(wish, *actor->sequence.topology, actor->height);
    });
}

ClipScene::~ClipScene() = default;

void ClipScene::show(const QStringList& names)
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

void ClipScene::rename(const QString& before, const QString& after)
{
    std::ranges::replace(m_names, before, after);
    m_ghosts.rename(before, after);
    if (Actor* actor = actorOf(before)) {
        actor->name = after;
        m_viewport.setFigureName(actor->figure, after);
    }
}

void ClipScene::update(const QString& name)
{
    if (!m_names.contains(name))
        return;
    const MeshSequence* sequence = m_source.clip(name, isComparing());
    Actor* actor = actorOf(name);
    if (actor != nullptr && (sequence == nullptr || !haveOneMesh(*sequence, actor->sequence))) {
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
            bounds(*actor);
    }
    m_ghosts.show(name, actorOf(name)->figure, *sequence);
    colorFigures();
    emit changed();
    load();
}

void ClipScene::addActor(const QString& name, const MeshSequence& sequence)
{
    Actor actor{.name = name, .sequence = sequence};
    actor.figure = m_viewport.addFigure(toFigureMesh(*sequence.topology), name);
    actor.stream = m_loader.addStream(sequence);
    m_actors.push_back(std::move(actor));
    std::ranges::sort(m_actors, {}, [this](const Actor& each) { return m_names.indexOf(each.name); });
    std::vector<int> order;
    for (const Actor& each : m_actors)
        order.push_back(each.figure);
    m_viewport.setFigureOrder(order);
    bounds(*actorOf(name));
}

void ClipScene::removeActor(const QString& name)
{
    const auto found = std::ranges::find(m_actors, name, &Actor::name);
    if (found == m_actors.end())
        return;
    const bool wasAwaited = found->isAwaited;
    m_loader.removeStream(found->stream);
    m_viewport.removeFigure(found->figure);
    m_ghosts.remove(name);
    m_actors.erase(found);
    if (wasAwaited)
        load();
}

ClipScene::Actor* ClipScene::actorOf(const QString& name)
{
    const auto found = std::ranges::find(m_actors, name, &Actor::name);
    return found == m_actors.end() ? nullptr : &*found;
}

const ClipScene::Actor* ClipScene::actorOf(const QString& name) const
{
    const auto found = std::ranges::find(m_actors, name, &Actor::name);
    return found == m_actors.end() ? nullptr : &*found;
}

ClipScene::Actor* ClipScene::actorOfFigure(int figure)
{
    const auto found = std::ranges::find(m_actors, figure, &Actor::figure);
    return found == m_actors.end() ? nullptr : &*found;
}

int ClipScene::figureOf(const QString& name) const
{
    const Actor* actor = actorOf(name);
    return actor == nullptr ? -1 : actor->figure;
}

QImage ClipScene::textureOf(const QString& name) const
{
    const Actor* actor = actorOf(name);
    return actor == nullptr || actor->loaded.textures.empty() ? QImage()
                                                              : actor->loaded.textures.front().second;
}

const MeshSequence* ClipScene::sequenceOf(const QString& name) const
{
    const Actor* actor = actorOf(name);
    return actor == nullptr ? nullptr : &actor->sequence;
}

const LoadedFrame* ClipScene::loadedFrame(const QString& name) const
{
    const Actor* actor = actorOf(name);
    return actor == nullptr || actor->loaded.frame.value < 0 ? nullptr : &actor->loaded;
}

std::int64_t ClipScene::frameCount() const
{
    std::int64_t count = 0;
    for (const Actor& actor : m_actors)
        count = std::max(count, actor.sequence.frameCount());
    return count;
}

FrameIndex ClipScene::frameOf(const Actor& actor, FrameIndex frame) const
{
    return FrameIndex(std::clamp<std::int64_t>(frame.value, 0, actor.sequence.frameCount() - 1));
}

bool ClipScene::isLoading() const
{
    return std::ranges::any_of(m_actors, &Actor::isAwaited);
}

void ClipScene::showFrame(FrameIndex frame, int step)
{
    m_wanted = frame;
    m_step = step;
    if (!isLoading())
        load();
}

bool ClipScene::isPinned() const
{
    return std::ranges::any_of(m_actors, [this](const Actor& actor) {
        return m_ghosts.isPinned(actor.name, frameOf(actor, m_wanted));
    });
}

void ClipScene::setPinned(bool pinned)
{
    for (const Actor& actor : m_actors)
        m_ghosts.setPinned(actor.name, frameOf(actor, m_wanted), pinned);
}

void ClipScene::load()
{
    m_loading = m_wanted;
    for (Actor& actor : m_actors) {
        actor.isAwaited = true;
        m_loader.want(actor.stream, frameOf(actor, m_loading), m_step);
    }
}

void ClipScene::take(int stream, const LoadedFrame& loaded)
{
    const auto found = std::ranges::find(m_actors, stream, &Actor::stream);
    if (found == m_actors.end() || !found->isAwaited || loaded.frame != frameOf(*found, m_loading))
        return;
    found->arrived = loaded;
    found->isAwaited = false;
    if (!isLoading())
        showArrived();
}

void ClipScene::showArrived()
{
    QStringList names;
    for (Actor& actor : m_actors) {
        names += actor.name;
        dress(actor);
    }
    m_frame = m_loading;
    m_isPainted = false;
    const auto hasShape = [](const Actor& actor) { return actor.loaded.error == std::nullopt; };
    if (m_frameNextFigure && std::ranges::any_of(m_actors, hasShape)) {
        m_frameNextFigure = false;
        frameAll();
    }
    for (const QString& name : names)
        emit frameLoaded(name);
    emit frameShown(m_frame);
    if (m_wanted != m_loading && !isLoading())
        load();
}

/// Puts what was read onto the figure.
void ClipScene::dress(Actor& actor)
{
    actor.loaded = std::exchange(actor.arrived, {});
    LoadedFrame& loaded = actor.loaded;
    if (loaded.error) {
        if (!std::exchange(actor.hasFailed, true))
            emit frameFailed(actor.name, *loaded.error);
    }
    if (loaded.positions)
        m_viewport.setPositions(actor.figure, toFloats(loaded.positions->positions()));
    actor.textureIndices.resize(loaded.textures.size(), -2);
    for (std::size_t material = 0; material < loaded.textures.size(); ++material) {
        const auto& [index, image] = loaded.textures[material];
        if (actor.textureIndices[material] == index)
            continue;
        actor.textureIndices[material] = index;
        m_viewport.setTexture(actor.figure, image, static_cast<int>(material));
    }
    loaded.positions.reset();
}

void ClipScene::bounds(const Actor& actor)
{
    m_jobs.start(
        {.name = tr("Reading the path of “%1”").arg(actor.name),
         .receiver = this,
         .failed = [](const Error&) { /* told when the frame is shown */ },
         .background = true},
        [sequence = actor.sequence, up = m_source.upAxis()](const Progress& progress) {
            return surveySequence(sequence, up, surveyedFrames, progress);
        },
        [this, figure = actor.figure](const SequenceBounds& bounds) {
            Actor* surveyed = actorOfFigure(figure);
            if (surveyed == nullptr)
                return;
            surveyed->path.clear();
            for (Vec3f centroid : bounds.centroids) {
                centroid[static_cast<int>(m_source.upAxis())] = bounds.lowest;
                surveyed->path.push_back(toVector(centroid));
            }
            surveyed->lowest = bounds.lowest;
            const Vec3f size = bounds.upper - bounds.lower;
            surveyed->height = static_cast<double>(
                std::max(size[static_cast<int>(m_source.upAxis())], 0.05F * size.maxCoeff()));
            colorFigures();
            m_viewport.setFigureExtent(figure, toVector(bounds.lower), toVector(bounds.upper));
            setGround();
            // The first pose was framed before the whole take was known; who has moved the camera keeps it.
            if (m_framedView == m_viewport.camera())
                frameAll();
        });
}

void ClipScene::frameAll()
{
    m_viewport.frameAll();
    m_framedView = m_viewport.camera();
}

void ClipScene::keepCamera()
{
    m_frameNextFigure = false;
    m_framedView.reset();
}

void ClipScene::setGround()
{
    float lowest = std::numeric_limits<float>::max();
    for (const Actor& actor : m_actors)
        lowest = std::min(lowest, actor.lowest);
    m_viewport.setGroundHeight(lowest);
}

void ClipScene::colorFigures()
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

#include "moc_clipscene.cpp"
