// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QLabel;
class QSpinBox;
class QToolButton;

namespace quadrille::widgets {

class ElidedLabel;

/// First, previous, play, next, last, loop, the frame as a number and the rate reached. It changes nothing
/// itself: buttons are signals, and what plays comes back by the setters.
class PlaybackBar : public QWidget
{
    Q_OBJECT
public:
    explicit PlaybackBar(QWidget* parent = nullptr);

    /// \param frames  0 disables the bar. Emits nothing.
    void setFrameCount(int frames);
    /// The true rate, for times beside frames.
    void setFps(double fps);
    /// Emits nothing. It may lie behind the last frame that plays.
    void setCurrentFrame(int frame);
    /// The rate reached is hidden when it stops.
    void setPlaying(bool playing);
    void setLooping(bool looping);
    /// Ways of looping to choose from, beside the button that loops. \param actions  outlive the bar.
    void setLoopActions(const QList<QAction*>& actions);
    /// Frames a second reached while playing; 0 hides the number.
    void setFpsReached(double fps);

signals:
    void playToggled();
    /// A step from the current frame, e.g. −1.
    void stepRequested(int frames);
    void firstRequested();
    void lastRequested();
    void frameEntered(int frame);
    void loopToggled(bool looping);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QToolButton* addButton(const char* name);
    void retranslate();
    void setRoom(int lastFrame);
    void enter(int frame);
    void showTime();

    QToolButton* m_first;
    QToolButton* m_previous;
    QToolButton* m_play;
    QToolButton* m_next;
    QToolButton* m_last;
    QToolButton* m_loop;
    QSpinBox* m_frame;
    ElidedLabel* m_time;
    QLabel* m_reached;
    double m_fps = 25.0;
    int m_frames = 0;
    bool m_playing = false;
    double m_fpsReached = 0;
};

} // namespace quadrille::widgets
