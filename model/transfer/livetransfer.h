// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/framesource.h"
#include "model/transfer/preparedtransfer.h"

#include <tbb/enumerable_thread_specific.h>

namespace quadrille {

/// A transfer whose poses are made when somebody looks at them: as transferClip makes them but for heights,
/// which are not evened over time, and a scale that steps have no say in.
class LiveTransfer : public FrameSource
{
public:
    /// \param unitsPerMetre  of the positions that are read.
    LiveTransfer(PreparedTransfer prepared, const TransferSettings& settings, double unitsPerMetre);

    const PreparedTransfer& prepared() const { return m_prepared; }
    std::int64_t frameCount() const override { return static_cast<std::int64_t>(m_prepared.frames()); }
    std::uint32_t vertexCount() const override { return static_cast<std::uint32_t>(m_prepared.vertices()); }
    /// Cost: see TransferSolver::pose.
    void read(FrameIndex frame, MutablePositions out) const override;

private:
    PreparedTransfer m_prepared;
    double m_scale;
    UpAxis m_up;
    float m_unitsPerMetre;
    mutable tbb::enumerable_thread_specific<TransferSolver::Scratch> m_scratch;
};

} // namespace quadrille
