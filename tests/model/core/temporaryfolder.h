// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/file.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <unistd.h>

namespace quadrille::test {

inline std::string textOf(const std::filesystem::path& file)
{
    return std::string(readFile(file).text());
}

/// A new empty folder for one test, removed with it.
class TemporaryFolder
{
public:
    TemporaryFolder()
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "quadrille-test-XXXXXX").string();
        m_path = ::mkdtemp(pattern.data());
    }
    ~TemporaryFolder()
    {
        std::error_code error;
        std::filesystem::remove_all(m_path, error);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return m_path; }
    std::filesystem::path operator/(const std::string& name) const { return m_path / name; }
    /// Writes a text file and returns its path.
    std::filesystem::path write(const std::string& name, std::string_view text) const
    {
        writeAtomically(m_path / name, text);
        return m_path / name;
    }

private:
    std::filesystem::path m_path;
};

} // namespace quadrille::test
