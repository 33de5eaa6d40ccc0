// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/projection/pinholecamera.h"
#include "model/render/rasterizer.h"

#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// How far a camera is trusted.
struct SightOptions
{
    double sharpness = 4;          ///< power of the cosine of the angle of view, 0 … 16
    double grazing = 0.1;          ///< cosine at which surfaces are not seen any more …
    double facing = 0.35;          ///< … and from which on they are seen wholly
    double depthTolerance = 0.002; ///< of the depth: what is nearer to what is seen is seen as well
    double edgeMargin = 3;         ///< along edges of what lies in front, pixels
    double borderMargin = 8;       ///< along the borders of the picture, pixels
};

/// A point of a surface.
struct SurfaceSample
{
    Vec3d point;            ///< world
    Vec3d normal;           ///< unit; smooth, for weights
    TriangleIndex triangle; ///< that it is on
};

/// How a camera sees a point.
struct Sight
{
    Vec2d pixel;      ///< where
    Vec3d place;      ///< in the camera
    double trust = 0; ///< 0 … 1, above 0: less at grazing angles, edges of what lies in front, and borders
    double clearance = 0; ///< how far the next edge is, pixels
    double weight = 0;    ///< trust · cosineˢʰᵃʳᵖⁿᵉˢˢ
};

/// What one camera sees of one frame: a map of depths, of its ideal picture, without the lens's distortion.
class CameraView
{
public:
    /// \pre The camera has no fault, positions are finite. Cost: O(pixels + triangles).
    CameraView(const PinholeCamera& camera, Positions positions, std::span<const Triangle> triangles,
               const SightOptions& options = {});

    /// Nothing where the point is not seen: behind the camera, outside of the picture, hidden, or turned
    /// away. Weights are continuous over a surface that has smooth normals.
    std::optional<Sight> sightOf(const SurfaceSample& sample) const;
    const CameraLens& lens() const { return m_lens; }

private:
    /// The plane of a triangle in the camera: normal · x = distance.
    struct Plane
    {
        Vec3d normal;
        double distance = 0;
        double depthAt(const Vec2d& ideal) const
        {
            return distance / (normal.x() * ideal.x() + normal.y() * ideal.y() + normal.z());
        }
    };

    void frameIdealPicture();
    void measureEdges();
    bool isStep(std::size_t a, std::size_t b) const;
    double depthAt(std::uint32_t triangle, const Vec2d& ideal) const
    {
        return m_planes[triangle].depthAt(ideal);
    }
    /// Of the middle of a sample of the ideal picture.
    Vec2d idealAt(std::size_t sample) const;
    bool isHidden(const SurfaceSample& sample, const Vec3d& place, int x, int y) const;
    double edgeDistance(const Vec2d& at) const;

    PinholeCamera m_camera;
    CameraLens m_lens;
    SightOptions m_options;
    Vec3d m_centre;
    int m_width = 0; ///< of the ideal picture, samples
    int m_height = 0;
    Vec2d m_middle; ///< where the axis of view meets it; the middle of the first sample is (0, 0)
    std::vector<Plane> m_planes; ///< per triangle; none where all lies behind the camera
    RasterBuffers m_seen;
    std::vector<float> m_edges; ///< per sample, how far the next step in depth is, samples
};

} // namespace quadrille
