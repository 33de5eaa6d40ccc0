// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/vtkview.h"

#include "widgets/viewport/vtkcanvas.h"
#include "widgets/viewport/vtkevents.h"
#include "widgets/viewport/vtkformat.h"

#include <QElapsedTimer>
#include <QHash>
#include <QOpenGLContext>
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
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkSmartPointer.h>

namespace quadrille::widgets {

namespace {

/// A processor draws pictures that follow each other faster than this as well as there is time for.
constexpr std::chrono::milliseconds restTime{200};

int bestLevel = 0;                    // see VtkView::setBestLevel
std::optional<bool> drawnByProcessor; // see VtkView::setDrawnByProcessor

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

struct VtkView::Private : VtkPicture
{
    explicit Private(VtkView* owner) : view(owner), events(interactor) {}

    void begin(QOpenGLContext* made, QSurface* on) override;
    void end() override;
    void paint(const std::function<void(bool isNew)>& show) override;
    vtkGenericOpenGLRenderWindow* window() const override { return renderWindow; }
    double pixelRatio() const override { return view->pixelRatio(); }

    void onWindowEvent(vtkObject* caller, unsigned long id, void* data);
    void onInteractorEvent(vtkObject* caller, unsigned long id, void* data);
    void createTimer(int id);
    bool isMoving() const { return software && (moving || rest.isActive()); }

    VtkView* view;
    vtkNew<vtkGenericOpenGLRenderWindow> renderWindow;
    vtkSmartPointer<vtkGenericRenderWindowInteractor> interactor = makeInteractor();
    VtkEvents events;
    QOpenGLContext* context = nullptr;
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
    bool unshown = true; ///< VTK drew what was not shown yet
    bool moving = false; ///< something plays
    bool software = drawnByProcessor.value_or(isDrawnByProcessor());
    std::unique_ptr<VtkCanvas> canvas;
};

VtkView::VtkView(QWidget* parent) : QWidget(parent), d(std::make_unique<Private>(this))
{
    d->canvas = makeCanvas(d->software, *d, this);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_AcceptTouchEvents);

    d->renderWindow->SetOwnContext(0);
    d->renderWindow->SetReadyForRendering(false);
    d->renderWindow->SetMultiSamples(d->drawn.samples);
    d->rest.setSingleShot(true);
    d->rest.setInterval(restTime);
    connect(&d->rest, &QTimer::timeout, this, [this] {
        if (d->isMoving())
            return;
        d->governor.rested();
        d->renderNeeded = true;
        d->canvas->widget()->update();
    });
    d->renderWindow->SetFrameBlitModeToNoBlit();
    for (const unsigned long id :
         {vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent, vtkCommand::WindowFrameEvent,
          vtkCommand::CursorChangedEvent, vtkCommand::WindowSupportsOpenGLEvent})
        d->renderWindow->AddObserver(id, d.get(), &Private::onWindowEvent);

