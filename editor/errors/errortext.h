// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"

#include <QString>

namespace quadrille {

/// An error or issue in the user's language.
struct ErrorText
{
    QString sentence; ///< what is wrong
    QString where;    ///< "take_0007.obj, line 12"; empty when nothing is known
    QString remedy;   ///< what to do; may be empty

    /// "Sentence (where)".
    QString placed() const;
    /// "Sentence Remedy (where)" in one line.
    QString oneLine() const;
};

/// In the language of now.
ErrorText describe(const Error& error);
ErrorText describe(const Issue& issue);

} // namespace quadrille
