// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace quadrille {

/// Writes the fuzzer's bytes to a file of this process, since importers read files.
inline std::filesystem::path fuzzFile(const std::uint8_t* data, std::size_t size,
                                      const std::string& extension)
{
    static const auto path =
        std::filesystem::temp_directory_path() / ("quadrille-fuzz-" + std::to_string(::getpid()) + extension);
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    return path;
}

} // namespace quadrille
