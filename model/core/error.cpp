// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"

namespace quadrille {

std::string ErrorPlace::toString() const
{
    std::string text;
    const auto add = [&text](const char* name, std::int64_t value) {
        text += text.empty() ? "" : ", ";
        text += name + std::to_string(value);
    };
    if (frame)
        add("frame ", frame->value);
    if (line)
        add("line ", *line);
    if (column)
        add("column ", *column);
    if (byte)
        add("byte ", *byte);
    return text;
}

std::string fillMessage(std::string_view sentence, const ErrorContext& context)
{
    std::string filled(sentence);
    for (const auto& [name, value] : context.values) {
        const std::string key = "{" + name + "}";
        for (auto at = filled.find(key); at != std::string::npos; at = filled.find(key, at + value.size()))
            filled.replace(at, key.size(), value);
    }
    return filled;
}

namespace {

std::string describe(const ErrorMessage& message, const ErrorContext& context)
{
    std::string text = context.file.empty() ? "" : context.file.string() + ": ";
    text += fillMessage(message.sentence, context);
    if (const auto remedy = fillMessage(message.remedy, context); !remedy.empty())
        text += " " + remedy;
    if (const auto place = context.place.toString(); !place.empty())
        text += " (" + place + ")";
    return text;
}

} // namespace

Error::Error(ErrorCode code, ErrorContext context)
    : m_code(code), m_context(std::move(context)), m_what(describe(errorMessage(code), m_context))
{
}

std::string Issue::toString() const
{
    return describe(issueMessage(code), context);
}

} // namespace quadrille
