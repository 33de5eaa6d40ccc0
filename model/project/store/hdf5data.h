// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/hdf5.h"
#include "model/project/store/result.h"

#include <filesystem>
#include <string>
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

/// One member of a group, in the order in which they were made.
struct Member
{
    std::string name;
    bool isGroup = false;
};

// All of these want the lock of lockHdf5() and throw Failure. Nothing that they write depends on the time.

Hdf5Handle createFile(const std::filesystem::path& path);
Hdf5Handle createGroup(hid_t parent, const std::string& name);
Hdf5Handle openGroup(hid_t parent, const std::string& name);
std::vector<Member> members(hid_t group);

/// A text attribute.
void writeText(hid_t object, const char* name, const std::string& text);
std::string readText(hid_t object, const char* name);

/// A dataset with its attributes.
void writeArray(hid_t parent, const DataArray& array);
/// \param limit bytes that the values may take; more is damage.
DataArray readArray(hid_t parent, const std::string& name, std::uint64_t limit);

} // namespace quadrille::hdf5data
