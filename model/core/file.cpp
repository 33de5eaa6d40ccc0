// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/file.h"

#include "model/core/message.h"

#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// A pipe would wait for a writer and a device never end.
void requireRegular(const fs::path& path, mode_t mode)
{
    if (S_ISREG(mode))
        return;
    const char* reason = QUADRILLE_MESSAGE("This is a device, not a file");
    if (S_ISDIR(mode))
        reason = QUADRILLE_MESSAGE("This is a folder, not a file");
    else if (S_ISFIFO(mode))
        reason = QUADRILLE_MESSAGE("This is a pipe, not a file");
    else if (S_ISSOCK(mode))
        reason = QUADRILLE_MESSAGE("This is a socket, not a file");
    throw Error(ErrorCode::BadArgument,
                {path, {}, {{"reason", reason}, {"remedy", QUADRILLE_MESSAGE("Choose a file on a disk.")}}});
}

/// Opens without waiting. What is no regular file is refused before, as opening alone may set a device going.
int openRegular(const fs::path& path)
{
    struct stat status = {};
    if (::stat(path.c_str(), &status) == 0)
        requireRegular(path, status.st_mode);
    return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
}

} // namespace

InputFile::InputFile(const fs::path& path) : m_path(path), m_descriptor(openRegular(path))
{
    if (m_descriptor < 0)
        throwSystemError(path, errno, ErrorCode::ReadFailed);
    try {
        struct stat status = {};
        if (::fstat(m_descriptor, &status) != 0)
            throwSystemError(path, errno, ErrorCode::ReadFailed);
        requireRegular(path, status.st_mode);
        m_size = static_cast<std::uint64_t>(status.st_size);
        if (m_size == 0)
            throw Error(ErrorCode::FileEmpty, {path, {}, {}});
    } catch (...) {
        ::close(m_descriptor);
        throw;
    }
}

InputFile::~InputFile()
{
    ::close(m_descriptor);
}

void InputFile::read(std::uint64_t offset, std::span<std::byte> out) const
{
    std::size_t done = 0;
    while (done < out.size()) {
        const auto count =
            ::pread(m_descriptor, out.data() + done, out.size() - done, static_cast<off_t>(offset + done));
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            throwSystemError(m_path, errno, ErrorCode::ReadFailed);
        if (count == 0) {
            throw Error(ErrorCode::FileTruncated,
                        {m_path,
                         {.byte = static_cast<std::int64_t>(offset + done)},
                         {{"expected", std::to_string(offset + out.size()) + " bytes"},
                          {"found", std::to_string(offset + done)}}});
        }
        done += static_cast<std::size_t>(count);
    }
}

FileContent readFile(const fs::path& path)
{
    const InputFile file(path);
    FileContent content{std::make_unique_for_overwrite<std::byte[]>(file.size()), file.size()};
    file.read(0, {content.data.get(), content.size});
    return content;
}

namespace {

/// Makes an empty file that nobody has made before: a link that lies ready under its name is not followed.
fs::path temporaryBeside(const fs::path& path)
{
    static std::atomic<unsigned> counter{0};
    for (;;) {
        auto name = path.stem();
        name += ".tmp" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
        name += path.extension();
        fs::path temporary = path.parent_path() / name;
        const int file =
            ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (file >= 0) {
            ::close(file);
            return temporary;
        }
        if (errno != EEXIST)
            throwSystemError(path, errno, ErrorCode::WriteFailed);
    }
}

} // namespace

void writeAtomically(const fs::path& path, const std::function<void(const fs::path&)>& write)
{
    std::error_code error;
    if (path.has_parent_path())
        fs::create_directories(path.parent_path(), error);
    if (error)
        throwSystemError(path.parent_path(), error.value(), ErrorCode::WriteFailed);
    const auto temporary = temporaryBeside(path);
    try {
        write(temporary);
        fs::rename(temporary, path);
    } catch (const fs::filesystem_error& failure) {
        fs::remove(temporary, error);
        throwSystemError(path, failure.code().value(), ErrorCode::WriteFailed);
    } catch (...) {
        fs::remove(temporary, error);
        throw;
    }
}

void writeAtomically(const fs::path& path, std::string_view content)
{
    writeAtomically(path, [&](const fs::path& temporary) {
        std::ofstream out(temporary, std::ios::binary);
        if (!out)
            throwSystemError(path, errno, ErrorCode::WriteFailed);
        out.write(content.data(), static_cast<std::streamsize>(content.size()));
        out.flush();
        if (!out)
            throwSystemError(path, errno, ErrorCode::WriteFailed);
    });
}

} // namespace quadrille
