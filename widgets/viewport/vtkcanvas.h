// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

class QOpenGLContext;
class QSurface;
class QWidget;
class vtkGenericOpenGLRenderWindow;

namespace quadrille::widgets {

/// What is drawn on a canvas.
class VtkPicture
{
public:
    virtual ~VtkPicture() = default;
    /// A context is there, and current. Comes again whenever there is another one.
    virtual void begin(QOpenGLContext* context, QSurface* surface) = 0;
    /// The context is about to go.
    virtual void end() = 0;
    /// Draws what is not up to date, and has it shown. To be called with the context current.
    /// \param show  is told whether VTK's picture is another than at the last call.
    virtual void paint(const std::function<void(bool isNew)>& show) = 0;
    virtual vtkGenericOpenGLRenderWindow* window() const = 0;
    /// Pixels of the picture for one logical pixel of the canvas.
    virtual double pixelRatio() const = 0;
};

/// Has the OpenGL context that VTK draws in, and shows what it has drawn. Leaves all events but painting to
/// the widget that it fills.
class VtkCanvas
{
public:
    virtual ~VtkCanvas() = default;
    virtual QWidget* widget() = 0;
    virtual QOpenGLContext* context() const = 0;
    virtual void makeCurrent() = 0;
    virtual void doneCurrent() = 0;
};

/// Where a processor draws, Qt would join the whole window from textures for each update of any widget in it
/// (QOpenGLWidget): 25 ms of the processor for 1580 × 960 pixels. There the picture is read and painted as
/// the rest of the window is, in 2 ms.
/// \param picture  to outlive the canvas.
std::unique_ptr<VtkCanvas> makeCanvas(bool byProcessor, VtkPicture& picture, QWidget* parent);

} // namespace quadrille::widgets
