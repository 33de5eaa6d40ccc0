// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/playback/player.h"
#include "model/audio/sound.h"

#include <QObject>
#include <memory>

namespace quadrille {

/// Where sound is heard.
class SoundOutput
{
public:
    virtual ~SoundOutput() = default;
    /// Plays from a time of the sound on, seconds; silence first where it is below zero. \param gain
    /// decibels. What plays ends.
    virtual void start(std::shared_ptr<const Sound> sound, double gain, double from) = 0;
    virtual void stop() = 0;
    /// The time of the sound that is heard now, seconds. \pre It was started.
    virtual double heard() const = 0;
};

/// Lets a sound be heard in step with a player: while it plays forwards at its true rate. What jumps or
/// drifts apart is brought together again.
class SoundPlayer : public QObject
{
    Q_OBJECT

public:
    /// How far sound and picture may be apart, seconds.
    static constexpr double tolerance = 0.12;

    /// \param output  null: nothing is ever heard.
    SoundPlayer(Player& player, std::unique_ptr<SoundOutput> output, QObject* parent = nullptr);
    ~SoundPlayer() override;

    /// Null for none. \param offset  when it begins, seconds. \param gain  decibels.
    void setSound(std::shared_ptr<const Sound> sound, double offset, double gain);
    void setFps(double fps);
    void setMuted(bool muted);
    void setOutput(std::unique_ptr<SoundOutput> output);
    /// Whether the output was started and not stopped since.
    bool isSounding() const { return m_isSounding; }

private:
    void follow();
    void stop();

    Player& m_player;
    std::unique_ptr<SoundOutput> m_output;
    std::shared_ptr<const Sound> m_sound;
    double m_offset = 0;
    double m_gain = 0;
    double m_fps = 25;
    bool m_isMuted = false;
    bool m_isSounding = false;
};

} // namespace quadrille
