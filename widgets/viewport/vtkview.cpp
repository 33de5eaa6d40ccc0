// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/vtkview.h"

#include "widgets/viewport/vtkevents.h"
#include "widgets/viewport/vtkformat.h"

#include <QElapsedTimer>
#include <QHash>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QPointer>
#include <QScopedValueRollback>
#include <QScreen>
#include <QTimer>
#include <algorithm>
#include <chrono>
#include <utility>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkSmartPointer.h>

namespace quadrille::widgets {

namespace {

/// A processor draws pictures that follow each other faster than this as well as there is time for.
constexpr std::chrono::milliseconds restTime{200};

int bestLevel = 0; // see VtkView::setBestLevel

Qt::CursorShape cursorShape(int vtkCursor)
{
    switch (vtkCursor) {
    case VTK_CURSOR_CROSSHAIR:
        return Qt::CrossCursor;
    case VTK_CURSOR_HAND:
        return Qt::PointingHandCursor;
    case VTK_CURSOR_SIZEALL:
        return Qt::SizeAllCursor;
    case VTK_CURSOR_SIZENS:
        return Qt::SizeVerCursor;
    case VTK_CURSOR_SIZEWE:
        return Qt::SizeHorCursor;
    case VTK_CURSOR_SIZENE:
    case VTK_CURSOR_SIZESW:
        return Qt::SizeBDiagCursor;
    case VTK_CURSOR_SIZENW:
    case VTK_CURSOR_SIZESE:
        return Qt::SizeFDiagCursor;
    default:
        return Qt::ArrowCursor;
    }
}

/// An interactor without a style. Its constructor asks for a default one from a module that is not
/// linked, and VTK would warn of that.
vtkSmartPointer<vtkGenericRenderWindowInteractor> makeInteractor()
{
    const int warnings = vtkObject::GetGlobalWarningDisplay();
    vtkObject::SetGlobalWarningDisplay(0);
    auto interactor = vtkSmartPointer<vtkGenericRenderWindowInteractor>::New();
    vtkObject::SetGlobalWarningDisplay(warnings);
    interactor->SetInteractorStyle(nullptr);
    return interactor;
}

} // namespace

struct VtkView::Private
{
    explicit Private(VtkView* owner) : view(owner), events(interactor) {}

    void onWindowEvent(vtkObject* caller, unsigned long id, void* data);
    void onInteractorEvent(vtkObject* caller, unsigned long id, void* data);
    void createTimer(int id);
    bool isMoving() const { return software && (moving || rest.isActive()); }

    VtkView* view;
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    vtkSmartPointer<vtkGenericRenderWindowInteractor> interactor = makeInteractor();
    VtkEvents events;
    QPointer<QOpenGLContext> boundContext;
    QSurface* surface = nullptr;
    QHash<int, QTimer*> timers;
    QTimer rest; ///< runs while pictures follow each other
    RenderGovernor governor;
    int best = bestLevel;
    RenderQuality drawn; ///< how the last picture was drawn
    std::optional<RenderQuality> held;
    bool glReady = false;
    bool painting = false;
    bool renderNeeded = true;
    bool moving = false;   ///< something plays
    bool software = false; ///< a processor draws in place of a graphics card
};

VtkView::VtkView(QWidget* parent) : QOpenGLWidget(parent), d(std::make_unique<Private>(this))
{
    setFormat(viewFormat());
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_AcceptTouchEvents);
    setUpdateBehavior(QOpenGLWidget::NoPartialUpdate);

    d->window->SetOwnContext(0);
    d->window->SetReadyForRendering(false);
    d->window->SetMultiSamples(d->drawn.samples);
    d->rest.setSingleShot(true);
    d->rest.setInterval(restTime);
    connect(&d->rest, &QTimer::timeout, this, [this] {
        if (d->isMoving())
            return;
        d->governor.rested();
        d->renderNeeded = true;
        update();
    });
    d->window->SetFrameBlitModeToNoBlit();
    for (const unsigned long id :
         {vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent, vtkCommand::WindowFrameEvent,
          vtkCommand::CursorChangedEvent, vtkCommand::WindowSupportsOpenGLEvent})
        d->window->AddObserver(id, d.get(), &Private::onWindowEvent);

