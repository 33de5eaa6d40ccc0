// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/playback/soundplayer.h"

#include <cmath>

namespace quadrille {

SoundPlayer::SoundPlayer(Player& player, std::unique_ptr<SoundOutput> output, QObject* parent)
    : QObject(parent), m_player(player), m_output(std::move(output))
{
    connect(&player, &Player::playingChanged, this, &SoundPlayer::follow);
    connect(&player, &Player::frameChanged, this, &SoundPlayer::follow);
}

SoundPlayer::~SoundPlayer() = default;

void SoundPlayer::setSound(std::shared_ptr<const Sound> sound, double offset, double gain)
{
    if (sound == m_sound && offset == m_offset && gain == m_gain)
        return;
    stop();
    m_sound = std::move(sound);
    m_offset = offset;
    m_gain = gain;
    follow();
}

void SoundPlayer::setFps(double fps)
{
    m_fps = fps;
}

void SoundPlayer::setMuted(bool muted)
{
    m_isMuted = muted;
    follow();
}

void SoundPlayer::setOutput(std::unique_ptr<SoundOutput> output)
{
    stop();
    m_output = std::move(output);
    follow();
}

void SoundPlayer::follow()
{
    const double wanted = static_cast<double>(m_player.frame().value) / m_fps - m_offset;
    const bool sounds = m_output && m_sound && !m_isMuted && m_player.isPlaying() && m_player.speed() == 1 &&
                        wanted < m_sound->seconds();
    if (!sounds) {
        stop();
        return;
    }
    if (m_isSounding && std::abs(m_output->heard() - wanted) <= tolerance)
        return;
    m_output->start(m_sound, m_gain, wanted);
    m_isSounding = true;
}

void SoundPlayer::stop()
{
    if (m_isSounding)
        m_output->stop();
    m_isSounding = false;
}

} // namespace quadrille

#include "moc_soundplayer.cpp"
