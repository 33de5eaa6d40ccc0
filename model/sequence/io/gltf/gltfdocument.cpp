// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/gltf/gltfdocument.h"

#include "model/core/message.h"
#include "model/sequence/io/files/textscan.h"
#include "model/sequence/io/files/uri.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace quadrille {

namespace {

constexpr std::uint32_t glbMagic = 0x46546c67;    // "glTF"
constexpr std::uint32_t jsonChunk = 0x4e4f534a;   // "JSON"
constexpr std::uint32_t binaryChunk = 0x004e4942; // "BIN"

constexpr std::array understoodExtensions = {
    "KHR_mesh_quantization",      "KHR_texture_transform",
    "KHR_materials_unlit",        "KHR_materials_emissive_strength",
    "KHR_materials_specular",     "KHR_materials_ior",
    "KHR_materials_clearcoat",    "KHR_lights_punctual",
    "KHR_materials_transmission", "KHR_materials_volume",
    "KHR_materials_sheen",        "KHR_materials_variants",
    "KHR_animation_pointer",
};

template <typename T>
T load(const std::byte* bytes)
{
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

} // namespace

/// Where an accessor's values lie.
struct GltfDocument::Layout
{
    int componentType = 0;
    std::size_t componentBytes = 0;
    std::size_t elementBytes = 0;
    std::int64_t count = 0;
    bool normalized = false;
};

/// The elements that a sparse accessor changes and their new values, one after the other.
struct GltfDocument::SparsePart
{
    std::vector<std::uint32_t> elements;
    std::span<const std::byte> values;
};

std::int64_t gltfIndex(const nlohmann::json& object, const char* key)
{
    const auto found = object.find(key);
    return found != object.end() && found->is_number_integer() ? found->get<std::int64_t>() : -1;
}

GltfDocument::GltfDocument(const std::filesystem::path& path) : GltfDocument(path, readFile(path)) {}

GltfDocument::GltfDocument(std::filesystem::path path, FileContent content) : m_path(std::move(path))
{
    parse(std::move(content));
    const auto asset = m_json.find("asset");
    if (asset == m_json.end() || !asset->is_object() || !asset->value("version", "").starts_with("2."))
        fail(QUADRILLE_MESSAGE("only glTF 2.0 is known"));
    checkExtensions();
    loadBuffers();
}

void GltfDocument::fail(const std::string& reason) const
{
    throw Error(ErrorCode::FileSyntax, {m_path, {}, {{"reason", reason}}});
}

void GltfDocument::parse(FileContent content)
{
    m_content = std::move(content);
    std::string_view text = m_content.text();
    const auto bytes = m_content.bytes();
    if (bytes.size() >= 4 && load<std::uint32_t>(bytes.data()) == glbMagic) {
        std::size_t offset = 12;
        const auto chunk = [&](std::uint32_t type) -> std::span<const std::byte> {
            if (offset + 8 > bytes.size())
                return {};
            const std::uint64_t length = load<std::uint32_t>(bytes.data() + offset);
            if (load<std::uint32_t>(bytes.data() + offset + 4) != type)
                fail(QUADRILLE_MESSAGE("a chunk of the GLB file has the wrong type"));
            offset += 8;
            if (length > bytes.size() - offset) {
                throw Error(ErrorCode::FileTruncated,
                            {m_path,
                             {},
                             {{"expected", std::to_string(offset + length) + " bytes"},
                              {"found", std::to_string(bytes.size())}}});
            }
            const auto data = bytes.subspan(offset, length);
            offset += length;
            return data;
        };
        const auto json = chunk(jsonChunk);
        text = {reinterpret_cast<const char*>(json.data()), json.size()};
        m_binaryChunk = chunk(binaryChunk);
    }
    try {
        m_json = Json::parse(text);
    } catch (const Json::parse_error& error) {
        const char* const at = text.data() + std::min<std::size_t>(error.byte, text.size());
        const char* const file = m_content.text().data();
        throw Error(ErrorCode::FileSyntax,
                    {m_path,
                     {.line = text.data() == file ? std::optional(lineOf(text, at)) : std::nullopt,
                      .byte = at - file},
                     {{"reason", QUADRILLE_MESSAGE("the JSON text breaks off or is wrong")}}});
    }
    if (!m_json.is_object())
        fail(QUADRILLE_MESSAGE("it is not a glTF document"));
}

void GltfDocument::checkExtensions() const
{
    for (const Json& extension : list("extensionsRequired")) {
        const auto name = extension.is_string() ? extension.get<std::string>() : std::string();
        if (std::find(understoodExtensions.begin(), understoodExtensions.end(), name) !=
            understoodExtensions.end())
            continue;
        throw Error(ErrorCode::FormatRefused,
                    {m_path,
                     {},
                     {{"format", "glTF with the extension " + name},
                      {"remedy", QUADRILLE_MESSAGE("Export it again without compression or extensions.")}}});
    }
}

void GltfDocument::loadBuffers()
{
    for (const Json& buffer : list("buffers")) {
        std::span<const std::byte> bytes = m_binaryChunk;
        const auto uri = buffer.find("uri");
        if (uri != buffer.end() && uri->is_string()) {
            auto data = dataOfUri(uri->get<std::string>());
            if (!data) {
                const FileContent file = readFile(fileOfUri(uri->get<std::string>()));
                data.emplace(file.bytes().begin(), file.bytes().end());
            }
            m_ownedBuffers.push_back(std::move(*data));
            bytes = m_ownedBuffers.back();
        }
        const auto length = static_cast<std::uint64_t>(checkedInteger(buffer, "byteLength", 0));
        if (length > bytes.size()) {
            throw Error(ErrorCode::FileTruncated,
                        {m_path,
                         {},
                         {{"expected", std::to_string(length) + " bytes of a buffer"},
                          {"found", std::to_string(bytes.size())}}});
        }
        m_buffers.push_back(bytes.first(length));
        m_bufferBytes += length;
    }
}

std::optional<std::vector<std::byte>> GltfDocument::dataOfUri(const std::string& uri) const
{
    if (!uri.starts_with("data:"))
        return std::nullopt;
    const auto comma = uri.find(";base64,");
    auto bytes =
        comma == std::string::npos ? std::nullopt : decodeBase64(std::string_view(uri).substr(comma + 8));
    if (!bytes)
        fail(QUADRILLE_MESSAGE("a data URI is not base64"));
    return bytes;
}

std::filesystem::path GltfDocument::fileOfUri(const std::string& uri) const
{
    return m_path.parent_path() / percentDecoded(uri);
}

const GltfDocument::Json& GltfDocument::list(const char* name) const
{
    static const Json empty = Json::array();
    const auto found = m_json.find(name);
    if (found == m_json.end())
        return empty;
    if (!found->is_array())
        fail(std::string("“") + name + "” is not a list");
    return *found;
}

const GltfDocument::Json& GltfDocument::at(const char* name, std::int64_t index) const
{
    const Json& entries = list(name);
    if (index < 0 || index >= static_cast<std::int64_t>(entries.size()))
        fail("there is no entry " + std::to_string(index) + " in “" + name + "”");
    const Json& entry = entries[static_cast<std::size_t>(index)];
    if (!entry.is_object())
        fail("entry " + std::to_string(index) + " of “" + name + "” is not an object");
    return entry;
}

std::int64_t GltfDocument::checkedInteger(const Json& object, const char* key, std::int64_t fallback) const
{
    const auto found = object.find(key);
    if (found == object.end())
        return fallback;
    const std::int64_t value = found->is_number_integer() ? found->get<std::int64_t>() : -1;
    if (value < 0)
        fail(std::string("“") + key + "” is not a whole number from zero");
    return value;
}

std::span<const std::byte> GltfDocument::viewBytes(std::int64_t view) const
{
    const Json& object = at("bufferViews", view);
    const auto buffer = static_cast<std::size_t>(checkedInteger(object, "buffer", 0));
    const auto offset = static_cast<std::uint64_t>(checkedInteger(object, "byteOffset", 0));
    const auto length = static_cast<std::uint64_t>(checkedInteger(object, "byteLength", 0));
    if (buffer >= m_buffers.size())
        fail("there is no buffer " + std::to_string(buffer));
    if (offset > m_buffers[buffer].size() || length > m_buffers[buffer].size() - offset) {
        throw Error(ErrorCode::FileTruncated,
                    {m_path,
                     {},
                     {{"expected", std::to_string(length) + " bytes at " + std::to_string(offset)},
                      {"found", "a buffer of " + std::to_string(m_buffers[buffer].size())}}});
    }
    return m_buffers[buffer].subspan(offset, length);
}

GltfDocument::Layout GltfDocument::layoutOf(const Json& accessor, std::size_t components) const
{
    static constexpr std::array<std::pair<const char*, std::size_t>, 5> types = {
        {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}}};
    const std::string type = accessor.value("type", "");
    const auto known =
        std::find_if(types.begin(), types.end(), [&](const auto& entry) { return type == entry.first; });
    if (known == types.end() || known->second != components)
        fail("an accessor has the type “" + type + "” where another is needed");
    Layout layout;
    layout.componentType = static_cast<int>(gltfIndex(accessor, "componentType"));
    switch (layout.componentType) {
    case 5120:
    case 5121:
        layout.componentBytes = 1;
        break;
    case 5122:
    case 5123:
        layout.componentBytes = 2;
        break;
    case 5125:
    case 5126:
        layout.componentBytes = 4;
        break;
    default:
        fail(QUADRILLE_MESSAGE("an accessor has an unknown component type"));
    }
    layout.elementBytes = layout.componentBytes * components;
    layout.count = checkedInteger(accessor, "count", 0);
    layout.normalized = accessor.value("normalized", false);
    return layout;
}

