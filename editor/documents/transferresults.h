// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/wantedresults.h"
#include "model/project/results/opentransfer.h"

namespace quadrille {

/// The transfers of a document as clips that can be shown. Those that are wanted are computed in jobs by
/// themselves, and again whenever they or what they are made of change: a preview comes first, whose poses
/// are made when they are looked at, then the result.
class TransferResults : public WantedResults
{
    Q_OBJECT

public:
    /// Computing until the result is there; failed where there is none, with a preview maybe.
    struct State : ResultState
    {
        TransferPreviewPointer preview; ///< the last one; may be null, may be outdated
        TransferResultPointer result;   ///< null until it is as the project says
    };

    TransferResults(ProjectDocument& document, JobRunner& jobs, QObject* parent = nullptr);
    ~TransferResults() override;

    /// The transfers that somebody looks at. Others are let go of.
    void want(const QStringList& names) { setWanted(names); }
    /// Null where the project has no such transfer, or nobody ever wanted it.
    const State* resultState(const QString& name) const { return find<const State>(name); }
    /// Computes again what failed or was stopped. Nothing happens where nobody wants it.
    void retry(const QString& name);
    /// Clips that they are made of may be there now, or be others.
    void refresh();

signals:
    /// A result was computed: clips that show it can be opened.
    void computed(const QString& name);

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
