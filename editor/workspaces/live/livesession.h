// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/live/livesteering.h"
#include "model/live/liveplayer.h"
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

    /// Another one begins anew, in its first space; null ends.
    void setGraph(OpenedLiveGraphPointer graph);
    const OpenedLiveGraphPointer& graph() const { return m_graph; }
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

    LiveSteering& steering() { return m_steering; }
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

    /// What is shown. \pre isReady(), so for all below.
    const LiveState& state() const { return m_player->state(); }
    LiveProvenance provenance() const { return m_player->provenance(); }
    /// All vertices in the project's unit, vertices × 3; good until the next tick.
    std::span<const float> pose();
    double tickSeconds() const { return m_player->tickSeconds(); }
    /// Ticks that were played; any can be shown.
    std::int64_t tickCount() const { return static_cast<std::int64_t>(m_inputs.size()); }
    const LiveState& stateAt(std::int64_t tick) const { return m_states[static_cast<std::size_t>(tick)]; }
    const std::vector<LiveDecision>& decisions() const { return m_decisions; }
    /// Pauses and shows a tick; kept within those there are.
    void goTo(std::int64_t tick);
    /// How fast it goes over the ground, and turns to the left, over the last half second: m/s, degrees/s.
    std::pair<double, double> measuredMotion() const;
    /// What the last tick with its pose took, milliseconds.
    double tickMilliseconds() const { return m_tickMilliseconds; }

    bool isRecording() const { return m_recordedFrom.has_value(); }
    /// Records from the tick that is shown, and runs.
    void startRecording();
    /// Ends it. \return the performance, without a name; nothing where it has no frame.
    std::optional<LiveEntry> stopRecording();
    /// All that was played. \pre isReady().
    LiveEntry entry(std::int64_t from) const;
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
    void tick(const LiveInput& input);
    void catchUp();
    void followSpace();
    /// What was wanted at the tick that is shown is wanted again.
    void wantAsThen();

    OpenedLiveGraphPointer m_graph;
    std::unique_ptr<LivePlayer> m_player;
    LiveStart m_start;
    Steer m_steer;
    LiveSteering m_steering;
    std::size_t m_wanted = 0;
    bool m_isResponsive = false;
    std::vector<LiveInput> m_inputs;
    std::vector<LiveState> m_states; ///< one more: before the first tick
    std::vector<LiveDecision> m_decisions;
    std::optional<std::int64_t> m_recordedFrom;
    std::vector<Vec3f> m_pose;
    QTimer m_timer;
    QElapsedTimer m_clock;
    double m_due = 0; ///< seconds that are not played yet
    double m_tickMilliseconds = 0;
};

} // namespace quadrille
