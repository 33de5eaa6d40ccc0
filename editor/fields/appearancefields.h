// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldform.h"
#include "model/project/document/appearanceentry.h"

#include <QCoreApplication>

namespace quadrille {

struct AppearanceTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::AppearanceFields)
};

/// Object names of the fields of a model of appearance.
struct AppearanceNames
{
    const char* components;
    const char* warps;
    const char* flow;
    const char* varied;
};

/// How large a model of appearance is, and how it is learned and used.
template <typename Form>
void addAppearanceFields(FieldForm<AppearanceEntry, Form>& fields, const AppearanceNames& names)
{
    constexpr double hundredth = 0.01;
    fields.addNumber(
        {names.components, [] { return AppearanceTexts::tr("Components"); },
         [] {
             return AppearanceTexts::tr("Of Eigen textures and Eigen warps together, at most; 1 to 1000");
         }},
        &AppearanceEntry::components, {.path = "appearance.components", .step = 5, .decimals = 0});
    fields.addNumber(
        {names.warps, [] { return AppearanceTexts::tr("Warps"); },
         [] {
             return AppearanceTexts::tr("How many of the components are Eigen warps, which align textures");
         }},
        &AppearanceEntry::warpShare,
        {.path = "appearance.warp_share", .scale = hundredth, .step = 5, .decimals = 0, .unit = [] {
             return AppearanceTexts::tr(" %", "percent");
         }});
    fields.addChoice(
        {names.flow, [] { return AppearanceTexts::tr("Alignment"); },
         [] { return AppearanceTexts::tr("How the way of each texel is found from texture to texture"); }},
        &AppearanceEntry::flow,
        {[] { return AppearanceTexts::tr("TV-L1"); },
         [] { return AppearanceTexts::tr("Dense inverse search, quick"); }});
    fields.addChoice({names.varied, [] { return AppearanceTexts::tr("Variations"); },
                      [] {
                          return AppearanceTexts::tr(
                              "What frames of variations take their textures from: their poses, as the model "
                              "learned to vary with them, or the captured frames that they vary");
                      }},
                     &AppearanceEntry::varied,
                     {[] { return AppearanceTexts::tr("Learned from poses"); },
                      [] { return AppearanceTexts::tr("Of captured frames"); }});
}

} // namespace quadrille
