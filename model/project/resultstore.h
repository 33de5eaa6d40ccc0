// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/resultfile.h"

#include <filesystem>
#include <string>

namespace quadrille {

/// The results of a project on disk: NAME.quadrille.cache/STAGE.h5. Safe from any thread; different stages
/// may be written at once.
class ResultStore
{
public:
    enum class State
    {
        Missing,
        OtherKey, ///< of other inputs, settings or algorithm
        Damaged,
        Fresh,
    };
    struct Entry
    {
        State state = State::Missing;
        Result result; ///< when fresh, or of another key
    };

    explicit ResultStore(std::filesystem::path folder) : m_folder(std::move(folder)) {}

    std::filesystem::path fileOf(const std::string& stage) const;
    /// Reads a result and verifies its checksum.
    /// \throws Error PermissionDenied, ReadFailed.
    Entry load(const std::string& stage, const std::string& key) const;
    /// \throws Error WriteFailed, PermissionDenied.
    void save(const std::string& stage, const std::string& key, const Result& result) const;

private:
    std::filesystem::path m_folder;
};

} // namespace quadrille
