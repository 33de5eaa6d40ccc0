// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/vtkformat.h"

#include "widgets/viewport/vtkview.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

namespace quadrille::widgets {

namespace {

/// What OpenGL's implementation calls itself, in small letters; empty where it is not good enough.
QByteArray findRenderer()
{
    if (QGuiApplication::platformName() == QLatin1String("offscreen") ||
        QGuiApplication::platformName() == QLatin1String("minimal"))
        return {};
    QOpenGLContext context;
    context.setFormat(viewFormat());
    if (!context.create())
        return {};
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface) || context.format().version() < qMakePair(3, 2))
        return {};
    const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    return name != nullptr ? QByteArray(name).toLower() : "unknown";
}

const QByteArray& renderer()
{
    static const QByteArray found = findRenderer();
    return found;
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
    return !renderer().isEmpty();
}

bool isDrawnByProcessor()
{
    const QByteArray& name = renderer();
    return name.contains("llvmpipe") || name.contains("softpipe") || name.contains("swrast");
}

} // namespace quadrille::widgets
