// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/animationcamera.h"

#include "editor/context/editorcontext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/view/sceneview.h"
#include "widgets/timeline/momentlane.h"

#include <QMenu>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// Three decimals are finer than anybody sees, and read well in the file.
double rounded(double value)
{
    return std::round(value * 1000) / 1000;
}

/// What is seen, as a key.
CameraKey cameraKeyOf(const widgets::Turntable& camera, double time)
{
    return {.time = rounded(time),
            .target = {rounded(static_cast<double>(camera.target.x())),
                       rounded(static_cast<double>(camera.target.y())),
                       rounded(static_cast<double>(camera.target.z()))},
            .distance = std::max(rounded(static_cast<double>(camera.distance)), 0.001),
            .azimuth = rounded(std::remainder(static_cast<double>(camera.yaw), 360.0)),
            .elevation = rounded(static_cast<double>(camera.pitch)),
            .fieldOfView = rounded(static_cast<double>(camera.fieldOfView))};
}

widgets::Turntable turntableOf(const CameraKey& key, widgets::UpAxis up)
{
    const Vec3f target = key.target.cast<float>();
    return {.target = {target.x(), target.y(), target.z()},
            .yaw = static_cast<float>(key.azimuth),
            .pitch = static_cast<float>(key.elevation),
            .distance = static_cast<float>(key.distance),
            .fieldOfView = static_cast<float>(key.fieldOfView),
            .upAxis = up};
}

std::vector<CameraKey> cameraKeysOf(const AnimationEntry& entry)
{
    std::vector<CameraKey> keys;
    for (const CameraKeyEntry& each : entry.camera)
        keys.push_back(each.key);
    return keys;
}

} // namespace

AnimationCamera::AnimationCamera(CurrentAnimation& animation, QObject* parent)
    : QObject(parent), m_animation(animation), m_lane(new widgets::MomentLane(animation.view().timeline()))
{
    using widgets::MomentLane;
    m_lane->setObjectName(QStringLiteral("cameraLane"));
    animation.view().addBelowTimeline(m_lane);
    makeActions();
    connect(m_lane, &MomentLane::momentSelected, this, &AnimationCamera::updateActions);
    connect(m_lane, &MomentLane::momentMoved, this, [this](int key, double seconds, bool committed) {
        moveKey(key, seconds, committed ? EditPhase::Final : EditPhase::Dragging);
    });
    connect(m_lane, &MomentLane::momentActivated, this, &AnimationCamera::goToKey);
    connect(m_lane, &MomentLane::removalRequested, this, &AnimationCamera::removeKey);
    connect(m_lane, &MomentLane::additionRequested, this, &AnimationCamera::addKeyAt);
    connect(m_lane, &MomentLane::menuRequested, this, [this](double, const QPoint& position) {
        QMenu menu;
        for (const char* id :
             {"animate.camera.add", "animate.camera.replace", "animate.camera.remove", "animate.camera.look"})
            menu.addAction(m_animation.context().actions.action(QLatin1String(id)));
        menu.exec(position);
    });
    connect(&animation, &CurrentAnimation::changed, this, &AnimationCamera::refresh);
    connect(&animation.view().player(), &Player::frameChanged, this, &AnimationCamera::look);
    connect(&animation.view().timeline(), &widgets::Timeline::frameScrubbed, this, &AnimationCamera::look);
    retranslates(m_lane, [this] {
        m_lane->setTexts(tr("Camera"), tr("No camera keys: double-click to keep what you see as one"));
    });
    refresh();
}

void AnimationCamera::makeActions()
{
    ActionRegistry& actions = m_animation.context().actions;
    const auto group = [] { return tr("Animate"); };
    actions.add({"animate.camera.add",
                 group,
                 [] { return tr("Add &camera key"); },
                 [] { return tr("Keep what the view shows now, at the playhead, for pictures and videos"); },
                 "camera",
                 {QKeySequence(Qt::ALT | Qt::Key_K)}},
                [this] { addKey(); });
    actions.add({"animate.camera.replace",
                 group,
                 [] { return tr("Replace camera key"); },
                 [] { return tr("Make the chosen camera key what the view shows now"); },
                 "exchange",
                 {QKeySequence(Qt::ALT | Qt::SHIFT | Qt::Key_K)}},
                [this] { replaceKey(); });
    actions.add({"animate.camera.remove",
                 group,
                 [] { return tr("Remove camera key"); },
                 [] { return tr("Take the chosen camera key away"); },
                 "delete",
                 {}},
                [this] { removeKey(m_lane->selected()); });
    actions.addToggle({"animate.camera.look",
                       group,
                       [] { return tr("&Look through the camera"); },
                       [] { return tr("Let the view follow the camera keys while the clip plays"); },
                       "visible",
                       {QKeySequence(Qt::ALT | Qt::Key_C)}},
                      false, [this](bool looks) { setLookingThrough(looks); });
}

