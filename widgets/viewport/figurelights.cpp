// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/figurelights.h"

#include <array>
#include <vtkNew.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

namespace quadrille::widgets {

namespace {

/// The colour alone; light comes after the texture.
constexpr auto colorCode = "  fragOutput0 = vec4(diffuseColor, opacity);\n";

/// The same sum as Lights::shade of the model, with short forms of the sRGB curve; the one back is off by at
/// most 1.5 of 255.
constexpr auto lightCode = R"(
  {
    vec3 own = fragOutput0.rgb;
    vec3 linearColor = own * (own * (own * 0.305306011 + 0.682171111) + 0.012522878);
    vec3 normal = normalVCVSOutput;
    vec3 toEye = normalize(-vertexVC.xyz);
    const vec3 keyColor = vec3(1.06, 1.0, 0.93);
    const vec3 fillColor = vec3(0.82, 0.92, 1.10);
    float above = 0.5 + 0.5 * dot(normal, upLight);
    vec3 around = mix(vec3(0.52, 0.49, 0.47), vec3(1.0, 1.02, 1.06), above) * surfaceAmbient;
    float key = max((dot(normal, keyLight) + 0.25) / 1.25, 0.0);
    float fill = max((dot(normal, fillLight) + 0.4) / 1.4, 0.0);
    vec3 directed = (keyColor * key + fillColor * (0.34 * fill)) * surfaceDiffuse;
    float gloss = max(dot(normal, normalize(keyLight + toEye)), 0.0);
    gloss *= gloss; gloss *= gloss; gloss *= gloss; gloss *= gloss; gloss *= gloss;
    float grazing = 1.0 - max(dot(normal, toEye), 0.0);
    float rim = max((dot(normal, rimLight) + 0.1) / 1.1, 0.0) * grazing * grazing * surfaceRim;
    vec3 light = linearColor * (around + directed + fillColor * rim)
               + vec3(gloss * key * surfaceSpecular + 0.12 * rim);
    vec3 over = max(light - 0.8, 0.0);
    light = min(light, vec3(0.8)) + 0.2 * over / (over + 0.2);
    fragOutput0.rgb = max(1.2345 * sqrt(max(light, 0.0)) - 0.2172 * light - 0.0231, 0.0) + ambientColor;
  }
//VTK::DepthPeeling::Impl
)";

/// Numbers of the model's clayMaterial and texturedMaterial.
struct Material
{
    float diffuse;
    float ambient;
    float specular;
    float rim;
};
constexpr std::array<Material, 2> materials{{{0.86F, 0.36F, 0.10F, 0.30F}, {0.57F, 0.68F, 0.03F, 0.22F}}};

QVector3D upOf(const Turntable& camera)
{
    return camera.upAxis == UpAxis::Y ? QVector3D(0, 1, 0) : QVector3D(0, 0, 1);
}

/// Right, up and back of somebody who stands at the camera.
struct Standing
{
    QVector3D right;
    QVector3D up;
    QVector3D back;

    explicit Standing(const Turntable& camera)
        : right(camera.right()), up(upOf(camera)), back(QVector3D::crossProduct(right, up))
    {
    }
    QVector3D direction(float r, float u, float b) const
    {
        return (r * right + u * up + b * back).normalized();
    }
};

} // namespace

struct FigureLights::Private
{
    std::array<vtkNew<vtkShaderProperty>, materials.size()> shaders;
};

FigureLights::FigureLights() : d(std::make_unique<Private>())
{
    for (std::size_t i = 0; i < materials.size(); ++i) {
        vtkShaderProperty* shader = d->shaders[i];
        shader->AddFragmentShaderReplacement("//VTK::Light::Impl", true, colorCode, false);
        shader->AddFragmentShaderReplacement("//VTK::DepthPeeling::Impl", true, lightCode, false);
        vtkUniforms* uniforms = shader->GetFragmentCustomUniforms();
        uniforms->SetUniformf("surfaceDiffuse", materials[i].diffuse);
        uniforms->SetUniformf("surfaceAmbient", materials[i].ambient);
        uniforms->SetUniformf("surfaceSpecular", materials[i].specular);
        uniforms->SetUniformf("surfaceRim", materials[i].rim);
    }
    follow(Turntable{});
}

FigureLights::~FigureLights() = default;

vtkShaderProperty* FigureLights::shader(Surface surface) const
{
    return d->shaders[static_cast<std::size_t>(surface)];
}

QVector3D FigureLights::keyDirection(const Turntable& camera)
{
    return Standing(camera).direction(-0.62F, 1.0F, 0.62F);
}

void FigureLights::follow(const Turntable& camera)
{
    const Standing standing(camera);
    const auto set = [&](const char* name, const QVector3D& world) {
        const float seen[3] = {QVector3D::dotProduct(world, camera.right()),
                               QVector3D::dotProduct(world, camera.up()),
                               -QVector3D::dotProduct(world, camera.forward())};
        for (const auto& shader : d->shaders)
            shader->GetFragmentCustomUniforms()->SetUniform3f(name, seen);
    };
    set("upLight", standing.up);
    set("keyLight", keyDirection(camera));
    set("fillLight", standing.direction(0.85F, 0.20F, 0.60F));
    set("rimLight", standing.direction(0.45F, 0.55F, -0.90F));
}

} // namespace quadrille::widgets
