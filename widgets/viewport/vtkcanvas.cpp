// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/vtkcanvas.h"

#include "widgets/viewport/vtkformat.h"

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLWidget>
#include <QPainter>
#include <QPointer>
#include <algorithm>
#include <utility>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

namespace quadrille::widgets {

namespace {

/// Copies the picture into a texture that Qt joins with the rest of the window. The context may be replaced
/// (undocking).
class CardCanvas : public QOpenGLWidget, public VtkCanvas
{
public:
    CardCanvas(VtkPicture& picture, QWidget* parent) : QOpenGLWidget(parent), m_picture(picture)
    {
        setFormat(viewFormat());
        setUpdateBehavior(QOpenGLWidget::NoPartialUpdate);
    }
    ~CardCanvas() override
    {
        // ~QOpenGLWidget destroys the context after this part of the object is gone.
        if (m_known)
            m_known->disconnect(this);
    }
    QWidget* widget() override { return this; }
    QOpenGLContext* context() const override { return QOpenGLWidget::context(); }
    void makeCurrent() override { QOpenGLWidget::makeCurrent(); }
    void doneCurrent() override { QOpenGLWidget::doneCurrent(); }

protected:
    // Runs again whenever Qt gives the widget a new context (reparenting to another window, undocking).
    void initializeGL() override
    {
        if (m_known != context()) {
            m_known = context();
            connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { m_picture.end(); });
        }
        m_picture.begin(context(), context()->surface());
    }
    void paintGL() override
    {
        m_picture.paint([this](bool /*isNew*/) { copy(); });
    }

private:
    VtkPicture& m_picture;
    QPointer<QOpenGLContext> m_known;

    void copy()
    {
        auto* window = m_picture.window();
        auto* gl = context()->extraFunctions();
        gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
        const GLenum buffer = GL_COLOR_ATTACHMENT0;
        gl->glDrawBuffers(1, &buffer);
        window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
        gl->glDisable(GL_SCISSOR_TEST);
        if (auto* framebuffer = window->GetRenderFramebuffer()) {
            const int* rendered = framebuffer->GetLastSize();
            const QSize shown = size() * devicePixelRatioF();
            window->BlitDisplayFramebuffer(0, 0, 0, rendered[0], rendered[1], 0, 0, shown.width(),
                                           shown.height(), GL_COLOR_BUFFER_BIT, GL_LINEAR);
        }
        // Opaque, or a compositor may show what lies behind.
        gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
        gl->glClearColor(0, 0, 0, 1);
        gl->glClear(GL_COLOR_BUFFER_BIT);
        gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }
};

/// Reads the picture, and paints it as the rest of the window is painted.
class ProcessorCanvas : public QWidget, public VtkCanvas
{
public:
    ProcessorCanvas(VtkPicture& picture, QWidget* parent) : QWidget(parent), m_picture(picture)
    {
        setAttribute(Qt::WA_OpaquePaintEvent);
        m_surface.setFormat(viewFormat());
        m_surface.create();
        m_context.setFormat(viewFormat());
        m_context.create();
    }
    QWidget* widget() override { return this; }
    QOpenGLContext* context() const override { return const_cast<QOpenGLContext*>(&m_context); }
    void makeCurrent() override { m_context.makeCurrent(&m_surface); }
    void doneCurrent() override { m_context.doneCurrent(); }

protected:
    void paintEvent(QPaintEvent* /*event*/) override
    {
        if (m_context.makeCurrent(&m_surface)) {
            if (!std::exchange(m_begun, true))
                m_picture.begin(&m_context, &m_surface);
            m_picture.paint([this](bool isNew) {
                if (isNew)
                    read();
            });
            m_context.doneCurrent();
        }
        QPainter painter(this);
        if (m_image.isNull())
            painter.fillRect(rect(), Qt::black);
        else
            paint(painter);
    }

private:
    VtkPicture& m_picture;
    QOffscreenSurface m_surface;
    QOpenGLContext m_context;
    QImage m_image;
    double m_ratio = 1; ///< pixels of the image for one logical pixel
    bool m_begun = false;

    void paint(QPainter& painter) const
    {
        if (m_ratio == devicePixelRatioF()) {
            painter.drawImage(0, 0, m_image);
            return;
        }
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(QRectF(QPointF(), QSizeF(m_image.size()) / m_ratio), m_image);
    }

    void read()
    {
        auto* window = m_picture.window();
        auto* framebuffer = window->GetDisplayFramebuffer();
        if (framebuffer == nullptr)
            return;
        const int* size = framebuffer->GetLastSize();
        const QSize wanted(size[0], size[1]);
        if (m_image.size() != wanted)
            m_image = QImage(wanted, QImage::Format_RGB32);
        m_ratio = m_picture.pixelRatio();
        m_image.setDevicePixelRatio(devicePixelRatioF());
        auto* gl = m_context.functions();
        window->GetState()->PushReadFramebufferBinding();
        framebuffer->Bind(GL_READ_FRAMEBUFFER);
        framebuffer->ActivateReadBuffer(0);
        gl->glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        gl->glPixelStorei(GL_PACK_ALIGNMENT, 4);
        gl->glReadPixels(0, 0, wanted.width(), wanted.height(), GL_BGRA, GL_UNSIGNED_BYTE, m_image.bits());
        window->GetState()->PopReadFramebufferBinding();
        // OpenGL begins at the lower edge.
        const int bytes = 4 * wanted.width();
        for (int row = 0; row < wanted.height() / 2; ++row) {
            uchar* upper = m_image.scanLine(row);
            std::swap_ranges(upper, upper + bytes, m_image.scanLine(wanted.height() - 1 - row));
        }
    }
};

} // namespace

std::unique_ptr<VtkCanvas> makeCanvas(bool byProcessor, VtkPicture& picture, QWidget* parent)
{
    std::unique_ptr<VtkCanvas> canvas;
    if (byProcessor)
        canvas = std::make_unique<ProcessorCanvas>(picture, parent);
    else
        canvas = std::make_unique<CardCanvas>(picture, parent);
    canvas->widget()->setAttribute(Qt::WA_TransparentForMouseEvents);
    canvas->widget()->setFocusPolicy(Qt::NoFocus);
    return canvas;
}

} // namespace quadrille::widgets
