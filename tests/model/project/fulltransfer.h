// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/transferentry.h"

namespace quadrille::test {

/// With every key that is known.
inline TransferEntry fullTransfer()
{
    TransferEntry entry;
    entry.name = "doubled";
    entry.clip = "sequences/talk";
    entry.target = {"softly", FrameIndex(7)};
    entry.reference = NamedFrame{"talk", FrameIndex(4)};
    entry.pairs = {{TriangleIndex(12), TriangleIndex(340)}, {TriangleIndex(9), TriangleIndex(3)}};
    entry.field = FieldKind::Logarithms;
    entry.scale = 0.9;
    entry.correctsPose = false;
    entry.carriesStretch = false;
    entry.marksSurroundings = false;
    entry.correctsContacts = false;
    entry.truth = "sequences/softly";
    return entry;
}

} // namespace quadrille::test
