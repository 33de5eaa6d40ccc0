// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/rendergovernor.h"

#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

class vtkRenderWindow;
class vtkRenderWindowInteractor;

namespace quadrille::widgets {

/// Shows a VTK render window. VTK draws into its own framebuffer inside the OpenGL context of a canvas (see
/// vtkcanvas.h) that fills the view; painting copies the result. The context may be replaced (undocking):
/// VTK's objects are then rebuilt. \pre openGlAvailable()
class VtkView : public QWidget
{
    Q_OBJECT
public:
    explicit VtkView(QWidget* parent = nullptr);
    ~VtkView() override;

    /// Sets the default surface format; call before the QApplication is constructed.
    static void setDefaultFormat();
    /// Whether a context that VTK can use is to be had. Where it is not, constructing a view would crash.
    static bool openGlAvailable();

    vtkRenderWindow* renderWindow() const;
    vtkRenderWindowInteractor* interactor() const;
    /// Asks for a redraw; any number of calls before the next paint cost one frame. Where there is no
    /// graphics card, pictures that follow each other are drawn as well as there is time for; once no
    /// further redraw was asked for during a fifth of a second, as well as can be.
    void scheduleRender();
    /// While something plays, pictures follow each other however far they are apart.
    void setMoving(bool moving);
    /// How many pictures a second are wanted while something plays; 25 unless set.
    void setPictureRate(double picturesPerSecond);
    /// How well pictures that follow each other are drawn now.
    RenderQuality quality() const;
    /// Pixels that VTK draws for one logical pixel; changes with the quality.
    double pixelRatio() const;
    /// The best level (see RenderGovernor) at which the views of the program draw that are made from now on;
    /// 0 unless set. For tests, most of which look at other things than edges and shadows.
    static void setBestLevel(int level);
    /// Whether views that are made from now on show their pictures as those of a processor. None, as at
    /// first: if a processor draws. For tests.
    static void setDrawnByProcessor(std::optional<bool> byProcessor);
    /// Draws all pictures so, whatever they take; for measuring. None: the governor chooses again.
    void holdQuality(std::optional<RenderQuality> quality);
    /// Runs VTK drawing that is not the widget's own picture (a snapshot) with the context current, and
    /// draws the widget anew afterwards. Does nothing and returns false before the widget was first shown.
    bool renderApart(const std::function<void(vtkRenderWindow*)>& draw);

signals:
    /// A picture was drawn. \param milliseconds  what drawing took.
    void rendered(double milliseconds);
    /// The next picture is drawn so; told before it is.
    void qualityChanged(const quadrille::widgets::RenderQuality& quality);

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    struct Private;
    std::unique_ptr<Private> d;
    void syncSize();
    void applyQuality(const RenderQuality& quality);
};

} // namespace quadrille::widgets
