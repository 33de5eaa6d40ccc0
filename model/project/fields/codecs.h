// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/json/objectreader.h"

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace quadrille {

// Members of the file that have a form of their own, by the type of what they stand for: an entry as a whole
// where several members of it belong together. For each there are
//   readValue    takes it out of an object; what is wrong is reported, and left as it is
//   writeValue   adds it to an object, unless it says nothing new
//   valueSchema  adds it to the properties of a JSON schema
//   valueKeys    the keys that it has; the given one unless it says otherwise

/// What the form of some members depends on besides them.
struct FieldContext
{
    const CoordinateSystem& axes; ///< the project's
};

/// Names the type of a value.
template <typename Value>
struct Type
{
};

template <typename Value>
std::vector<std::string> valueKeys(const std::string& key, Type<Value>)
{
    return {key};
}

// An up axis and a unit; the key is what stands before “up_axis” and “unit”.
std::vector<std::string> valueKeys(const std::string& key, Type<CoordinateSystem>);
void readValue(const ObjectReader& reader, const std::string& key, CoordinateSystem& axes,
               const FieldContext&);
void writeValue(Json& json, const std::string& key, const CoordinateSystem& axes, const FieldContext&);
void valueSchema(Json& properties, const std::string& key, Type<CoordinateSystem>);
std::vector<std::string> valueKeys(const std::string& key, Type<std::optional<CoordinateSystem>>);
void readValue(const ObjectReader& reader, const std::string& key, std::optional<CoordinateSystem>& axes,
               const FieldContext& context);
void writeValue(Json& json, const std::string& key, const std::optional<CoordinateSystem>& axes,
                const FieldContext& context);
void valueSchema(Json& properties, const std::string& key, Type<std::optional<CoordinateSystem>>);

// "a.png", {"per_frame": "folder"} or {"per_material": ["a.png", …]}.
void readValue(const ObjectReader& reader, const std::string& key, TextureReference& texture,
               const FieldContext&);
void writeValue(Json& json, const std::string& key, const TextureReference& texture, const FieldContext&);
void valueSchema(Json& properties, const std::string& key, Type<TextureReference>);

// Notes about frames, which entries carry along in what is unknown, see framenote.h.
void readValue(const ObjectReader& reader, const std::string& key, UnknownKeys& entry, const FieldContext&);
void writeValue(Json& json, const std::string& key, const UnknownKeys& entry, const FieldContext&);
void valueSchema(Json& properties, const std::string& key, Type<UnknownKeys>);

// [shortest, longest] window of a transition.
using Durations = std::optional<std::pair<double, double>>;
void readValue(const ObjectReader& reader, const std::string& key, Durations& durations, const FieldContext&);
void writeValue(Json& json, const std::string& key, const Durations& durations, const FieldContext&);
void valueSchema(Json& properties, const std::string& key, Type<Durations>);

// A point in space, which must be there.
void readValue(const ObjectReader& reader, const std::string& key, Vec3d& point, const FieldContext&);
void writeValue(Json& json, const std::string& key, const Vec3d& point, const FieldContext&);
void valueSchema(Json& properties, const std::string& key, Type<Vec3d>);

// The two coordinates of a point on the ground that are not up.
void readValue(const ObjectReader& reader, const std::string& key, std::optional<Vec2d>& point,
               const FieldContext&);
void writeValue(Json& json, const std::string& key, const std::optional<Vec2d>& point, const FieldContext&);
void valueSchema(Json& properties, const std::string& key, Type<std::optional<Vec2d>>);

// The points of a path, of two coordinates on the ground or three in space.
void readValue(const ObjectReader& reader, const std::string& key, PathEntry& path,
               const FieldContext& context);
void writeValue(Json& json, const std::string& key, const PathEntry& path, const FieldContext& context);
void valueSchema(Json& properties, const std::string& key, Type<PathEntry>);

// Centre and radius of a disc, or a polygon.
std::vector<std::string> valueKeys(const std::string& key, Type<ObstacleEntry>);
void readValue(const ObjectReader& reader, const std::string& key, ObstacleEntry& obstacle,
               const FieldContext&);
void writeValue(Json& json, const std::string& key, const ObstacleEntry& obstacle, const FieldContext&);
void valueSchema(Json& properties, const std::string& key, Type<ObstacleEntry>);

// A factor, a duration, or a curve of times.
std::vector<std::string> valueKeys(const std::string& key, Type<RetimeSettings>);
void readValue(const ObjectReader& reader, const std::string& key, RetimeSettings& retime,
               const FieldContext&);
void writeValue(Json& json, const std::string& key, const RetimeSettings& retime, const FieldContext&);
void valueSchema(Json& properties, const std::string& key, Type<RetimeSettings>);

// The weight of the second of two takes, written where there is a second.
void readValue(const ObjectReader& reader, const std::string& key, SamplesEntry& samples,
               const FieldContext&);
void writeValue(Json& json, const std::string& key, const SamplesEntry& samples, const FieldContext&);
void valueSchema(Json& properties, const std::string& key, Type<SamplesEntry>);

// [least, greatest] share of proposals that are accepted.
void readValue(const ObjectReader& reader, const std::string& key, HmcSettings& chain, const FieldContext&);
void writeValue(Json& json, const std::string& key, const HmcSettings& chain, const FieldContext&);
void valueSchema(Json& properties, const std::string& key, Type<HmcSettings>);

// [[tick, space, 1 where latency counts more, parameters…], …]
void readValue(const ObjectReader& reader, const std::string& key, std::vector<LiveChange>& changes,
               const FieldContext&);
void writeValue(Json& json, const std::string& key, const std::vector<LiveChange>& changes,
                const FieldContext&);
void valueSchema(Json& properties, const std::string& key, Type<std::vector<LiveChange>>);

// [[triangle of the template, triangle of the target], …]
void readValue(const ObjectReader& reader, const std::string& key, std::vector<TrianglePair>& pairs,
               const FieldContext&);
void writeValue(Json& json, const std::string& key, const std::vector<TrianglePair>& pairs,
                const FieldContext&);
void valueSchema(Json& properties, const std::string& key, Type<std::vector<TrianglePair>>);

// The spread of trajectories, or that they are the model's.
void readValue(const ObjectReader& reader, const std::string& key, TrajectoryLimits& extent,
               const FieldContext&);
void writeValue(Json& json, const std::string& key, const TrajectoryLimits& extent, const FieldContext&);
void valueSchema(Json& properties, const std::string& key, Type<TrajectoryLimits>);

// The greatest pose distance of a variation, or that of the takes.
void readValue(const ObjectReader& reader, const std::string& key, VariationLimits& limits,
               const FieldContext&);
void writeValue(Json& json, const std::string& key, const VariationLimits& limits, const FieldContext&);
void valueSchema(Json& properties, const std::string& key, Type<VariationLimits>);

// How an exported picture looks, which stays as it stands in the file; see pictureoptions.h.
void readValue(const ObjectReader& reader, const std::string& key, ExportEntry& entry, const FieldContext&);
void writeValue(Json& json, const std::string& key, const ExportEntry& entry, const FieldContext&);
void valueSchema(Json& properties, const std::string& key, Type<ExportEntry>);

} // namespace quadrille
