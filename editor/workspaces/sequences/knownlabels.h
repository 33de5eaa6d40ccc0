// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

#include <QStringList>

namespace quadrille {

/// All labels of the takes of a project, each once, in the order of the alphabet.
QStringList knownLabels(const Project& project);

} // namespace quadrille
