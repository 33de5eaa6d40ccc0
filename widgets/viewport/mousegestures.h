// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <qnamespace.h>
#include <span>

namespace quadrille::widgets {

/// What a drag of the mouse does to the camera.
enum class CameraDrag
{
    Orbit,
    Pan,
    Dolly
};

/// A button with the keys that are held: what a drag with them does.
struct MouseGesture
{
    Qt::MouseButton button;
    Qt::KeyboardModifiers keys;
    CameraDrag drag;
};

/// Whose mouse gestures a view has.
enum class MousePreset
{
    Quadrille, ///< left or middle orbits, right or Shift pans, Ctrl dollies
    Blender, ///< middle orbits, with Shift pans, with Ctrl dollies; Alt makes the left button the middle one
    Maya,    ///< with Alt: left orbits, middle pans, right dollies
    ParaView ///< left orbits, middle pans, right dollies
};

/// The gestures of a preset. Keys are held exactly as they say.
std::span<const MouseGesture> gesturesOf(MousePreset preset);

} // namespace quadrille::widgets
