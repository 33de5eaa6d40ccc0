// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/playback/clipscene.h"

#include <QObject>
#include <QPointer>
#include <optional>

namespace quadrille {

class Job;

/// Colours the two figures that a scene compares by what each triangle adds to the distance of their poses.
/// Computed in jobs; while one runs, only the frames shown last count, so that playback is never held up.
class PoseHeatMap : public QObject
{
    Q_OBJECT

public:
    enum class State
    {
        Off,
        NotTwo,        ///< more or fewer than two sequences are shown
        Waiting,       ///< frames are on their way
        DifferentMesh, ///< the sequences do not share their triangles
        Shown,
    };

    /// Refers to viewport, scene and jobs.
    PoseHeatMap(widgets::Viewport& viewport, ClipScene& scene, JobRunner& jobs, QObject* parent = nullptr);
    ~PoseHeatMap() override;

    void setOn(bool on);
    State state() const { return m_state; }
    /// Surface distance of the two frames that are coloured now, radians; there when shown. Mean over the
    /// triangles that have an area in both.
    std::optional<double> distance() const;

signals:
    /// State or distance changed.
    void changed();

private:
    struct Shown
    {
        QStringList names;
        FrameIndex first;
        FrameIndex second;
        bool operator==(const Shown&) const = default;
    };
    struct Distances
    {
        std::vector<float> ofTriangles; ///< radians; NaN without an area
        double mean = 0;
        double high = 0; ///< that nearly all triangles stay below
    };

    void follow();
    void start();
    void apply(const Shown& shown, const Distances& distances);
    void clear();
    void setState(State state);
    std::optional<Shown> wanted() const;
    static Distances measure(const MeshSequence& a, FrameIndex frameOfA, const MeshSequence& b,
                             FrameIndex frameOfB);

    widgets::Viewport& m_viewport;
    ClipScene& m_scene;
    JobRunner& m_jobs;
    QPointer<Job> m_job;
    bool m_isOn = false;
    State m_state = State::Off;
    std::optional<Shown> m_measured; ///< what the figures are coloured by, or will be when the job is done
    double m_mean = 0;
    double m_greatest = 0; ///< end of the colours, radians; only grows while the same two are compared
};

} // namespace quadrille
