// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/blendingrenderer.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderer.h>

namespace quadrille::widgets {

namespace {

class BlendingRenderer : public vtkOpenGLRenderer
{
public:
    static BlendingRenderer* New() { VTK_STANDARD_NEW_BODY(BlendingRenderer); }
    vtkTypeMacro(BlendingRenderer, vtkOpenGLRenderer)

        void DeviceRenderTranslucentPolygonalGeometry(
            vtkFrameBufferObjectBase* /*target*/) override // NOLINT(readability-identifier-naming)
    {
        UpdateTranslucentPolygonalGeometry();
    }

    BlendingRenderer(const BlendingRenderer&) = delete;
    void operator=(const BlendingRenderer&) = delete;

protected:
    BlendingRenderer() = default;
    ~BlendingRenderer() override = default;
};

} // namespace

vtkRenderer* newBlendingRenderer()
{
    return BlendingRenderer::New();
}

} // namespace quadrille::widgets
