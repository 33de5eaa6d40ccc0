// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/prepassactor.h"

#include <vtkMapper.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLActor.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOpenGLState.h>
#include <vtkProperty.h>

namespace quadrille::widgets {

namespace {

class PrepassActor : public vtkOpenGLActor
{
public:
    static PrepassActor* New() { VTK_STANDARD_NEW_BODY(PrepassActor); }
    vtkTypeMacro(PrepassActor, vtkOpenGLActor)

        void Render(vtkRenderer* renderer,
                    vtkMapper* mapper) override // NOLINT(readability-identifier-naming)
    {
        if (GetProperty()->GetOpacity() < 1.0) {
            auto* state = static_cast<vtkOpenGLRenderer*>(renderer)->GetState();
            const vtkOpenGLState::ScopedglColorMask colors(state);
            const vtkOpenGLState::ScopedglDepthMask depth(state);
            state->vtkglColorMask(0, 0, 0, 0);
            state->vtkglDepthMask(1);
            mapper->Render(renderer, this);
        }
        vtkOpenGLActor::Render(renderer, mapper);
    }

    PrepassActor(const PrepassActor&) = delete;
    void operator=(const PrepassActor&) = delete;

protected:
    PrepassActor() = default;
    ~PrepassActor() override = default;
};

} // namespace

vtkActor* newPrepassActor()
{
    return PrepassActor::New();
}

} // namespace quadrille::widgets
