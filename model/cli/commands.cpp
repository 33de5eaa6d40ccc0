// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/cli/commands.h"

#include "model/project/document/lengthunit.h"

#include <charconv>
#include <cmath>

namespace quadrille::cli {

namespace {

template <typename Number>
std::optional<Number> parseNumber(std::string_view text)
{
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return number;
}

} // namespace

Project loadProject(const std::string& file, Console& console)
{
    ProjectReading reading = readProject(std::filesystem::path(file));
    for (const ProjectProblem& problem : reading.problems) {
        if (problem.severity == ProjectProblem::Severity::Warning)
            console.warn(problem.toString());
    }
    for (const ProjectProblem& problem : reading.problems) {
        if (problem.severity == ProjectProblem::Severity::Error)
            throw Error(problem.code, problem.context);
    }
    return std::move(reading.project);
}

void throwUsage(const std::string& text)
{
    throw CLI::ValidationError(text);
}

FrameRange parseRange(const std::string& text)
{
    const auto colon = text.find(':');
    if (colon != std::string::npos) {
        const auto first = parseNumber<std::int64_t>(std::string_view(text).substr(0, colon));
        const auto last = parseNumber<std::int64_t>(std::string_view(text).substr(colon + 1));
        if (first && last && *first >= 0 && *first <= *last)
            return {FrameIndex(*first), FrameIndex(*last)};
    }
    throwUsage("--range: “" + text + "” is not A:B with 0 ≤ A ≤ B");
}

CoordinateSystem AxesArguments::toAxes(const CoordinateSystem& fallback) const
{
    CoordinateSystem axes = fallback;
    if (!up.empty()) {
        const auto axis = upAxisFromString(up);
        if (!axis)
            throwUsage("“" + up + "” is no axis: x, y or z");
        axes.up = *axis;
    }
    if (!unit.empty()) {
        const auto named = metresPerUnit(unit);
        const auto metres = named ? named : parseNumber<double>(unit);
        if (!metres || !(*metres > 0) || !std::isfinite(*metres))
            throwUsage("“" + unit + "” is no unit: m, cm, mm, km, in, ft or metres");
        axes.metresPerUnit = *metres;
    }
    return axes;
}

void addOverwrite(CLI::App& command, bool& overwrite)
{
    command.add_flag("--overwrite", overwrite,
                     "Replace files that the program did not write itself; inputs are never replaced");
}

void addAllowOutside(CLI::App& command, bool& outside)
{
    command.add_flag("--allow-outside", outside, "Let the project write outside of its folder");
}

CLI::Validator positiveNumber()
{
    return CLI::Validator(
        [](const std::string& text) {
            const auto number = parseNumber<double>(text);
            const bool fits = number && *number > 0 && std::isfinite(*number);
            return fits ? std::string() : "“" + text + "” is not a positive number";
        },
        "POSITIVE");
}

} // namespace quadrille::cli
