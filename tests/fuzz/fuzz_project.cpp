// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/project.h"
#include "model/project/file/projectfile.h"
#include "model/project/file/projectjson.h"
#include "model/project/json/jsontext.h"

#include <cstdlib>

/// Whatever the text, reading gives a project with problems or a quadrille::Error; what reads without
/// problems reads back equal from what is written.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace quadrille;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const ProjectReading first = readProject(text, "fuzz.quadrille");
        if (!hasErrors(first.problems)) {
            const std::string written = writeJson(projectToJson(first.project));
            if (readProject(written, "again.quadrille").project != first.project)
                std::abort();
        }
    } catch (const Error&) {
        return 0;
    }
    return 0;
}
