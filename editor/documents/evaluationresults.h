// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/wantedresults.h"
#include "model/project/results/openevaluations.h"
#include "model/project/store/dataitem.h"

namespace quadrille {

/// The tables of a document's evaluations. What is up to date among the results is opened by itself, again
/// whenever the project changes; the rest is computed on demand.
class EvaluationResults : public WantedResults
{
    Q_OBJECT

public:
    /// Idle while nobody knows yet whether it is up to date.
    struct State : ResultState
    {
        std::vector<DataItem> tables; ///< the last ones; of other inputs unless ready, none at first
    };

    EvaluationResults(ProjectDocument& document, JobRunner& jobs, QObject* parent = nullptr);
    ~EvaluationResults() override;

    /// Null when the project has no such evaluation. \param name  see evaluationName().
    const State* resultState(const QString& name) const { return find<const State>(name); }
    /// Computes it and what it needs, as a rebuild does. Nothing happens while it is being computed; a name
    /// that the project does not have is ignored. Tables of before stay until it is done; `changed` tells
    /// beginning and end.
    void compute(const QString& name);

private:
    void follow(const ChangeEvent& event) override;
    void update() override;
    void stopped(const QString& name, ResultState& state) override;
    void take(const QStringList& names, std::vector<OpenedEvaluation> opened);
    static void take(State& state, OpenedEvaluation opened);

    QPointer<Job> m_opening; ///< of all of them
};

} // namespace quadrille
