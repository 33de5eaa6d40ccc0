// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/playback/clipscene.h"
#include "widgets/timeline/paintedrate.h"
#include "widgets/timeline/playbackclock.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace quadrille {

/// Plays what the scene shows: holds the rate by leaving frames out and tells which frame it is at, while it
/// plays the one that is seen. Frames are those of the scene, from 0.
class Player : public QObject
{
    Q_OBJECT

public:
    /// \param scene  outlives it.
    explicit Player(ClipScene& scene, QObject* parent = nullptr);

    /// The true rate, frames a second.
    void setFps(double fps);
    /// Frames that play, both included. \pre 0 ≤ first ≤ last < the scene's frameCount().
    void setRange(FrameIndex first, FrameIndex last);
    /// Whether it begins again at the end of the range, or stops there.
    void setLooping(bool looping);
    void setBackAndForth(bool backAndForth) { m_clock.setBackAndForth(backAndForth); }
    bool isPlaying() const { return m_clock.isPlaying(); }
    /// Times the true rate, of what plays now or played last.
    double speed() const { return m_clock.speed(); }
    FrameIndex frame() const { return m_frame; }

public slots:
    void toggle();
    /// At an end it begins again from the other one. Nothing happens while the scene shows no frame.
    /// \param speed times the true rate; negative plays backwards.
    void play(double speed = 1.0);
    void pause();
    /// Plays, and goes back to where it is now when it stops. While it plays, that is to stop.
    void playAndReturn();
    /// Stops, and goes so many frames on, or back where negative. It may leave the range.
    void step(int frames);
    /// Kept inside the scene's frames. While it plays, it plays on from there.
    void goTo(qint64 frame);
    void goToStart() { goTo(m_first.value); }
    void goToEnd() { goTo(m_last.value); }
    /// J and L: plays in a direction (−1, 1), twice as fast each time it is asked for again. Up to eight
    /// times the true rate.
    void shuttle(int direction);

signals:
    /// While it plays, when the frame is shown; else when it is asked for.
    void frameChanged(qint64 frame);
    void playingChanged(bool playing);
    /// Frames painted a second while it plays, about twice a second; 0 when that is not known yet.
    void fpsReached(double fps);

private:
    void tick();
    void stopAt(FrameIndex frame);
    void show(FrameIndex frame, int step);
    void setFrame(FrameIndex frame);
    void measure(FrameIndex frame);
    double now() const { return static_cast<double>(m_time.nsecsElapsed()) * 1e-9; }

    ClipScene& m_scene;
    widgets::PlaybackClock m_clock;
    QElapsedTimer m_time;
    QTimer m_timer;
    FrameIndex m_first{0};
    FrameIndex m_last{0};
    FrameIndex m_frame{0};
    widgets::PaintedRate m_rate;
    std::optional<FrameIndex> m_returnsTo; ///< when it stops
};

} // namespace quadrille
