// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/mediacache.h"
#include "model/core/units.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace quadrille {

/// Where a sequence's frames come from: memory, a point cache on disk, a series of files, a conversion of
/// another source. All calls are safe from any thread.
class FrameSource
{
public:
    virtual ~FrameSource() = default;
    FrameSource(const FrameSource&) = delete;
    FrameSource& operator=(const FrameSource&) = delete;

    virtual std::int64_t frameCount() const = 0;
    virtual std::uint32_t vertexCount() const = 0;
    /// Positions that are in memory anyway; most sources have none.
    virtual std::optional<Positions> view(FrameIndex) const { return std::nullopt; }
    /// Reads one frame.
    /// \param out vertexCount() positions.
    /// \pre 0 ≤ frame < frameCount().
    /// \throws Error what reading its file can throw, with file and frame.
    virtual void read(FrameIndex frame, MutablePositions out) const = 0;
    /// The file that holds a frame, for messages; empty when there is none.
    virtual std::filesystem::path fileOf(FrameIndex) const { return {}; }

    MediaId id() const { return m_id; }

protected:
    FrameSource() = default;

private:
    MediaId m_id;
};

/// Frames in memory, one after the other.
class MemoryFrames : public FrameSource
{
public:
    /// \param positions frames × vertices.
    /// \pre positions.size() is a multiple of vertexCount.
    MemoryFrames(std::vector<Vec3f> positions, std::uint32_t vertexCount);

    std::int64_t frameCount() const override;
    std::uint32_t vertexCount() const override { return m_vertexCount; }
    std::optional<Positions> view(FrameIndex frame) const override;
    void read(FrameIndex frame, MutablePositions out) const override;

private:
    std::vector<Vec3f> m_positions;
    std::uint32_t m_vertexCount;
};

} // namespace quadrille
