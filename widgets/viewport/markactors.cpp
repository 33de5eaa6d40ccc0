// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/markactors.h"

#include "widgets/viewport/vtkbuffers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>
#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

namespace quadrille::widgets {

namespace {

constexpr float areaLift = 0.002F;    // metres above the ground, or the grid would flicker through
constexpr float curveLift = 0.004F;   // above areas
constexpr float hatchSpacing = 0.12F; // metres
constexpr double fillOpacity = 0.22;

struct Drawn
{
    Drawn()
    {
        mapper->SetInputData(shape);
        mapper->SetScalarModeToUsePointData();
        actor->SetMapper(mapper);
        actor->PickableOff();
        actor->GetProperty()->LightingOff();
    }

    vtkNew<vtkPolyData> shape;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
};

/// Fills one actor from points, colours, lines and triangles.
class Builder
{
public:
    vtkIdType add(const QVector3D& point)
    {
        return m_points->InsertNextPoint(static_cast<double>(point.x()), static_cast<double>(point.y()),
                                         static_cast<double>(point.z()));
    }
    void add(const QVector3D& point, const QColor& color)
    {
        add(point);
        m_colors.push_back(color);
    }
    void line(std::initializer_list<vtkIdType> ends) { m_lines->InsertNextCell(ends); }
    void line(vtkIdType first, vtkIdType count)
    {
        m_lines->InsertNextCell(static_cast<int>(count));
        for (vtkIdType i = 0; i < count; ++i)
            m_lines->InsertCellPoint(first + i);
    }
    void triangle(std::initializer_list<vtkIdType> corners) { m_triangles->InsertNextCell(corners); }
    vtkIdType count() const { return m_points->GetNumberOfPoints(); }

    void finish(Drawn& drawn, const QColor& color, double width, double opacity)
    {
        drawn.shape->Initialize();
        drawn.shape->SetPoints(m_points);
        drawn.shape->SetLines(m_lines);
        drawn.shape->SetPolys(m_triangles);
        if (!m_colors.empty()) {
            vtkNew<vtkUnsignedCharArray> colors;
            colors->SetNumberOfComponents(3);
            for (const QColor& own : m_colors)
                colors->InsertNextTuple3(own.red(), own.green(), own.blue());
            drawn.shape->GetPointData()->SetScalars(colors);
        }
        drawn.mapper->SetScalarVisibility(m_colors.empty() ? 0 : 1);
        const auto rgb = vtkbuffers::rgb(color);
        vtkProperty* property = drawn.actor->GetProperty();
        property->SetColor(rgb[0], rgb[1], rgb[2]);
        property->SetLineWidth(static_cast<float>(width));
        property->SetOpacity(opacity);
        drawn.actor->SetVisibility(count() > 0 ? 1 : 0);
    }

private:
    vtkNew<vtkPoints> m_points;
    vtkNew<vtkCellArray> m_lines;
    vtkNew<vtkCellArray> m_triangles;
    std::vector<QColor> m_colors;
};

QColor mixed(const QColor& a, const QColor& b, float t)
{
    const auto mix = [t](int from, int to) { return static_cast<int>(std::lround(from + t * (to - from))); };
    return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

/// Lines where dashes are, cut out of the curve at their ends.
void addDashes(Builder& builder, const SceneCurve& curve, const QVector3D& lift)
{
    const bool isColored = curve.colors.size() == curve.points.size();
    const auto put = [&](std::size_t i, float t) {
        const QVector3D place = curve.points[i] + t * (curve.points[i + 1] - curve.points[i]) + lift;
        if (isColored)
            builder.add(place, mixed(curve.colors[i], curve.colors[i + 1], t));
        else
            builder.add(place);
    };
    float walked = 0.0F;
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
        const float length = (curve.points[i + 1] - curve.points[i]).length();
        for (float from = 0.0F; from < length;) {
            const float cell = std::floor((walked + from) / curve.dash + 1e-4F);
            const float to =
                std::min(length, std::max((cell + 1.0F) * curve.dash - walked, from + 1e-3F * curve.dash));
            if (static_cast<long>(cell) % 2 == 0) {
                const vtkIdType first = builder.count();
                put(i, from / length);
                put(i, to / length);
                builder.line({first, first + 1});
            }
            from = to;
        }
        walked += length;
    }
}

void build(Builder& builder, const SceneCurve& curve, const QVector3D& lift)
{
    if (curve.dash > 0.0F && !curve.pairs) {
        addDashes(builder, curve, lift);
        return;
    }
    const bool isColored = curve.colors.size() == curve.points.size();
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        if (isColored)
            builder.add(curve.points[i] + lift, curve.colors[i]);
        else
            builder.add(curve.points[i] + lift);
    }
    if (curve.pairs) {
        for (vtkIdType i = 0; i + 1 < builder.count(); i += 2)
            builder.line({i, i + 1});
    } else if (builder.count() > 1) {
        builder.line(vtkIdType{0}, builder.count());
    }
}

} // namespace