    d->interactor->SetRenderWindow(d->window);
    d->interactor->EnableRenderOff(); // the interactor's Render() only schedules a paint
    for (const unsigned long id :
         {vtkCommand::RenderEvent, vtkCommand::CreateTimerEvent, vtkCommand::DestroyTimerEvent})
        d->interactor->AddObserver(id, d.get(), &Private::onInteractorEvent);
    d->interactor->Initialize();
}

VtkView::~VtkView()
{
    releaseGl();
    // ~QOpenGLWidget destroys the context after this part of the object is gone.
    if (d->boundContext)
        d->boundContext->disconnect(this);
    d->window->RemoveAllObservers();
    d->interactor->RemoveAllObservers();
    d->interactor->SetInteractorStyle(nullptr);
    d->interactor->SetRenderWindow(nullptr);
    d->window->SetInteractor(nullptr);
}

vtkRenderWindow* VtkView::renderWindow() const
{
    return d->window;
}

vtkRenderWindowInteractor* VtkView::interactor() const
{
    return d->interactor;
}

void VtkView::scheduleRender()
{
    if (d->software)
        d->rest.start();
    d->renderNeeded = true;
    update();
}

void VtkView::setBestLevel(int level)
{
    bestLevel = level;
}

RenderQuality VtkView::quality() const
{
    if (d->held)
        return *d->held;
    return RenderGovernor::qualityOf(std::max(d->best, d->isMoving() ? d->governor.level() : 0));
}

void VtkView::setMoving(bool moving)
{
    d->moving = moving;
    if (d->software)
        d->rest.start();
}

void VtkView::holdQuality(std::optional<RenderQuality> quality)
{
    d->held = quality;
    scheduleRender();
}

void VtkView::applyQuality(const RenderQuality& quality)
{
    if (quality == d->drawn)
        return;
    d->drawn = quality;
    d->window->SetMultiSamples(quality.samples);
    auto* renderers = d->window->GetRenderers();
    renderers->InitTraversal();
    while (vtkRenderer* renderer = renderers->GetNextItem())
        renderer->SetUseFXAA(quality.smoothsEdges);
    emit qualityChanged(quality);
}

bool VtkView::renderApart(const std::function<void(vtkRenderWindow*)>& draw)
{
    if (!d->glReady)
        return false;
    makeCurrent();
    {
        const QScopedValueRollback<bool> guard(d->painting, true);
        auto* state = d->window->GetState();
        state->Reset();
        state->Push();
        state->vtkglDepthFunc(GL_LEQUAL);
        applyQuality(RenderQuality());
        draw(d->window);
        state->Pop();
    }
    doneCurrent();
    scheduleRender();
    return true;
}

void VtkView::releaseGl()
{
    if (!d->glReady)
        return;
    d->glReady = false;
    makeCurrent();
    d->window->Finalize();
    d->window->SetReadyForRendering(false);
    doneCurrent();
}

// Runs again whenever Qt gives the widget a new context (reparenting to another window, undocking).
void VtkView::initializeGL()
{
    if (d->boundContext != context()) {
        d->boundContext = context();
        connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &VtkView::releaseGl,
                Qt::DirectConnection);
    }
    d->surface = context()->surface();
    d->glReady = true;
    const auto* renderer = reinterpret_cast<const char*>(context()->functions()->glGetString(GL_RENDERER));
    const QByteArray name = renderer != nullptr ? QByteArray(renderer).toLower() : QByteArray();
    d->software = name.contains("llvmpipe") || name.contains("softpipe") || name.contains("swrast");
    d->window->SetForceMaximumHardwareLineWidth(1);
    d->window->SetReadyForRendering(true);
    d->window->SetOwnContext(0);
    d->window->OpenGLInitContext();
    auto* state = d->window->GetState();
    state->Reset();
    state->vtkglDepthFunc(GL_LEQUAL); // Qt leaves GL_LESS
    d->renderNeeded = true;
}

void VtkView::syncSize()
{
    const double ratio = devicePixelRatioF();
    const int w = qMax(1, qRound(width() * ratio));
    const int h = qMax(1, qRound(height() * ratio));
    const int* size = d->window->GetSize();
    if (size[0] != w || size[1] != h) {
        d->interactor->UpdateSize(w, h);
        d->renderNeeded = true;
    }
    constexpr double pointsPerInch = 72.0;
    const int dotsPerInch = qRound(pointsPerInch * ratio);
    if (d->window->GetDPI() != dotsPerInch) {
        d->window->SetDPI(dotsPerInch);
        d->renderNeeded = true;
    }
    const QSize screenSize = screen()->size() * ratio;
    d->window->SetScreenSize(screenSize.width(), screenSize.height());
}

