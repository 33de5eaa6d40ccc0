// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/smoothline.h"

#include <algorithm>

namespace quadrille::widgets {

namespace {

constexpr int rounds = 4;

/// The place so many steps from another, on a line that is closed or ends.
const QVector3D& at(const std::vector<QVector3D>& line, std::size_t index, std::ptrdiff_t step, bool isClosed)
{
    const auto count = static_cast<std::ptrdiff_t>(line.size());
    const std::ptrdiff_t place = static_cast<std::ptrdiff_t>(index) + step;
    return line[static_cast<std::size_t>(isClosed ? (place + count) % count
                                                  : std::clamp<std::ptrdiff_t>(place, 0, count - 1))];
}

} // namespace

std::vector<QVector3D> withoutZigzag(std::vector<QVector3D> line, const std::vector<std::size_t>& fixed,
                                     bool isClosed)
{
    for (int round = 0; round < rounds; ++round) {
        const std::vector<QVector3D> before = line;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const bool isEnd = !isClosed && (i == 0 || i + 1 == line.size());
            if (!isEnd && !std::binary_search(fixed.begin(), fixed.end(), i))
                line[i] =
                    (at(before, i, -1, isClosed) + 2.0F * before[i] + at(before, i, 1, isClosed)) / 4.0F;
        }
    }
    return line;
}

QVector3D smoothPlace(const std::vector<QVector3D>& line, std::size_t index, float share, bool isClosed)
{
    const QVector3D& a = at(line, index, -1, isClosed);
    const QVector3D& b = line[index];
    const QVector3D& c = at(line, index, 1, isClosed);
    const QVector3D& d = at(line, index, 2, isClosed);
    const float t = share;
    return 0.5F * (2.0F * b + (c - a) * t + (2.0F * a - 5.0F * b + 4.0F * c - d) * (t * t) +
                   (3.0F * (b - c) + d - a) * (t * t * t));
}

} // namespace quadrille::widgets
