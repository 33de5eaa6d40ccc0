// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace quadrille {

/// What an evaluation is called where users read it. \param name  see evaluationName().
QString evaluationTitle(const QString& name);
/// What an evaluation shows, in one sentence without a stop.
QString evaluationSentence(const QString& name);
/// A word of evaluations' tables – the name of a column, or a value – in the user's language; words that
/// nobody knows, such as names of takes, as they are.
QString evaluationWord(const QString& word);
/// With a capital where it is a word, not a symbol.
QString capitalized(QString word);

} // namespace quadrille
