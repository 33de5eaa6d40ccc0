// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/walks/walktask.h"

namespace quadrille {

/// Exchanges transitions of a walk, one after the other and over and over, as long as that makes it cheaper:
/// what a search that looks ahead by guesses has missed. \param found  receives each better walk.
/// \return a walk that no exchange makes cheaper (see WalkExchanges), unless at the place of the last one.
/// \throws Error Cancelled.
FoundRoute improvedRoute(const WalkTask& task, WalkCourse& course, FoundRoute route,
                         const FoundCallback& found, const Progress& progress);

} // namespace quadrille
