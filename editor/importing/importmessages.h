// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/importing/importplan.h"
#include "widgets/controls/messagestrip.h"

#include <QString>

namespace quadrille {

/// What is to be said about an import before it is carried out, and what helps.
struct ImportMessage
{
    enum class Help
    {
        None,
        ChooseMesh,
        ConfirmRate, ///< the guessed rate is right
    };
    widgets::MessageStrip::Kind kind = widgets::MessageStrip::Kind::Info;
    QString sentence; ///< empty when there is nothing to say
    QString remedy;
    Help help = Help::None;
    QString button; ///< of the help
    bool forbidsImport = false;
};
/// The most important thing to say. \param current  the take that is shown; null without any.
ImportMessage importMessage(const ImportPlan& plan, const PlannedTake* current);

/// What was found out about a take, a line each.
QString importNotes(const PlannedTake& planned);
/// At which rate a take that names none is added, and why, for takes that are added without a preview; a
/// warning where it is a guess.
std::optional<Issue> rateIssue(const PlannedTake& planned);
/// What says the rate of a take; empty for one that does not move.
QString rateReason(const PlannedTake& planned);
/// Of the button that carries the plan out: it names a rate that is a guess.
QString importText(const ImportPlan& plan);

} // namespace quadrille
