// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/results/openanimation.h"

#include <QObject>
#include <QPointer>
#include <optional>

namespace quadrille {

class Job;
class JobRunner;

/// A transition with some of the frames before and behind it, blended in a job to be looked at. Of several
/// that are asked for quickly, only the last is blended.
class TransitionPreview : public QObject
{
    Q_OBJECT

public:
    explicit TransitionPreview(JobRunner& jobs, QObject* parent = nullptr);
    ~TransitionPreview() override;

    /// The clip of before stays until it is there. Nothing happens for what was asked for last, unless it
    /// failed.
    /// \param entry  how it is blended. \pre There is a transition between the frames.
    void show(const std::shared_ptr<const OpenedCharacter>& character, const FramePair& transition,
              const AnimationEntry& entry);
    /// Forgets the clip, and what is being blended.
    void end();
    /// What a scene calls it; no animation has this name.
    static QString name() { return QStringLiteral("/preview"); }
    /// Null while there is none.
    const MeshSequence* clip() const { return m_clip ? &m_clip->sequence : nullptr; }
    /// Frames of the clip before the transition. \pre There is one.
    int lead() const { return m_clip->lead; }

signals:
    /// There is another clip, or none any more.
    void changed();

private:
    struct Blended
    {
        MeshSequence sequence;
        int lead = 0;
    };
    static Blended blend(const OpenedCharacter& character, const FramePair& transition,
                         const AnimationEntry& entry, const Progress& progress);
    struct Asked
    {
        std::shared_ptr<const OpenedCharacter> character;
        FramePair transition;
        InterpolationMethod interpolation;
        bool isGentle = false;
        bool operator==(const Asked&) const = default;
    };

    JobRunner& m_jobs;
    QPointer<Job> m_job;
    std::optional<Asked> m_asked; ///< what was asked for last; nothing where it failed
    std::optional<Blended> m_clip;
};

} // namespace quadrille
