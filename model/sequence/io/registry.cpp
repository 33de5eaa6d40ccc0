// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/registry.h"

#include "model/core/error.h"
#include "model/core/file.h"
#include "model/core/message.h"
#include "model/sequence/io/files/refused.h"
#include "model/sequence/io/files/sourcefiles.h"
#include "model/sequence/io/formats.h"

#include <algorithm>
#include <charconv>

namespace quadrille {

namespace {

constexpr std::size_t headBytes = 512;

std::string readHead(const std::filesystem::path& path)
{
    const InputFile file(path);
    std::string head(std::min<std::uint64_t>(file.size(), headBytes), '\0');
    file.read(0, std::as_writable_bytes(std::span(head)));
    return head;
}

bool hasExtension(const FormatInfo& format, const std::string& extension)
{
    return std::find(format.extensions.begin(), format.extensions.end(), extension) !=
           format.extensions.end();
}

std::string toText(double value)
{
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.begin(), text.end(), value).ptr;
    return {text.begin(), end};
}

/// Reads the ends of a sequence, which find most of what can be wrong with a source.
void readEnds(const MeshSequence& sequence)
{
    sequence.frame(FrameIndex(0));
    sequence.frame(FrameIndex(sequence.frameCount() - 1));
}

} // namespace

std::span<const std::unique_ptr<Importer>> importers()
{
    static const std::vector<std::unique_ptr<Importer>> all = makeImporters();
    return all;
}

std::span<const std::unique_ptr<Exporter>> exporters()
{
    static const std::vector<std::unique_ptr<Exporter>> all = makeExporters();
    return all;
}

const Importer& importerFor(const SourceFiles& source)
{
    const auto& file = source.files.front();
    const auto head = readHead(file);
    const auto extension = lowerExtension(file);
    for (const auto& importer : importers()) {
        if (hasExtension(importer->format(), extension))
            return *importer;
    }
    for (const auto& importer : importers()) {
        if (importer->recognises(head))
            return *importer;
    }
    refuseForeignFormat(file, head);
    throw Error(ErrorCode::FormatUnknown, {file, {}, {}});
}

ImportResult openSequences(const std::filesystem::path& path, const ImportOptions& options,
                           const Progress& progress)
{
    progress.report(0);
    const auto source = findSource(path);
    auto result = importerFor(source).open(source, options, progress.part(0, 0.9));
    if (!source.missing.empty()) {
        result.issues.push_back({.code = Issue::Code::NumberingGap,
                                 .context = {path, {}, {{"missing", describeNumbers(source.missing)}}}});
    }
    const bool moves = std::any_of(result.sequences.begin(), result.sequences.end(),
                                   [](const MeshSequence& sequence) { return sequence.frameCount() > 1; });
    if (!result.hasOwnFps && moves) {
        result.issues.push_back({.severity = Issue::Severity::Info,
                                 .code = Issue::Code::FpsAssumed,
                                 .context = {path, {}, {{"fps", toText(options.fps)}}}});
    }
    const auto from = result.coordinates.value_or(options.from.value_or(CoordinateSystem{}));
    for (MeshSequence& sequence : result.sequences) {
        progress.report(0.95);
        readEnds(sequence);
        sequence = transformed(sequence, conversionMatrix(from, options.to));
    }
    progress.report(1);
    return result;
}

const Exporter& exporterFor(const std::filesystem::path& out)
{
    const auto extension = lowerExtension(out);
    for (const auto& exporter : exporters()) {
        if (hasExtension(exporter->format(), extension))
            return *exporter;
    }
    throw Error(ErrorCode::FormatUnknown, {out, {}, {}});
}

void checkOutputName(const FormatInfo& format, const std::filesystem::path& out)
{
    if (format.onePerFrame || out.filename().string().find('#') == std::string::npos)
        return;
    throw Error(
        ErrorCode::BadArgument,
        {out,
         {},
         {{"reason", QUADRILLE_MESSAGE("“{name}” has a place for the number of a frame, but {format} is "
                                       "one file for all frames")},
          {"remedy", QUADRILLE_MESSAGE("Leave the # out of the name.")},
          {"name", out.filename().string()},
          {"format", format.name}}});
}

ExportResult exportSequence(const MeshSequence& sequence, const std::filesystem::path& out,
                            const ExportOptions& options, const Progress& progress)
{
    const Exporter& exporter = exporterFor(out);
    checkOutputName(exporter.format(), out);
    MeshSequence prepared = options.range ? sequence.cutTo(*options.range) : sequence;
    if (options.fps)
        prepared = resampled(prepared, *options.fps);
    prepared = transformed(prepared, conversionMatrix(options.from, options.to));
    return exporter.write(prepared, out, options, progress);
}

} // namespace quadrille