std::int64_t GltfDocument::accessorCount(std::int64_t accessor) const
{
    return checkedInteger(at("accessors", accessor), "count", 0);
}

void GltfDocument::checkRoom(std::int64_t accessor, std::uint64_t bytes, std::uint64_t offset,
                             std::uint64_t stride, std::uint64_t count, std::uint64_t elementBytes) const
{
    const bool fits = count == 0 || (offset <= bytes && elementBytes <= bytes - offset &&
                                     count - 1 <= (bytes - offset - elementBytes) / stride);
    if (fits)
        return;
    throw Error(ErrorCode::CountTooLarge, {m_path,
                                           {},
                                           {{"count", std::to_string(count)},
                                            {"what", "elements of accessor " + std::to_string(accessor)}}});
}

template <typename Value, typename Decode>
std::vector<Value> GltfDocument::read(std::int64_t index, std::size_t components, std::int64_t expectedCount,
                                      Decode&& decode) const
{
    const Json& accessor = at("accessors", index);
    const Layout layout = layoutOf(accessor, components);
    if (expectedCount >= 0 && layout.count != expectedCount)
        fail("an accessor has " + std::to_string(layout.count) + " elements where " +
             std::to_string(expectedCount) + " are needed");
    const auto count = static_cast<std::uint64_t>(layout.count);
    const auto decodeElement = [&](const std::byte* from, Value* to) {
        for (std::size_t c = 0; c < components; ++c)
            to[c] = decode(layout, from + c * layout.componentBytes);
    };
    std::vector<Value> values;
    if (const auto view = gltfIndex(accessor, "bufferView"); view >= 0) {
        const auto bytes = viewBytes(view);
        const auto offset = static_cast<std::uint64_t>(checkedInteger(accessor, "byteOffset", 0));
        auto stride = static_cast<std::uint64_t>(checkedInteger(at("bufferViews", view), "byteStride", 0));
        stride = stride == 0 ? layout.elementBytes : stride;
        checkRoom(index, bytes.size(), offset, stride, count, layout.elementBytes);
        values.resize(count * components);
        for (std::uint64_t i = 0; i < count; ++i)
            decodeElement(bytes.data() + offset + i * stride, values.data() + i * components);
    } else {
        // All zero but for the sparse part; such an accessor accompanies one that has its values in a buffer.
        checkRoom(index, m_bufferBytes, 0, 1, count, 1);
        values.resize(count * components);
    }
    const auto sparse = accessor.find("sparse");
    if (sparse == accessor.end() || !sparse->is_object())
        return values;
    const SparsePart part = sparsePart(index, *sparse, layout);
    for (std::size_t i = 0; i < part.elements.size(); ++i) {
        if (part.elements[i] >= count)
            fail(QUADRILLE_MESSAGE("a sparse accessor changes an element that is not there"));
        decodeElement(part.values.data() + i * layout.elementBytes,
                      values.data() + part.elements[i] * components);
    }
    return values;
}

