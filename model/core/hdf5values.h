// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/hdf5.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille::hdf5data {

/// A call into the library failed or the file holds something else than expected.
struct Failure
{
    int systemError = 0; ///< the system's number, where it was the system; 0 otherwise
};

/// \throws Failure when a status or identifier is negative.
template <typename Status>
Status check(Status status)
{
    if (status < 0)
        throw Failure{hdf5SystemError()};
    return status;
}

/// \throws Failure when the identifier is negative.
inline Hdf5Handle handle(hid_t id, Hdf5Handle::Close close)
{
    return {check(id), close};
}

// All of these want the lock of lockHdf5() and throw Failure. Nothing that they write depends on the time.

/// \param userBlock  bytes that are left before the library's own: none, or a power of two from 512 on.
Hdf5Handle createFile(const std::filesystem::path& path, hsize_t userBlock = 0);
/// \throws Error WriteFailed and what throwSystemError throws: why a file could not be written.
[[noreturn]] void throwWriting(const std::filesystem::path& path, const Failure& failure);
Hdf5Handle createGroup(hid_t parent, const std::string& name);
Hdf5Handle openGroup(hid_t parent, const std::string& name);
Hdf5Handle spaceOf(const std::vector<std::int64_t>& shape);
Hdf5Handle createDataset(hid_t parent, const std::string& name, const std::vector<std::int64_t>& shape,
                         hid_t type);

/// A text attribute.
void writeText(hid_t object, const char* name, const std::string& text);
std::string readText(hid_t object, const char* name);
/// Several texts in an attribute.
void writeTexts(hid_t object, const char* name, const std::vector<std::string>& texts);
std::vector<std::string> readTexts(hid_t object, const char* name);

/// UTF-8 text of a fixed size, padded with zeros.
Hdf5Handle textType(std::size_t size);

/// `count` texts from `first` on, one after the other, each `size` bytes.
template <typename Texts>
std::vector<char> packTexts(const Texts& texts, std::size_t size, std::size_t first, std::size_t count)
{
    std::vector<char> packed(std::max<std::size_t>(count * size, 1));
    for (std::size_t i = 0; i < count; ++i)
        std::copy(texts[first + i].begin(), texts[first + i].end(),
                  packed.begin() + static_cast<std::ptrdiff_t>(i * size));
    return packed;
}
/// All of them.
template <typename Texts>
std::vector<char> packTexts(const Texts& texts, std::size_t size)
{
    return packTexts(texts, size, 0, texts.size());
}

/// Adds packed texts to others.
template <typename Texts>
void unpackTexts(const std::vector<char>& packed, std::size_t size, Texts& texts)
{
    for (std::size_t at = 0; at + size <= packed.size(); at += size) {
        std::string text(packed.data() + at, size);
        text.erase(text.find_last_not_of('\0') + 1);
        texts.push_back(text);
    }
}
template <typename Texts>
Texts unpackTexts(const std::vector<char>& packed, std::size_t size)
{
    Texts texts;
    texts.reserve(packed.size() / size);
    unpackTexts(packed, size, texts);
    return texts;
}

/// In the file values are little-endian, in memory native.
template <typename T>
std::pair<hid_t, hid_t> typesOf()
{
    if constexpr (std::is_same_v<T, float>)
        return {H5T_IEEE_F32LE, H5T_NATIVE_FLOAT};
    else if constexpr (std::is_same_v<T, double>)
        return {H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE};
    else if constexpr (std::is_same_v<T, std::int64_t>)
        return {H5T_STD_I64LE, H5T_NATIVE_INT64};
    else if constexpr (std::is_same_v<T, std::uint32_t>)
        return {H5T_STD_U32LE, H5T_NATIVE_UINT32};
    else if constexpr (std::is_same_v<T, std::int16_t>)
        return {H5T_STD_I16LE, H5T_NATIVE_INT16};
    else if constexpr (std::is_same_v<T, std::uint16_t>)
        return {H5T_STD_U16LE, H5T_NATIVE_UINT16};
    else if constexpr (std::is_same_v<T, std::int8_t>)
        return {H5T_STD_I8LE, H5T_NATIVE_INT8};
    else {
        static_assert(std::is_same_v<T, std::uint8_t>);
        return {H5T_STD_U8LE, H5T_NATIVE_UINT8};
    }
}

} // namespace quadrille::hdf5data
