// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/changeevent.h"
#include "editor/playback/frameloader.h"
#include "editor/playback/sceneghosts.h"
#include "model/core/error.h"
#include "model/sequence/axes.h"
#include "widgets/viewport/viewport.h"

#include <QObject>
#include <functional>
#include <optional>
#include <vector>

namespace quadrille {

class JobRunner;

/// What a viewport shows of a document: one clip, or several to compare. Feeds the figures with frames and
/// textures, and draws trajectories and ghosts. Whoever owns the clips says when one is another: `update`.
class ClipScene : public QObject
{
    Q_OBJECT

public:
    /// Where clips come from.
    struct Source
    {
        /// A clip by its name, alone or compared with others; null until it can be shown.
        std::function<const MeshSequence*(const QString& name, bool isComparing)> clip;
        std::function<UpAxis()> upAxis;
        /// The colour of a frame's ghost; that of captured frames where empty.
        std::function<QColor(const QString& name, std::int64_t frame)> ghostColor = {};
        bool drawsWay = true; ///< of one clip alone, over the ground
        /// The colour of a clip among several; by their order where empty.
        std::function<QColor(const QString& name)> color = {};
        Section section = Section::Sequences; ///< whose names the clips have
    };

    /// Refers to viewport and jobs, and takes the viewport's figures for its own.
    ClipScene(widgets::Viewport& viewport, Source source, JobRunner& jobs, QObject* parent = nullptr);
    ~ClipScene() override;

    /// Shows these clips, in this order; those that are not ready come as soon as they are.
    void show(const QStringList& names);
    /// Whose names the clips have.
    Section section() const { return m_source.section; }
    /// A clip that is shown has another name: it stays as it is.
    void rename(const QString& before, const QString& after);
    /// A clip is ready, or another than before.
    void update(const QString& name);
    /// What comes next is shown from where the camera is now.
    void keepCamera();
    /// Whether none of them can be seen.
    bool isEmpty() const { return m_actors.empty(); }
    bool isComparing() const { return m_names.size() > 1; }
    const QStringList& shown() const { return m_names; }
    /// Shows a frame as soon as all sequences have read it; shorter ones stay at their last one. Of frames
    /// that are asked for meanwhile the last one comes next. \param step as FrameLoader::want.
    void showFrame(FrameIndex frame, int step = 0);
    /// The frame that is shown.
    FrameIndex frame() const { return m_frame; }
    /// The frame that is being read, else the one that is shown.
    FrameIndex comingFrame() const { return isLoading() ? m_loading : m_frame; }
    /// The length of the longest sequence shown that is ready; 0 without any.
    std::int64_t frameCount() const;
    SceneGhosts& ghosts() { return m_ghosts; }
    /// Whether the frame that was asked for last is pinned as a ghost, of any clip.
    bool isPinned() const;
    /// Pins that frame as a ghost of each clip, or takes it away.
    void setPinned(bool pinned);
    /// The figure that shows a sequence; −1 when there is none yet. It is another one when the clip comes
    /// with another topology.
    int figureOf(const QString& name) const;
    /// The picture that a sequence wears now; null when there is none. Of the first material.
    QImage textureOf(const QString& name) const;
    /// The sequence as it is shown; null until it can be. Good until `changed`; so for loadedFrame().
    const MeshSequence* sequenceOf(const QString& name) const;
    /// What was read of the frame that a sequence shows now, without positions; null until there is any.
    const LoadedFrame* loadedFrame(const QString& name) const;

signals:
    /// A figure shows another frame: `loadedFrame` is new.
    void frameLoaded(const QString& sequence);
    /// All figures show this frame now: the next picture has it.
    void frameShown(quadrille::FrameIndex frame);
    /// A picture with this frame was drawn, the first one of it.
    void framePainted(quadrille::FrameIndex frame);
    /// Sequences came, went or changed their length.
    void changed();
    /// A frame could not be read; the last good one stays.
    void frameFailed(const QString& sequence, const quadrille::Error& error);

private:
    struct Actor
    {
        QString name;
        int figure = -1;
        int stream = -1;
        MeshSequence sequence;
        std::vector<int> textureIndices;             ///< what the figure wears, per material
        LoadedFrame loaded{.frame = FrameIndex(-1)}; ///< without positions
        LoadedFrame arrived;                         ///< to be shown when that of all others is there
        bool isAwaited = false;
        std::vector<QVector3D> path; ///< of the centroid, on the ground
        float lowest = 0;            ///< height of the ground under it, in the unit of positions
        double height = 0;           ///< of the figure, in the same unit; 0 before it is known
        bool hasFailed = false;
    };

    void addActor(const QString& name, const MeshSequence& sequence);
    void removeActor(const QString& name);
    FrameIndex frameOf(const Actor& actor, FrameIndex frame) const;
    bool isLoading() const;
    void load();
    void take(int stream, const LoadedFrame& loaded);
    void showArrived();
    void dress(Actor& actor);
    void bounds(const Actor& actor);
    void colorFigures();
    Actor* actorOf(const QString& name);
    const Actor* actorOf(const QString& name) const;
    Actor* actorOfFigure(int figure);
    void setGround();
    void frameAll();

    widgets::Viewport& m_viewport;
    Source m_source;
    JobRunner& m_jobs;
    SceneGhosts m_ghosts;
    FrameLoader m_loader;
    QStringList m_names;
    std::vector<Actor> m_actors;
    FrameIndex m_frame;   ///< shown
    FrameIndex m_loading; ///< being read
    FrameIndex m_wanted;  ///< asked for last
    bool m_isPainted = true;
    int m_step = 0;
    bool m_frameNextFigure = true;
    std::optional<widgets::Turntable> m_framedView; ///< what framing made of the camera last
};

} // namespace quadrille
