// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/turntable.h"

#include <QVector3D>
#include <memory>

class vtkShaderProperty;

namespace quadrille::widgets {

/// The light that figures stand in, computed in linear light as in the pictures that are exported: a key, a
/// fill and a rim light that stand around the camera but stay upright, a sky above a floor.
class FigureLights
{
public:
    enum class Surface
    {
        Clay,
        Textured ///< captured textures hold light already
    };

    FigureLights();
    ~FigureLights();
    FigureLights(const FigureLights&) = delete;
    FigureLights& operator=(const FigureLights&) = delete;

    void follow(const Turntable& camera);
    /// What an actor needs to be lit so; its property's diffuse share must be 1, its ambient one 0.
    vtkShaderProperty* shader(Surface surface) const;

    /// Towards the key light, in the world; length one. Always above the ground.
    static QVector3D keyDirection(const Turntable& camera);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace quadrille::widgets
