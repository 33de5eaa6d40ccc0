// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/groundshadow.h"

#include "widgets/viewport/vtkbuffers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

namespace quadrille::widgets {

namespace {

/// The opacity of black over a colour that takes away a share of its linear light.
std::array<unsigned char, 256> opacities(double strength)
{
    std::array<unsigned char, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double missing = strength * static_cast<double>(i) / 255.0;
        table[i] = static_cast<unsigned char>(std::lround(255.0 * (1.0 - std::pow(1.0 - missing, 1 / 2.2))));
    }
    return table;
}

} // namespace

struct ShadowActor::Private
{
    vtkSmartPointer<vtkRenderer> renderer;
    vtkNew<vtkActor> actor;
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> places;
    vtkNew<vtkPolyData> surface;
    vtkNew<vtkImageData> image;
    vtkNew<vtkUnsignedCharArray> pixels;
    vtkNew<vtkTexture> texture;
};

ShadowActor::ShadowActor(vtkRenderer* renderer) : d(std::make_unique<Private>())
{
    d->renderer = renderer;
    vtkbuffers::makeQuad(d->surface, d->points, d->places);
    vtkNew<vtkFloatArray> uvs;
    vtkbuffers::allocate(uvs, 2, 4, "UVs");
    static constexpr float corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (vtkIdType i = 0; i < 4; ++i)
        uvs->SetTypedTuple(i, corners[i]);
    d->surface->GetPointData()->SetTCoords(uvs);
    vtkNew<vtkOpenGLPolyDataMapper> mapper;
    vtkbuffers::connect(mapper, d->surface);
    d->actor->SetMapper(mapper);
    d->actor->PickableOff();
    d->actor->ForceTranslucentOn();
    d->actor->GetProperty()->LightingOff();
    d->actor->GetProperty()->SetColor(0, 0, 0);
    d->pixels->SetNumberOfComponents(4);
    d->texture->SetInputData(d->image);
    d->texture->InterpolateOn();
    d->texture->RepeatOff();
    d->texture->EdgeClampOn();
    d->texture->SetColorModeToDirectScalars();
    d->actor->SetTexture(d->texture);
    d->actor->SetVisibility(0);
    renderer->AddActor(d->actor);
}

ShadowActor::~ShadowActor()
{
    d->renderer->RemoveActor(d->actor);
}

void ShadowActor::show(const GroundShadow& shadow, UpAxis up, double strength)
{
    const auto cells = static_cast<std::size_t>(shadow.columns) * static_cast<std::size_t>(shadow.rows);
    if (cells == 0 || shadow.darkness.size() != cells) {
        setVisible(false);
        return;
    }
    const auto opacity = opacities(strength);
    d->pixels->SetNumberOfTuples(static_cast<vtkIdType>(cells));
    unsigned char* pixel = d->pixels->GetPointer(0);
    for (const float darkness : shadow.darkness) {
        pixel[0] = pixel[1] = pixel[2] = 0;
        pixel[3] = opacity[static_cast<std::size_t>(std::lround(std::clamp(darkness, 0.0F, 1.0F) * 255.0F))];
        pixel += 4;
    }
    d->image->SetDimensions(shadow.columns, shadow.rows, 1);
    d->image->GetPointData()->SetScalars(d->pixels);
    d->pixels->Modified();
    d->image->Modified();
    d->texture->Modified();

    const int alongColumns = up == UpAxis::Y ? 2 : 0;
    const int alongRows = up == UpAxis::Y ? 0 : 1;
    const auto width = static_cast<float>(shadow.cell * shadow.columns);
    const auto height = static_cast<float>(shadow.cell * shadow.rows);
    static constexpr float corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (vtkIdType i = 0; i < 4; ++i) {
        QVector3D place = shadow.corner;
        place[alongColumns] += corners[i][0] * width;
        place[alongRows] += corners[i][1] * height;
        const float values[3] = {place.x(), place.y(), place.z()};
        d->places->SetTypedTuple(i, values);
    }
    d->places->Modified();
    d->points->Modified();
    d->surface->Modified();
    setVisible(true);
}

void ShadowActor::setOffset(const QVector3D& offset)
{
    d->actor->SetPosition(vtkbuffers::xyz(offset).data());
}

void ShadowActor::setVisible(bool visible)
{
    d->actor->SetVisibility(visible ? 1 : 0);
}

} // namespace quadrille::widgets
