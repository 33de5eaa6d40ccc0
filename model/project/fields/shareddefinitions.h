// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

namespace quadrille {

/// Definitions of the schema that several entries use, and of what has a form of its own.
inline constexpr auto sharedDefinitions = R"json({
  "name": {
    "description": "Unique in its section; a part of targets such as “sequences/NAME”.",
    "type": "string", "minLength": 1, "pattern": "^[^/\\\\]+$"
  },
  "up_axis": {
    "description": "The axis that points up, in a right-handed system.",
    "enum": ["x", "y", "z", "X", "Y", "Z"]
  },
  "unit": {
    "description": "A unit of length by name, or the metres that one unit has.",
    "anyOf": [{ "enum": ["m", "cm", "mm", "km", "in", "ft"] }, { "type": "number", "exclusiveMinimum": 0 }]
  },
  "range": {
    "description": "[first, last] frame, zero-based, both included.",
    "type": "array", "items": { "type": "integer", "minimum": 0 }, "minItems": 2, "maxItems": 2
  },
  "texture": {
    "description": "One picture file; a folder or pattern with one picture per frame of the source; or one file per material.",
    "anyOf": [{ "type": "string" }, { "$ref": "#/definitions/texture_files" }]
  },
  "texture_files": {
    "type": "object",
    "properties": {
      "per_frame": { "type": "string" },
      "per_material": { "type": "array", "items": { "type": "string" } }
    },
    "anyOf": [{ "required": ["per_frame"] }, { "required": ["per_material"] }]
  },
  "note": {
    "description": "What somebody wrote about a frame, of the sequence or of the clip as it is shown.",
    "type": "object",
    "required": ["frame", "text"],
    "properties": {
      "frame": { "description": "Zero-based.", "type": "integer", "minimum": 0 },
      "text": { "type": "string", "minLength": 1 }
    }
  },
  "point": { "type": "array", "items": { "type": "number" }, "minItems": 3, "maxItems": 3 },
  "coordinate": {
    "description": "In the project's unit; places lie within 10 km of the origin, 10,000,000 of the unit at most.",
    "type": "number", "minimum": -10000000, "maximum": 10000000
  },
  "ground_point": {
    "description": "The two coordinates that are not up, in the order of the axes; in the project's unit, within 10 km.",
    "type": "array", "items": { "$ref": "#/definitions/coordinate" }, "minItems": 2, "maxItems": 2
  },
  "path_point": {
    "description": "Two coordinates on the ground, or three in space; in the project's unit, within 10 km.",
    "type": "array", "items": { "$ref": "#/definitions/coordinate" }, "minItems": 2, "maxItems": 3
  },
  "seconds": { "description": "Seconds.", "type": "number", "exclusiveMinimum": 0, "maximum": 3600 },
  "junction": {
    "description": "A transition: [[sequence, frame], [sequence, frame]].",
    "type": "array",
    "items": {
      "type": "array",
      "items": [{ "type": "string" }, { "type": "integer" }],
      "minItems": 2, "maxItems": 2
    },
    "minItems": 2, "maxItems": 2
  }
})json";

} // namespace quadrille
