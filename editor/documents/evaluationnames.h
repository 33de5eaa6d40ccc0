// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/evaluationentry.h"

#include <QString>

namespace quadrille {

/// What an evaluation is called in its section, as the targets of a rebuild are: "fig7", or "fig7/anna" where
/// it names a character.
inline QString evaluationName(const EvaluationEntry& entry)
{
    const QString table = QString::fromStdString(entry.table);
    return entry.character.empty() ? table
                                   : table + QLatin1Char('/') + QString::fromStdString(entry.character);
}

} // namespace quadrille
