// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/figurelanes.h"

namespace quadrille::widgets {

namespace {

constexpr float gap = 0.5F; // metres between neighbours
/// Lanes one behind the other hide each other from the front: only for takes that need far less room so, by
/// this many times and by this many metres for each of them.
constexpr float farLess = 2.0F;
constexpr float saving = 3.0F;

float roomAlong(std::span<const LaneBox> boxes, int axis, float metre)
{
    float room = 0.0F;
    for (const LaneBox& box : boxes)
        room += box.upper[axis] - box.lower[axis] + gap * metre;
    return room;
}

} // namespace

std::vector<QVector3D> laneOffsets(std::span<const LaneBox> boxes, std::size_t anchor, UpAxis up, float metre)
{
    std::vector<QVector3D> offsets(boxes.size());
    if (boxes.size() < 2)
        return offsets;
    const int other = up == UpAxis::Y ? 2 : 1;
    const bool isFirst = roomAlong(boxes, 0, metre) <= farLess * roomAlong(boxes, other, metre) +
                                                           saving * metre * static_cast<float>(boxes.size());
    const int across = isFirst ? 0 : other;
    const int along = isFirst ? other : 0;
    const LaneBox& fixed = boxes[anchor];
    float place = 0.0F;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const LaneBox& box = boxes[i];
        offsets[i][across] = place - box.lower[across];
        offsets[i][along] =
            (fixed.lower[along] + fixed.upper[along] - box.lower[along] - box.upper[along]) / 2.0F;
        place += box.upper[across] - box.lower[across] + gap * metre;
    }
    const float shift = offsets[anchor][across];
    for (QVector3D& offset : offsets)
        offset[across] -= shift;
    return offsets;
}

} // namespace quadrille::widgets
