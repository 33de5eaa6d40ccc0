// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/vtkformat.h"

#include "widgets/viewport/vtkview.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

namespace quadrille::widgets {

namespace {

bool canDraw()
{
    if (QGuiApplication::platformName() == QLatin1String("offscreen") ||
        QGuiApplication::platformName() == QLatin1String("minimal"))
        return false;
    QOpenGLContext context;
    context.setFormat(viewFormat());
    if (!context.create())
        return false;
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    return surface.isValid() && context.makeCurrent(&surface) &&
           context.format().version() >= qMakePair(3, 2);
}

} // namespace

QSurfaceFormat viewFormat()
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setSwapBehavior(QSurfaceFormat::DoubleBuffer);
    format.setRedBufferSize(8);
    format.setGreenBufferSize(8);
    format.setBlueBufferSize(8);
    format.setAlphaBufferSize(8);
    format.setDepthBufferSize(24);
    format.setSamples(0); // VTK multisamples in its own framebuffer
    return format;
}

void VtkView::setDefaultFormat()
{
    QSurfaceFormat::setDefaultFormat(viewFormat());
}

bool VtkView::openGlAvailable()
{
    static const bool isAvailable = canDraw();
    return isAvailable;
}

} // namespace quadrille::widgets
