// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/registry.h"

#include "model/sequence/io/formats.h"

namespace quadrille {

std::span<const std::unique_ptr<Importer>> importers()
{
    static const std::vector<std::unique_ptr<Importer>> all = makeImporters();
    return all;
}

std::span<const std::unique_ptr<Exporter>> exporters()
{
    static const std::vector<std::unique_ptr<Exporter>> all = makeExporters();
    return all;
}

} // namespace quadrille
