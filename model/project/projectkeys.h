// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace quadrille::projectkeys {

// The keys of each object of the project file, in the order in which they are written.
inline constexpr std::array<std::string_view, 11> document{
    "format", "version",    "settings",   "characters",  "sequences", "body_parts",
    "graph",  "animations", "variations", "evaluations", "exports"};
inline constexpr std::array<std::string_view, 4> settings{"fps", "up_axis", "unit", "cache_megabytes"};
inline constexpr std::array<std::string_view, 4> character{"name", "mesh", "texture", "notes"};
inline constexpr std::array<std::string_view, 13> sequence{
    "name",        "character", "source", "clip",     "range",        "source_fps", "source_up_axis",
    "source_unit", "texture",   "labels", "contacts", "joint_angles", "notes"};
inline constexpr std::array<std::string_view, 13> graph{
    "character",       "metric", "stretch_weight", "cost",  "cost_scale", "length", "contact_weight",
    "velocity_weight", "slope",  "durations",      "alpha", "smoothing",  "d_max"};
inline constexpr std::array<std::string_view, 13> animation{
    "name",          "character", "start", "constraints", "search", "junctions", "walk",
    "interpolation", "blend",     "post",  "audio",       "camera", "notes"};
inline constexpr std::array<std::string_view, 2> note{"frame", "text"};
inline constexpr std::array<std::string_view, 3> audio{"file", "offset", "gain"};
inline constexpr std::array<std::string_view, 6> cameraKey{"time",    "target",    "distance",
                                                           "azimuth", "elevation", "fov"};
inline constexpr std::array<std::string_view, 5> key{"kind", "sequence", "frame", "time", "tolerance"};
inline constexpr std::array<std::string_view, 6> path{"kind",  "curve",     "points",
                                                      "spans", "obstacles", "clearance"};
inline constexpr std::array<std::string_view, 6> pathSpan{"from",     "to",    "label",
                                                          "sequence", "range", "duration"};
inline constexpr std::array<std::string_view, 3> obstacle{"centre", "radius", "polygon"};
inline constexpr std::array<std::string_view, 7> action{"kind",   "label",    "sequence",   "range",
                                                        "repeat", "duration", "least_share"};
inline constexpr std::array<std::string_view, 3> frameChoice{"label", "sequence", "range"};
inline constexpr std::array<std::string_view, 8> search{"budget", "beta",  "mu",        "global",
                                                        "style",  "dwell", "dead_zone", "steering"};
inline constexpr std::array<std::string_view, 4> junctions{"banned", "locked", "chosen", "walk"};
inline constexpr std::array<std::string_view, 3> walk{"spans", "turn", "at"};
inline constexpr std::array<std::string_view, 7> post{
    "variations", "loop", "contact_correction", "mirror", "symmetry", "repeats", "retime"};
inline constexpr std::array<std::string_view, 2> variedRepeats{"from", "ease"};
inline constexpr std::array<std::string_view, 3> loop{"cut_start", "cut_end", "in_place"};
inline constexpr std::array<std::string_view, 5> contactCorrection{"strength", "ease", "greatest_shift",
                                                                   "greatest_turn", "greatest_lift"};
inline constexpr std::array<std::string_view, 4> retime{"factor", "duration", "curve", "keep_root_speed"};
inline constexpr std::array<std::string_view, 4> bodyParts{"character", "pose", "curves", "parts"};
inline constexpr std::array<std::string_view, 3> partCurve{"name", "vertices", "points"};
inline constexpr std::array<std::string_view, 3> part{"name", "parent", "curves"};
inline constexpr std::array<std::string_view, 14> variation{
    "name",    "character", "sequences",          "reference", "template",
    "cycles",  "blends",    "displacement_share", "learning",  "sampling",
    "samples", "poses",     "contact_correction", "limits"};
inline constexpr std::array<std::string_view, 6> variationLimits{"pose_distance", "skate",    "intersections",
                                                                 "volume_change", "collapse", "sink"};
inline constexpr std::array<std::string_view, 2> training{"sequence", "range"};
inline constexpr std::array<std::string_view, 2> namedFrame{"sequence", "frame"};
inline constexpr std::array<std::string_view, 4> blend{"from", "to", "weights", "across"};
inline constexpr std::array<std::string_view, 3> acrossBlend{"from", "to", "weights"};
inline constexpr std::array<std::string_view, 6> learning{"dimensions", "restarts", "seed",
                                                          "tolerance",  "window",   "iterations"};
inline constexpr std::array<std::string_view, 6> sampling{"leapfrog_steps", "burn_in", "thinning",
                                                          "acceptance",     "spread",  "uncertainty"};
inline constexpr std::array<std::string_view, 7> samples{"of",    "to",   "weight",   "across",
                                                         "count", "seed", "discarded"};
inline constexpr std::array<std::string_view, 3> acrossSamples{"of", "to", "weight"};
inline constexpr std::array<std::string_view, 6> evaluation{"table",  "character", "sequences",
                                                            "alphas", "count",     "seed"};
inline constexpr std::array<std::string_view, 10> exportEntry{
    "name", "what", "path", "format", "range", "fps", "up_axis", "unit", "textures", "picture"};
inline constexpr std::array<std::string_view, 8> picture{"width", "height", "shading",     "background",
                                                         "grid",  "camera", "revolutions", "view"};
inline constexpr std::array<std::string_view, 4> view{"eye", "target", "up", "fov"};
inline constexpr std::array<std::string_view, 2> texture{"per_frame", "per_material"};
inline constexpr std::array<std::string_view, 2> label{"label", "frames"};
inline constexpr std::array<std::string_view, 2> contact{"foot", "frames"};

/// The known word that a misspelt one probably stands for: at most two letters wrong, and fewer than half of
/// them.
std::optional<std::string> closestWord(std::string_view word, std::span<const std::string_view> known);

} // namespace quadrille::projectkeys
