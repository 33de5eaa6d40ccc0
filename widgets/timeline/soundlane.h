// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/timelinelane.h"

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::widgets {

/// A sound below a timeline, drawn by its peaks. It is dragged, or moved by the arrow keys, by a frame (with
/// Shift by a tenth of a second); it snaps to the first frame unless Alt is held. Delete asks to remove it.
/// While it is dragged, signals come with `committed` false, at the end once with true; Escape ends with the
/// old value.
class SoundLane : public TimelineLane
{
    Q_OBJECT

public:
    /// The lowest and highest sample, −1 … 1, of `count` stretches of `seconds` from a time of the sound.
    using Peaks = std::function<std::vector<std::pair<float, float>>(double from, double seconds, int count)>;

    using TimelineLane::TimelineLane;

    /// \param seconds  how long it is; 0 for no sound. \param peaks  called when the lane is painted.
    void setSound(const QString& name, double seconds, Peaks peaks);
    void setMuted(bool muted);
    /// When it begins. Emits nothing.
    void setOffset(double seconds);
    double offset() const { return m_offset; }
    /// Where the sound is drawn, in this widget; it may reach beyond.
    QRectF soundRect() const;

signals:
    /// Rounded to milliseconds; it may be before the first frame.
    void offsetEdited(double seconds, bool committed);
    void removalRequested();
    /// A click while there is no sound.
    void choiceRequested();

protected:
    void paintContent(QPainter& painter, const QRectF& area) override;
    bool isEmpty() const override { return m_seconds <= 0; }
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Drag
    {
        double x = 0;
        double offset = 0;
    };
    void edit(double offset, bool committed);

    QString m_name;
    double m_seconds = 0;
    double m_offset = 0;
    bool m_muted = false;
    Peaks m_peaks;
    std::optional<Drag> m_drag;
};

} // namespace quadrille::widgets
