// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/fileseal.h"

#include "model/core/contenthash.h"
#include "model/core/error.h"
#include "model/core/file.h"
#include "model/core/message.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fstream>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view sealName = "quadrille-appearance ";

/// The seal of a file as it is now.
std::string sealOf(const InputFile& file)
{
    ContentHasher hasher;
    std::vector<std::byte> bytes(std::size_t{1} << 20);
    for (std::uint64_t at = sealSize; at < file.size(); at += bytes.size()) {
        const auto some = std::span(bytes).first(std::min<std::uint64_t>(bytes.size(), file.size() - at));
        file.read(at, some);
        hasher.addBytes(some);
    }
    std::string seal = std::string(sealName) + std::to_string(file.size()) + ' ' + hasher.hex() + '\n';
    seal.resize(sealSize);
    return seal;
}

[[noreturn]] void throwUnsealed(const fs::path& file, const char* reason)
{
    throw Error(ErrorCode::FileSyntax, {file, {}, {{"reason", reason}}});
}

} // namespace

void sealFile(const fs::path& path)
{
    const std::string seal = sealOf(InputFile(path));
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    file.write(seal.data(), static_cast<std::streamsize>(seal.size()));
    file.close();
    if (!file)
        throwSystemError(path, errno, ErrorCode::WriteFailed);
}

void checkSeal(const fs::path& path)
{
    const InputFile file(path);
    std::string seal(std::min(sealSize, file.size()), '\0');
    file.read(0, std::as_writable_bytes(std::span(seal)));
    if (!seal.starts_with(sealName))
        throwUnsealed(path, QUADRILLE_MESSAGE("it is no model of appearance"));
    std::uint64_t size = 0;
    const char* end = seal.data() + seal.size();
    if (std::from_chars(seal.data() + sealName.size(), end, size).ec == std::errc() && size > file.size())
        throw Error(ErrorCode::FileTruncated, {path,
                                               {},
                                               {{"expected", std::to_string(size) + " bytes"},
                                                {"found", std::to_string(file.size())}}});
    if (seal != sealOf(file))
        throwUnsealed(path, QUADRILLE_MESSAGE("a part of the file is damaged"));
}

} // namespace quadrille
