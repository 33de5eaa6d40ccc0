// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/file/migration.h"

#include <algorithm>

namespace quadrille {

namespace {

[[noreturn]] void throwInvalid(const std::filesystem::path& file, const ErrorPlace& place,
                               const std::string& reason, const std::string& remedy)
{
    throw Error(ErrorCode::ProjectInvalid, {file, place, {{"reason", reason}, {"remedy", remedy}}});
}

} // namespace

std::span<const Migration> projectMigrations()
{
    return {};
}

void migrate(JsonText& text, std::span<const Migration> migrations, int current,
             const std::filesystem::path& file)
{
    Json& document = text.document;
    if (!document.is_object() || !document.contains("format") || document["format"] != "quadrille-project") {
        throwInvalid(file, text.placeOf("/format"), "This is not a Quadrille project",
                     "A project says \"format\": \"quadrille-project\" at its beginning.");
    }
    const auto found = document.find("version");
    if (found == document.end() || !found->is_number_integer()) {
        throwInvalid(file, text.placeOf("/version"), "The project names no version",
                     "Write \"version\": " + std::to_string(current) + ".");
    }
    if (*found > current) {
        throw Error(
            ErrorCode::ProjectNewer,
            {file, text.placeOf("/version"), {{"found", found->dump()}, {"known", std::to_string(current)}}});
    }
    for (Json version = *found; version < current; version = document["version"]) {
        const auto step = std::find_if(migrations.begin(), migrations.end(),
                                       [&](const Migration& migration) { return version == migration.from; });
        if (step == migrations.end()) {
            throwInvalid(file, text.placeOf("/version"),
                         "There never was a project of version " + version.dump(),
                         "Write \"version\": " + std::to_string(current) + ".");
        }
        step->apply(document);
        document["version"] = step->from + 1;
    }
}

} // namespace quadrille
