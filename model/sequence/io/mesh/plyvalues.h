// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/files/textscan.h"
#include "model/sequence/io/mesh/plyheader.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstring>

namespace quadrille {

/// Reads the values of a binary PLY body one after the other. Refers to its body.
class PlyBinaryValues
{
public:
    PlyBinaryValues(std::string_view body, bool isBigEndian)
        : m_at(body.data()), m_end(body.data() + body.size()), m_isBigEndian(isBigEndian)
    {
    }

    const char* place() const { return m_at; }
    /// \return false at the end of the file.
    template <typename Number>
    bool take(PlyType type, Number& value)
    {
        if (static_cast<std::size_t>(m_end - m_at) < sizeOf(type))
            return false;
        switch (type) {
        case PlyType::Int8:
            value = static_cast<Number>(raw<std::int8_t>()); // NOLINT(bugprone-signed-char-misuse): a number
            break;
        case PlyType::UInt8:
            value = static_cast<Number>(raw<std::uint8_t>());
            break;
        case PlyType::Int16:
            value = static_cast<Number>(raw<std::int16_t>());
            break;
        case PlyType::UInt16:
            value = static_cast<Number>(raw<std::uint16_t>());
            break;
        case PlyType::Int32:
            value = static_cast<Number>(raw<std::int32_t>());
            break;
        case PlyType::UInt32:
            value = static_cast<Number>(raw<std::uint32_t>());
            break;
        case PlyType::Float32:
            value = convert<Number>(raw<float>());
            break;
        case PlyType::Float64:
            value = convert<Number>(raw<double>());
            break;
        }
        return true;
    }
    bool skip(PlyType type, std::int64_t count)
    {
        const std::size_t size = sizeOf(type);
        if (static_cast<std::uint64_t>(count) > static_cast<std::size_t>(m_end - m_at) / size)
            return false;
        m_at += static_cast<std::size_t>(count) * size;
        return true;
    }

private:
    template <typename Value>
    Value raw()
    {
        std::array<char, sizeof(Value)> bytes;
        std::memcpy(bytes.data(), m_at, bytes.size());
        if (m_isBigEndian)
            std::reverse(bytes.begin(), bytes.end());
        m_at += bytes.size();
        Value value;
        std::memcpy(&value, bytes.data(), bytes.size());
        return value;
    }
    /// A real number as an index is out of every range unless it fits.
    template <typename Number, std::floating_point Value>
    static Number convert(Value value)
    {
        if constexpr (std::integral<Number>)
            return value >= -1e15 && value <= 1e15 ? static_cast<Number>(value) : Number{-1};
        else
            return static_cast<Number>(value);
    }

    const char* m_at;
    const char* m_end;
    bool m_isBigEndian;
};

/// Reads the values of an ASCII PLY body one after the other. Refers to its body.
class PlyTextValues
{
public:
    explicit PlyTextValues(std::string_view body) : m_at(body.data()), m_end(body.data() + body.size()) {}

    const char* place() const { return m_at; }
    template <typename Number>
    bool take(PlyType type, Number& value)
    {
        skipSpace();
        const char* behind = nullptr;
        if constexpr (std::integral<Number>) {
            behind = scanNumber(m_at, m_end, value);
            // Some writers give integers as 3.0.
            if (behind && behind != m_end && *behind == '.' && type >= PlyType::Float32) {
                float real = 0;
                behind = scanNumber(m_at, m_end, real);
            }
        } else {
            behind = scanNumber(m_at, m_end, value);
        }
        if (!behind)
            return false;
        m_at = behind;
        return true;
    }
    bool skip(PlyType type, std::int64_t count)
    {
        double ignored = 0;
        for (std::int64_t i = 0; i < count; ++i) {
            if (!take(type, ignored))
                return false;
        }
        return true;
    }

private:
    void skipSpace()
    {
        while (m_at != m_end && (*m_at == ' ' || *m_at == '\t' || *m_at == '\n' || *m_at == '\r'))
            ++m_at;
    }

    const char* m_at;
    const char* m_end;
};

/// Calls `read` with what reads the values of a file of this header.
template <typename Read>
decltype(auto) withPlyValues(const PlyHeader& header, std::string_view content, Read&& read)
{
    const std::string_view body = content.substr(header.size);
    if (header.encoding == PlyHeader::Encoding::Ascii) {
        PlyTextValues values(body);
        return read(values);
    }
    PlyBinaryValues values(body, header.encoding == PlyHeader::Encoding::BigEndian);
    return read(values);
}

} // namespace quadrille
