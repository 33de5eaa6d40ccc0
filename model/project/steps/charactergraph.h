// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/digraph.h"
#include "model/project/steps/charactersteps.h"
#include "model/project/steps/edgecosts.h"
#include "model/project/steps/graphstepresults.h"
#include "model/synthesis/clips/rootposes.h"
#include "model/synthesis/clips/stepcosts.h"
#include "model/synthesis/clips/walk.h"
#include "model/synthesis/finishing/footdrift.h"
#include "model/synthesis/walks/findwalk.h"
#include "model/transition/warppath.h"

#include <optional>

namespace quadrille {

/// What walks through the frames of a character need, from the results of its graph's steps. What is made of
/// results alone is shared by the graphs of all values of a project that have the same.
class CharacterGraph
{
public:
    /// The steps whose results it is made of.
    static std::vector<std::string> inputs(const CharacterInputs& work);

    CharacterGraph(const CharacterInputs& work, const StepContext& context);
    CharacterGraph(const CharacterGraph&) = delete;
    CharacterGraph& operator=(const CharacterGraph&) = delete;

    const CharacterInputs& work() const { return m_work; }
    const FrameLayout& layout() const { return m_tables->layout; }
    TableView<float> distances() const { return *m_tables->distances; }
    const TransitionCosts& costs() const { return *m_tables->costs; }
    /// What transitions are sought by: the distances, and what else frames that are blended differ in.
    /// Cost: O(frames² · feet).
    Table<float> steps() const;
    /// What the cost of a transition is made of; adds up to costs().cost() of it. \pre It has a transition.
    CostParts partsOf(const FramePair& pair) const;
    /// What all edges of graphs cost, with its parts. \throws Error Cancelled. Cost: see splitCosts.
    std::vector<std::vector<EdgeCost>> edgeCosts(const std::vector<const Digraph*>& graphs,
                                                 const Progress& progress = {}) const;
    const WarpPaths& paths() const { return *m_tables->paths; }
    /// A transition with its path, whatever costs are scaled by; nothing where there is none.
    /// Cost: O(l_max²).
    std::optional<Transition> transition(const FramePair& pair) const;
    const RootPoses& roots() const { return m_tables->roots; }
    /// The Essential graph.
    const Digraph& graph() const { return *m_graph; }
    /// Both graphs at some α: the project's as its step left them, others by graphsAt.
    std::shared_ptr<const MeasuredGraphs> at(double alpha, const Progress& progress = {},
                                             const GraphsTaker& edges = {}) const
    {
        return alpha == m_work.graph.alpha ? storedGraphs(m_work, m_context, progress)
                                           : graphsAt(m_work, alpha, m_context, progress, edges);
    }
    /// Whether transitions and their costs are the same, and not only equal.
    bool hasTablesOf(const CharacterGraph& other) const { return m_tables == other.m_tables; }
    /// Gives back the memory of tables in files, after all of them were looked at; see SharedTable. Safe
    /// while others look at them.
    void unloadTables() const;
    double alpha() const { return m_work.graph.alpha; }
    double fps() const { return m_work.opener->project().settings.fps; }
    double metresPerUnit() const { return m_work.opener->project().settings.axes.metresPerUnit; }
    /// Which frames are locomotion: those of sequences whose poses come back and that always get on,
    /// and, of others without a jump, what lies between the first and the last frame that gets on and is as
    /// near to them as such sequences are to each other, where that is half of the take.
    std::vector<bool> locomotion() const;
    /// What walks are sought in; refers to this object. \param blend  how transitions will be blended.
    /// \param isAlongPath  whether there will be a path, for which locomotion counts.
    WalkMaterial material(const BlendSettings& blend, bool isAlongPath) const;

    /// A frame by the name of its sequence. \throws Error ProjectInvalid where there is none.
    NodeIndex node(const NamedFrame& frame) const;
    /// Some frames of a sequence. \throws Error as node.
    WalkSpan span(const std::string& sequence, const std::optional<FrameRange>& range) const;
    NamedFrame nameOf(NodeIndex node) const;
    /// An error of a walk with its frames called by their sequences.
    Error named(const Error& error) const;

private:
    /// What is known of a transition beside its path. \pre There is one.
    KnownTransition knownTransition(const FramePair& pair) const;

    /// All but the graph itself: α changes none of it.
    struct Tables
    {
        Tables(const CharacterInputs& work, const StepContext& context);
        Tables(const Tables&) = delete;
        Tables& operator=(const Tables&) = delete;

        float step(NodeIndex i, NodeIndex j) const
        {
            return differences->step(distances(i, j), weights, i, j);
        }

        FrameLayout layout;
        SharedTable<float> distances;
        float greatestStep = 0;
        StepWeights weights;
        RootPoses roots;
        std::optional<StepDifferences> differences;
        std::optional<FootDrifts> drifts; ///< nothing where costs do not know them
        std::shared_ptr<const TransitionCosts> costs;
        SharedTable<std::uint16_t> windows; ///< as TransitionTable has them
        std::optional<WarpPaths> paths;     ///< of the steps
    };

    CharacterInputs m_work;
    StepContext m_context;
    std::shared_ptr<const Tables> m_tables;
    std::shared_ptr<const Digraph> m_graph;
};

} // namespace quadrille
