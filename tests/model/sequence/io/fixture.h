// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"
#include "model/sequence/io/registry.h"
#include "tests/model/core/temporaryfolder.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille {

/// A folder of its own for each test, removed afterwards.
class FolderTest : public ::testing::Test
{
protected:
    const std::filesystem::path& folder() const { return m_folder.path(); }
    std::filesystem::path write(const std::filesystem::path& name, std::string_view content) const
    {
        auto path = folder() / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << content;
        return path;
    }
    static std::string read(const std::filesystem::path& path)
    {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    /// Names of everything in a folder, sorted.
    static std::vector<std::string> names(const std::filesystem::path& path)
    {
        std::vector<std::string> found;
        for (const auto& entry : std::filesystem::directory_iterator(path))
            found.push_back(entry.path().filename().string());
        std::sort(found.begin(), found.end());
        return found;
    }

private:
    test::TemporaryFolder m_folder;
};

/// The error that a call throws; fails the test when it throws none.
inline Error errorOf(const std::function<void()>& call)
{
    try {
        call();
    } catch (const Error& error) {
        return error;
    }
    ADD_FAILURE() << "no error was thrown";
    return Error(ErrorCode::BadArgument);
}

inline bool hasIssue(const std::vector<Issue>& issues, Issue::Code code)
{
    return std::any_of(issues.begin(), issues.end(), [code](const Issue& i) { return i.code == code; });
}

inline std::vector<Vec3f> positionsOf(const MeshSequence& sequence, std::int64_t frame = 0)
{
    const auto read = sequence.frame(FrameIndex(frame));
    return {read.positions().begin(), read.positions().end()};
}

/// A value of an error's context; empty when it has none of this name.
inline std::string valueOf(const Error& error, std::string_view name)
{
    for (const auto& [key, value] : error.context().values) {
        if (key == name)
            return value;
    }
    return {};
}

} // namespace quadrille
