// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/mesh/meshwriter.h"

#include "model/core/file.h"
#include "model/core/seriesname.h"

#include <atomic>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

class MeshExporter : public Exporter
{
public:
    explicit MeshExporter(MeshWriterFormat format) : m_format(std::move(format)) {}
    const FormatInfo& format() const override { return m_format.info; }
    ExportResult write(const MeshSequence& sequence, const std::filesystem::path& out,
                       const ExportOptions& options, const Progress& progress) const override
    {
        StagedFiles files(out.parent_path(), options.guard);
        const std::string stem = seriesStem(out);
        CopiedTextures textures;
        if (options.textures)
            textures = copyTextures(sequence, stem, files, progress.part(0, 0.2));
        const auto writer = m_format.start(sequence, stem, std::move(textures), files);
        const std::int64_t frames = sequence.frameCount();
        const Progress writing = progress.part(0.2, 1);
        std::atomic<std::int64_t> done{0};
        tbb::parallel_for(std::int64_t{0}, frames, [&](std::int64_t f) {
            writing.report(done++, frames);
            const std::string name = numberedName(out, f, frames);
            const Frame frame = sequence.frame(FrameIndex(f));
            const std::string content =
                writer->write({f, frame.positions(), std::filesystem::path(name).stem().string()}, files);
            writeAtomically(files.add(name), content);
        });
        progress.report(1);
        return {files.commit(), {}};
    }

private:
    MeshWriterFormat m_format;
};

} // namespace

std::unique_ptr<Exporter> makeMeshExporter(MeshWriterFormat format)
{
    return std::make_unique<MeshExporter>(std::move(format));
}

} // namespace quadrille
