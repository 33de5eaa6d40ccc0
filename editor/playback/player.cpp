// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/playback/player.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille {

namespace {

constexpr double fastest = 8.0;

} // namespace

Player::Player(ClipScene& scene, QObject* parent) : QObject(parent), m_scene(scene)
{
    m_time.start();
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &Player::tick);
    connect(&m_scene, &ClipScene::frameShown, this, [this](FrameIndex frame) {
        if (isPlaying())
            setFrame(frame);
    });
    // Not in the middle of painting: what listens changes its own texts.
    connect(&m_scene, &ClipScene::framePainted, this, &Player::measure, Qt::QueuedConnection);
}

void Player::setFps(double fps)
{
    m_clock.setFps(fps);
    if (isPlaying())
        play(m_clock.speed());
}

void Player::setRange(FrameIndex first, FrameIndex last)
{
    m_first = first;
    m_last = last;
    m_clock.setRange(first.value, last.value);
    if (isPlaying())
        play(m_clock.speed());
}

void Player::setLooping(bool looping)
{
    m_clock.setLooping(looping);
}

void Player::toggle()
{
    if (isPlaying())
        pause();
    else
        play();
}

void Player::play(double speed)
{
    if (m_scene.frameCount() == 0)
        return;
    const bool wasPlaying = isPlaying();
    const bool isAtEnd = speed > 0 ? m_frame >= m_last : m_frame <= m_first;
    const FrameIndex start = isAtEnd ? (speed > 0 ? m_first : m_last) : m_frame;
    m_clock.start(start.value, now(), speed);
    m_rate.restart();
    if (!wasPlaying)
        emit playingChanged(true);
    if (isPlaying()) // nobody who heard of it has paused it
        tick();
}

void Player::pause()
{
    if (!isPlaying())
        return;
    m_clock.stop();
    m_timer.stop();
    stopAt(m_scene.comingFrame());
}

void Player::playAndReturn()
{
    if (isPlaying()) {
        pause();
        return;
    }
    const FrameIndex here = m_frame;
    play();
    if (isPlaying())
        m_returnsTo = here;
}

void Player::stopAt(FrameIndex frame)
{
    show(std::exchange(m_returnsTo, std::nullopt).value_or(frame), 0);
    emit playingChanged(false);
}

void Player::step(int frames)
{
    pause();
    goTo(m_frame.value + frames);
}

void Player::goTo(qint64 frame)
{
    const std::int64_t last = std::max<std::int64_t>(0, m_scene.frameCount() - 1);
    const FrameIndex wanted(std::clamp<std::int64_t>(frame, 0, last));
    if (isPlaying())
        m_clock.start(wanted.value, now(), m_clock.speed());
    m_rate.restart();
    show(wanted, 0);
}

void Player::shuttle(int direction)
{
    const double speed = isPlaying() ? m_clock.speed() : 0.0;
    const bool isFaster = speed * direction > 0;
    play(isFaster ? std::clamp(2 * speed, -fastest, fastest) : direction);
}

void Player::tick()
{
    const double time = now();
    const FrameIndex frame(m_clock.frameAt(time));
    if (!isPlaying()) {
        stopAt(frame);
        return;
    }
    const double speed = m_clock.speed();
    if (frame != m_scene.comingFrame())
        show(frame, speed > 0 ? std::max(1, static_cast<int>(std::lround(speed)))
                              : std::min(-1, static_cast<int>(std::lround(speed))));
    m_timer.start(static_cast<int>(std::ceil(m_clock.untilNext(time) * 1000)));
}

/// While it plays, the playhead is where the picture is; otherwise the picture follows the playhead.
void Player::show(FrameIndex frame, int step)
{
    m_scene.showFrame(frame, step);
    if (!isPlaying())
        setFrame(frame);
}

void Player::setFrame(FrameIndex frame)
{
    if (frame == m_frame)
        return;
    m_frame = frame;
    emit frameChanged(frame.value);
}

void Player::measure(FrameIndex frame)
{
    if (!isPlaying())
        return;
    const double time = now();
    m_rate.painted(frame.value, time);
    if (const auto reached = m_rate.report(time))
        emit fpsReached(*reached);
}

} // namespace quadrille

#include "moc_player.cpp"
