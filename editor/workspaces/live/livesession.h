// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/live/livesteering.h"
#include "model/live/livepath.h"
#include "model/project/document/liveentry.h"
#include "model/project/results/openlive.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace quadrille {

/// A character that is steered: ticks a player at its rate, keeps every tick to go back to, and makes entries
/// of the project from them.
class LiveSession : public QObject
{
    Q_OBJECT

public:
    /// Says what is steered by now.
    using Steer = std::function<SteeringState()>;

    explicit LiveSession(QObject* parent = nullptr);
    ~LiveSession() override;

    /// Another one begins anew, in its first space with a cycle; null ends. One of the same spaces goes on as
    /// it is. \return whether it goes on.
    bool setGraph(OpenedLiveGraphPointer graph);
    const OpenedLiveGraphPointer& graph() const { return m_graph; }
    /// Whether one of these spaces is played.
    bool plays(const OpenedLiveGraphPointer& graph) const;
    /// Whether there is something to play.
    bool isReady() const { return m_player != nullptr; }
    void setSteer(Steer steer) { m_steer = std::move(steer); }

    bool isRunning() const { return m_timer.isActive(); }
    /// Goes on from the tick that is shown. What was played after it plays again, until its end or until
    /// somebody steers: that takes over, and the rest is forgotten.
    void run();
    /// Whether what plays, or would, was played before.
    bool isReplaying() const { return isReady() && state().tick < tickCount(); }
    /// Forgets what was played after the tick that is shown.
    void takeOver();
    void pause();
    /// Begins anew where it began, and goes on if it ran.
    void restart();
    /// One tick on, whatever the clock says.
    void step();

    const LiveSteering& steering() const { return m_steering; }
    /// As by a slider. \pre The space that is wanted has such a parameter.
    void setParameter(std::size_t parameter, double value);
    /// The space that is wanted; −1 without any.
    int wantedSpace() const { return isReady() ? static_cast<int>(m_wanted) : -1; }
    /// \param space  without a cycle: it is played once.
    void want(int space);
    /// The next or the one before, in their order; those without a cycle are left out.
    void wantNext(int by);
    /// The first space without a cycle, once; nothing happens where there is none.
    void jump();
    bool isResponsive() const { return m_isResponsive; }
    void setResponsive(bool responsive);

    /// Begins anew at the beginning of a path, which it follows as it plays, until its end or until somebody
    /// steers; nothing: goes on by hand. \pre isReady() \throws Error as LivePathFollower.
    void followPath(const std::optional<PathConstraint>& path);
    /// Null where it is steered by hand.
    const LivePathFollower* follower() const { return m_follower.get(); }

    /// What is shown. \pre isReady(), so for all below.
    const LiveState& state() const { return m_player->state(); }
    LiveProvenance provenance() const { return m_player->provenance(); }
    /// All vertices in the project's unit, vertices × 3; good until the next tick.
    std::span<const float> pose();
    double tickSeconds() const { return m_player->tickSeconds(); }
    /// Ticks that were played; any can be shown.
    std::int64_t tickCount() const { return static_cast<std::int64_t>(m_inputs.size()); }
    const LiveState& stateAt(std::int64_t tick) const { return m_states[static_cast<std::size_t>(tick)]; }
    /// A space that is played from a tick on.
    struct Visit
    {
        std::int64_t first = 0;
        std::size_t space = 0;
    };
    /// In their order; the first is at tick 0.
    const std::vector<Visit>& visits() const { return m_visits; }
    const std::vector<LiveDecision>& decisions() const { return m_decisions; }
    /// The last one before the tick that is shown; null before the first.
    const LiveDecision* lastDecision() const;
    /// Of a transition, from the wish on, seconds.
    double latencyOf(const LiveDecision& decision) const
    {
        const int perFrame = m_player->settings().ticksPerFrame;
        return decision.latencyFrames(perFrame) * perFrame * tickSeconds();
    }
    /// Pauses and shows a tick; kept within those there are.
    void goTo(std::int64_t tick);
    /// How fast it goes over the ground, and turns to the left, m/s, degrees/s: over the last cycle of the
    /// space that is played, or over half a second of one without a cycle.
    std::pair<double, double> measuredMotion() const;
    /// What the last tick and the last pose took together, milliseconds.
    double tickMilliseconds() const { return m_tickMilliseconds + m_poseMilliseconds; }

    bool isRecording() const { return m_recordedFrom.has_value(); }
    /// Ticks that are recorded until the one that is shown. \pre isRecording()
    std::int64_t recordedTicks() const { return state().tick - *m_recordedFrom; }
    /// Records from the tick that is shown, and runs.
    void startRecording();
    /// Ends it. \return the performance, without a name; nothing where it has no frame.
    std::optional<LiveEntry> stopRecording();
    /// Plays an entry anew, at once, and shows its first frame. \pre The graph has its spaces.
    /// \return whether that is so.
    bool load(const LiveEntry& entry, const CoordinateSystem& axes);

signals:
    /// Another graph, running or not, recording or not, another wanted space.
    void changed();
    /// Another tick is shown.
    void ticked();
    /// A transition was found, or those that were are others.
    void decided();

private:
    void begin(const LiveStart& start, const LiveSettings& settings);
    /// Plays on, and keeps it. \return whether a transition was found.
    bool tick(const LiveInput& input);
    void catchUp();
    void followSpace();
    /// What was wanted at the tick that is shown is wanted again.
    void wantAsThen();
    /// Wants what the path does. \return false at its end.
    bool followOn();
    void leavePath();

    OpenedLiveGraphPointer m_graph;
    std::unique_ptr<LivePlayer> m_player;
    std::unique_ptr<LivePathFollower> m_follower;
    std::int64_t m_followedTick = 0; ///< that the follower expects next
    std::vector<double> m_walked;    ///< along the path, metres, by tick
    LiveStart m_start;
    Steer m_steer;
    LiveSteering m_steering;
    std::size_t m_wanted = 0;
    bool m_isResponsive = false;
    std::vector<LiveInput> m_inputs;
    std::vector<LiveState> m_states; ///< one more: before the first tick
    std::vector<Visit> m_visits;
    std::vector<LiveDecision> m_decisions;
    LiveEntry m_entry; ///< what a recording has besides what is wanted: of the performance that plays again
    std::optional<std::int64_t> m_recordedFrom;
    std::vector<Vec3f> m_pose;
    QTimer m_timer;
    QElapsedTimer m_clock;
    double m_due = 0; ///< seconds that are not played yet
    double m_tickMilliseconds = 0;
    double m_poseMilliseconds = 0;
};

} // namespace quadrille
