// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"
#include "model/core/file.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// A glTF 2.0 file (.gltf or .glb) with its buffers: JSON and typed access to what its accessors hold. Every
/// index, offset and count is checked against what is there.
///
/// Errors of all members: FileSyntax, FileTruncated, CountTooLarge, nlohmann::json::exception where a value
/// has the wrong type; reading external buffers also throws what readFile throws.
///
/// Why not tinygltf (2.7): it leaves strides, sparse parts and all bounds to its user, takes negative offsets
/// for zero and ignores values of a wrong type, refuses buffer files longer than needed and indices that are
/// all sparse, also looks for buffers in the working directory, and tells errors as one text.
class GltfDocument
{
public:
    using Json = nlohmann::json;

    /// \throws Error also FormatRefused for extensions without which the file cannot be understood.
    explicit GltfDocument(const std::filesystem::path& path);
    /// \overload from the content of a file.
    GltfDocument(std::filesystem::path path, FileContent content);

    const std::filesystem::path& path() const { return m_path; }
    const Json& json() const { return m_json; }
    /// An array of the document ("nodes"); empty where there is none.
    const Json& list(const char* name) const;
    /// Entry of such an array.
    const Json& at(const char* name, std::int64_t index) const;

    /// Values of an accessor, count × components, integers as they are or, if normalised, in [−1, 1].
    /// \param components  what its type must have (VEC3: 3); \param expectedCount  −1: any.
    std::vector<float> floats(std::int64_t accessor, std::size_t components,
                              std::int64_t expectedCount = -1) const;
    /// Values of an accessor of unsigned integers.
    std::vector<std::uint32_t> integers(std::int64_t accessor, std::size_t components,
                                        std::int64_t expectedCount = -1) const;
    std::int64_t accessorCount(std::int64_t accessor) const;

    /// The bytes of a buffer view.
    std::span<const std::byte> viewBytes(std::int64_t view) const;
    /// The bytes of a URI: base64 data, or none if it names a file.
    std::optional<std::vector<std::byte>> dataOfUri(const std::string& uri) const;
    /// The file that a relative URI names.
    std::filesystem::path fileOfUri(const std::string& uri) const;

    [[noreturn]] void fail(const std::string& reason) const;

private:
    struct Layout;
    struct SparsePart;

    void parse(FileContent content);
    void checkExtensions() const;
    void loadBuffers();
    Layout layoutOf(const Json& accessor, std::size_t components) const;
    SparsePart sparsePart(std::int64_t accessor, const Json& sparse, const Layout& layout) const;
    void checkRoom(std::int64_t accessor, std::uint64_t bytes, std::uint64_t offset, std::uint64_t stride,
                   std::uint64_t count, std::uint64_t elementBytes) const;
    template <typename Value, typename Decode>
    std::vector<Value> read(std::int64_t accessor, std::size_t components, std::int64_t expectedCount,
                            Decode&& decode) const;
    std::int64_t checkedInteger(const Json& object, const char* key, std::int64_t fallback) const;

    std::filesystem::path m_path;
    FileContent m_content;
    Json m_json;
    std::span<const std::byte> m_binaryChunk;
    std::vector<std::vector<std::byte>> m_ownedBuffers;
    std::vector<std::span<const std::byte>> m_buffers;
    std::uint64_t m_bufferBytes = 0;
};

/// Reads an index such as "mesh" of a node; −1 when it is not there.
std::int64_t gltfIndex(const nlohmann::json& object, const char* key);

} // namespace quadrille
