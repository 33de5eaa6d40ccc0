// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QVector3D>
#include <array>
#include <cstdint>
#include <span>

class vtkCellArray;
class vtkFloatArray;
class vtkOpenGLPolyDataMapper;
class vtkPoints;
class vtkPolyData;

/// Small helpers between spans and VTK's arrays; included by sources of the viewport only.
namespace quadrille::widgets::vtkbuffers {

/// Makes room for zeros.
void allocate(vtkFloatArray* array, int components, std::size_t tuples, const char* name);
/// All numbers of an array, good until it gets another size; Modified() is the caller's to call.
std::span<float> values(vtkFloatArray* array);
/// Adds triangles, as indices of points.
void setCells(vtkCellArray* cells, std::span<const std::array<std::uint32_t, 3>> triangles);
/// Makes a surface of four corners, all at the origin, in two triangles. \param places  of the corners, 4
/// × 3.
void makeQuad(vtkPolyData* surface, vtkPoints* points, vtkFloatArray* places);
/// Lets a mapper show one surface without scalars, quick to update.
void connect(vtkOpenGLPolyDataMapper* mapper, vtkPolyData* surface);
/// From 0 to 1, as VTK has them.
std::array<double, 3> rgb(const QColor& color);
std::array<double, 3> xyz(const QVector3D& place);
/// Mean of points given as vertices × 3. Summed up in double precision; zero for none.
QVector3D mean(std::span<const float> positions);

} // namespace quadrille::widgets::vtkbuffers
