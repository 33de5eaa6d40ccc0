// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/bakedplayer.h"

#include "model/core/contenthash.h"
#include "model/core/file.h"
#include "model/live/bakedparts.h"

#include <array>
#include <cerrno>
#include <fstream>

namespace quadrille {

namespace {

constexpr std::string_view magic = "QUADPLAY";
constexpr std::uint32_t bakedVersion = 2;
constexpr std::size_t hashDigits = 32;

/// What stands before the data.
struct Head
{
    std::uint32_t version = bakedVersion;
    std::uint64_t size = 0; ///< of the data
    std::array<char, hashDigits> hash{};

    static constexpr std::size_t bytes = magic.size() + sizeof version + sizeof size + hashDigits;
};

std::string hashOf(std::span<const std::byte> data)
{
    ContentHasher hasher;
    hasher.addBytes(data);
    return hasher.hex();
}

class OutputFile
{
public:
    explicit OutputFile(const std::filesystem::path& file) : m_path(file), m_out(file, std::ios::binary)
    {
        check();
    }
    void write(const void* data, std::size_t size)
    {
        m_out.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
        check();
    }
    void close()
    {
        m_out.close();
        check();
    }

private:
    void check() const
    {
        if (!m_out)
            throwSystemError(m_path, errno, ErrorCode::WriteFailed);
    }

    std::filesystem::path m_path;
    std::ofstream m_out;
};

[[noreturn]] void refuseFile(const std::filesystem::path& file, std::int64_t byte, const std::string& reason)
{
    throw Error(ErrorCode::FileSyntax, {file, {.byte = byte}, {{"reason", reason}}});
}

Head headOf(const InputFile& input)
{
    if (input.size() < Head::bytes)
        refuseFile(input.path(), 0, "it is too short for a player");
    std::array<std::byte, Head::bytes> raw{};
    input.read(0, raw);
    if (std::memcmp(raw.data(), magic.data(), magic.size()) != 0)
        refuseFile(input.path(), 0, "it does not begin as a player does");
    Head head;
    const std::byte* at = raw.data() + magic.size();
    std::memcpy(&head.version, at, sizeof head.version);
    at += sizeof head.version;
    std::memcpy(&head.size, at, sizeof head.size);
    std::memcpy(head.hash.data(), at + sizeof head.size, hashDigits);
    if (head.version != bakedVersion)
        refuseFile(input.path(), magic.size(),
                   "it is of version " + std::to_string(head.version) + ", and only version " +
                       std::to_string(bakedVersion) + " is known here");
    if (head.size > input.size() - Head::bytes)
        throw Error(ErrorCode::FileTruncated, {input.path(),
                                               {},
                                               {{"expected", std::to_string(head.size + Head::bytes)},
                                                {"found", std::to_string(input.size())}}});
    return head;
}

/// Where in a file the pictures are, one after the other, each after its size.
struct BakedPicture
{
    std::uint64_t begin = 0;
    std::uint64_t size = 0;
};

std::vector<BakedPicture> picturesIn(const InputFile& input, std::uint64_t begin, std::size_t count)
{
    if (count > (input.size() - begin) / sizeof(std::uint64_t))
        refuseFile(input.path(), static_cast<std::int64_t>(begin),
                   "more pictures are promised than there are");
    std::vector<BakedPicture> pictures(count);
    for (BakedPicture& picture : pictures) {
        input.read(begin, std::as_writable_bytes(std::span(&picture.size, 1)));
        picture.begin = begin + sizeof picture.size;
        if (picture.size > input.size() - picture.begin)
            refuseFile(input.path(), static_cast<std::int64_t>(begin), "a picture ends behind the file");
        begin = picture.begin + picture.size;
    }
    return pictures;
}

} // namespace

void writeBakedPlayer(const BakedPlayer& player, const std::filesystem::path& file, const Progress& progress)
{
    BakedWriter data;
    bake(data, player);
    const Head head{.size = data.bytes().size()};
    const std::string hash = hashOf(std::as_bytes(std::span(data.bytes())));
    OutputFile out(file);
    out.write(magic.data(), magic.size());
    out.write(&head.version, sizeof head.version);
    out.write(&head.size, sizeof head.size);
    out.write(hash.data(), hashDigits);
    out.write(data.bytes().data(), data.bytes().size());
    for (std::size_t i = 0; i < player.pictureCount; ++i) {
        progress.report(static_cast<double>(i) / static_cast<double>(player.pictureCount));
        const PictureBytes picture = player.picture(i);
        const std::uint64_t size = picture.size();
        out.write(&size, sizeof size);
        out.write(picture.data(), picture.size());
    }
    out.close();
}

BakedPlayer readBakedPlayer(const std::filesystem::path& file)
{
    const auto input = std::make_shared<const InputFile>(file);
    const Head head = headOf(*input);
    std::vector<std::byte> data(head.size);
    input->read(Head::bytes, data);
    if (hashOf(data) != std::string_view(head.hash.data(), hashDigits))
        refuseFile(file, Head::bytes, "the data are not those that were written");
    BakedPlayer player;
    BakedReader reader(data, file, Head::bytes);
    bake(reader, player);
    player.picture = [input, pictures = picturesIn(*input, Head::bytes + head.size, player.pictureCount)](
                         std::size_t picture) {
        PictureBytes bytes(pictures[picture].size);
        input->read(pictures[picture].begin, bytes);
        return bytes;
    };
    return player;
}

} // namespace quadrille
