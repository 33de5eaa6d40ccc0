// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"
#include "model/geometry/surfaceroute.h"
#include "model/variation/parts/bodylimbs.h"

#include <string>
#include <vector>

namespace quadrille {

/// Finds where one limb begins, on the half of the body that is nearer to its tip than to that of the limb
/// opposite.
class LimbCurves
{
public:
    /// \param taken  vertices that no curve may touch. \param name  of the limb, for errors.
    LimbCurves(const SurfaceGraph& graph, const BodyLimbs& body, const Limb& limb, const Limb& opposite,
               const std::vector<bool>& taken, std::string name);

    /// The innermost point of a limb whose end the body's surface leaves on its way to the tip of another:
    /// loops around the limb grow slowly up to there, and beyond as fast as they have to lead back to it.
    /// \throws Error PartsNotCut, PartsLimbGrown where a head has to be taken for the limb, Cancelled.
    VertexIndex armpit(const Limb& other, const Progress& progress);
    /// The last point before the middle between the limb and the one opposite. \throws Error PartsNotCut.
    VertexIndex crotch();
    /// The closed curve around the limb through its innermost point, and on the outside nearer to the body,
    /// as an armhole leads. \throws Error PartsNotCut.
    std::vector<VertexIndex> slantingLoop(VertexIndex inside) const;

private:
    void openTo(const Limb& other);
    OpenedSurface half() const { return {&m_graph, &*m_cut, &m_half}; }
    float loopLength(VertexIndex through, float limit) const;
    std::vector<VertexIndex> loopThrough(VertexIndex inside) const;
    std::vector<VertexIndex> loopThrough(VertexIndex inside, VertexIndex outside) const;
    std::vector<VertexIndex> routed(SurfaceDistances& forward, SheetVertex from, SheetVertex to,
                                    const std::vector<bool>& blocked) const;
    VertexIndex beyond(VertexIndex outside) const;
    [[noreturn]] void fail(ErrorCode code = ErrorCode::PartsNotCut) const;

    const SurfaceGraph& m_graph;
    const BodyLimbs& m_body;
    const Limb& m_limb;
    const Limb& m_opposite;
    const std::vector<bool>& m_taken;
    std::string m_name;
    std::vector<bool> m_half;
    std::optional<CrossCut> m_cut;
};

} // namespace quadrille
