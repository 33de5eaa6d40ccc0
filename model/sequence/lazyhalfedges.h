// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <memory>
#include <mutex>

namespace quadrille {

/// Apart from HalfEdges, so that who asks for none links no OpenMesh.
struct Topology::LazyHalfEdges
{
    std::once_flag once;
    std::shared_ptr<const HalfEdges> halfEdges;
};

} // namespace quadrille
