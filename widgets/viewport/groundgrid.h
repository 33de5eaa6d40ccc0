// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/turntable.h"

#include <QColor>
#include <memory>

class vtkRenderer;

namespace quadrille::widgets {

/// Lines on the ground every metre, every ten centimetres when near, that fade with the distance; the two
/// axes in their colours.
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
    /// Height of the ground along the up axis, metres.
    void setHeight(float height);
    /// Keeps the grid about what the camera looks at.
    void follow(const Turntable& camera);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace quadrille::widgets