void VtkView::paintGL()
{
    if (!d->glReady || d->painting)
        return;
    const QScopedValueRollback<bool> guard(d->painting, true);
    syncSize();
    auto* state = d->window->GetState();
    state->Reset();
    state->Push();
    state->vtkglDepthFunc(GL_LEQUAL);
    QElapsedTimer timer;
    timer.start();
    const bool isNew = std::exchange(d->renderNeeded, false);
    if (isNew) {
        applyQuality(quality());
        d->window->Render();
    }
    makeCurrent(); // an observer of VTK's may have changed it
    auto* gl = context()->extraFunctions();
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    const GLenum buffer = GL_COLOR_ATTACHMENT0;
    gl->glDrawBuffers(1, &buffer);
    state->vtkglDisable(GL_SCISSOR_TEST);
    gl->glDisable(GL_SCISSOR_TEST);
    if (auto* framebuffer = d->window->GetRenderFramebuffer()) {
        const int* rendered = framebuffer->GetLastSize();
        const int* size = d->window->GetSize();
        d->window->BlitDisplayFramebuffer(0, 0, 0, rendered[0], rendered[1], 0, 0, size[0], size[1],
                                          GL_COLOR_BUFFER_BIT, GL_LINEAR);
    }
    // Opaque, or a compositor may show what lies behind.
    gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    gl->glClearColor(0, 0, 0, 1);
    gl->glClear(GL_COLOR_BUFFER_BIT);
    gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->Pop();
    if (!isNew)
        return;
    // A processor draws when the picture is waited for: only then is it known what it took.
    if (d->software)
        gl->glFinish();
    const double milliseconds = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
    if (d->isMoving())
        d->governor.drawn(milliseconds);
    emit rendered(milliseconds);
}

bool VtkView::event(QEvent* event)
{
    if (d->events.forward(event, devicePixelRatioF())) {
        event->accept();
        return true;
    }
    return QOpenGLWidget::event(event);
}

void VtkView::Private::onWindowEvent(vtkObject* /*caller*/, unsigned long id, void* data)
{
    switch (id) {
    case vtkCommand::WindowMakeCurrentEvent:
        // Not QOpenGLWidget::makeCurrent(): it would bind Qt's framebuffer in the middle of VTK's drawing,
        // behind the back of VTK's state cache.
        if (glReady && QOpenGLContext::currentContext() != view->context())
            view->context()->makeCurrent(surface);
        break;
    case vtkCommand::WindowIsCurrentEvent:
        *static_cast<bool*>(data) =
            view->context() != nullptr && QOpenGLContext::currentContext() == view->context();
        break;
    case vtkCommand::WindowSupportsOpenGLEvent:
        *static_cast<int*>(data) = 1;
        break;
    case vtkCommand::WindowFrameEvent:
        // Someone called Render() outside paintGL: the picture is ready, show it.
        if (!painting && window->GetSwapBuffers()) {
            renderNeeded = false;
            view->update();
        }
        break;
    case vtkCommand::CursorChangedEvent:
        view->setCursor(cursorShape(*static_cast<int*>(data)));
        break;
    default:
        break;
    }
}

void VtkView::Private::createTimer(int id)
{
    auto* timer = new QTimer(view);
    timer->setSingleShot(interactor->GetTimerEventType() == vtkRenderWindowInteractor::OneShotTimer);
    QObject::connect(timer, &QTimer::timeout, view, [this, id] {
        int timerId = id;
        if (interactor->GetEnabled())
            interactor->InvokeEvent(vtkCommand::TimerEvent, &timerId);
    });
    interactor->SetTimerEventPlatformId(id);
    timers.insert(id, timer);
    timer->start(static_cast<int>(interactor->GetTimerEventDuration()));
}

void VtkView::Private::onInteractorEvent(vtkObject* /*caller*/, unsigned long id, void* data)
{
    if (id == vtkCommand::RenderEvent) {
        view->scheduleRender();
        return;
    }
    const int timerId = *static_cast<int*>(data);
    if (id == vtkCommand::CreateTimerEvent) {
        createTimer(timerId);
    } else if (QTimer* timer = timers.take(timerId)) {
        timer->stop();
        timer->deleteLater();
    }
}

} // namespace quadrille::widgets

#include "moc_vtkview.cpp"
