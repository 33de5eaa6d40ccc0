// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/hdf5values.h"
#include "model/project/store/result.h"

#include <string>
#include <vector>

namespace quadrille::hdf5data {

/// One member of a group, in the order in which they were made.
struct Member
{
    std::string name;
    bool isGroup = false;
};

// All of these want the lock of lockHdf5() and throw Failure.

std::vector<Member> members(hid_t group);

/// A dataset with its attributes.
void writeArray(hid_t parent, const DataArray& array);
/// \param limit bytes that the values may take; more is damage.
DataArray readArray(hid_t parent, const std::string& name, std::uint64_t limit);

} // namespace quadrille::hdf5data
