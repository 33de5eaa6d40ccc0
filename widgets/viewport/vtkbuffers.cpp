// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/vtkbuffers.h"

#include <algorithm>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace quadrille::widgets::vtkbuffers {

void allocate(vtkFloatArray* array, int components, std::size_t tuples, const char* name)
{
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
    std::fill_n(array->GetPointer(0), tuples * static_cast<std::size_t>(components), 0.0F);
}

std::span<float> values(vtkFloatArray* array)
{
    return {array->GetPointer(0), static_cast<std::size_t>(array->GetNumberOfValues())};
}

void setCells(vtkCellArray* cells, std::span<const std::array<std::uint32_t, 3>> triangles)
{
    cells->AllocateEstimate(static_cast<vtkIdType>(triangles.size()), 3);
    for (const auto& triangle : triangles)
        cells->InsertNextCell({static_cast<vtkIdType>(triangle[0]), static_cast<vtkIdType>(triangle[1]),
                               static_cast<vtkIdType>(triangle[2])});
}

void makeQuad(vtkPolyData* surface, vtkPoints* points, vtkFloatArray* places)
{
    allocate(places, 3, 4, "Places");
    points->SetData(places);
    surface->SetPoints(points);
    vtkNew<vtkCellArray> cells;
    const std::array<std::array<std::uint32_t, 3>, 2> triangles{{{0, 1, 2}, {0, 2, 3}}};
    setCells(cells, triangles);
    surface->SetPolys(cells);
}

void connect(vtkOpenGLPolyDataMapper* mapper, vtkPolyData* surface)
{
    mapper->SetInputData(surface);
    // Metres need no shifting into the range of floats; computing it would cost a pass per frame.
    mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
    mapper->ScalarVisibilityOff();
}

std::array<double, 3> xyz(const QVector3D& place)
{
    return {static_cast<double>(place.x()), static_cast<double>(place.y()), static_cast<double>(place.z())};
}

std::array<double, 3> rgb(const QColor& color)
{
    return {color.redF(), color.greenF(), color.blueF()};
}

QVector3D mean(std::span<const float> positions)
{
    double sum[3] = {};
    for (std::size_t i = 0; i + 2 < positions.size(); i += 3)
        for (std::size_t axis = 0; axis < 3; ++axis)
            sum[axis] += static_cast<double>(positions[i + axis]);
    const std::size_t vertices = positions.size() / 3;
    const auto count = static_cast<double>(std::max<std::size_t>(vertices, 1));
    return {static_cast<float>(sum[0] / count), static_cast<float>(sum[1] / count),
            static_cast<float>(sum[2] / count)};
}

} // namespace quadrille::widgets::vtkbuffers
