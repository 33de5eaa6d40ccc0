// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/graphresults.h"
#include "model/project/document/project.h"

namespace quadrille {

struct AnimationResult;

/// The animations of a document as clips that can be shown. Those that are wanted are solved in jobs by
/// themselves, and again whenever they or their graph change; each better walk is told as soon as it is
/// found, and the last result stays until then.
class AnimationResults : public WantedResults
{
    Q_OBJECT

public:
    /// Idle where nothing is asked of it yet, or its search was stopped; waiting for the graph of its
    /// character.
    struct State : ResultState
    {
        std::shared_ptr<const AnimationResult> result; ///< the last one; may be null, may be outdated
    };

    /// Refers to document, graphs and jobs.
    AnimationResults(ProjectDocument& document, GraphResults& graphs, JobRunner& jobs,
                     QObject* parent = nullptr);
    ~AnimationResults() override;

    /// The animations that somebody looks at: these are solved. The graphs of their characters are asked for,
    /// and computed where they are missing. Those that are not among them any more are forgotten, with the
    /// work on them. Names that the project does not have (yet) do no harm.
    void want(const QStringList& names) { setWanted(names); }
    /// Null when the project has no such animation, or nobody ever wanted it.
    const State* resultState(const QString& name) const { return find<const State>(name); }
    /// The last result of an animation; null without one.
    std::shared_ptr<const AnimationResult> result(const QString& name) const;
    /// The character that an animation is of; empty in a project without characters.
    QString characterOf(const QString& name) const;
    /// Seeks again what failed or was stopped. Nothing happens where nobody wants it.
    void retry(const QString& name);

private:
    struct Item : State
    {
        AnimationEntry solved; ///< what the last search was started with
        Project drawnFrom;     ///< and its variations
        std::shared_ptr<const OpenedCharacter> character;
    };

    void follow(const ChangeEvent& event) override;
    void renamed(const QString& before, const QString& name) override;
    void update() override;
    void update(const QString& name, Item& item);
    void solve(const QString& name, Item& item, const AnimationEntry& entry);

    GraphResults& m_graphs;
};

} // namespace quadrille
