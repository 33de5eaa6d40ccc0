// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/latent/latentscene.h"
#include "widgets/latent/latentview.h"
#include "widgets/viewport/viewgestures.h"

#include <QKeyEvent>

namespace quadrille::widgets {

class VtkView;

/// Paints over VTK's picture and lets the pointer through.
class LatentView::Overlay : public QWidget
{
public:
    explicit Overlay(LatentView& view);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    LatentView& m_view;
};

struct LatentView::Private
{
    VtkView* view = nullptr;    ///< null without OpenGL
    QWidget* surface = nullptr; ///< the view, or why there is none
    LatentScene scene;
    ViewGestures* gestures = nullptr;
    Overlay* overlay = nullptr;
    std::vector<LatentPath> paths;
    std::vector<std::optional<double>> current; ///< as many as paths
    LatentCloud cloud;
    ScalarRange range;
    QString emptyText;
    std::optional<Place> chosen;
    int dimensions = 3;
    bool isConfidenceShown = false;

    int frameCount(int path) const
    {
        return static_cast<int>(paths[static_cast<std::size_t>(path)].points.size());
    }
    /// Lower and upper corner of what the paths take up, with some room.
    std::pair<QVector3D, QVector3D> box() const;
    /// The corner that axes start at, and their ends.
    std::array<QVector3D, 4> axes() const;
    std::optional<QPointF> project(const QVector3D& point) const;
    static bool isOwnKey(const QKeyEvent& event);
};

} // namespace quadrille::widgets
