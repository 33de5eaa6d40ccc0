// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/figureactor.h"

#include "widgets/viewport/prepassactor.h"
#include "widgets/viewport/vtkbuffers.h"

#include <algorithm>
#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

namespace quadrille::widgets {

/// The triangles of one material.
struct FigureActor::Part
{
    std::vector<std::uint32_t> triangles; ///< of the figure
    vtkNew<vtkPolyData> surface;
    vtkNew<vtkOpenGLPolyDataMapper> mapper;
    vtkSmartPointer<vtkActor> actor;
    QImage picture; ///< keeps the pixels alive that VTK reads
    vtkNew<vtkImageData> image;
    vtkNew<vtkTexture> texture;

    /// \param colorOf  gives the QRgb of a triangle of the figure.
    template <typename ColorOf>
    void setColors(const ColorOf& colorOf)
    {
        vtkNew<vtkUnsignedCharArray> colors;
        colors->SetNumberOfComponents(3);
        colors->SetNumberOfTuples(static_cast<vtkIdType>(triangles.size()));
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const QRgb color = colorOf(triangles[i]);
            colors->SetTuple3(static_cast<vtkIdType>(i), qRed(color), qGreen(color), qBlue(color));
        }
        surface->GetCellData()->SetScalars(colors);
    }
};

struct FigureActor::Private
{
    vtkSmartPointer<vtkRenderer> renderer;
    const FigureLights* lights = nullptr;
    FigureMesh mesh;
    SplitMesh split;
    std::vector<float> positions;
    std::vector<float> normals;
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> splitPositions;
    vtkNew<vtkFloatArray> splitNormals;
    vtkNew<vtkUnsignedCharArray> vertexColors;
    std::vector<std::unique_ptr<Part>> parts;
    QVector3D lower;
    QVector3D upper;
    bool scalars = false;
    ScalarPlace scalarPlace = ScalarPlace::PerVertex;
    Shading shading = Shading::Textured;
    QColor clay{200, 200, 200};
    QColor wire{Qt::black};
    double lineWidth = 1.0;
};

FigureActor::FigureActor(vtkRenderer* renderer, const FigureLights& lights, FigureMesh mesh)
    : d(std::make_unique<Private>())
{
    d->renderer = renderer;
    d->lights = &lights;
    d->mesh = std::move(mesh);
    d->split = splitAtSeams(d->mesh);
    d->positions.assign(std::size_t{3} * d->mesh.vertexCount, 0.0F);
    d->normals = d->positions;
    vtkbuffers::allocate(d->splitPositions, 3, d->split.source.size(), "Positions");
    vtkbuffers::allocate(d->splitNormals, 3, d->split.source.size(), "Normals");
    d->points->SetData(d->splitPositions);
    vtkNew<vtkFloatArray> uvs;
    if (!d->split.uvs.empty()) {
        vtkbuffers::allocate(uvs, 2, d->split.uvs.size(), "UVs");
        // VTK's pictures start at the bottom, Qt's at the top: turning v spares turning every texture.
        for (std::size_t i = 0; i < d->split.uvs.size(); ++i) {
            uvs->SetValue(static_cast<vtkIdType>(i) * 2, d->split.uvs[i][0]);
            uvs->SetValue(static_cast<vtkIdType>(i) * 2 + 1, 1.0F - d->split.uvs[i][1]);
        }
    }
    d->parts.resize(static_cast<std::size_t>(d->mesh.materialCount()));
    for (auto& part : d->parts)
        part = std::make_unique<Part>();
    for (std::uint32_t t = 0; t < d->mesh.triangles.size(); ++t)
        d->parts[d->mesh.triangleMaterials.empty() ? 0 : d->mesh.triangleMaterials[t]]->triangles.push_back(
            t);
    for (auto& part : d->parts) {
        std::vector<std::array<std::uint32_t, 3>> triangles;
        triangles.reserve(part->triangles.size());
        for (const std::uint32_t t : part->triangles)
            triangles.push_back(d->split.triangles[t]);
        part->surface->SetPoints(d->points);
        vtkNew<vtkCellArray> cells;
        vtkbuffers::setCells(cells, triangles);
        part->surface->SetPolys(cells);
        part->surface->GetPointData()->SetNormals(d->splitNormals);
        if (!d->split.uvs.empty())
            part->surface->GetPointData()->SetTCoords(uvs);
        vtkbuffers::connect(part->mapper, part->surface);
        part->actor = vtkSmartPointer<vtkActor>::Take(newPrepassActor());
        part->actor->SetMapper(part->mapper);
        part->texture->SetInputData(part->image);
        part->texture->InterpolateOn();
        part->texture->SetColorModeToDirectScalars();
        renderer->AddActor(part->actor);
    }
    applyAppearance();
}

