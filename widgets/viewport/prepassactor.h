// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

class vtkActor;

namespace quadrille::widgets {

/// An actor that, when translucent, shows only its surface next to the camera: it draws its depth before
/// its colours. Far cheaper than depth peeling, and the inside of a figure stays hidden.
/// \return a new actor with one reference, owned by the caller.
vtkActor* newPrepassActor();

} // namespace quadrille::widgets
