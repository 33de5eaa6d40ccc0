// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/fileplace.h"

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// What somebody was asked about and allowed.
struct WritePermissions
{
    bool overwrite = false; ///< files that the program did not write itself may be replaced
    bool outside = false;   ///< files may be put outside of the guarded folder
};

/// A file that stays as it is, and what it is for messages: "sequences/walk".
struct ProtectedFile
{
    std::filesystem::path file;
    std::string what;
};

/// Names of files that differ in one number: "walk_" + 0007 + ".obj".
struct NumberedNames
{
    std::filesystem::path folder;
    std::string before;
    std::string after;

    bool contains(const std::string& name) const;
};

/// Stands between what is written and what is there: inputs are never written over, nothing leaves its
/// folder, and files of somebody else are replaced only with permission. Files are told by what they are, not
/// by their paths, so that links, hard links and other spellings of a name make no difference. All files
/// that the program puts somewhere for its user go through `put`. Safe from any thread; what is set up is set
/// up before.
class WriteGuard
{
public:
    explicit WriteGuard(WritePermissions permissions = {}) : m_permissions(permissions) {}

    void protect(const ProtectedFile& input);
    /// Everything in a folder and below, also what is not there yet.
    void protectFolder(const ProtectedFile& folder);
    /// The files of one folder whose names `belongs` knows, also those that are not there yet: a series
    /// grows.
    void protectNames(const ProtectedFile& folder, std::function<bool(const std::string& name)> belongs);
    /// Inputs that take their time to be found: asked for once, when a file is about to be replaced.
    void protectLater(std::function<std::vector<ProtectedFile>()> find);
    /// Nothing is put outside of this folder without permission.
    void confineTo(const std::filesystem::path& folder);
    /// A file that an earlier run wrote, with the hash of its content: it may be replaced for as long as it
    /// is as it was written.
    void know(const std::filesystem::path& file, const std::string& hash);

    /// Refuses a place where nothing may be written, whatever is there.
    /// \throws Error BadArgument (an input; outside of the folder).
    void checkPlace(const std::filesystem::path& file);
    /// The same for everything that will be put into a folder.
    void checkFolder(const std::filesystem::path& folder) const;
    /// The same for a numbered series: none of its files may be an input, however many it will have.
    void checkSeries(const NumberedNames& series);
    bool isOutside(const std::filesystem::path& file) const;
    /// Whether something is there that the program did not write, or that was changed since.
    /// \throws Error what reading the file throws.
    bool isForeign(const std::filesystem::path& file) const;

    struct Move
    {
        std::filesystem::path from; ///< a finished file
        std::filesystem::path to;   ///< its place; missing folders are made
    };
    /// Moves files to their places, all or none of them. What is there already with the same content stays
    /// what it is and counts as written.
    /// \throws Error BadArgument (an input; outside; a file of somebody else; another content was put there
    /// in this run), PermissionDenied, WriteFailed.
    void put(std::span<const Move> moves);
    /// What was put, with the hashes of the contents.
    std::map<std::filesystem::path, std::string> written() const;

private:
    struct Names
    {
        std::filesystem::path folder;
        std::string what;
        std::function<bool(const std::string&)> belongs;
    };

    void findLateInputs();
    /// What the file is that would be hit; null when there is no such input.
    const std::string* inputAt(const std::filesystem::path& file, const std::filesystem::path& place) const;
    void checkPut(const Move& move, const std::string& hash);

    WritePermissions m_permissions;
    std::map<std::filesystem::path, std::string> m_inputs; ///< by resolved place
    std::map<FileIdentity, std::string> m_inputFiles;
    std::map<std::filesystem::path, std::string> m_folders;
    std::vector<Names> m_names;
    std::function<std::vector<ProtectedFile>()> m_findInputs;
    std::optional<std::filesystem::path> m_root;
    std::map<std::filesystem::path, std::string> m_known;
    std::map<std::filesystem::path, std::string> m_written;
    mutable std::recursive_mutex m_mutex;
};

/// \throws Error BadArgument, always: something is there that the program did not write.
[[noreturn]] void refuseExisting(const std::filesystem::path& file);
/// \throws Error BadArgument, always: an export writes what another writes. \param name of the file or
/// series.
[[noreturn]] void refuseTwice(const std::filesystem::path& file, const std::string& name,
                              const std::string& other);

} // namespace quadrille
