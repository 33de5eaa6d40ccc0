// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/groundshadow.h"

#include <map>
#include <memory>
#include <set>

namespace quadrille::widgets {

struct SceneFigure;

/// The shadows of all figures of a scene. They are made when a picture is drawn, of what changed since the
/// last one, by whoever knows how.
class SceneShadows
{
public:
    /// \param renderer  outlives them.
    explicit SceneShadows(vtkRenderer* renderer) : m_renderer(renderer) {}

    /// Null: no shadows.
    void setMaker(ShadowMaker maker);
    void setVisible(bool visible);
    bool isVisible() const { return m_isVisible; }
    void setGround(float height);
    void setCoarseness(double coarseness);
    /// Share of the light that is missing where it is darkest.
    void setStrength(double strength);
    /// A figure has other positions.
    void changed(int figure) { m_stale.insert(figure); }
    void remove(int figure);
    /// Makes what is missing. Shadows of figures that are not to be seen, or see-through, are hidden; from
    /// below the ground there are none.
    void update(const std::map<int, SceneFigure>& figures, const Turntable& camera);

private:
    struct Shadow
    {
        std::unique_ptr<ShadowActor> actor;
        QVector3D toLight;
        double coarseness = 0;
    };

    void makeAllAnew();

    vtkRenderer* m_renderer;
    ShadowMaker m_maker;
    std::map<int, Shadow> m_shadows;
    std::set<int> m_stale;
    bool m_isVisible = true;
    float m_ground = 0;
    double m_coarseness = 1;
    double m_strength = 0.5;
};

} // namespace quadrille::widgets
