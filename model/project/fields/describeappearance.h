// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/fields/describebodyparts.h"

namespace quadrille {

template <typename Fields>
void describe(Fields& f, Type<MaskStrokeEntry>)
{
    using E = MaskStrokeEntry;
    f.about("mask_stroke", "A stroke of a brush over a texture.");
    f.field("points", &E::points,
            {.help = "u and v of its points, one after the other, from the lower left corner of the texture.",
             .need = Need::Required,
             .limits = Limits::between(-1, 2, "A point of a stroke lies outside of the texture")});
    f.field("radius", &E::radius,
            {.help = "In widths of the texture.",
             .need = Need::Always,
             .limits = Limits::above(0, "The radius of a stroke must be above 0, and 1 at most")
                           .upTo(1, {"The radius of a stroke must be above 0, and 1 at most"})});
    f.field("erases", &E::erases, {.help = "Takes away what strokes before it have marked."});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<CompletionEntry>)
{
    using E = CompletionEntry;
    f.about("completion", "A captured texture of which a part is not known, to be filled in.");
    f.object("frame", &E::frame, {.need = Need::Required});
    f.as(Role::File, "mask", &E::mask,
         {.help = "A picture of the texture's size, white where the texture is not known."});
    f.list("strokes", &E::strokes, {.help = "Marks more of it, or less, over the mask."});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<AppearanceEntry>)
{
    using E = AppearanceEntry;
    f.about("appearance");
    f.name("name", &E::name);
    f.as(Role::Character, "character", &E::character, {.help = ownCharacterHelp});
    f.reference("sequences", &E::sequences, NamedKind::Sequence,
                {.help = "Whose textures are learned; all that have a texture for each frame.",
                 .loss = Loss::OfOwner});
    f.field(
        "components", &E::components,
        {.help = "Of Eigen textures and Eigen warps together, at most.",
         .need = Need::Always,
         .limits = Limits::between(1, 1000, "The components must be from 1 to 1000", "Write 50, as usual.")});
    f.field("warp_share", &E::warpShare,
            {.help = "How many of the components are Eigen warps.",
             .limits = Limits::between(0, 1, "The share of the warps must be from 0 to 1",
                                       "Write 0.33, as published.")});
    f.word("flow", &E::flow, words<FlowMethod>({{"tv-l1", FlowMethod::TvL1}, {"dis", FlowMethod::Dis}}),
           {.help = "How textures are aligned: by TV-L1, or quickly by dense inverse search."});
    f.object("reference", &E::reference,
             {.help = "The frame that all textures are aligned to; the most central one."});
    f.word(
        "varied", &E::varied,
        words<VariedTextures>({{"learned", VariedTextures::Learned}, {"nearest", VariedTextures::Nearest}}),
        {.help = "What frames of variations take their textures from: their poses, or the captured "
                 "frames that they vary."});
    f.list("completions", &E::completions, {.help = "Textures of which a part is filled in."});
    f.unknown(&E::unknown);
}

} // namespace quadrille
