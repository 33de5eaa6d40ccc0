// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/mdd.h"

#include <bit>
#include <cmath>
#include <cstring>

namespace quadrille {

namespace {

const FormatInfo& mddFormat()
{
    static const FormatInfo format{
        .id = "mdd", .name = "MDD point cache", .extensions = {".mdd"}, .needsMesh = true};
    return format;
}

std::uint32_t fromBigEndian(std::uint32_t bits)
{
    return __builtin_bswap32(bits);
}

float floatAt(const InputFile& file, std::uint64_t offset)
{
    std::uint32_t bits = 0;
    file.read(offset, std::as_writable_bytes(std::span(&bits, 1)));
    return std::bit_cast<float>(fromBigEndian(bits));
}

void appendBigEndian(std::string& text, std::uint32_t bits)
{
    const std::uint32_t swapped = fromBigEndian(bits);
    std::array<char, sizeof swapped> bytes;
    std::memcpy(bytes.data(), &swapped, bytes.size());
    text.append(bytes.data(), bytes.size());
}

std::string mddHeaderOf(const MeshSequence& sequence)
{
    std::string header;
    appendBigEndian(header, static_cast<std::uint32_t>(sequence.frameCount()));
    appendBigEndian(header, sequence.topology->vertexCount());
    for (std::int64_t frame = 0; frame < sequence.frameCount(); ++frame)
        appendBigEndian(header, std::bit_cast<std::uint32_t>(
                                    static_cast<float>(static_cast<double>(frame) / sequence.fps)));
    return header;
}

} // namespace

PointCacheLayout readMddLayout(const InputFile& file)
{
    std::array<std::uint32_t, 2> counts{};
    file.read(0, std::as_writable_bytes(std::span(counts)));
    PointCacheLayout layout{.frameCount = static_cast<std::int32_t>(fromBigEndian(counts[0])),
                            .vertexCount = static_cast<std::int32_t>(fromBigEndian(counts[1])),
                            .offset = sizeof counts,
                            .isBigEndian = true,
                            .fps = std::nullopt,
                            .issues = {}};
    if (layout.frameCount > 0)
        layout.offset += static_cast<std::uint64_t>(layout.frameCount) * sizeof(float);
    if (layout.frameCount < 2 || layout.offset > file.size())
        return layout;
    const double first = floatAt(file, sizeof counts);
    const double last = floatAt(file, layout.offset - sizeof(float));
    const double rate = static_cast<double>(layout.frameCount - 1) / (last - first);
    // Times in float round the rate; 29.97 and its like stay.
    if (rate >= 10 && rate <= 1000)
        layout.fps = std::round(rate * 1000) / 1000;
    return layout;
}

std::unique_ptr<Importer> makeMddImporter()
{
    return makePointCacheImporter({.info = mddFormat(),
                                   .recognises = [](std::string_view) { return false; }, // has no signature
                                   .readLayout = readMddLayout});
}

std::unique_ptr<Exporter> makeMddExporter()
{
    return makePointCacheExporter({.info = mddFormat(), .header = mddHeaderOf, .isBigEndian = true});
}

} // namespace quadrille
