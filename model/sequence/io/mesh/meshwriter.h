// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/files/copytextures.h"
#include "model/sequence/io/files/format.h"

#include <functional>
#include <memory>
#include <string>

namespace quadrille {

/// A frame that is written as a file of its own.
struct WrittenFrame
{
    std::int64_t number = 0;
    Positions positions;
    std::string stem; ///< of its file, with its number
};

/// What writes the frames of one sequence; safe to call for several frames at a time.
class FrameWriter
{
public:
    virtual ~FrameWriter() = default;
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    /// The content of a frame's file. Further files that it names go into `files`.
    virtual std::string write(const WrittenFrame& frame, StagedFiles& files) const = 0;

protected:
    FrameWriter() = default;
};

/// A format with one mesh per file: DIR/NAME.obj is written as DIR/NAME_0000.obj, DIR/NAME_0001.obj, …,
/// several at a time; all of them or none.
struct MeshWriterFormat
{
    FormatInfo info;
    /// \param stem of the exported files, without numbers.
    std::unique_ptr<FrameWriter> (*start)(const MeshSequence& sequence, const std::string& stem,
                                          CopiedTextures textures, StagedFiles& files) = nullptr;
};
std::unique_ptr<Exporter> makeMeshExporter(MeshWriterFormat format);

} // namespace quadrille
