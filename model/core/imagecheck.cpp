// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/imagecheck.h"

#include "model/core/error.h"
#include "model/core/message.h"

#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille {

namespace {

/// 32,768 × 16,384; as RGBA two gigabytes.
constexpr std::uint64_t pixelsAtMost = std::uint64_t{1} << 29;
/// Deflate packs 1032 to one, and a pixel may be a bit; JPEG needs at least a bit for each 8 × 8 block.
constexpr std::uint64_t pixelsPerByteAtMost = 10'000;
/// Of a JPEG file; progressive ones have about ten. Each is a pass over all pixels, however short it is.
constexpr int scansAtMost = 500;

/// Reads numbers of a picture's bytes; what lies behind the end is an error.
class Bytes
{
public:
    Bytes(std::span<const std::byte> bytes, const std::filesystem::path& file) : m_bytes(bytes), m_file(file)
    {
    }

    std::uint64_t size() const { return m_bytes.size(); }
    bool startsWith(std::string_view signature) const
    {
        return std::string_view(reinterpret_cast<const char*>(m_bytes.data()), m_bytes.size())
            .starts_with(signature);
    }
    std::uint64_t number(std::uint64_t offset, unsigned count, bool isBigEndian = true) const
    {
        need(offset + count);
        std::uint64_t value = 0;
        for (unsigned i = 0; i < count; ++i) {
            const unsigned at = isBigEndian ? i : count - 1 - i;
            value = value << 8U | std::to_integer<std::uint64_t>(m_bytes[offset + at]);
        }
        return value;
    }
    /// The next byte of a value.
    /// \throws Error FileTruncated where there is none.
    std::uint64_t find(int value, std::uint64_t from) const
    {
        need(from + 1);
        const void* const found = std::memchr(m_bytes.data() + from, value, size() - from);
        if (!found)
            need(size() + 1);
        return static_cast<std::uint64_t>(static_cast<const std::byte*>(found) - m_bytes.data());
    }
    /// \throws Error FileTruncated unless there are as many bytes.
    void need(std::uint64_t end) const
    {
        if (end > size())
            fail(ErrorCode::FileTruncated, {{"expected", "at least " + std::to_string(end) + " bytes"},
                                            {"found", std::to_string(size())}});
    }
    [[noreturn]] void fail(ErrorCode code, std::vector<std::pair<std::string, std::string>> values) const
    {
        throw Error(code, {m_file, {}, std::move(values)});
    }
    void checkSize(std::uint64_t width, std::uint64_t height) const
    {
        const std::string extent = std::to_string(width) + " × " + std::to_string(height);
        if (width == 0 || height == 0)
            fail(ErrorCode::ImageUnreadable, {});
        if (width > pixelsAtMost || height > pixelsAtMost || width * height > size() * pixelsPerByteAtMost)
            fail(ErrorCode::CountTooLarge, {{"count", extent}, {"what", "pixels"}});
        if (width * height > pixelsAtMost)
            fail(ErrorCode::FormatRefused,
                 {{"format", "A picture of " + extent + " pixels"},
                  {"remedy", QUADRILLE_MESSAGE("Scale it down to 16,384 pixels a side or less.")}});
    }

private:
    std::span<const std::byte> m_bytes;
    const std::filesystem::path& m_file;
};

constexpr std::string_view pngSignature = "\x89PNG\r\n\x1a\n";

/// A chain of chunks from IHDR to IEND.
void checkPng(const Bytes& bytes)
{
    constexpr std::uint64_t header = 0x49484452; // IHDR
    constexpr std::uint64_t end = 0x49454E44;    // IEND
    if (bytes.number(12, 4) != header)
        bytes.fail(ErrorCode::ImageUnreadable, {});
    bytes.checkSize(bytes.number(16, 4), bytes.number(20, 4));
    for (std::uint64_t at = pngSignature.size(); bytes.number(at + 4, 4) != end;)
        at += bytes.number(at, 4) + 12; // length, type, checksum
}

/// Segments up to the scans, then coded data up to the end marker.
void checkJpeg(const Bytes& bytes)
{
    bool hasSize = false;
    int scans = 0;
    for (std::uint64_t at = 2;;) {
        at = bytes.find(0xFF, at); // behind coded data
        const std::uint64_t marker = bytes.number(at + 1, 1);
        if (marker == 0xFF) { // padding
            ++at;
            continue;
        }
        at += 2;
        if (marker == 0xD9)
            break;
        const bool isAlone = marker <= 0x01 || (marker >= 0xD0 && marker <= 0xD8);
        if (isAlone)
            continue;
        if (marker == 0xDA && ++scans > scansAtMost)
            bytes.fail(ErrorCode::ImageUnreadable, {});
        const bool isFrame =
            marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
        if (isFrame && !hasSize) {
            bytes.checkSize(bytes.number(at + 5, 2), bytes.number(at + 3, 2));
            hasSize = true;
        }
        at += bytes.number(at, 2);
    }
    if (!hasSize)
        bytes.fail(ErrorCode::ImageUnreadable, {});
}

/// The first directory, which says the size; the decoder itself refuses strips that are not there.
void checkTiff(const Bytes& bytes, bool isBigEndian)
{
    const auto number = [&](std::uint64_t offset, unsigned count) {
        return bytes.number(offset, count, isBigEndian);
    };
    const std::uint64_t directory = number(4, 4);
    const std::uint64_t entries = number(directory, 2);
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    for (std::uint64_t i = 0; i < entries; ++i) {
        const std::uint64_t entry = directory + 2 + i * 12;
        const std::uint64_t tag = number(entry, 2);
        constexpr std::uint64_t shortType = 3;
        const std::uint64_t value = number(entry + 8, number(entry + 2, 2) == shortType ? 2 : 4);
        if (tag == 256)
            width = value;
        else if (tag == 257)
            height = value;
    }
    bytes.checkSize(width, height);
}

} // namespace

void checkEncodedImage(std::span<const std::byte> encoded, const std::filesystem::path& file)
{
    const Bytes bytes(encoded, file);
    if (bytes.startsWith(pngSignature))
        checkPng(bytes);
    else if (bytes.startsWith("\xFF\xD8\xFF"))
        checkJpeg(bytes);
    else if (bytes.startsWith(std::string_view("II*\0", 4)))
        checkTiff(bytes, false);
    else if (bytes.startsWith(std::string_view("MM\0*", 4)))
        checkTiff(bytes, true);
    else
        bytes.fail(ErrorCode::ImageUnreadable, {});
}

} // namespace quadrille