    d->interactor->SetRenderWindow(d->renderWindow);
    d->interactor->EnableRenderOff(); // the interactor's Render() only schedules a paint
    for (const unsigned long id :
         {vtkCommand::RenderEvent, vtkCommand::CreateTimerEvent, vtkCommand::DestroyTimerEvent})
        d->interactor->AddObserver(id, d.get(), &Private::onInteractorEvent);
    d->interactor->Initialize();
}

VtkView::~VtkView()
{
    d->end();
    d->renderWindow->RemoveAllObservers();
    d->interactor->RemoveAllObservers();
    d->interactor->SetInteractorStyle(nullptr);
    d->interactor->SetRenderWindow(nullptr);
    d->renderWindow->SetInteractor(nullptr);
    d->canvas.reset();
}

vtkRenderWindow* VtkView::renderWindow() const
{
    return d->renderWindow;
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
    d->canvas->widget()->update();
}

void VtkView::setBestLevel(int level)
{
    bestLevel = level;
}

void VtkView::setDrawnByProcessor(std::optional<bool> byProcessor)
{
    drawnByProcessor = byProcessor;
}

RenderQuality VtkView::quality() const
{
    if (d->held)
        return *d->held;
    return RenderGovernor::qualityOf(std::max(d->best, d->isMoving() ? d->governor.level() : 0));
}

double VtkView::pixelRatio() const
{
    return devicePixelRatioF() * d->drawn.scale;
}

void VtkView::setMoving(bool moving)
{
    d->moving = moving;
    if (d->software)
        d->rest.start();
}

void VtkView::setPictureRate(double picturesPerSecond)
{
    d->governor.setBudget(RenderGovernor::budgetFor(picturesPerSecond));
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
    d->renderWindow->SetMultiSamples(quality.samples);
    auto* renderers = d->renderWindow->GetRenderers();
    renderers->InitTraversal();
    while (vtkRenderer* renderer = renderers->GetNextItem())
        renderer->SetUseFXAA(quality.smoothsEdges);
    emit qualityChanged(quality);
}

bool VtkView::renderApart(const std::function<void(vtkRenderWindow*)>& draw)
{
    if (!d->glReady)
        return false;
    d->canvas->makeCurrent();
    {
        const QScopedValueRollback<bool> guard(d->painting, true);
        auto* state = d->renderWindow->GetState();
        state->Reset();
        state->Push();
        state->vtkglDepthFunc(GL_LEQUAL);
        applyQuality(RenderQuality());
        draw(d->renderWindow);
        state->Pop();
    }
    d->canvas->doneCurrent();
    scheduleRender();
    return true;
}

void VtkView::syncSize()
{
    const double ratio = pixelRatio();
    const int w = qMax(1, qRound(width() * ratio));
    const int h = qMax(1, qRound(height() * ratio));
    const int* size = d->renderWindow->GetSize();
    if (size[0] != w || size[1] != h) {
        d->interactor->UpdateSize(w, h);
        d->renderNeeded = true;
    }
    constexpr double pointsPerInch = 72.0;
    const int dotsPerInch = qRound(pointsPerInch * ratio);
    if (d->renderWindow->GetDPI() != dotsPerInch) {
        d->renderWindow->SetDPI(dotsPerInch);
        d->renderNeeded = true;
    }
    const QSize screenSize = screen()->size() * devicePixelRatioF();
    d->renderWindow->SetScreenSize(screenSize.width(), screenSize.height());
}

void VtkView::resizeEvent(QResizeEvent* event)
{
    d->canvas->widget()->setGeometry(rect());
    QWidget::resizeEvent(event);
}

bool VtkView::event(QEvent* event)
{
    if (d->events.forward(event, pixelRatio())) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void VtkView::Private::begin(QOpenGLContext* made, QSurface* on)
{
    context = made;
    surface = on;
    glReady = true;
    renderWindow->SetForceMaximumHardwareLineWidth(1);
    renderWindow->SetReadyForRendering(true);
    renderWindow->SetOwnContext(0);
    renderWindow->OpenGLInitContext();
    auto* state = renderWindow->GetState();
    state->Reset();
    state->vtkglDepthFunc(GL_LEQUAL); // Qt leaves GL_LESS
    renderNeeded = true;
}

void VtkView::Private::end()
{
    if (!glReady)
        return;
    glReady = false;
    canvas->makeCurrent();
    renderWindow->Finalize();
    renderWindow->SetReadyForRendering(false);
    canvas->doneCurrent();
}

void VtkView::Private::paint(const std::function<void(bool isNew)>& show)
{
    if (!glReady || painting)
        return;
    const QScopedValueRollback<bool> guard(painting, true);
    if (renderNeeded)
        view->applyQuality(view->quality());
    view->syncSize();
    auto* state = renderWindow->GetState();
    state->Reset();
    state->Push();
    state->vtkglDepthFunc(GL_LEQUAL);
    QElapsedTimer timer;
    timer.start();
    const bool isNew = std::exchange(renderNeeded, false);
    if (isNew) {
        renderWindow->Render();
        unshown = true;
    }
    canvas->makeCurrent(); // an observer of VTK's may have changed it
    show(std::exchange(unshown, false));
    state->Pop();
    if (!isNew)
        return;
    const double milliseconds = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
    if (isMoving())
        governor.drawn(milliseconds);
    emit view->rendered(milliseconds);
}

void VtkView::Private::onWindowEvent(vtkObject* /*caller*/, unsigned long id, void* data)
{
    switch (id) {
    case vtkCommand::WindowMakeCurrentEvent:
        // Not QOpenGLWidget::makeCurrent(): it would bind Qt's framebuffer in the middle of VTK's drawing,
        // behind the back of VTK's state cache.
        if (glReady && QOpenGLContext::currentContext() != context)
            context->makeCurrent(surface);
        break;
    case vtkCommand::WindowIsCurrentEvent:
        *static_cast<bool*>(data) = glReady && QOpenGLContext::currentContext() == context;
        break;
    case vtkCommand::WindowSupportsOpenGLEvent:
        *static_cast<int*>(data) = 1;
        break;
    case vtkCommand::WindowFrameEvent:
        // Someone called Render() outside paintGL: the picture is ready, show it.
        if (!painting && renderWindow->GetSwapBuffers()) {
            renderNeeded = false;
            unshown = true;
            canvas->widget()->update();
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