struct MarkActors::Private
{
    vtkSmartPointer<vtkRenderer> renderer;
    std::vector<std::unique_ptr<Drawn>> fills; ///< drawn first
    std::vector<std::unique_ptr<Drawn>> lines;

    void resize(std::vector<std::unique_ptr<Drawn>>& drawn, std::size_t count) const
    {
        while (drawn.size() > count) {
            renderer->RemoveActor(drawn.back()->actor);
            drawn.pop_back();
        }
        while (drawn.size() < count) {
            drawn.push_back(std::make_unique<Drawn>());
            renderer->AddActor(drawn.back()->actor);
        }
    }
};

MarkActors::MarkActors(vtkRenderer* renderer) : d(std::make_unique<Private>())
{
    d->renderer = renderer;
}

MarkActors::~MarkActors()
{
    d->resize(d->fills, 0);
    d->resize(d->lines, 0);
}

void MarkActors::show(const SceneMarks& marks, const QVector3D& metre, double pixels)
{
    const QVector3D up = metre.normalized();
    d->resize(d->fills, marks.areas.size());
    d->resize(d->lines, marks.curves.size() + marks.areas.size());
    for (std::size_t i = 0; i < marks.areas.size(); ++i) {
        const SceneArea& area = marks.areas[i];
        Builder fill;
        for (const QVector3D& corner : area.outline)
            fill.add(corner + areaLift * metre);
        const std::vector<int> triangles = triangulate(area.outline, up);
        for (std::size_t t = 0; t + 2 < triangles.size(); t += 3)
            fill.triangle({triangles[t], triangles[t + 1], triangles[t + 2]});
        fill.finish(*d->fills[i], area.color, 1.0, fillOpacity);

        Builder border;
        for (const QVector3D& corner : area.outline)
            border.add(corner + curveLift * metre);
        const vtkIdType corners = border.count();
        for (vtkIdType c = 0; c < corners; ++c)
            border.line({c, (c + 1) % corners});
        if (area.hatched) {
            const std::vector<QVector3D> hatch = hatchLines(area.outline, up, hatchSpacing * metre.length());
            for (std::size_t h = 0; h + 1 < hatch.size(); h += 2) {
                const vtkIdType first = border.add(hatch[h] + curveLift * metre);
                border.line({first, border.add(hatch[h + 1] + curveLift * metre)});
            }
        }
        border.finish(*d->lines[i], area.color, 1.5 * pixels, 1.0);
    }
    for (std::size_t i = 0; i < marks.curves.size(); ++i) {
        const SceneCurve& curve = marks.curves[i];
        Builder builder;
        // Each a little above the one before, or they would flicker through each other.
        build(builder, curve, (curveLift + 0.001F * static_cast<float>(i)) * metre);
        builder.finish(*d->lines[marks.areas.size() + i], curve.color,
                       static_cast<double>(curve.width) * pixels, curve.color.alphaF());
    }
}

} // namespace quadrille::widgets
