// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/sceneshadows.h"

#include "widgets/viewport/figurelights.h"
#include "widgets/viewport/viewportscene.h"

#include <utility>

namespace quadrille::widgets {

namespace {

/// A light that turns less than this leaves the shadow where it is.
constexpr float sameDirection = 0.9999F;
/// A ghostly figure has no shadow.
constexpr double solid = 0.95;

} // namespace

void SceneShadows::setMaker(ShadowMaker maker)
{
    m_maker = std::move(maker);
    makeAllAnew();
}

void SceneShadows::setVisible(bool visible)
{
    m_isVisible = visible;
}

void SceneShadows::setGround(float height)
{
    if (std::exchange(m_ground, height) != height)
        makeAllAnew();
}

void SceneShadows::setCoarseness(double coarseness)
{
    m_coarseness = coarseness;
}

void SceneShadows::setStrength(double strength)
{
    if (std::exchange(m_strength, strength) != strength)
        makeAllAnew();
}

void SceneShadows::remove(int figure)
{
    m_shadows.erase(figure);
    m_stale.erase(figure);
}

void SceneShadows::makeAllAnew()
{
    m_shadows.clear();
}

void SceneShadows::update(const std::map<int, SceneFigure>& figures, const Turntable& camera)
{
    const int up = camera.upAxis == UpAxis::Y ? 1 : 2;
    const bool isSeen = m_isVisible && m_maker && camera.position()[up] > m_ground;
    const QVector3D toLight = FigureLights::keyDirection(camera);
    for (const auto& [id, figure] : figures) {
        const bool casts = isSeen && figure.visible && figure.firstPose && figure.opacity >= solid;
        if (!casts) {
            if (const auto hidden = m_shadows.find(id); hidden != m_shadows.end())
                hidden->second.actor->setVisible(false);
            m_stale.insert(id);
            continue;
        }
        Shadow& shadow = m_shadows[id];
        const bool isNew = shadow.actor == nullptr;
        if (isNew)
            shadow.actor = std::make_unique<ShadowActor>(m_renderer);
        shadow.actor->setOffset(figure.shift());
        const bool isSame = !isNew && !m_stale.contains(id) && shadow.coarseness == m_coarseness &&
                            QVector3D::dotProduct(shadow.toLight, toLight) > sameDirection;
        if (isSame)
            continue;
        m_stale.erase(id);
        shadow.toLight = toLight;
        shadow.coarseness = m_coarseness;
        shadow.actor->show(m_maker({.figure = id,
                                    .positions = figure.actor->positions(),
                                    .up = camera.upAxis,
                                    .ground = m_ground,
                                    .toLight = toLight,
                                    .coarseness = m_coarseness}),
                           camera.upAxis, m_strength);
    }
}

} // namespace quadrille::widgets
