// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/file.h"
#include "model/project/pictureoptions.h"
#include "model/project/project.h"

#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace quadrille::test {

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

inline std::string textOf(const std::filesystem::path& file)
{
    return std::string(readFile(file).text());
}

inline CharacterEntry characterOf(std::string name, std::string mesh)
{
    CharacterEntry character;
    character.name = std::move(name);
    character.mesh = std::move(mesh);
    return character;
}

inline SequenceEntry sequenceOf(std::string name, std::string source)
{
    SequenceEntry sequence;
    sequence.name = std::move(name);
    sequence.source = std::move(source);
    return sequence;
}

inline TextureReference textureOf(TextureReference::Kind kind, std::vector<std::string> paths)
{
    TextureReference texture;
    texture.kind = kind;
    texture.paths = std::move(paths);
    return texture;
}

} // namespace quadrille::test
