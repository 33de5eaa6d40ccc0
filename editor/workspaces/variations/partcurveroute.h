// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/variations/partcurvecontent.h"
#include "model/geometry/surfacecurve.h"
#include "widgets/tools/showncurve.h"

#include <optional>

namespace quadrille {

/// A curve of a body while its points are edited: each leads it over the surface, around all other curves.
/// Edits throw what those of SurfaceCurve throw, and leave the curve as it was then.
class PartCurveRoute
{
public:
    /// \param content  outlives the route, with a graph. \param entry  null: a new curve, without a name yet.
    /// \param snaps  whether it follows creases, where that is wanted at all.
    /// \throws Error as SurfaceCurve::restore.
    PartCurveRoute(const PartCurveContent& content, const PartCurveEntry* entry, bool snaps);
    const std::string& name() const { return m_name; }
    /// Under which putInto() puts it.
    void setName(const std::string& name) { m_name = name; }
    const SurfaceCurve& curve() const { return m_curve; }
    /// The body as it was when the edit began.
    const BodyPartsEntry& before() const { return m_before; }

    /// \param before  the point that it comes before, from 0; their number: behind the last.
    void insert(std::size_t before, const widgets::SurfacePlace& place);
    /// \return false where the point is there already, or was tried to be put there last.
    bool move(std::size_t index, const widgets::SurfacePlace& place);
    void remove(std::size_t index) { m_curve.remove(index); }
    /// Whether move() has done or tried something.
    bool hasMoved() const { return m_last.has_value(); }
    /// Leads the curve on to a place, by a point behind the last one; further calls move that point.
    void leadTo(const widgets::SurfacePlace& place);
    /// The vertices of the two pieces at the last point, from the point before it to the first one. Empty
    /// without points.
    std::vector<std::uint32_t> lastPieces() const;
    /// Puts the curve in the place of that of its name, or behind the others.
    void putInto(BodyPartsEntry& body) const;

private:
    /// Where a point goes; to a crease where that is wanted and free.
    VertexIndex vertexAt(const widgets::SurfacePlace& place) const;

    const PartCurveContent& m_content;
    std::string m_name;
    SurfaceCurve m_curve;
    BodyPartsEntry m_before;
    std::vector<VertexIndex> m_taken;  ///< by other curves
    std::optional<VertexIndex> m_last; ///< where the moved point is now
};

} // namespace quadrille
