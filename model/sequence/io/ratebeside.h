// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace quadrille {

/// The rate of a take whose own file names none, and what says it.
struct RateBeside
{
    enum class Evidence
    {
        OwnMotion,    ///< a BVH of the take's name
        OtherMotions, ///< BVHs of other takes, which agree
        Notes,        ///< a JSON or text file beside that speaks of one rate
        OtherTakes,   ///< takes in the same folder that name their rate, which agree
    };
    double fps = 0;
    Evidence evidence = Evidence::OwnMotion;
    std::filesystem::path file; ///< that says it; one of several

    /// English: "30 fps, as in jog.bvh beside it".
    std::string toString() const;
    bool operator==(const RateBeside&) const = default;
};

/// Looks for the rate of a take in what lies beside it: in the BVH of its name, in those of other takes, in
/// notes, and in takes that name theirs; nothing where these do not say it, or contradict each other.
/// \param source  a file, or the folder or pattern of a series.
/// \param frameCount  of the take: a BVH of its name may have been captured at a multiple of its rate.
std::optional<RateBeside> rateBeside(const std::filesystem::path& source, std::int64_t frameCount);

} // namespace quadrille
