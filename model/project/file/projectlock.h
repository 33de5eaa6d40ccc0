// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace quadrille {

/// Who works on a project, as a lock file says.
struct LockHolder
{
    std::string id; ///< of the lock, unlike any other
    std::string program;
    std::string user;
    std::string host;
    std::int64_t process = 0;
    std::string processStart; ///< tells two processes of one number apart; empty where it is not known
    std::chrono::system_clock::time_point since;
    /// When it last said that it is still there; programs do about twice a minute.
    std::chrono::system_clock::time_point seen;

    /// It ran on this machine and runs no more.
    bool isGone() const;
    /// "ada@studio, process 4711"
    std::string toString() const;
};

/// The right to write a project, kept in a hidden file beside it (".NAME.quadrille.lock") so that programs on
/// other machines see it, too. It is advice: it keeps programs that ask for it from writing over each other's
/// work. A lock whose process is gone is taken without asking.
class ProjectLock
{
public:
    enum class State
    {
        Held,
        Foreign,  ///< somebody else has it
        ReadOnly, ///< the folder may not be written, so nobody can have it
        None,     ///< it cannot be made for another reason; the project can be used without
    };

    /// Takes the lock unless somebody has it.
    /// \param project the project file, which need not exist; a link stands for the file it names.
    /// \param program who asks, for those who find it locked.
    ProjectLock(const std::filesystem::path& project, std::string program);
    /// Gives it back.
    ~ProjectLock();
    ProjectLock(const ProjectLock&) = delete;
    ProjectLock& operator=(const ProjectLock&) = delete;

    State state() const { return m_state; }
    /// Who has it; there while it is foreign.
    const std::optional<LockHolder>& holder() const { return m_holder; }
    /// Takes it from whoever has it.
    void takeOver();
    /// Looks whether it is still as it was: it may have been taken over, and taken back where its file went.
    State look();
    /// Says that the holder is still there.
    void keepAlive() const;

    static std::filesystem::path fileOf(const std::filesystem::path& project);

private:
    void acquire();
    bool create();
    std::filesystem::path writeBeside() const;
    void fail(int error);

    std::filesystem::path m_file;
    LockHolder m_self;
    State m_state = State::None;
    std::optional<LockHolder> m_holder;
};

} // namespace quadrille
