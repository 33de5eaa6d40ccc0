// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/pc2.h"

#include "model/core/message.h"

#include <cstring>

namespace quadrille {

namespace {

constexpr std::string_view signature{"POINTCACHE2\0", 12};

struct Pc2Header
{
    char signature[12];
    std::int32_t version;
    std::int32_t points;
    float startFrame;
    float sampleRate;
    std::int32_t samples;
};
static_assert(sizeof(Pc2Header) == 32);

const FormatInfo& pc2Format()
{
    static const FormatInfo format{
        .id = "pc2", .name = "PC2 point cache", .extensions = {".pc2"}, .needsMesh = true};
    return format;
}

std::string pc2HeaderOf(const MeshSequence& sequence)
{
    Pc2Header header{{},   1,    static_cast<std::int32_t>(sequence.topology->vertexCount()),
                     0.0F, 1.0F, static_cast<std::int32_t>(sequence.frameCount())};
    std::memcpy(header.signature, signature.data(), signature.size());
    return {reinterpret_cast<const char*>(&header), sizeof header};
}

} // namespace

PointCacheLayout readPc2Layout(const InputFile& file)
{
    Pc2Header header{};
    file.read(0, std::as_writable_bytes(std::span(&header, 1)));
    const auto fail = [&file](std::int64_t byte, std::string reason) {
        throw Error(ErrorCode::FileSyntax, {file.path(), {.byte = byte}, {{"reason", std::move(reason)}}});
    };
    if (std::string_view(header.signature, signature.size()) != signature)
        fail(0, QUADRILLE_MESSAGE("it does not begin with POINTCACHE2"));
    if (header.version != 1)
        fail(12, "version " + std::to_string(header.version) + " instead of 1");
    PointCacheLayout layout{.frameCount = header.samples,
                            .vertexCount = header.points,
                            .offset = sizeof header,
                            .fps = std::nullopt,
                            .issues = {}};
    if (header.sampleRate >= 10 && header.sampleRate <= 1000)
        layout.fps = header.sampleRate;
    return layout;
}

std::unique_ptr<Importer> makePc2Importer()
{
    return makePointCacheImporter(
        {.info = pc2Format(),
         .recognises = [](std::string_view head) { return head.starts_with(signature); },
         .readLayout = readPc2Layout});
}

std::unique_ptr<Exporter> makePc2Exporter()
{
    return makePointCacheExporter({.info = pc2Format(), .header = pc2HeaderOf});
}

} // namespace quadrille
