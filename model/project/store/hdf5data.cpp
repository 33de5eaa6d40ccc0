// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/store/hdf5data.h"

#include <algorithm>

namespace quadrille::hdf5data {

namespace {

std::size_t longest(const TextColumn& texts)
{
    std::size_t size = 1;
    for (const std::string& text : texts.words())
        size = std::max(size, text.size());
    return size;
}

/// Texts are packed and unpacked so many bytes at a time: those of the edges of a large graph take more than
/// its numbers.
constexpr std::size_t packedBytes = std::size_t{1} << 20;

/// Calls `transfer` with the spaces in memory and in the file for some of the values after the others.
/// \param transfer  (first, count, id of the space in memory, id of that in the file)
template <typename Transfer>
void forEachPart(hid_t dataset, std::size_t count, std::size_t most, const Transfer& transfer)
{
    const Hdf5Handle space = handle(H5Dget_space(dataset), H5Sclose);
    const bool isColumn = check(H5Sget_simple_extent_ndims(space.id())) == 1;
    for (std::size_t first = 0; first < count;) {
        const hsize_t start = first;
        const hsize_t part = isColumn ? std::min(most, count - first) : count;
        if (isColumn)
            check(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &start, nullptr, &part, nullptr));
        const Hdf5Handle memory = handle(H5Screate_simple(1, &part, nullptr), H5Sclose);
        transfer(first, static_cast<std::size_t>(part), memory.id(), space.id());
        first += static_cast<std::size_t>(part);
    }
}

void writeTexts(hid_t dataset, hid_t type, const TextColumn& texts, std::size_t size)
{
    forEachPart(dataset, texts.size(), std::max<std::size_t>(packedBytes / size, 1),
                [&](std::size_t first, std::size_t count, hid_t memory, hid_t file) {
                    check(H5Dwrite(dataset, type, memory, file, H5P_DEFAULT,
                                   packTexts(texts, size, first, count).data()));
                });
}

TextColumn readTexts(hid_t dataset, hid_t type, std::size_t count, std::size_t size)
{
    TextColumn texts;
    texts.reserve(count);
    std::vector<char> packed;
    forEachPart(dataset, count, std::max<std::size_t>(packedBytes / size, 1),
                [&](std::size_t, std::size_t part, hid_t memory, hid_t file) {
                    packed.resize(part * size);
                    check(H5Dread(dataset, type, memory, file, H5P_DEFAULT, packed.data()));
                    unpackTexts(packed, size, texts);
                });
    return texts;
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

/// The numbers where they lie in the file; empty where they do not lie there as they would in memory, or are
/// too few to be worth it. Results are replaced whole, never changed.
template <typename T>
SharedTable<T> tableInFile(hid_t dataset, Eigen::Index rows, Eigen::Index columns)
{
    constexpr std::size_t least = std::size_t{16} << 20;
    const auto size = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns) * sizeof(T);
    if (size < least)
        return {};
    const Hdf5Handle type = handle(H5Dget_type(dataset), H5Tclose);
    const Hdf5Handle properties = handle(H5Dget_create_plist(dataset), H5Pclose);
    const haddr_t offset = H5Dget_offset(dataset);
    if (H5Pget_layout(properties.id()) != H5D_CONTIGUOUS || H5Pget_external_count(properties.id()) != 0 ||
        check(H5Tequal(type.id(), typesOf<T>().second)) == 0 || offset == HADDR_UNDEF ||
        offset % alignof(T) != 0)
        return {};
    std::string file(static_cast<std::size_t>(check(H5Fget_name(dataset, nullptr, 0))), '\0');
    check(H5Fget_name(dataset, file.data(), file.size() + 1));
    auto bytes = MappedBytes::tryToMap(file, offset, size);
    return bytes ? SharedTable<T>(std::move(bytes), rows, columns) : SharedTable<T>();
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
    if (SharedTable<T> inFile =
            tableInFile<T>(dataset, static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
        !inFile.empty())
        return inFile;
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
        return readTexts(dataset, type.id(), count, size);
    }
    default:
        throw Failure{};
    }
}

} // namespace

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

void writeArray(hid_t parent, const DataArray& array)
{
    const Hdf5Handle dataset = std::visit(
        [&](const auto& values) {
            using Value = typename std::decay_t<decltype(values)>::value_type;
            if constexpr (std::is_same_v<Value, std::string>) {
                const std::size_t size = longest(values);
                const Hdf5Handle type = textType(size);
                Hdf5Handle created = createDataset(parent, array.name, array.shape, type.id());
                writeTexts(created.id(), type.id(), values, size);
                return created;
            } else {
                const auto [inFile, inMemory] = typesOf<Value>();
                Hdf5Handle created = createDataset(parent, array.name, array.shape, inFile);
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
