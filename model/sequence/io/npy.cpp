// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/npy.h"

#include "model/core/message.h"
#include "model/core/npy.h"

#include <algorithm>

namespace quadrille {

namespace {

const FormatInfo& npyFormat()
{
    static const FormatInfo format{
        .id = "npy", .name = "NumPy array", .extensions = {".npy"}, .needsMesh = true};
    return format;
}

[[noreturn]] void refuse(const InputFile& file, const std::string& what, const std::string& remedy)
{
    throw Error(ErrorCode::FormatRefused,
                {file.path(), {}, {{"format", "A NumPy array " + what}, {"remedy", remedy}}});
}

} // namespace

PointCacheLayout readNpyLayout(const InputFile& file)
{
    constexpr std::uint64_t headerAtMost = 64 << 10;
    std::string head(static_cast<std::size_t>(std::min(file.size(), headerAtMost)), '\0');
    file.read(0, std::as_writable_bytes(std::span(head)));
    const NpyHeader header = parseNpyHeader(head, file.path());
    const bool isFloat = header.type.size() == 3 && header.type[1] == 'f';
    if (!isFloat || std::string_view("248").find(header.type[2]) == std::string_view::npos) {
        refuse(file, "of type " + (header.type.empty() ? "record" : header.type),
               QUADRILLE_MESSAGE("Save it as numpy.ascontiguousarray(a, 'float32')."));
    }
    if (header.isFortranOrder && header.shape.size() > 1)
        refuse(file, "in Fortran order",
               QUADRILLE_MESSAGE("Save it as numpy.ascontiguousarray(a, 'float32')."));
    const auto& shape = header.shape;
    if (shape.size() < 2 || shape.size() > 3 || shape.back() != 3) {
        std::string text;
        for (const std::int64_t extent : shape)
            text += (text.empty() ? "" : " × ") + std::to_string(extent);
        refuse(file, "of shape " + (text.empty() ? "()" : text),
               QUADRILLE_MESSAGE("Save it as frames × vertices × 3."));
    }
    return {.frameCount = shape.size() == 3 ? shape[0] : 1,
            .vertexCount = shape[shape.size() - 2],
            .offset = header.size,
            .numberBytes = static_cast<unsigned>(header.type[2] - '0'),
            .isBigEndian = header.type[0] == '>',
            .fps = std::nullopt,
            .issues = {}};
}

std::unique_ptr<Importer> makeNpyImporter()
{
    return makePointCacheImporter(
        {.info = npyFormat(),
         .recognises = [](std::string_view head) { return head.starts_with("\x93NUMPY"); },
         .readLayout = readNpyLayout});
}

std::unique_ptr<Exporter> makeNpyExporter()
{
    return makePointCacheExporter({.info = npyFormat(), .header = [](const MeshSequence& sequence) {
                                       const std::array shape{sequence.frameCount(),
                                                              std::int64_t{sequence.topology->vertexCount()},
                                                              std::int64_t{3}};
                                       return npyHeader("'<f4'", shape);
                                   }});
}

} // namespace quadrille
