// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"

#include <Eigen/Core>
#include <bit>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace quadrille {

static_assert(std::endian::native == std::endian::little, "Files are written as values lie in memory.");

/// Values that are written as they lie in memory.
template <typename Value>
concept PlainValue = std::is_arithmetic_v<Value> || std::is_enum_v<Value>;

/// Appends values to bytes. Together with BakedReader: what is said once of the members of a value, by a
/// function `bake(bytes, value)` that hands them over in their order, both writes and reads it.
class BakedWriter
{
public:
    static constexpr bool isReading = false;

    template <PlainValue Value>
    void operator()(const Value& value)
    {
        append(&value, sizeof(Value));
    }
    void operator()(const std::string& text)
    {
        (*this)(static_cast<std::uint64_t>(text.size()));
        append(text.data(), text.size());
    }
    /// Values without padding: their count, then all of them.
    template <typename Value>
    void list(const std::vector<Value>& values)
    {
        static_assert(std::has_unique_object_representations_v<Value> || std::is_floating_point_v<Value>);
        (*this)(static_cast<std::uint64_t>(values.size()));
        append(values.data(), values.size() * sizeof(Value));
    }
    template <int size>
    void list(const std::vector<Eigen::Matrix<float, size, 1>>& vectors)
    {
        (*this)(static_cast<std::uint64_t>(vectors.size()));
        for (const auto& vector : vectors)
            append(vector.data(), size * sizeof(float));
    }
    /// Values that are baked one by one. \param leastBytes  of each.
    template <typename Value, typename Bake>
    void each(const std::vector<Value>& values, Bake bakeOne, std::size_t /*leastBytes*/ = 1)
    {
        (*this)(static_cast<std::uint64_t>(values.size()));
        for (const Value& value : values)
            bakeOne(value);
    }

    const std::string& bytes() const { return m_bytes; }
    /// Keeps what was allocated.
    void clear() { m_bytes.clear(); }

private:
    void append(const void* data, std::size_t size) { m_bytes.append(static_cast<const char*>(data), size); }

    std::string m_bytes;
};

/// Takes values from bytes. Never reads beyond them, nor makes more of them than they can hold.
class BakedReader
{
public:
    static constexpr bool isReading = true;

    /// Both are referred to. \param begin  where in the file the bytes begin.
    BakedReader(std::span<const std::byte> bytes, const std::filesystem::path& file, std::size_t begin)
        : m_bytes(bytes), m_file(file), m_begin(begin)
    {
    }

    /// \throws Error FileSyntax, as all that follow.
    template <PlainValue Value>
    void operator()(Value& value)
    {
        if constexpr (std::is_same_v<Value, bool>) {
            std::uint8_t raw = 0;
            take(&raw, sizeof raw);
            if (raw > 1)
                refuse("a truth value is neither 0 nor 1");
            value = raw == 1;
        } else {
            take(&value, sizeof(Value));
        }
    }
    void operator()(std::string& text)
    {
        text.resize(count(1));
        take(text.data(), text.size());
    }
    template <typename Value>
    void list(std::vector<Value>& values)
    {
        values.resize(count(sizeof(Value)));
        take(values.data(), values.size() * sizeof(Value));
    }
    /// \throws also where one is infinite or not a number.
    template <int size>
    void list(std::vector<Eigen::Matrix<float, size, 1>>& vectors)
    {
        vectors.resize(count(size * sizeof(float)));
        for (auto& vector : vectors) {
            take(vector.data(), size * sizeof(float));
            if (!vector.allFinite())
                refuse("a coordinate is infinite, or not a number");
        }
    }
    template <typename Value, typename Bake>
    void each(std::vector<Value>& values, Bake bakeOne, std::size_t leastBytes = 1)
    {
        values.resize(count(leastBytes));
        for (Value& value : values)
            bakeOne(value);
    }

    bool isAtEnd() const { return m_at == m_bytes.size(); }
    /// \param reason  in words that end a sentence.
    [[noreturn]] void refuse(const std::string& reason) const
    {
        throw Error(ErrorCode::FileSyntax,
                    {m_file, {.byte = static_cast<std::int64_t>(m_begin + m_at)}, {{"reason", reason}}});
    }

private:
    void take(void* out, std::size_t size)
    {
        if (size > m_bytes.size() - m_at)
            refuse("the data end within a value");
        if (size > 0)
            std::memcpy(out, m_bytes.data() + m_at, size);
        m_at += size;
    }
    std::size_t count(std::size_t leastBytes)
    {
        std::uint64_t count = 0;
        (*this)(count);
        if (count > (m_bytes.size() - m_at) / leastBytes)
            refuse("more values are promised than there are");
        return static_cast<std::size_t>(count);
    }

    std::span<const std::byte> m_bytes;
    const std::filesystem::path& m_file;
    std::size_t m_begin;
    std::size_t m_at = 0;
};

/// A size as wide on all machines.
inline void bakeSize(BakedWriter& bytes, std::size_t size)
{
    bytes(static_cast<std::uint64_t>(size));
}
inline void bakeSize(BakedReader& bytes, std::size_t& size)
{
    std::uint64_t value = 0;
    bytes(value);
    size = static_cast<std::size_t>(value);
}

/// Numbers one after the other, to be read, or const.
template <typename Bytes, typename... Values>
void bakeAll(Bytes& bytes, Values&... values)
{
    (bytes(values), ...);
}

/// \param motion  a GroundMotion.
void bakeMotion(auto& bytes, auto& motion)
{
    bakeAll(bytes, motion.turn, motion.shift.x(), motion.shift.y());
}

/// \param point  a SpacePoint.
void bakePoint(auto& bytes, auto& point)
{
    for (auto& coordinate : point)
        bytes(coordinate);
}

} // namespace quadrille
