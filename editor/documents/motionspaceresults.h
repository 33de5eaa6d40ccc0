// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/wantedresults.h"
#include "model/project/results/openmotionspace.h"

#include <optional>

namespace quadrille {

/// The motion spaces of a document. Those that are wanted are computed in jobs, and again whenever they or
/// what they are made of change.
class MotionSpaceResults : public WantedResults
{
    Q_OBJECT

public:
    struct State : ResultState
    {
        MotionSpaceResultPointer result; ///< the last one; may be null, may be outdated
    };

    MotionSpaceResults(ProjectDocument& document, JobRunner& jobs, QObject* parent = nullptr);
    ~MotionSpaceResults() override;

    /// The spaces that somebody looks at. Others are let go of.
    void want(const QStringList& names) { setWanted(names); }
    /// Null where the project has no such space, or nobody ever wanted it.
    const State* resultState(const QString& name) const { return find<const State>(name); }

private:
    struct Item : State
    {
        std::optional<Project> made; ///< all that the last work depended on
    };

    void follow(const ChangeEvent& event) override;
    void renamed(const QString& before, const QString& name) override;
    void update() override;
    void compute(const QString& name, Item& item);
};

} // namespace quadrille