GltfDocument::SparsePart GltfDocument::sparsePart(std::int64_t accessor, const Json& sparse,
                                                  const Layout& layout) const
{
    const Json& indices = sparse.at("indices");
    const Json& changes = sparse.at("values");
    const auto count = static_cast<std::uint64_t>(checkedInteger(sparse, "count", 0));
    const auto type = gltfIndex(indices, "componentType");
    const std::size_t indexBytes = type == 5121 ? 1 : type == 5123 ? 2 : 4;
    const auto indexView = viewBytes(gltfIndex(indices, "bufferView"));
    const auto valueView = viewBytes(gltfIndex(changes, "bufferView"));
    const auto indexOffset = static_cast<std::uint64_t>(checkedInteger(indices, "byteOffset", 0));
    const auto valueOffset = static_cast<std::uint64_t>(checkedInteger(changes, "byteOffset", 0));
    checkRoom(accessor, indexView.size(), indexOffset, indexBytes, count, indexBytes);
    checkRoom(accessor, valueView.size(), valueOffset, layout.elementBytes, count, layout.elementBytes);
    SparsePart part;
    part.elements.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        std::memcpy(&part.elements[i], indexView.data() + indexOffset + i * indexBytes, indexBytes);
    part.values = valueView.subspan(count == 0 ? 0 : valueOffset);
    return part;
}

