// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/store/resultfile.h"

#include "model/core/contenthash.h"
#include "model/core/file.h"
#include "model/project/store/hdf5data.h"

#include <algorithm>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

constexpr const char* formatName = "quadrille-result";
constexpr const char* filesGroup = "files";

void addToHash(ContentHasher& hasher, const DataArray& array)
{
    for (const std::string& text : {array.name, array.description, array.unit, typeName(array.values)})
        hasher.add(text);
    hasher.add(static_cast<std::int64_t>(array.shape.size()));
    for (const std::int64_t extent : array.shape)
        hasher.add(extent);
    hasher.add(static_cast<std::int64_t>(array.columns.size()));
    for (const std::string& column : array.columns)
        hasher.add(column);
    std::visit(
        [&hasher](const auto& values) {
            using Value = typename std::decay_t<decltype(values)>::value_type;
            if constexpr (std::is_same_v<Value, std::string>) {
                for (const std::string& value : values)
                    hasher.add(value);
            } else {
                hasher.addBytes(std::as_bytes(std::span(values)));
                if constexpr (requires { values.unload(); })
                    values.unload();
            }
        },
        array.values);
}

DataTable filesTable(const std::vector<WrittenFile>& files)
{
    std::vector<std::string> paths;
    std::vector<std::string> hashes;
    for (const WrittenFile& file : files) {
        paths.push_back(file.path);
        hashes.push_back(file.hash);
    }
    return {filesGroup,
            "Files written outside of the store, relative to the project's folder.",
            {columnOf("path", "", std::move(paths)), columnOf("hash", "", std::move(hashes))}};
}

std::vector<WrittenFile> filesOf(const DataTable& table)
{
    std::vector<WrittenFile> files;
    const auto& paths = std::get<TextColumn>(table.columns.at(0).values);
    const auto& hashes = std::get<TextColumn>(table.columns.at(1).values);
    for (std::size_t i = 0; i < std::min(paths.size(), hashes.size()); ++i)
        files.push_back({paths[i], hashes[i]});
    return files;
}

void writeTable(hid_t parent, const DataTable& table)
{
    const Hdf5Handle group = hdf5data::createGroup(parent, table.name);
    hdf5data::writeText(group.id(), "description", table.description);
    for (const DataArray& column : table.columns)
        hdf5data::writeArray(group.id(), column);
}

DataTable readTable(hid_t parent, const std::string& name, std::uint64_t limit)
{
    const Hdf5Handle group = hdf5data::openGroup(parent, name);
    DataTable table{name, hdf5data::readText(group.id(), "description"), {}};
    for (const auto& member : hdf5data::members(group.id()))
        table.columns.push_back(hdf5data::readArray(group.id(), member.name, limit));
    return table;
}

ResultHeader headerOf(const Hdf5Handle& file)
{
    if (hdf5data::readText(file.id(), "format") != formatName)
        throw hdf5data::Failure{};
    return {hdf5data::readText(file.id(), "stage"), hdf5data::readText(file.id(), "key")};
}

Result contentOf(const Hdf5Handle& file, std::uint64_t limit)
{
    Result result;
    for (const auto& member : hdf5data::members(file.id())) {
        if (!member.isGroup)
            result.arrays.push_back(hdf5data::readArray(file.id(), member.name, limit));
        else if (member.name == filesGroup)
            result.files = filesOf(readTable(file.id(), member.name, limit));
        else
            result.tables.push_back(readTable(file.id(), member.name, limit));
    }
    return result;
}

/// Opens the file and reads from it; whatever is wrong inside makes it a damaged result.
template <typename Read>
auto readDamageable(const fs::path& path, const Read& read)
{
    const std::uint64_t size = InputFile(path).size();
    const auto lock = lockHdf5();
    try {
        const Hdf5Handle file = openHdf5(path);
        return read(file, size);
    } catch (const hdf5data::Failure&) {
        throw Error(ErrorCode::ResultDamaged, {path, {}, {}});
    } catch (const std::logic_error&) {
        throw Error(ErrorCode::ResultDamaged, {path, {}, {}});
    } catch (const std::bad_variant_access&) {
        throw Error(ErrorCode::ResultDamaged, {path, {}, {}});
    } catch (const Error& error) {
        if (error.code() == ErrorCode::FileSyntax || error.code() == ErrorCode::FileTruncated)
            throw Error(ErrorCode::ResultDamaged, {path, {}, {}});
        throw;
    }
}

} // namespace

std::string checksumOf(const ResultHeader& header, const Result& result)
{
    ContentHasher hasher;
    hasher.add(header.step);
    hasher.add(header.key);
    hasher.add(static_cast<std::int64_t>(result.arrays.size()));
    for (const DataArray& array : result.arrays)
        addToHash(hasher, array);
    hasher.add(static_cast<std::int64_t>(result.tables.size()));
    for (const DataTable& table : result.tables) {
        hasher.add(table.name);
        hasher.add(table.description);
        hasher.add(static_cast<std::int64_t>(table.columns.size()));
        for (const DataArray& column : table.columns)
            addToHash(hasher, column);
    }
    for (const WrittenFile& file : result.files) {
        hasher.add(file.path);
        hasher.add(file.hash);
    }
    return hasher.hex();
}

void writeResultFile(const fs::path& path, const ResultHeader& header, const Result& result)
{
    const std::string checksum = checksumOf(header, result);
    writeAtomically(path, [&](const fs::path& temporary) {
        const auto lock = lockHdf5();
        try {
            const Hdf5Handle file = hdf5data::createFile(temporary);
            hdf5data::writeText(file.id(), "format", formatName);
            hdf5data::writeText(file.id(), "stage", header.step);
            hdf5data::writeText(file.id(), "key", header.key);
            hdf5data::writeText(file.id(), "checksum", checksum);
            for (const DataArray& array : result.arrays)
                hdf5data::writeArray(file.id(), array);
            for (const DataTable& table : result.tables)
                writeTable(file.id(), table);
            if (!result.files.empty())
                writeTable(file.id(), filesTable(result.files));
            hdf5data::check(H5Fflush(file.id(), H5F_SCOPE_GLOBAL));
        } catch (const hdf5data::Failure& failure) {
            hdf5data::throwWriting(path, failure);
        }
    });
}

Result readResultFile(const fs::path& path)
{
    return readDamageable(path, [&](const Hdf5Handle& file, std::uint64_t size) {
        const ResultHeader header = headerOf(file);
        Result result = contentOf(file, size);
        if (checksumOf(header, result) != hdf5data::readText(file.id(), "checksum"))
            throw hdf5data::Failure{};
        return result;
    });
}

std::vector<WrittenFile> readWrittenFiles(const fs::path& path)
{
    return readDamageable(path, [](const Hdf5Handle& file, std::uint64_t size) {
        for (const auto& member : hdf5data::members(file.id())) {
            if (member.isGroup && member.name == filesGroup)
                return filesOf(readTable(file.id(), member.name, size));
        }
        return std::vector<WrittenFile>();
    });
}

ResultHeader readResultHeader(const fs::path& path)
{
    return readDamageable(path, [](const Hdf5Handle& file, std::uint64_t) { return headerOf(file); });
}

} // namespace quadrille
