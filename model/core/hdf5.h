// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <hdf5.h>
#include <mutex>
#include <string>

namespace quadrille {

/// Debian's HDF5 is not thread-safe: hold this lock around every call into the library (also around closing;
/// Hdf5Handle does so itself). May be taken again by the thread that holds it.
[[nodiscard]] std::unique_lock<std::recursive_mutex> lockHdf5();

/// Owns an HDF5 identifier: file, dataset, dataspace, type, property list, ….
class Hdf5Handle
{
public:
    using Close = herr_t (*)(hid_t);

    Hdf5Handle() = default;
    /// \param id  what an H5…open or H5…create call returned; negative when it failed.
    Hdf5Handle(hid_t id, Close close) : m_id(id), m_close(close) {}
    ~Hdf5Handle() { reset(); }
    Hdf5Handle(Hdf5Handle&& other) noexcept;
    Hdf5Handle& operator=(Hdf5Handle&& other) noexcept;
    Hdf5Handle(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(const Hdf5Handle&) = delete;

    hid_t id() const { return m_id; }
    bool isValid() const { return m_id >= 0; }
    void reset();

private:
    hid_t m_id = H5I_INVALID_HID;
    Close m_close = nullptr;
};

/// The system's number in what the library notes about the last call that failed (28: the disk is full); 0
/// where it was not the system. Call under the same lock, before anything is closed.
int hdf5SystemError();

/// File access properties: where a file system knows no locks, the library goes without. Wants the lock.
Hdf5Handle hdf5FileAccess();

/// False for a dataset stored in one piece that is smaller than its values: reading it would take the library
/// (1.10) beyond the end of its buffer. Wants the lock.
bool holdsAllValues(const Hdf5Handle& dataset);

/// Opens a file for reading.
/// \throws Error file errors as InputFile; FileTruncated; ReadFailed where another program is writing it;
/// FileSyntax when it is no HDF5 file or damaged.
Hdf5Handle openHdf5(const std::filesystem::path& path);

} // namespace quadrille
