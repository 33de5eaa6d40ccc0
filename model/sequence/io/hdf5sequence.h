// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/files/format.h"

namespace quadrille {

/// HDF5 as Dynamic FAUST has it: one dataset vertices × 3 × frames per sequence and integer triangles "faces"
/// (triangles × 3) that all share. Datasets frames × vertices × 3 are read too. Each becomes a sequence named
/// after its dataset; an attribute "fps" gives its rate. Source: Bogo et al., "Dynamic FAUST", CVPR 2017.
class Hdf5Importer : public Importer
{
public:
    const FormatInfo& format() const override;
    bool recognises(std::string_view head) const override;
    ImportResult open(const SourceFiles& source, const ImportOptions& options,
                      const Progress& progress) const override;
};

} // namespace quadrille
