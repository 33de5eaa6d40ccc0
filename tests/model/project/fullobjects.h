// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

namespace quadrille {

/// An object of the full project, with its keys.
struct FullObject
{
    const char* definition; ///< of the schema
    const char* place;      ///< JSON pointer in fullProject()
    /// What the manual's table of defaults calls it; null where none of its keys has a default.
    const char* entry = nullptr;
    bool hasAllKeys = true; ///< false where some exclude each other
};

inline constexpr FullObject fullObjects[] = {
    {"settings", "/settings", "settings"},
    {"character", "/characters/0"},
    {"sequence", "/sequences/0"},
    {"label", "/sequences/0/labels/0"},
    {"contact", "/sequences/0/contacts/0"},
    {"graph", "/graph/0", "graph"},
    {"evaluation", "/evaluations/0", "evaluations"},
    {"animation", "/animations/0", "animations"},
    {"path", "/animations/0/constraints/0", "path"},
    {"key", "/animations/0/constraints/1"},
    {"search", "/animations/0/search", "search"},
    {"junctions", "/animations/0/junctions"},
    {"walk", "/animations/0/walk", "walk"},
    {"post", "/animations/0/post", "post"},
    {"varied_repeats", "/animations/0/post/variations", "post.variations"},
    {"loop", "/animations/0/post/loop", "post.loop"},
    {"contact_correction", "/animations/0/post/contact_correction", "post.contact_correction"},
    {"audio", "/animations/0/audio", "audio"},
    {"camera_key", "/animations/0/camera/0", "camera"},
    {"note", "/animations/0/notes/0"},
    {"body_parts", "/body_parts/0"},
    {"part_curve", "/body_parts/0/curves/0"},
    {"part", "/body_parts/0/parts/1"},
    {"variation", "/variations/0", "variations"},
    {"training", "/variations/0/sequences/0"},
    {"named_frame", "/variations/0/template", "template"},
    {"blend", "/variations/0/blends/0", "blends"},
    {"across_blend", "/variations/0/blends/0/across", "blends.across"},
    {"learning", "/variations/0/learning", "learning"},
    {"sampling", "/variations/0/sampling", "sampling"},
    {"variation_limits", "/variations/0/limits", "limits"},
    {"samples", "/variations/0/samples/0", "samples"},
    {"across_samples", "/variations/0/samples/0/across", "samples.across"},
    {"motion_space", "/motion_spaces/0", "motion_spaces"},
    {"space_take", "/motion_spaces/0/takes/0", "motion_spaces.takes"},
    {"space_parameter", "/motion_spaces/0/parameters/0", "motion_spaces.parameters"},
    {"appearance", "/appearance/0", "appearance"},
    {"completion", "/appearance/0/completions/0"},
    {"live", "/live/0", "live"},
    {"transfer", "/transfers/0", "transfers"},
    {"projection", "/projections/0", "projections"},
    {"mask_stroke", "/appearance/0/completions/0/strokes/0", "appearance.completions.strokes"},
    {"export", "/exports/0", "exports"},
    {"picture", "/exports/0/picture", "exports.picture"},
    {"view", "/exports/0/picture/view", "exports.picture.view"},
    {"path_span", "/animations/0/constraints/0/spans/0", "path.spans", false},
    {"action", "/animations/0/constraints/2", "action", false},
    {"retime", "/animations/0/post/retime", "post.retime", false},
};

} // namespace quadrille
