// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/json/jsonline.h"

#include <nlohmann/json.hpp>

namespace quadrille {

JsonLine::JsonLine(double value) : m_text(nlohmann::json(value).dump()) {}

JsonLine::JsonLine(const std::string& text) : m_text(nlohmann::json(text).dump()) {}

} // namespace quadrille
