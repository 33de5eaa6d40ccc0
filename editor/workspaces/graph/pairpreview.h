// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/jobs/job.h"
#include "model/project/results/opencharacter.h"

#include <QObject>
#include <QPointer>
#include <list>
#include <memory>
#include <optional>

namespace quadrille {

class JobRunner;

/// A transition with some captured frames on both sides, blended.
struct TransitionClip
{
    FramePair frames;
    bool isGentle = false;
    MeshSequence sequence;
    std::int64_t first = 0; ///< frame that shows the pose it leaves
    std::int64_t last = 0;  ///< frame that shows the pose it arrives at
};

/// Makes what a view shows of transitions, in jobs: the two frames of one, laid over each other as the
/// transition would, and the clip of one. Of several that are asked for while one is made, only the newest
/// is made next. Clips are kept, those used last.
class PairPreview : public QObject
{
    Q_OBJECT

public:
    /// Names of the clips, for ClipScene.
    static QString sourceName();
    static QString destinationName();
    static QString clipName();

    explicit PairPreview(JobRunner& jobs, QObject* parent = nullptr);
    ~PairPreview() override;

    /// \param opened  null for none. What was made and asked for is forgotten.
    void setCharacter(std::shared_ptr<const OpenedCharacter> opened);
    /// Takes one with the same frames instead; what was made stays.
    void replaceCharacter(std::shared_ptr<const OpenedCharacter> opened) { m_opened = std::move(opened); }
    /// Whether speeds stay smooth and standing feet in place (BlendSettings::gentle), or as published. The
    /// clip that is shown is made anew.
    void setGentle(bool gentle);
    /// Makes both frames: they stand at the origin, turned as the transition turns them. Nothing happens
    /// without a character.
    void showFrames(const FramePair& pair);
    /// \pre there is a transition between them.
    void makeClip(const FramePair& pair);

    /// By the names above; null until there is one.
    const MeshSequence* sequence(const QString& name) const;
    const TransitionClip* clip() const { return m_clip.get(); }

signals:
    /// Other frames can be shown.
    void framesChanged();
    void clipChanged();
    /// A clip could not be made; that of before stays.
    void clipFailed(const quadrille::Error& error);

private:
    struct Frames
    {
        FramePair pair;
        MeshSequence source;
        MeshSequence destination;
    };
    static Frames readFrames(const OpenedCharacter& opened, const FramePair& pair);
    static TransitionClip blend(const OpenedCharacter& opened, const FramePair& pair, bool isGentle,
                                const Progress& progress);
    void startFrames();
    void startClip();
    void take(std::shared_ptr<const TransitionClip> clip);

    JobRunner& m_jobs;
    std::shared_ptr<const OpenedCharacter> m_opened;
    int m_generation = 0; ///< of the frames: results of earlier ones are dropped
    bool m_isGentle = false;
    std::optional<FramePair> m_wantedFrames;
    std::optional<FramePair> m_wantedClip;
    std::optional<Frames> m_frames;
    std::shared_ptr<const TransitionClip> m_clip;
    std::list<std::shared_ptr<const TransitionClip>> m_known; ///< used last first
    QPointer<Job> m_framesJob;
    QPointer<Job> m_clipJob;
};

} // namespace quadrille