FigureActor::~FigureActor()
{
    for (const auto& part : d->parts)
        d->renderer->RemoveActor(part->actor);
}

const FigureMesh& FigureActor::mesh() const
{
    return d->mesh;
}

std::span<const float> FigureActor::positions() const
{
    return d->positions;
}

QVector3D FigureActor::lowerBound() const
{
    return d->lower;
}

QVector3D FigureActor::upperBound() const
{
    return d->upper;
}

QVector3D FigureActor::centroid() const
{
    return vtkbuffers::mean(d->positions);
}

void FigureActor::setPositions(std::span<const float> positions)
{
    Q_ASSERT(positions.size() == d->positions.size());
    std::copy(positions.begin(), positions.end(), d->positions.begin());
    computeNormals(d->mesh, d->positions, d->normals);
    spread(d->split, d->positions, vtkbuffers::values(d->splitPositions));
    spread(d->split, d->normals, vtkbuffers::values(d->splitNormals));
    if (!positions.empty()) {
        d->lower = d->upper = QVector3D(positions[0], positions[1], positions[2]);
        for (std::size_t i = 0; i + 2 < positions.size(); i += 3)
            for (int axis = 0; axis < 3; ++axis) {
                const float value = positions[i + static_cast<std::size_t>(axis)];
                d->lower[axis] = std::min(d->lower[axis], value);
                d->upper[axis] = std::max(d->upper[axis], value);
            }
    }
    d->splitPositions->Modified();
    d->splitNormals->Modified();
    d->points->Modified();
    for (const auto& part : d->parts)
        part->surface->Modified();
}

void FigureActor::setTexture(const QImage& texture, int material)
{
    if (material < 0 || material >= static_cast<int>(d->parts.size()))
        return;
    Part& part = *d->parts[static_cast<std::size_t>(material)];
    const bool hadTexture = !part.picture.isNull();
    // Rows must follow each other without padding.
    const bool tightRgb =
        texture.format() == QImage::Format_RGB888 && texture.bytesPerLine() == qsizetype{3} * texture.width();
    part.picture = tightRgb ? texture : texture.convertToFormat(QImage::Format_RGBA8888);
    if (!part.picture.isNull()) {
        const int channels = tightRgb ? 3 : 4;
        vtkNew<vtkUnsignedCharArray> pixels;
        pixels->SetNumberOfComponents(channels);
        // VTK only reads them; a const_cast is what its interface leaves.
        pixels->SetArray(const_cast<unsigned char*>(part.picture.constBits()),
                         static_cast<vtkIdType>(part.picture.width()) * part.picture.height() * channels, 1);
        part.image->SetDimensions(part.picture.width(), part.picture.height(), 1);
        part.image->GetPointData()->SetScalars(pixels);
        part.image->Modified();
        part.texture->Modified();
    }
    if (hadTexture == part.picture.isNull())
        applyAppearance();
}

bool FigureActor::hasTexture() const
{
    return std::any_of(d->parts.begin(), d->parts.end(),
                       [](const auto& part) { return !part->picture.isNull(); });
}

