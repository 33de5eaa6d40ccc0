// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/file/projectlock.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <pwd.h>
#include <random>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

namespace quadrille {

namespace fs = std::filesystem;
using Clock = std::chrono::system_clock;

namespace {

std::string hostName()
{
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

std::string userName()
{
    const passwd* user = ::getpwuid(::geteuid());
    return user != nullptr ? user->pw_name : std::to_string(::geteuid());
}

/// When a process began, in ticks since the machine did; empty where the system does not say.
std::string startOf(std::int64_t process)
{
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    // The name of the program, in parentheses, may hold anything.
    const auto name = text.rfind(')');
    if (name == std::string::npos)
        return {};
    std::istringstream fields(text.substr(name + 1));
    std::string field;
    constexpr int startField = 20; // of those behind the name
    for (int i = 0; i < startField && fields >> field; ++i) {
    }
    return field;
}

std::string newId()
{
    static std::atomic<unsigned> count{0};
    std::random_device random;
    std::ostringstream id;
    id << std::hex << random() << random() << '-' << ++count;
    return id.str();
}

LockHolder thisProgram(std::string program)
{
    const auto process = static_cast<std::int64_t>(::getpid());
    return {newId(), std::move(program), userName(),   hostName(),
            process, startOf(process),   Clock::now(), Clock::now()};
}

std::string textOf(const LockHolder& holder)
{
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(holder.since.time_since_epoch());
    nlohmann::ordered_json json{{"program", holder.program},
                                {"user", holder.user},
                                {"host", holder.host},
                                {"process", holder.process},
                                {"since", seconds.count()},
                                {"process_start", holder.processStart},
                                {"id", holder.id}};
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

/// Nothing where there is no lock; somebody unknown where its text says nothing.
std::optional<LockHolder> readHolder(const fs::path& file)
{
    struct stat status = {};
    if (::stat(file.c_str(), &status) != 0)
        return std::nullopt;
    LockHolder holder;
    holder.seen = holder.since = Clock::from_time_t(status.st_mtime);
    std::ifstream in(file, std::ios::binary);
    const auto json = nlohmann::json::parse(in, nullptr, false);
    if (!json.is_object())
        return holder;
    const auto text = [&](const char* key) {
        const auto found = json.find(key);
        return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
    };
    const auto number = [&](const char* key) {
        const auto found = json.find(key);
        return found != json.end() && found->is_number_integer() ? found->get<std::int64_t>() : 0;
    };
    holder.id = text("id");
    holder.program = text("program");
    holder.user = text("user");
    holder.host = text("host");
    holder.processStart = text("process_start");
    holder.process = number("process");
    if (const auto since = number("since"); since > 0)
        holder.since = Clock::time_point(std::chrono::seconds(since));
    return holder;
}

} // namespace

bool LockHolder::isGone() const
{
    if (process <= 0 || host.empty() || host != hostName())
        return false;
    if (::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH)
        return true;
    const std::string start = startOf(process);
    return !processStart.empty() && !start.empty() && start != processStart;
}

std::string LockHolder::toString() const
{
    std::string who = user.empty() ? "somebody" : user;
    if (!host.empty())
        who += "@" + host;
    return process > 0 ? who + ", process " + std::to_string(process) : who;
}

ProjectLock::ProjectLock(const fs::path& project, std::string program)
    : m_file(fileOf(project)), m_self(thisProgram(std::move(program)))
{
    acquire();
}

ProjectLock::~ProjectLock()
{
    if (look() == State::Held)
        ::unlink(m_file.c_str());
}

fs::path ProjectLock::fileOf(const fs::path& project)
{
    std::error_code error;
    fs::path target = fs::weakly_canonical(project, error);
    if (error)
        target = fs::absolute(project);
    return target.parent_path() / ("." + target.filename().string() + ".lock");
}

void ProjectLock::fail(int error)
{
    m_holder.reset();
    m_state = error == EACCES || error == EPERM || error == EROFS ? State::ReadOnly : State::None;
}

/// A file beside the lock's with the text of ours; no path where it could not be made.
fs::path ProjectLock::writeBeside() const
{
    fs::path file = m_file.string() + "." + m_self.id;
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (descriptor < 0)
        return {};
    const std::string text = textOf(m_self);
    const bool isWhole = ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    const int error = errno;
    if (::close(descriptor) == 0 && isWhole)
        return file;
    ::unlink(file.c_str());
    errno = isWhole ? errno : error;
    return {};
}

/// Makes the lock's file unless it is there. \return whether it was made.
bool ProjectLock::create()
{
    const fs::path beside = writeBeside();
    if (beside.empty()) {
        fail(errno);
        return false;
    }
    // A link appears whole or not at all, on network file systems, too.
    bool isMade = ::link(beside.c_str(), m_file.c_str()) == 0;
    int error = errno;
    struct stat status = {};
    if (!isMade && error != EEXIST && ::stat(beside.c_str(), &status) == 0 && status.st_nlink == 2)
        isMade = true; // only the answer was lost
    if (!isMade && error != EEXIST && !fs::exists(m_file)) {
        // Here are no links: the next best.
        isMade = ::rename(beside.c_str(), m_file.c_str()) == 0;
        error = errno;
    }
    ::unlink(beside.c_str());
    if (isMade)
        m_state = State::Held;
    else
        fail(error);
    return isMade;
}

void ProjectLock::acquire()
{
    if (!readHolder(m_file) && create()) {
        m_holder.reset();
        return;
    }
    m_holder = readHolder(m_file);
    if (!m_holder)
        return; // it could not be made
    m_state = State::Foreign;
    if (m_holder->isGone())
        takeOver();
}

void ProjectLock::takeOver()
{
    m_self.since = Clock::now();
    const fs::path beside = writeBeside();
    if (beside.empty() || ::rename(beside.c_str(), m_file.c_str()) != 0) {
        const int error = errno;
        if (!beside.empty())
            ::unlink(beside.c_str());
        fail(error);
        return;
    }
    m_holder.reset();
    m_state = State::Held;
}

ProjectLock::State ProjectLock::look()
{
    if (m_state != State::Held && m_state != State::Foreign)
        return m_state;
    const auto holder = readHolder(m_file);
    if (holder && holder->id == m_self.id) {
        m_holder.reset();
        m_state = State::Held;
    } else if (holder) {
        m_holder = holder;
        m_state = State::Foreign;
    } else if (m_state == State::Held) {
        acquire();
    }
    return m_state;
}

void ProjectLock::keepAlive() const
{
    if (m_state == State::Held)
        ::utimensat(AT_FDCWD, m_file.c_str(), nullptr, 0);
}

} // namespace quadrille
