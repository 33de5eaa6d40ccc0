// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/ruler.h"
#include "widgets/viewport/turntable.h"

#include <QColor>
#include <memory>

class vtkRenderer;

namespace quadrille::widgets {

/// A faint floor with lines every metre, every ten centimetres when near (feet and inches for rulers that
/// have them), that fades with the distance; near the origin the two axes in their colours.
class GroundGrid
{
public:
    explicit GroundGrid(vtkRenderer* renderer);
    ~GroundGrid();
    GroundGrid(const GroundGrid&) = delete;
    GroundGrid& operator=(const GroundGrid&) = delete;

    void setVisible(bool visible);
    bool isVisible() const;
    /// \param first  the axis to the right. \param second  the other one on the ground.
    void setColors(const QColor& lines, const QColor& first, const QColor& second);
    /// How much brighter the ground is than what lies behind it, 0 … 1.
    void setFloor(double brightness);
    /// \param pixels  of the screen for one logical pixel.
    void setPixelRatio(double pixels);
    /// Takes effect with the next follow(), as the height does.
    void setRuler(const Ruler& ruler);
    /// Height of the ground along the up axis.
    void setHeight(float height);
    /// Keeps the grid about what the camera looks at.
    void follow(const Turntable& camera);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace quadrille::widgets
