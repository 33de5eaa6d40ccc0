// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/file.h"
#include "model/sequence/io/files/format.h"
#include "tests/model/codeof.h"
#include "tests/model/core/temporaryfolder.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace quadrille {

using test::codeOf;
using test::TemporaryFolder;

inline SourceFiles fileSource(const std::filesystem::path& path)
{
    SourceFiles source;
    source.path = path;
    source.files = {path};
    source.stem = path.stem().string();
    return source;
}

inline std::filesystem::path dataDirectory()
{
    return QUADRILLE_DATA_DIR;
}

/// Positions of a PC2 point cache, frames × points.
struct PointCache
{
    std::size_t points = 0;
    std::size_t frames = 0;
    std::vector<Vec3f> positions;
};
inline PointCache readPointCache(const std::filesystem::path& path)
{
    const FileContent content = readFile(path);
    std::int32_t points = 0;
    std::int32_t frames = 0;
    std::memcpy(&points, content.data.get() + 16, 4);
    std::memcpy(&frames, content.data.get() + 28, 4);
    PointCache cache{static_cast<std::size_t>(points), static_cast<std::size_t>(frames), {}};
    cache.positions.resize(cache.points * cache.frames);
    std::memcpy(cache.positions.front().data(), content.data.get() + 32, cache.positions.size() * 12);
    return cache;
}

/// Length of the diagonal of the box around some points.
inline float sizeOf(std::span<const Vec3f> points)
{
    Vec3f low = points.front();
    Vec3f high = points.front();
    for (const Vec3f& p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    return (high - low).norm();
}

} // namespace quadrille
