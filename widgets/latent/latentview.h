// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/latent/latentpath.h"
#include "widgets/theme/colormap.h"
#include "widgets/viewport/turntable.h"

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

namespace quadrille::widgets {

/// Movements in the latent space of a model, in three dimensions: a line for each, its start marked, the
/// frame that is shown as a point on it, and how sure the model is as colours. Looked at as a viewport.
/// Keys: ← and → (Home, End) go from frame to frame of the chosen path, ↑ and ↓ choose another, Return goes
/// there; F shows everything, 1, 3 and 7 look along the axes.
class LatentView : public QWidget
{
    Q_OBJECT

public:
    /// A frame of a path.
    struct Place
    {
        int path = 0;
        int frame = 0;

        bool operator==(const Place&) const = default;
    };

    explicit LatentView(QWidget* parent = nullptr);
    ~LatentView() override;

    /// The first paths frame the view; later ones leave the camera where it is. What was chosen stays by its
    /// place, where there still is one.
    void setPaths(std::vector<LatentPath> paths);
    const std::vector<LatentPath>& paths() const;
    /// \param dimensions  of the space. In two the view looks from above; beyond three the first three are
    /// shown, and it says so.
    void setDimensions(int dimensions);
    /// The frame that is shown of each path; nothing where none is.
    void setCurrent(std::vector<std::optional<double>> frames);
    /// Points in the space, and what colours mean; both for as long as confidence is shown.
    void setConfidence(LatentCloud cloud, const ScalarRange& range);
    /// Whether colours tell how sure the model is, instead of which path a line is.
    void setConfidenceShown(bool shown);
    bool isConfidenceShown() const;
    /// What is said for as long as there are no paths.
    void setEmptyText(const QString& text);
    bool isEmpty() const { return paths().empty(); }

    /// What the pointer or the keys are at.
    std::optional<Place> chosen() const;
    /// "walk_1, frame 12", with how sure the model is.
    QString readOut() const;
    /// Where a frame of a path appears; nothing behind the camera.
    std::optional<QPointF> positionOf(const Place& place) const;
    Turntable camera() const;
    void setCamera(const Turntable& camera);
    void frameAll();
    void lookFrom(StandardView view);

    QSize sizeHint() const override { return {320, 300}; }
    QSize minimumSizeHint() const override { return {160, 140}; }

signals:
    /// The user wants to see a frame of a path. A click on it, or Return.
    void activated(int path, int frame);
    /// The pointer or the keys are at another place, or at none.
    void chosenChanged();

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    class Overlay;
    struct Private;

    void choose(std::optional<Place> place);
    std::optional<Place> placeAt(const QPointF& position) const;
    void stepChosen(int paths, int frames);
    void redraw();
    void updateScene();
    void paint(QPainter& painter) const;
    void paintPaths(QPainter& painter) const;
    void paintAxisNames(QPainter& painter) const;
    void paintTexts(QPainter& painter) const;
    QRectF legendPlace(const QFont& font) const;

    std::unique_ptr<Private> d;
};

} // namespace quadrille::widgets
