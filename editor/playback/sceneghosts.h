// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/meshsequence.h"
#include "widgets/viewport/viewport.h"

#include <QColor>
#include <QObject>
#include <functional>
#include <map>
#include <set>
#include <vector>

namespace quadrille {

class JobRunner;

/// Earlier and later poses of the clips that a view shows: one every so many frames, and those of frames that
/// were pinned, which tell their number. Pinned frames are kept while their clip is not shown.
class SceneGhosts : public QObject
{
    Q_OBJECT

public:
    using ColorOf = std::function<QColor(const QString& clip, std::int64_t frame)>;

    /// \param colorOf  of a frame's ghost, without its transparency.
    SceneGhosts(widgets::Viewport& viewport, JobRunner& jobs, ColorOf colorOf, QObject* parent = nullptr);

    /// A figure shows a clip, or another one of this name.
    void show(const QString& clip, int figure, const MeshSequence& sequence);
    /// The clip is not shown any more.
    void remove(const QString& clip);
    void rename(const QString& before, const QString& after);

    /// Ghosts every `interval` frames; 0 for none. They are farther apart where there would be more than
    /// about two dozen.
    void setInterval(int interval);
    int interval() const { return m_interval; }
    /// \param frame  of the clip, from 0.
    void setPinned(const QString& clip, FrameIndex frame, bool pinned);
    bool isPinned(const QString& clip, FrameIndex frame) const;
    bool hasPinned() const { return !m_pinned.empty(); }
    /// Unpins all of all clips.
    void unpinAll();

signals:
    /// Frames were pinned or unpinned; not by renaming.
    void pinnedChanged();

private:
    struct Shown
    {
        int figure = -1;
        MeshSequence sequence;
        int run = 0; ///< counts what was asked for, so that late ghosts are known
    };
    struct Wish
    {
        std::int64_t frame = 0;
        bool isPinned = false;
    };

    std::vector<Wish> wishes(const QString& clip, const Shown& shown) const;
    void update(const QString& clip);
    void updateAll();

    widgets::Viewport& m_viewport;
    JobRunner& m_jobs;
    ColorOf m_colorOf;
    int m_interval = 0;
    std::map<QString, Shown> m_shown;
    std::map<QString, std::set<std::int64_t>> m_pinned;
};

} // namespace quadrille
