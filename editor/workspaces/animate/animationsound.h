// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/playback/soundplayer.h"
#include "model/audio/waveform.h"
#include "model/core/error.h"

#include <QPointer>
#include <filesystem>
#include <optional>

namespace quadrille {

class CurrentAnimation;
class Job;

namespace widgets {
class SoundLane;
} // namespace widgets

/// The sound of the animation that is worked on: its lane below the timeline, its actions, and what is heard.
class AnimationSound : public QObject
{
    Q_OBJECT

public:
    explicit AnimationSound(CurrentAnimation& animation, QObject* parent = nullptr);

    /// Takes a file as the animation's sound, from its start.
    void use(const std::filesystem::path& file);
    void remove();
    SoundPlayer& player() { return *m_player; }
    widgets::SoundLane& lane() { return *m_lane; }
    /// The sound that is there to be heard; null before it is read.
    std::shared_ptr<const Sound> sound() const { return m_sound; }

private:
    void makeActions();
    void refresh();
    void read(const std::filesystem::path& file);
    void show();
    void choose();
    void setOffset(double seconds, bool committed);

    CurrentAnimation& m_animation;
    widgets::SoundLane* m_lane;
    SoundPlayer* m_player;
    QString m_folder; ///< that a sound was chosen from last
    std::filesystem::path m_file;
    std::shared_ptr<const Sound> m_sound;
    std::shared_ptr<const Waveform> m_waveform;
    std::optional<Error> m_error;
    QPointer<Job> m_job;
};

} // namespace quadrille
