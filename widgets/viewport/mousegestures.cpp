// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/mousegestures.h"

namespace quadrille::widgets {

namespace {

using enum CameraDrag;

constexpr MouseGesture quadrilleGestures[] = {
    {Qt::LeftButton, Qt::NoModifier, Orbit},      {Qt::LeftButton, Qt::ShiftModifier, Pan},
    {Qt::LeftButton, Qt::ControlModifier, Dolly}, {Qt::MiddleButton, Qt::NoModifier, Orbit},
    {Qt::MiddleButton, Qt::ShiftModifier, Pan},   {Qt::MiddleButton, Qt::ControlModifier, Dolly},
    {Qt::RightButton, Qt::NoModifier, Pan},       {Qt::RightButton, Qt::ShiftModifier, Pan},
    {Qt::RightButton, Qt::ControlModifier, Dolly}};
constexpr MouseGesture blenderGestures[] = {{Qt::MiddleButton, Qt::NoModifier, Orbit},
                                            {Qt::MiddleButton, Qt::ShiftModifier, Pan},
                                            {Qt::MiddleButton, Qt::ControlModifier, Dolly},
                                            {Qt::LeftButton, Qt::AltModifier, Orbit},
                                            {Qt::LeftButton, Qt::AltModifier | Qt::ShiftModifier, Pan},
                                            {Qt::LeftButton, Qt::AltModifier | Qt::ControlModifier, Dolly}};
constexpr MouseGesture mayaGestures[] = {{Qt::LeftButton, Qt::AltModifier, Orbit},
                                         {Qt::MiddleButton, Qt::AltModifier, Pan},
                                         {Qt::RightButton, Qt::AltModifier, Dolly}};
constexpr MouseGesture paraViewGestures[] = {
    {Qt::LeftButton, Qt::NoModifier, Orbit},      {Qt::LeftButton, Qt::ShiftModifier, Orbit},
    {Qt::LeftButton, Qt::ControlModifier, Dolly}, {Qt::MiddleButton, Qt::NoModifier, Pan},
    {Qt::MiddleButton, Qt::ShiftModifier, Orbit}, {Qt::MiddleButton, Qt::ControlModifier, Orbit},
    {Qt::RightButton, Qt::NoModifier, Dolly},     {Qt::RightButton, Qt::ShiftModifier, Pan},
    {Qt::RightButton, Qt::ControlModifier, Dolly}};

} // namespace

std::span<const MouseGesture> gesturesOf(MousePreset preset)
{
    switch (preset) {
    case MousePreset::Quadrille:
        return quadrilleGestures;
    case MousePreset::Blender:
        return blenderGestures;
    case MousePreset::Maya:
        return mayaGestures;
    case MousePreset::ParaView:
        return paraViewGestures;
    }
    return quadrilleGestures;
}

} // namespace quadrille::widgets
