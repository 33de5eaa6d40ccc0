// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/hdf5.h"

#include "model/core/error.h"
#include "model/core/file.h"

#include <utility>

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

std::string hdf5ErrorText()
{
    std::string text = "HDF5 gives no reason";
    const auto innermost = [](unsigned, const H5E_error2_t* error, void* out) -> herr_t {
        if (error->desc)
            *static_cast<std::string*>(out) = error->desc;
        return 0;
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, innermost, &text);
    return text;
}

Hdf5Handle openHdf5(const std::filesystem::path& path)
{
    // InputFile says why a file cannot be opened; HDF5 does not.
    const InputFile exists(path);
    const auto lock = lockHdf5();
    Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (!file.isValid())
        throw Error(ErrorCode::FileSyntax, {path, {}, {{"reason", hdf5ErrorText()}}});
    return file;
}

} // namespace quadrille
