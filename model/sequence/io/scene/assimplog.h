// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quadrille {

/// Gathers, while it lives, the errors that Assimp logs in this thread: what it cannot read of an FBX file it
/// leaves out, and says so there only.
class AssimpErrors
{
public:
    AssimpErrors();
    ~AssimpErrors();
    AssimpErrors(const AssimpErrors&) = delete;
    AssimpErrors& operator=(const AssimpErrors&) = delete;

    /// One readable line each.
    const std::vector<std::string>& lines() const { return m_lines; }

private:
    std::vector<std::string> m_lines;
};

/// What Assimp says, cut to one readable line: it quotes whole files.
std::string plainAssimpText(std::string_view text);

} // namespace quadrille
