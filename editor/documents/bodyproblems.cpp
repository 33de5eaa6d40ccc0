// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/bodyproblems.h"

namespace quadrille {

void BodyProblems::set(const QString& character, const QString& problem)
{
    if (problem == problemOf(character))
        return;
    if (problem.isEmpty())
        m_problems.remove(character);
    else
        m_problems[character] = problem;
    emit changed(character);
}

} // namespace quadrille

#include "moc_bodyproblems.cpp"
