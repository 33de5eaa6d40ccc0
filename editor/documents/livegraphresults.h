// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/wantedresults.h"
#include "model/project/results/openlive.h"

namespace quadrille {

/// The motion spaces of a document's characters, ready to be played; computed in a job for the character that
/// is wanted, and again whenever its spaces change.
class LiveGraphResults : public WantedResults
{
    Q_OBJECT

public:
    struct State : ResultState
    {
        OpenedLiveGraphPointer graph; ///< the last one; may be null, may be outdated
    };

    LiveGraphResults(ProjectDocument& document, JobRunner& jobs, QObject* parent = nullptr);
    ~LiveGraphResults() override;

    /// \param character  whose spaces somebody plays; null where nobody does any more.
    void want(const QString& character)
    {
        setWanted(character.isNull() ? QStringList() : QStringList{character});
    }
    /// Null where nobody ever wanted it, or the character has no spaces.
    const State* resultState(const QString& character) const { return find<const State>(character); }
    /// Computes again what failed or was stopped. Nothing happens where nobody wants it.
    void retry(const QString& character);

private:
    struct Item : State
    {
        std::optional<Project> made; ///< all that the last work depended on
    };

    void follow(const ChangeEvent& event) override;
    void update() override;
    void compute(const QString& name, Item& item);
};

} // namespace quadrille
