// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/surfacemesh.h"

#include <Eigen/Geometry>

namespace quadrille {

std::vector<Vec3d> vertexNormals(const SurfaceMesh& mesh)
{
    std::vector<Vec3d> normals(mesh.points.size(), Vec3d::Zero());
    for (const Triangle& t : mesh.triangles) {
        const Vec3d& a = mesh.points[t[0].value];
        const Vec3d n = 0.5 * (mesh.points[t[1].value] - a).cross(mesh.points[t[2].value] - a);
        for (const VertexIndex v : t)
            normals[v.value] += n;
    }
    for (Vec3d& n : normals)
        n.normalize();
    return normals;
}

} // namespace quadrille
