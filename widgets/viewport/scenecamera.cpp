// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/scenecamera.h"

#include "widgets/theme/theme.h"
#include "widgets/viewport/vtkbuffers.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

namespace quadrille::widgets {

void lookWith(vtkRenderer* renderer, const Turntable& camera, double nearest, double farthest)
{
    vtkCamera* active = renderer->GetActiveCamera();
    active->SetPosition(vtkbuffers::xyz(camera.position()).data());
    active->SetFocalPoint(vtkbuffers::xyz(camera.target).data());
    active->SetViewUp(vtkbuffers::xyz(camera.up()).data());
    active->SetViewAngle(static_cast<double>(camera.fieldOfView));
    active->SetClippingRange(nearest, farthest);
}

void updateBackground(vtkRenderer* renderer)
{
    const auto bottom = vtkbuffers::rgb(Theme::color(ColorRole::ViewportBottom));
    const auto top = vtkbuffers::rgb(Theme::color(ColorRole::ViewportTop));
    renderer->GradientBackgroundOn();
    renderer->SetBackground(bottom[0], bottom[1], bottom[2]);
    renderer->SetBackground2(top[0], top[1], top[2]);
}

} // namespace quadrille::widgets
