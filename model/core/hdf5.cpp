// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/hdf5.h"

#include "model/core/error.h"
#include "model/core/file.h"
#include "model/core/message.h"

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

namespace quadrille {

std::unique_lock<std::recursive_mutex> lockHdf5()
{
    static std::recursive_mutex mutex;
    std::unique_lock lock(mutex);
    // Errors are thrown, not printed; each thread has its own setting.
    thread_local const herr_t silenced = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    static_cast<void>(silenced);
    return lock;
}

Hdf5Handle::Hdf5Handle(Hdf5Handle&& other) noexcept
    : m_id(std::exchange(other.m_id, H5I_INVALID_HID)), m_close(other.m_close)
{
}

Hdf5Handle& Hdf5Handle::operator=(Hdf5Handle&& other) noexcept
{
    if (this != &other) {
        reset();
        m_id = std::exchange(other.m_id, H5I_INVALID_HID);
        m_close = other.m_close;
    }
    return *this;
}

void Hdf5Handle::reset()
{
    if (!isValid())
        return;
    const auto lock = lockHdf5();
    m_close(std::exchange(m_id, H5I_INVALID_HID));
}

namespace {

/// What the library noted about the last call that failed, innermost first.
std::vector<std::string> notesOfFailure()
{
    std::vector<std::string> notes;
    const auto note = [](unsigned, const H5E_error2_t* error, void* out) -> herr_t {
        if (error->desc)
            static_cast<std::vector<std::string>*>(out)->emplace_back(error->desc);
        return 0;
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, note, &notes);
    return notes;
}

} // namespace

int hdf5SystemError()
{
    constexpr std::string_view name = "errno = ";
    for (const std::string& note : notesOfFailure()) {
        const auto at = note.find(name);
        int number = 0;
        if (at != std::string::npos)
            std::from_chars(note.data() + at + name.size(), note.data() + note.size(), number);
        if (number > 0)
            return number;
    }
    return 0;
}

Hdf5Handle hdf5FileAccess()
{
    Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_file_locking(access.id(), true, true);
    return access;
}

bool holdsAllValues(const Hdf5Handle& dataset)
{
    const Hdf5Handle type(H5Dget_type(dataset.id()), H5Tclose);
    const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose);
    const Hdf5Handle properties(H5Dget_create_plist(dataset.id()), H5Pclose);
    if (!type.isValid() || !space.isValid() || !properties.isValid())
        return false;
    if (H5Pget_layout(properties.id()) == H5D_CHUNKED)
        return true;
    std::vector<hsize_t> extents(
        static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space.id()))));
    H5Sget_simple_extent_dims(space.id(), extents.data(), nullptr);
    auto bytes = static_cast<double>(H5Tget_size(type.id())); // counts may be too large for whole numbers
    for (const hsize_t extent : extents)
        bytes *= static_cast<double>(extent);
    return bytes <= static_cast<double>(H5Dget_storage_size(dataset.id()));
}

namespace {

/// Why opening failed, as an error of our own.
[[noreturn]] void throwOpening(const InputFile& file)
{
    const std::vector<std::string> notes = notesOfFailure();
    const std::string reason = notes.empty() ? "" : notes.front();
    if (reason.find("unable to lock file") != std::string::npos) {
        throw Error(ErrorCode::ReadFailed,
                    {file.path(),
                     {},
                     {{"reason", QUADRILLE_MESSAGE("another program has the file open for writing")}}});
    }
    constexpr std::string_view stored = "stored_eof = ";
    if (const auto at = reason.find(stored);
        reason.starts_with("truncated file") && at != std::string::npos) {
        std::uint64_t expected = 0;
        std::from_chars(reason.data() + at + stored.size(), reason.data() + reason.size(), expected);
        throw Error(ErrorCode::FileTruncated, {file.path(),
                                               {},
                                               {{"expected", std::to_string(expected) + " bytes"},
                                                {"found", std::to_string(file.size())}}});
    }
    throw Error(ErrorCode::FileSyntax,
                {file.path(), {}, {{"reason", QUADRILLE_MESSAGE("it is no HDF5 file, or a damaged one")}}});
}

} // namespace

Hdf5Handle openHdf5(const std::filesystem::path& path)
{
    // InputFile says why a file cannot be opened; HDF5 does not.
    const InputFile readable(path);
    const auto lock = lockHdf5();
    const Hdf5Handle access = hdf5FileAccess();
    Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose);
    if (!file.isValid())
        throwOpening(readable);
    return file;
}

} // namespace quadrille