double AnimationCamera::fps() const
{
    return m_animation.context().document.project().settings.fps;
}

double AnimationCamera::playhead() const
{
    return m_animation.view().timeline().currentFrame() / fps();
}

void AnimationCamera::refresh()
{
    const AnimationEntry* entry = m_animation.entry();
    std::vector<double> times;
    if (entry != nullptr) {
        for (const CameraKeyEntry& key : entry->camera)
            times.push_back(key.key.time);
    }
    m_lane->setFps(fps());
    if (times != m_lane->moments())
        m_lane->setMoments(std::move(times));
    updateActions();
    look();
}

void AnimationCamera::updateActions()
{
    const AnimationEntry* entry = m_animation.entry();
    const bool isChosen = m_lane->selected() >= 0;
    ActionRegistry& actions = m_animation.context().actions;
    actions.action(QStringLiteral("animate.camera.add"))
        ->setEnabled(!m_animation.context().document.project().sequences.empty());
    actions.action(QStringLiteral("animate.camera.replace"))->setEnabled(isChosen);
    actions.action(QStringLiteral("animate.camera.remove"))->setEnabled(isChosen);
    actions.action(QStringLiteral("animate.camera.look"))
        ->setEnabled(entry != nullptr && !entry->camera.empty());
}

void AnimationCamera::addKey()
{
    addKeyAt(playhead());
}

void AnimationCamera::addKeyAt(double time)
{
    const CameraKey key = cameraKeyOf(m_animation.view().viewport().camera(), time);
    int place = 0;
    m_animation.edit(tr("Add camera key"), QStringLiteral("camera"), [&](AnimationEntry& entry) {
        auto& keys = entry.camera;
        const auto behind = std::ranges::find_if(
            keys, [&](const CameraKeyEntry& other) { return other.key.time > key.time - 0.5 / fps(); });
        place = static_cast<int>(behind - keys.begin());
        if (behind != keys.end() && behind->key.time < key.time + 0.5 / fps())
            behind->key = key;
        else
            keys.insert(behind, CameraKeyEntry{.key = key});
    });
    m_lane->setSelected(place);
    updateActions();
}

void AnimationCamera::replaceKey()
{
    const int chosen = m_lane->selected();
    if (chosen < 0)
        return;
    m_animation.edit(tr("Replace camera key"), QStringLiteral("camera"), [&](AnimationEntry& entry) {
        CameraKey& key = entry.camera.at(static_cast<std::size_t>(chosen)).key;
        key = cameraKeyOf(m_animation.view().viewport().camera(), key.time);
    });
}

void AnimationCamera::removeKey(int key)
{
    if (key < 0)
        return;
    m_animation.edit(tr("Remove camera key"), QStringLiteral("camera"),
                     [key](AnimationEntry& entry) { entry.camera.erase(entry.camera.begin() + key); });
    m_lane->setSelected(-1);
    updateActions();
}

void AnimationCamera::moveKey(int key, double seconds, EditPhase phase)
{
    m_animation.edit(
        tr("Move camera key"), QStringLiteral("camera key %1").arg(key),
        [&](AnimationEntry& entry) { entry.camera.at(static_cast<std::size_t>(key)).key.time = seconds; },
        phase);
}

void AnimationCamera::goToKey(int key)
{
    const AnimationEntry* entry = m_animation.entry();
    if (entry == nullptr || key < 0)
        return;
    const CameraKey& shown = entry->camera.at(static_cast<std::size_t>(key)).key;
    const auto frame = std::lround(shown.time * fps());
    m_animation.view().player().goTo(frame);
    m_animation.view().timeline().setCurrentFrame(static_cast<int>(frame));
    widgets::Viewport& viewport = m_animation.view().viewport();
    viewport.setCamera(turntableOf(shown, viewport.camera().upAxis));
}

void AnimationCamera::setLookingThrough(bool looks)
{
    m_looksThrough = looks;
    // The view would go along with the figure as well.
    QAction* following = m_animation.context().actions.action(QStringLiteral("view.follow"));
    if (looks && following->isChecked())
        following->trigger();
    look();
}

void AnimationCamera::look()
{
    const AnimationEntry* entry = m_animation.entry();
    if (!m_looksThrough || entry == nullptr || entry->camera.empty())
        return;
    widgets::Viewport& viewport = m_animation.view().viewport();
    viewport.setCamera(turntableOf(cameraAt(cameraKeysOf(*entry), playhead()), viewport.camera().upAxis));
}

} // namespace quadrille

#include "moc_animationcamera.cpp"
