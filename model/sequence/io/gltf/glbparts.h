// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace quadrille {

/// A GLB file on its way: its document, and where the bytes of its buffer will come from. They are asked for
/// when the file is written, so that they never lie in memory together.
class GlbParts
{
public:
    using Json = nlohmann::ordered_json;
    using Source = std::function<void(std::ostream&)>;

    static constexpr int floatType = 5126;
    static constexpr int uintType = 5125;

    Json json = Json::object();

    /// Adds a buffer view whose bytes `source` will write. \return its index.
    std::size_t addView(std::uint64_t bytes, Source source);
    /// \overload of values that are kept.
    template <typename T>
    std::size_t addView(std::vector<T> values)
    {
        const std::uint64_t bytes = values.size() * sizeof(T);
        return addView(bytes, [values = std::move(values), bytes](std::ostream& out) {
            out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(bytes));
        });
    }
    std::size_t addAccessor(Json accessor);
    /// An accessor of a whole view. \param shape "VEC3", "SCALAR", …
    std::size_t addArray(std::size_t view, int type, std::uint64_t count, const char* shape);

    /// Bytes of the whole file, once `finish` was called.
    std::uint64_t fileBytes() const { return 28 + m_text.size() + m_bytes; }
    std::uint64_t bufferBytes() const { return m_bytes; }
    /// Nothing is added any more.
    void finish();
    /// \pre finish() was called. \throws Error WriteFailed (of `named`), Cancelled, what the sources throw.
    void write(const std::filesystem::path& file, const std::filesystem::path& named,
               const Progress& progress) const;

private:
    struct Part
    {
        Source write;
        std::uint64_t padding;
    };

    std::vector<Part> m_parts;
    std::uint64_t m_bytes = 0;
    std::string m_text;
};

} // namespace quadrille
