// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/jobs/job.h"
#include "editor/jobs/mailbox.h"
#include "editor/workspaces/graph/takefilter.h"
#include "model/graph/comparison.h"
#include "model/graph/gaps.h"
#include "model/graph/measuredgraphs.h"
#include "model/project/results/opencharacter.h"

#include <QObject>
#include <QPointer>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille {

class JobRunner;

/// What would make walks come to all frames and back.
struct ExploredGaps
{
    double alpha = 0;
    std::vector<GraphGap> essential;
    std::vector<GraphGap> motion;
};

/// Keeps both graphs of an opened character up with α while it is changed: of all values that come while one
/// is computed only the newest is computed next. Edges come first – of many frames those that are certain
/// before the others –, then path costs, then – once α rests – gaps, and a comparison over many α. What is
/// computed so for an α that the project takes is not computed again (graphsAt).
class GraphExplorer : public QObject
{
    Q_OBJECT

public:
    explicit GraphExplorer(JobRunner& jobs, QObject* parent = nullptr);
    ~GraphExplorer() override;

    /// Explores another character, or none. One with the same transitions as before only takes its place.
    void setCharacter(std::shared_ptr<const OpenedCharacter> opened);
    const std::shared_ptr<const OpenedCharacter>& character() const { return m_opened; }
    /// Computes both graphs for it, unless they are there; signals tell what comes of it.
    void setAlpha(double alpha);
    double alpha() const { return m_alpha; }
    /// Which takes are looked at; all of another character.
    const TakeFilter& filter() const { return m_filter; }
    /// One that names all takes is an empty one.
    void setFilter(TakeFilter filter);
    /// Compares the graphs over the values of figure9Alphas and beyond, unless that was done. Nothing happens
    /// before there are graphs, or where they are not compared unasked. It comes by itself once gaps are
    /// there.
    void askForComparison();
    /// Whether both graphs are compared over α once somebody looks. Of many frames that takes minutes and
    /// much memory: only once it was wanted.
    bool comparesUnasked() const;
    /// Compares them all the same, now and whenever α rests.
    void wantComparison();

    /// From so many frames on, certain edges come first: of fewer all are there at once.
    void setManyFrames(NodeIndex frames) { m_manyFrames = frames; }
    /// Up to so many they are compared unasked.
    void setMostFramesCompared(NodeIndex frames) { m_mostCompared = frames; }

    /// The last that is known of each, maybe of an earlier α; null until there is any.
    const std::shared_ptr<const GraphPair>& graphs() const { return m_graphs; }
    /// With what is known of their paths.
    const std::shared_ptr<const MeasuredGraphs>& measured() const { return m_measured; }
    const std::shared_ptr<const ExploredGaps>& gaps() const { return m_gaps; }
    /// One for each α; empty until it was made.
    const std::vector<GraphComparison>& comparison() const { return m_comparison; }
    /// Whether a comparison is on its way.
    bool isComparing() const { return m_comparing != nullptr; }
    /// For how many α it has come so far, and for how many it will.
    std::pair<int, int> comparedAlphas() const;

signals:
    /// Other transitions, or none.
    void characterChanged();
    /// The same transitions, opened anew: what was opened before can be let go.
    void characterReplaced();
    /// graphs() are others; what is known of their paths comes later.
    void graphsChanged();
    void pathsChanged();
    void gapsChanged();
    /// A comparison is there, came further, or its job ended without.
    void comparisonChanged();
    void filterChanged();

private:
    void computeGraphs();
    void computeGaps();
    void take(std::shared_ptr<const GraphPair> graphs);
    void take(std::shared_ptr<const MeasuredGraphs> measured);
    void cancelAll();

    JobRunner& m_jobs;
    std::shared_ptr<const OpenedCharacter> m_opened;
    double m_alpha = usualAlpha;
    NodeIndex m_manyFrames = 3000;
    NodeIndex m_mostCompared = 5000;
    bool m_isComparisonWanted = false; ///< of this character
    TakeFilter m_filter;
    std::shared_ptr<const GraphPair> m_graphs;
    std::shared_ptr<const MeasuredGraphs> m_measured;
    std::shared_ptr<const ExploredGaps> m_gaps;
    std::vector<GraphComparison> m_comparison;
    std::vector<GraphComparison> m_compared; ///< of it, as far as it came
    QPointer<Job> m_graphsJob;
    double m_computedAlpha = 0; ///< by that job
    QPointer<Job> m_gapsJob;
    QPointer<Job> m_comparing;
    int m_generation = 0; ///< of the transitions: results of earlier ones are dropped
    Mailbox m_mailbox{this};
};

} // namespace quadrille