void FigureActor::setScalars(std::span<const float> scalars, ScalarPlace place, const ScalarRange& range)
{
    const auto colorOf = [&](std::size_t index) { return range.color(static_cast<double>(scalars[index])); };
    const bool had = d->scalars;
    d->scalars = !scalars.empty();
    if (d->scalars && place == ScalarPlace::PerVertex) {
        Q_ASSERT(scalars.size() == d->mesh.vertexCount);
        d->vertexColors->SetNumberOfComponents(3);
        d->vertexColors->SetNumberOfTuples(static_cast<vtkIdType>(d->split.source.size()));
        for (std::size_t i = 0; i < d->split.source.size(); ++i) {
            const QColor color = colorOf(d->split.source[i]);
            d->vertexColors->SetTuple3(static_cast<vtkIdType>(i), color.red(), color.green(), color.blue());
        }
        d->vertexColors->Modified();
    }
    for (const auto& part : d->parts) {
        if (d->scalars && place == ScalarPlace::PerVertex)
            part->surface->GetPointData()->SetScalars(d->vertexColors);
        else if (d->scalars)
            part->setColors([&](std::uint32_t triangle) { return colorOf(triangle).rgb(); });
    }
    if (had != d->scalars || place != d->scalarPlace) {
        d->scalarPlace = place;
        applyAppearance();
    }
}

void FigureActor::setTriangleColors(std::span<const QRgb> colors)
{
    Q_ASSERT(colors.empty() || colors.size() == d->mesh.triangles.size());
    d->scalars = !colors.empty();
    d->scalarPlace = ScalarPlace::PerTriangle;
    for (const auto& part : d->parts)
        if (d->scalars)
            part->setColors([&](std::uint32_t triangle) { return colors[triangle]; });
    applyAppearance();
}

bool FigureActor::hasScalars() const
{
    return d->scalars;
}

void FigureActor::setOffset(const QVector3D& offset)
{
    for (const auto& part : d->parts)
        part->actor->SetPosition(static_cast<double>(offset.x()), static_cast<double>(offset.y()),
                                 static_cast<double>(offset.z()));
}

void FigureActor::setVisible(bool visible)
{
    for (const auto& part : d->parts)
        part->actor->SetVisibility(visible ? 1 : 0);
}

void FigureActor::setOpacity(double opacity)
{
    for (const auto& part : d->parts)
        part->actor->GetProperty()->SetOpacity(opacity);
    applyAppearance();
}

void FigureActor::setColors(const QColor& clay, const QColor& wire)
{
    d->clay = clay;
    d->wire = wire;
    applyAppearance();
}

void FigureActor::setShading(Shading shading)
{
    d->shading = shading;
    applyAppearance();
}

void FigureActor::setLineWidth(double pixels)
{
    d->lineWidth = pixels;
    applyAppearance();
}

void FigureActor::applyAppearance()
{
    for (const auto& part : d->parts) {
        const bool textured = d->shading == Shading::Textured && !part->picture.isNull() && d->mesh.hasUvs();
        const bool scalar = d->shading == Shading::Scalar && d->scalars;
        const bool wire = d->shading == Shading::Wireframe;
        vtkProperty* property = part->actor->GetProperty();
        part->actor->SetTexture(textured ? part->texture.Get() : nullptr);
        // A texture's alpha is no transparency of the figure, and VTK would look for it in every pixel.
        part->actor->SetForceOpaque(property->GetOpacity() >= 1.0);
        part->mapper->SetScalarVisibility(scalar ? 1 : 0);
        part->mapper->SetColorModeToDirectScalars();
        if (d->scalarPlace == ScalarPlace::PerVertex)
            part->mapper->SetScalarModeToUsePointData();
        else
            part->mapper->SetScalarModeToUseCellData();
        const auto color = vtkbuffers::rgb(textured ? QColor(Qt::white) : d->clay);
        property->SetColor(color[0], color[1], color[2]);
        property->SetAmbient(0.0);
        property->SetDiffuse(1.0);
        part->actor->SetShaderProperty(
            d->lights->shader(textured ? FigureLights::Surface::Textured : FigureLights::Surface::Clay));
        property->SetEdgeVisibility(wire ? 1 : 0);
        const auto edge = vtkbuffers::rgb(d->wire);
        property->SetEdgeColor(edge[0], edge[1], edge[2]);
        property->SetLineWidth(static_cast<float>(d->lineWidth));
    }
}

} // namespace quadrille::widgets
