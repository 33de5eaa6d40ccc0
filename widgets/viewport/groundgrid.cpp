// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/groundgrid.h"

#include "widgets/viewport/vtkbuffers.h"

#include <algorithm>
#include <cmath>
#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkSmartPointer.h>
#include <vtkUniforms.h>

namespace quadrille::widgets {

namespace {

/// Draws lines from the place on the ground, antialiased by its derivative, in place of the lit colour.
constexpr auto fragmentCode = R"(
  vec2 place = groundPlace / lineStep;
  vec2 perPixel = max(fwidth(place), vec2(1e-6));
  vec2 perLine = perPixel * linePixels;
  float coarsest = max(perPixel.x, perPixel.y) * linePixels;
  vec2 metre = abs(fract(place - 0.5) - 0.5) / perLine;
  vec2 tenth = abs(fract(place * lineParts - 0.5) - 0.5) / (perLine * lineParts);
  float metreLine = (1.0 - min(min(metre.x, metre.y), 1.0)) * (1.0 - smoothstep(0.15, 0.5, coarsest));
  float tenthLine = (1.0 - min(min(tenth.x, tenth.y), 1.0)) * (1.0 - smoothstep(0.006, 0.02, coarsest));
  float alpha = max(metreLine * 0.42, tenthLine * 0.14);
  vec3 color = lineColor;
  vec2 axis = 1.0 - clamp(abs(place) / perLine - 0.25, 0.0, 1.0);
  axis *= 0.7 * (1.0 - smoothstep(0.0, 1.0, vec2(abs(groundPlace.y), abs(groundPlace.x)) / axisLength));
  if (axis.y > 0.0) { color = mix(color, firstColor, axis.y); alpha = max(alpha, axis.y); }
  if (axis.x > 0.0) { color = mix(color, secondColor, axis.x); alpha = max(alpha, axis.x); }
  float away = length(groundPlace - fadeCenter) / fadeRadius;
  float near = 1.0 - smoothstep(0.12, 1.0, away);
  alpha *= near;
  float under = floorBrightness * near * near * (1.0 - alpha);
  fragOutput0 = vec4((color * alpha + vec3(under)) / max(alpha + under, 1e-4), alpha + under);
)";

void setColor(vtkUniforms* uniforms, const char* name, const QColor& color)
{
    const float rgb[3] = {static_cast<float>(color.redF()), static_cast<float>(color.greenF()),
                          static_cast<float>(color.blueF())};
    uniforms->SetUniform3f(name, rgb);
}

} // namespace

struct GroundGrid::Private
{
    vtkSmartPointer<vtkRenderer> renderer;
    vtkNew<vtkActor> actor;
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> places;
    vtkNew<vtkPolyData> surface;
    Ruler ruler;
    float height = 0.0F;
    double floor = 0.0;
};

GroundGrid::GroundGrid(vtkRenderer* renderer) : d(std::make_unique<Private>())
{
    d->renderer = renderer;
    vtkbuffers::makeQuad(d->surface, d->points, d->places);
    vtkNew<vtkOpenGLPolyDataMapper> mapper;
    vtkbuffers::connect(mapper, d->surface);
    d->actor->SetMapper(mapper);
    d->actor->PickableOff();
    d->actor->GetProperty()->LightingOff();
    // Anything below one makes VTK draw it after the solid figures, blended.
    d->actor->GetProperty()->SetOpacity(0.99);

    vtkShaderProperty* shader = d->actor->GetShaderProperty();
    shader->AddVertexShaderReplacement("//VTK::PositionVC::Dec", true,
                                       "//VTK::PositionVC::Dec\nout vec2 groundPlace;\n", false);
    shader->AddVertexShaderReplacement(
        "//VTK::PositionVC::Impl", true,
        "//VTK::PositionVC::Impl\n  groundPlace = upIsZ == 1 ? vertexMC.xy : vertexMC.xz;\n", false);
    shader->AddFragmentShaderReplacement("//VTK::PositionVC::Dec", true,
                                         "//VTK::PositionVC::Dec\nin vec2 groundPlace;\n", false);
    shader->AddFragmentShaderReplacement("//VTK::Light::Impl", true, fragmentCode, false);
    renderer->AddActor(d->actor);
    setPixelRatio(1.0);
    follow(Turntable{});
}

GroundGrid::~GroundGrid()
{
    d->renderer->RemoveActor(d->actor);
}

void GroundGrid::setVisible(bool visible)
{
    d->actor->SetVisibility(visible ? 1 : 0);
}

bool GroundGrid::isVisible() const
{
    return d->actor->GetVisibility() != 0;
}

void GroundGrid::setColors(const QColor& lines, const QColor& first, const QColor& second)
{
    vtkUniforms* uniforms = d->actor->GetShaderProperty()->GetFragmentCustomUniforms();
    setColor(uniforms, "lineColor", lines);
    setColor(uniforms, "firstColor", first);
    setColor(uniforms, "secondColor", second);
}

void GroundGrid::setFloor(double brightness)
{
    d->floor = brightness;
}

void GroundGrid::setPixelRatio(double pixels)
{
    d->actor->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformf("linePixels",
                                                                            static_cast<float>(pixels));
}

void GroundGrid::setRuler(const Ruler& ruler)
{
    d->ruler = ruler;
}

void GroundGrid::setHeight(float height)
{
    d->height = height;
}

void GroundGrid::follow(const Turntable& camera)
{
    const bool upIsZ = camera.upAxis == UpAxis::Z;
    const int second = upIsZ ? 1 : 2;
    const int up = upIsZ ? 2 : 1;
    const float radius = std::clamp(camera.distance * 3.0F, d->ruler.of(4.0F), d->ruler.of(400.0F));
    const float center[2] = {camera.target.x(), camera.target[second]};
    static constexpr float corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (vtkIdType i = 0; i < 4; ++i) {
        float place[3];
        place[0] = center[0] + corners[i][0] * radius;
        place[second] = center[1] + corners[i][1] * radius;
        place[up] = d->height;
        d->places->SetTypedTuple(i, place);
    }
    d->places->Modified();
    d->points->Modified();
    d->surface->Modified();
    vtkShaderProperty* shader = d->actor->GetShaderProperty();
    shader->GetVertexCustomUniforms()->SetUniformi("upIsZ", upIsZ ? 1 : 0);
    vtkUniforms* uniforms = shader->GetFragmentCustomUniforms();
    uniforms->SetUniform2f("fadeCenter", center);
    uniforms->SetUniformf("fadeRadius", radius);
    uniforms->SetUniformf("axisLength",
                          std::clamp(camera.distance * 0.5F, d->ruler.of(0.5F), d->ruler.of(4.0F)));
    uniforms->SetUniformf("lineStep", static_cast<float>(d->ruler.coarse()));
    uniforms->SetUniformf("lineParts", static_cast<float>(d->ruler.parts()));
    // Seen from below, a floor would hide the soles.
    const bool isAbove = camera.position()[up] > d->height;
    uniforms->SetUniformf("floorBrightness", isAbove ? static_cast<float>(d->floor) : 0.0F);
}

} // namespace quadrille::widgets