std::vector<float> GltfDocument::floats(std::int64_t accessor, std::size_t components,
                                        std::int64_t expectedCount) const
{
    return read<float>(accessor, components, expectedCount, [](const Layout& layout, const std::byte* at) {
        const auto scaled = [&](float value, float largest) {
            return layout.normalized ? std::max(value / largest, -1.0F) : value;
        };
        switch (layout.componentType) {
        case 5120:
            return scaled(load<std::int8_t>(at), 127.0F);
        case 5121:
            return scaled(load<std::uint8_t>(at), 255.0F);
        case 5122:
            return scaled(load<std::int16_t>(at), 32767.0F);
        case 5123:
            return scaled(load<std::uint16_t>(at), 65535.0F);
        case 5125:
            return static_cast<float>(load<std::uint32_t>(at));
        default:
            return load<float>(at);
        }
    });
}

std::vector<std::uint32_t> GltfDocument::integers(std::int64_t accessor, std::size_t components,
                                                  std::int64_t expectedCount) const
{
    const auto type = gltfIndex(at("accessors", accessor), "componentType");
    if (type != 5121 && type != 5123 && type != 5125)
        fail(QUADRILLE_MESSAGE("an accessor of indices does not hold unsigned integers"));
    return read<std::uint32_t>(accessor, components, expectedCount,
                               [](const Layout& layout, const std::byte* at) -> std::uint32_t {
                                   switch (layout.componentBytes) {
                                   case 1:
                                       return load<std::uint8_t>(at);
                                   case 2:
                                       return load<std::uint16_t>(at);
                                   default:
                                       return load<std::uint32_t>(at);
                                   }
                               });
}

} // namespace quadrille
