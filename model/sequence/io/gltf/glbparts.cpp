// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/gltf/glbparts.h"

#include "model/core/error.h"
#include "model/core/file.h"

#include <cerrno>

namespace quadrille {

std::size_t GlbParts::addView(std::uint64_t bytes, Source source)
{
    Json view = {{"buffer", 0}, {"byteOffset", m_bytes}, {"byteLength", bytes}};
    json["bufferViews"].push_back(std::move(view));
    m_parts.push_back({std::move(source), (4 - bytes % 4) % 4});
    m_bytes += (bytes + 3) / 4 * 4;
    return json["bufferViews"].size() - 1;
}

std::size_t GlbParts::addAccessor(Json accessor)
{
    json["accessors"].push_back(std::move(accessor));
    return json["accessors"].size() - 1;
}

std::size_t GlbParts::addArray(std::size_t view, int type, std::uint64_t count, const char* shape)
{
    return addAccessor({{"bufferView", view}, {"componentType", type}, {"count", count}, {"type", shape}});
}

void GlbParts::finish()
{
    json["asset"] = {{"version", "2.0"}, {"generator", "Quadrille"}};
    json["buffers"] = Json::array({{{"byteLength", m_bytes}}});
    m_text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    m_text.resize((m_text.size() + 3) / 4 * 4, ' ');
}

void GlbParts::write(const std::filesystem::path& file, const std::filesystem::path& named,
                     const Progress& progress) const
{
    std::ofstream out(file, std::ios::binary);
    const auto check = [&] {
        if (!out)
            throwSystemError(named, errno, ErrorCode::WriteFailed);
    };
    check();
    const auto number = [&](std::uint64_t value) {
        const auto narrow = static_cast<std::uint32_t>(value);
        out.write(reinterpret_cast<const char*>(&narrow), sizeof(narrow));
    };
    out << "glTF";
    number(2);
    number(fileBytes());
    number(m_text.size());
    out << "JSON" << m_text;
    number(m_bytes);
    out.write("BIN\0", 4);
    for (std::size_t p = 0; p < m_parts.size(); ++p) {
        progress.report(static_cast<std::int64_t>(p), static_cast<std::int64_t>(m_parts.size()));
        m_parts[p].write(out);
        out.write("\0\0\0", static_cast<std::streamsize>(m_parts[p].padding));
        check();
    }
    out.flush();
    check();
}

} // namespace quadrille
