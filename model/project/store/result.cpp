// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/store/result.h"

#include <array>

namespace quadrille {

std::size_t valueCount(const DataValues& values)
{
    return std::visit([](const auto& list) { return list.size(); }, values);
}

std::string typeName(const DataValues& values)
{
    static constexpr std::array<const char*, std::variant_size_v<DataValues>> names{"float32", "float64",
                                                                                    "int64", "uint8", "text"};
    return names.at(values.index());
}

} // namespace quadrille
