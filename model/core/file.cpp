// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/file.h"

#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace quadrille {

namespace fs = std::filesystem;

void throwSystemError(const fs::path& path, int error, ErrorCode otherwise)
{
    if ((error == ENOENT || error == ENOTDIR) && otherwise != ErrorCode::WriteFailed)
        throw Error(ErrorCode::FileNotFound, {path, {}, {}});
    if (error == EACCES || error == EPERM || error == EROFS)
        throw Error(ErrorCode::PermissionDenied, {path, {}, {}});
    throw Error(otherwise, {path, {}, {{"reason", std::generic_category().message(error)}}});
}

InputFile::InputFile(const fs::path& path)
    : m_path(path), m_descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC))
{
    if (m_descriptor < 0)
        throwSystemError(path, errno, ErrorCode::ReadFailed);
    struct stat status = {};
    const bool known = ::fstat(m_descriptor, &status) == 0;
    const int error = known ? S_ISDIR(status.st_mode) ? EISDIR : 0 : errno;
    m_size = known ? static_cast<std::uint64_t>(status.st_size) : 0;
    if (error == 0 && m_size > 0)
        return;
    ::close(m_descriptor);
    if (error != 0)
        throwSystemError(path, error, ErrorCode::ReadFailed);
    throw Error(ErrorCode::FileEmpty, {path, {}, {}});
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

fs::path temporaryBeside(const fs::path& path)
{
    static std::atomic<unsigned> counter{0};
    auto name = path.stem();
    name += ".tmp" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
    name += path.extension();
    return path.parent_path() / name;
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
