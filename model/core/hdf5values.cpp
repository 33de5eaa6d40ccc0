// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/hdf5values.h"

#include "model/core/error.h"
#include "model/core/file.h"
#include "model/core/message.h"

namespace quadrille::hdf5data {

Hdf5Handle createFile(const std::filesystem::path& path, hsize_t userBlock)
{
    const Hdf5Handle properties = handle(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    check(H5Pset_userblock(properties.id(), userBlock));
    check(H5Pset_link_creation_order(properties.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
    check(H5Pset_obj_track_times(properties.id(), false));
    const Hdf5Handle access = hdf5FileAccess();
    return handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, properties.id(), access.id()), H5Fclose);
}

void throwWriting(const std::filesystem::path& path, const Failure& failure)
{
    if (failure.systemError != 0)
        throwSystemError(path, failure.systemError, ErrorCode::WriteFailed);
    throw Error(ErrorCode::WriteFailed,
                {path, {}, {{"reason", QUADRILLE_MESSAGE("it could not be written to its end")}}});
}

Hdf5Handle createGroup(hid_t parent, const std::string& name)
{
    const Hdf5Handle properties = handle(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
    check(H5Pset_link_creation_order(properties.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
    check(H5Pset_obj_track_times(properties.id(), false));
    return handle(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Gclose);
}

Hdf5Handle openGroup(hid_t parent, const std::string& name)
{
    return handle(H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose);
}

Hdf5Handle spaceOf(const std::vector<std::int64_t>& shape)
{
    const std::vector<hsize_t> extents(shape.begin(), shape.end());
    if (extents.empty())
        return handle(H5Screate(H5S_SCALAR), H5Sclose);
    return handle(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), H5Sclose);
}

Hdf5Handle createDataset(hid_t parent, const std::string& name, const std::vector<std::int64_t>& shape,
                         hid_t type)
{
    const Hdf5Handle space = spaceOf(shape);
    const Hdf5Handle properties = handle(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    check(H5Pset_obj_track_times(properties.id(), false));
    return handle(
        H5Dcreate2(parent, name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
        H5Dclose);
}

Hdf5Handle textType(std::size_t size)
{
    Hdf5Handle type = handle(H5Tcopy(H5T_C_S1), H5Tclose);
    check(H5Tset_size(type.id(), std::max<std::size_t>(size, 1)));
    check(H5Tset_cset(type.id(), H5T_CSET_UTF8));
    check(H5Tset_strpad(type.id(), H5T_STR_NULLPAD));
    return type;
}

void writeText(hid_t object, const char* name, const std::string& text)
{
    const Hdf5Handle type = textType(text.size());
    const Hdf5Handle space = handle(H5Screate(H5S_SCALAR), H5Sclose);
    const Hdf5Handle attribute =
        handle(H5Acreate2(object, name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    check(H5Awrite(attribute.id(), type.id(), text.c_str()));
}

std::string readText(hid_t object, const char* name)
{
    const auto texts = readTexts(object, name);
    return texts.empty() ? "" : texts.front();
}

void writeTexts(hid_t object, const char* name, const std::vector<std::string>& texts)
{
    std::size_t size = 1;
    for (const std::string& text : texts)
        size = std::max(size, text.size());
    const Hdf5Handle type = textType(size);
    const Hdf5Handle space = spaceOf({static_cast<std::int64_t>(texts.size())});
    const Hdf5Handle attribute =
        handle(H5Acreate2(object, name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    check(H5Awrite(attribute.id(), type.id(), packTexts(texts, size).data()));
}

std::vector<std::string> readTexts(hid_t object, const char* name)
{
    const Hdf5Handle attribute = handle(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
    const Hdf5Handle type = handle(H5Aget_type(attribute.id()), H5Tclose);
    const Hdf5Handle space = handle(H5Aget_space(attribute.id()), H5Sclose);
    const auto count = static_cast<std::size_t>(check(H5Sget_simple_extent_npoints(space.id())));
    const std::size_t size = H5Tget_size(type.id());
    constexpr std::size_t largestAttribute = std::size_t{1} << 20;
    if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) > 0 || size == 0 ||
        count > largestAttribute / size)
        throw Failure{};
    std::vector<char> packed(count * size);
    check(H5Aread(attribute.id(), type.id(), packed.data()));
    return unpackTexts<std::vector<std::string>>(packed, size);
}

} // namespace quadrille::hdf5data
