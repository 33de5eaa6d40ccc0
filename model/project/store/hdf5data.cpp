// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/store/hdf5data.h"

#include <algorithm>

namespace quadrille::hdf5data {

namespace {

Hdf5Handle handle(hid_t id, Hdf5Handle::Close close)
{
    return {check(id), close};
}

/// UTF-8 text of a fixed size, padded with zeros.
Hdf5Handle textType(std::size_t size)
{
    Hdf5Handle type = handle(H5Tcopy(H5T_C_S1), H5Tclose);
    check(H5Tset_size(type.id(), std::max<std::size_t>(size, 1)));
    check(H5Tset_cset(type.id(), H5T_CSET_UTF8));
    check(H5Tset_strpad(type.id(), H5T_STR_NULLPAD));
    return type;
}

/// Texts one after the other, each `size` bytes.
std::vector<char> packTexts(const TextColumn& texts, std::size_t size)
{
    std::vector<char> packed(std::max<std::size_t>(texts.size() * size, 1));
    for (std::size_t i = 0; i < texts.size(); ++i)
        std::copy(texts[i].begin(), texts[i].end(), packed.begin() + static_cast<std::ptrdiff_t>(i * size));
    return packed;
}

TextColumn unpackTexts(const std::vector<char>& packed, std::size_t size)
{
    TextColumn texts;
    texts.reserve(packed.size() / size);
    for (std::size_t at = 0; at + size <= packed.size(); at += size) {
        std::string text(packed.data() + at, size);
        text.erase(text.find_last_not_of('\0') + 1);
        texts.push_back(text);
    }
    return texts;
}

std::size_t longest(const TextColumn& texts)
{
    std::size_t size = 1;
    for (const std::string& text : texts.words())
        size = std::max(size, text.size());
    return size;
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
    else if constexpr (std::is_same_v<T, std::uint16_t>)
        return {H5T_STD_U16LE, H5T_NATIVE_UINT16};
    else
        return {H5T_STD_U8LE, H5T_NATIVE_UINT8};
}

Hdf5Handle spaceOf(const std::vector<std::int64_t>& shape)
{
    const std::vector<hsize_t> extents(shape.begin(), shape.end());
    if (extents.empty())
        return handle(H5Screate(H5S_SCALAR), H5Sclose);
    return handle(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), H5Sclose);
}

Hdf5Handle createDataset(hid_t parent, const DataArray& array, hid_t type)
{
    const Hdf5Handle space = spaceOf(array.shape);
    const Hdf5Handle properties = handle(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    check(H5Pset_obj_track_times(properties.id(), false));
    return handle(
        H5Dcreate2(parent, array.name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
        H5Dclose);
}

void writeTexts(hid_t object, const char* name, const std::vector<std::string>& texts)
{
    const std::size_t size = longest(texts);
    const Hdf5Handle type = textType(size);
    const Hdf5Handle space = spaceOf({static_cast<std::int64_t>(texts.size())});
    const Hdf5Handle attribute =
        handle(H5Acreate2(object, name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    check(H5Awrite(attribute.id(), type.id(), packTexts(texts, size).data()));
}

/// Texts of an attribute, one or several.
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
    return unpackTexts(packed, size).list();
}

template <typename T>
DataValues readNumbers(hid_t dataset, std::size_t count, std::uint64_t limit)
{
    if (count > limit / sizeof(T))
        throw Failure{};
    std::vector<T> values(count);
    if (count > 0)
        check(H5Dread(dataset, typesOf<T>().second, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    return values;
}

/// As one row for each index of the first dimension.
template <typename T>
DataValues readTable(hid_t dataset, const std::vector<std::int64_t>& shape, std::uint64_t limit)
{
    std::size_t columns = 1;
    for (std::size_t d = 1; d < shape.size(); ++d)
        columns *= static_cast<std::size_t>(shape[d]);
    const auto rows = shape.empty() ? std::size_t{1} : static_cast<std::size_t>(shape.front());
    if (rows > 0 && columns > limit / sizeof(T) / rows)
        throw Failure{};
    Table<T> table(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
    if (table.size() > 0)
        check(H5Dread(dataset, typesOf<T>().second, H5S_ALL, H5S_ALL, H5P_DEFAULT, table.data()));
    return SharedTable<T>(std::move(table));
}

DataValues readValues(hid_t dataset, const std::vector<std::int64_t>& shape, std::size_t count,
                      std::uint64_t limit)
{
    const Hdf5Handle type = handle(H5Dget_type(dataset), H5Tclose);
    const std::size_t size = H5Tget_size(type.id());
    switch (H5Tget_class(type.id())) {
    case H5T_FLOAT:
        if (size != 4)
            return readNumbers<double>(dataset, count, limit);
        return shape.size() == 2 ? readTable<float>(dataset, shape, limit)
                                 : readNumbers<float>(dataset, count, limit);
    case H5T_INTEGER:
        if (size == 2)
            return readTable<std::uint16_t>(dataset, shape, limit);
        return size == 1 ? readNumbers<std::uint8_t>(dataset, count, limit)
                         : readNumbers<std::int64_t>(dataset, count, limit);
    case H5T_STRING: {
        if (size == 0 || H5Tis_variable_str(type.id()) > 0 || count > limit / size)
            throw Failure{};
        std::vector<char> packed(count * size);
        if (count > 0)
            check(H5Dread(dataset, type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, packed.data()));
        return unpackTexts(packed, size);
    }
    default:
        throw Failure{};
    }
}

} // namespace

Hdf5Handle createFile(const std::filesystem::path& path)
{
    const Hdf5Handle properties = handle(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    check(H5Pset_link_creation_order(properties.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
    check(H5Pset_obj_track_times(properties.id(), false));
    const Hdf5Handle access = hdf5FileAccess();
    return handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, properties.id(), access.id()), H5Fclose);
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

std::vector<Member> members(hid_t group)
{
    std::vector<Member> found;
    const auto add = [](hid_t parent, const char* name, const H5L_info_t*, void* out) -> herr_t {
        H5O_info_t info;
        if (H5Oget_info_by_name2(parent, name, &info, H5O_INFO_BASIC, H5P_DEFAULT) < 0)
            return -1;
        static_cast<std::vector<Member>*>(out)->push_back({name, info.type == H5O_TYPE_GROUP});
        return 0;
    };
    check(H5Literate(group, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, add, &found));
    return found;
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

void writeArray(hid_t parent, const DataArray& array)
{
    const Hdf5Handle dataset = std::visit(
        [&](const auto& values) {
            using Value = typename std::decay_t<decltype(values)>::value_type;
            if constexpr (std::is_same_v<Value, std::string>) {
                const std::size_t size = longest(values);
                const Hdf5Handle type = textType(size);
                Hdf5Handle created = createDataset(parent, array, type.id());
                if (!values.empty())
                    check(H5Dwrite(created.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT,
                                   packTexts(values, size).data()));
                return created;
            } else {
                const auto [inFile, inMemory] = typesOf<Value>();
                Hdf5Handle created = createDataset(parent, array, inFile);
                if (!values.empty())
                    check(H5Dwrite(created.id(), inMemory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
                return created;
            }
        },
        array.values);
    writeText(dataset.id(), "description", array.description);
    writeText(dataset.id(), "unit", array.unit);
    if (!array.columns.empty())
        writeTexts(dataset.id(), "columns", array.columns);
}

DataArray readArray(hid_t parent, const std::string& name, std::uint64_t limit)
{
    const Hdf5Handle dataset = handle(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose);
    const Hdf5Handle space = handle(H5Dget_space(dataset.id()), H5Sclose);
    std::vector<hsize_t> extents(static_cast<std::size_t>(check(H5Sget_simple_extent_ndims(space.id()))));
    check(H5Sget_simple_extent_dims(space.id(), extents.data(), nullptr));
    DataArray array;
    array.name = name;
    array.shape.assign(extents.begin(), extents.end());
    array.description = readText(dataset.id(), "description");
    array.unit = readText(dataset.id(), "unit");
    if (check(H5Aexists(dataset.id(), "columns")) > 0)
        array.columns = readTexts(dataset.id(), "columns");
    if (!holdsAllValues(dataset))
        throw Failure{};
    const auto count = static_cast<std::size_t>(check(H5Sget_simple_extent_npoints(space.id())));
    array.values = readValues(dataset.id(), array.shape, count, limit);
    return array;
}

} // namespace quadrille::hdf5data
