// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

class vtkRenderer;

namespace quadrille::widgets {

/// A renderer that blends what is translucent over the picture in the order in which it was added: ground,
/// shadows, figures. VTK's own way, for translucent things in any order, fills and combines whole pictures
/// more, which is a third of the time that a processor draws a frame of a playing take.
/// \return a new renderer with one reference, owned by the caller.
vtkRenderer* newBlendingRenderer();

} // namespace quadrille::widgets
