// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/live/livegraph.h"
#include "model/live/liveorigin.h"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace quadrille {

/// Plays motion spaces as inputs want it (IA4D section 3.3): loops within those with a cycle, goes to the
/// place of wanted parameters no faster than settings allow, and from space to space by the transitions that
/// the trellis search finds when they are wanted. A space without a cycle is played nearly to its end, then
/// it goes on where it is wanted, else to the last space with a cycle.
///
/// At a switch the target stands where it fits the source best on the ground, by the vertices near the
/// ground before all others; then its surface takes over from that of the source, which goes on meanwhile.
///
/// The same start and inputs give the same states and poses, to the bit. One thread at a time; knows nothing
/// of time: whoever ticks it does.
class LivePlayer
{
public:
    /// \pre Start and inputs are of spaces that the graph has. \throws Error BadArgument (settings that make
    /// no sense).
    LivePlayer(std::shared_ptr<const LiveGraph> graph, const LiveSettings& settings, const LiveStart& start);

    /// Begins anew. From a space without a cycle it goes on to the first one with a cycle that it leads to,
    /// in the middle of its parameters, unless something else is wanted. \pre As above. Allocates nothing.
    void start(const LiveStart& start);

    const LiveGraph& graph() const { return *m_graph; }
    const std::shared_ptr<const LiveGraph>& sharedGraph() const { return m_graph; }
    const LiveSettings& settings() const { return m_settings; }
    double tickSeconds() const { return 1 / (m_graph->fps * m_settings.ticksPerFrame); }

    /// One tick. Allocates nothing. Cost: some microseconds, some tens to hundreds more at a tick that looks
    /// for a transition.
    void tick(const LiveInput& input);

    const LiveState& state() const { return m_state; }
    /// Goes to a state of a player of the same graph and settings; what follows is what followed then. The
    /// last decision stays as it was.
    void restore(const LiveState& state) { m_state = state; }

    /// The pose of the state: all vertices over the ground, metres. Allocates nothing. Cost: as blendedPose,
    /// twice while one space takes over from another.
    /// \param out  of all vertices.
    void pose(MutablePositions out);
    /// Takes the body to where it is.
    GroundMotion root() const;
    LiveProvenance provenance() const { return provenanceOf(*m_graph, m_state); }
    LiveLook look() const { return lookOf(*m_graph, m_state); }
    /// The last one; without any choices before the first.
    const LiveDecision& decision() const { return m_decision; }

private:
    struct Link
    {
        std::unique_ptr<TransitionSearch> smooth;
        std::unique_ptr<TransitionSearch> responsive;
    };

    const MotionSpace& spaceOf(const LiveTrack& track) const { return *m_graph->spaces[track.space]; }
    bool isCyclic(const LiveTrack& track) const { return spaceOf(track).isCyclic; }
    double fadeFrames() const { return m_settings.fadeSeconds * m_graph->fps; }
    SpacePoint wantedPlace(std::size_t space, const SpacePoint& parameters) const;
    std::size_t wantedSpace(const LiveInput& input) const;
    bool mayLeave() const;
    void decide(const LiveInput& input);
    void movePlace(const LiveInput& input, double seconds);
    /// \return frames. \param most  to be played at most.
    double play(LiveTrack& track, double& seconds, double most) const;
    /// What was left, while it fades.
    void playOut(LiveTrack& track, double seconds) const;
    void switchOver();
    void poseOf(const LiveTrack& track, MutablePositions out) const;

    std::shared_ptr<const LiveGraph> m_graph;
    LiveSettings m_settings;
    std::vector<std::vector<Link>> m_links;
    LiveState m_state;
    LiveDecision m_decision;
    std::vector<Vec3f> m_other; ///< poses that are blended with or fitted to
    std::vector<Vec3f> m_fitted;
};

/// Plays a recording. \param use  gets the player at the start and after each tick. \throws Error Cancelled.
void perform(LivePlayer& player, std::span<const LiveInput> inputs,
             const std::function<void(LivePlayer&)>& use, const Progress& progress = {});

} // namespace quadrille
