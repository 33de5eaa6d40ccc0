// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/files/format.h"

#include <memory>
#include <vector>

namespace quadrille {

/// Every format of the program. A new format is one source file and its lines in formats.cpp.
std::vector<std::unique_ptr<Importer>> makeImporters();
std::vector<std::unique_ptr<Exporter>> makeExporters();

} // namespace quadrille
