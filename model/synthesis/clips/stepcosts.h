// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/rootposes.h"

namespace quadrille {

/// What two frames that are blended differ in beside their poses, and how much that weighs; without any
/// weight the costs are the paper's (SMCAS eq. 8).
struct StepWeights
{
    /// rad, where every foot stands in one frame only; and where a foot is dragged by dragOfOneFoot
    double contacts = 0;
    double velocity = 0; ///< rad for a difference of one body height a second

    bool isNothing() const { return contacts == 0 && velocity == 0; }
    bool operator==(const StepWeights&) const = default;
};

/// The parts of what it costs to show two frames together.
struct StepCosts
{
    Table<float> contacts; ///< share of the feet that stand in one of both frames only, 0 … 1
    /// By how much centres and, on average, feet move otherwise in one frame than in the other, turned onto
    /// each other about the up axis; body heights a second.
    Table<float> velocity;
};

/// The share of the feet that stand in one of both frames only; 0 where nothing is known of feet.
double differingFeet(const Stances& stances, NodeIndex i, NodeIndex j);

/// The same for single pairs of frames. Refers to the root poses. Safe from several threads.
class StepDifferences
{
public:
    /// Cost: O(frames · feet).
    StepDifferences(const RootPoses& roots, const FrameLayout& layout, double fps);

    /// Whether anything is known of feet; nothing differs otherwise.
    bool areKnown() const { return m_points > 1 && m_stances.height > 0; }
    /// As in StepCosts. \pre areKnown(), i ≠ j.
    float contacts(NodeIndex i, NodeIndex j) const;
    float velocity(NodeIndex i, NodeIndex j) const;
    /// What transitions are sought by, of the distance between both poses.
    float step(float distance, const StepWeights& weights, NodeIndex i, NodeIndex j) const
    {
        if (i == j || !areKnown())
            return distance;
        return distance + static_cast<float>(weights.contacts) * contacts(i, j) +
               static_cast<float>(weights.velocity) * velocity(i, j);
    }

private:
    /// How a point moves over the ground, and up.
    struct Velocity
    {
        Vec2d over = Vec2d::Zero();
        double up = 0;
    };

    const Stances& m_stances;
    SharedTable<float> m_turns;
    std::size_t m_points;           ///< the centre and the feet
    std::vector<Velocity> m_moving; ///< by frame, point after point
};

/// \param roots  with turns and known stances; zeros where nothing is known of feet.
/// \return both frames × frames, symmetric, zeros on the diagonal.
/// Cost: O(frames² · feet).
StepCosts stepCosts(const RootPoses& roots, const FrameLayout& layout, double fps);

/// How far a foot is dragged (footDrifts) for as much as one of all feet that stand in one frame only costs,
/// body heights.
inline constexpr double dragOfOneFoot = 0.25;

/// Adds to costs of transitions what dragging feet costs. \param cost  D, frames × frames. \param drifts  of
/// footDrifts. \param isSum  whether D is the sum over `length` steps, not the mean.
void addDrifts(Table<float>& cost, TableView<float> drifts, TableView<std::uint16_t> length, bool isSum,
               const StepWeights& weights);

/// What transitions are sought by: pose distances with both parts by their weights.
Table<float> weightedSteps(TableView<float> distances, const StepCosts& parts, const StepWeights& weights);
/// The same without tables of the parts. \param distances  in: of poses; out: with both parts.
void addStepCosts(Table<float>& distances, const StepDifferences& differences, const StepWeights& weights);

} // namespace quadrille
