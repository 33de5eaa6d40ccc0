// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/errorcode.h"
#include "model/core/units.h"

#include <cstdint>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille {

/// Where in a file or sequence an error lies; fields that do not apply stay empty.
struct ErrorPlace
{
    std::optional<std::int64_t> line;   ///< one-based
    std::optional<std::int64_t> column; ///< one-based
    std::optional<std::int64_t> byte;   ///< zero-based offset
    std::optional<FrameIndex> frame;    ///< zero-based

    /// "line 3, column 7", "byte 128", "frame 12", …; empty when nothing is known.
    std::string toString() const;
};

/// File, place and named values of an error, as data.
struct ErrorContext
{
    std::filesystem::path file;
    ErrorPlace place;
    /// Values by the names that the sentence of the code uses, e.g. {"expected", "8431"}.
    std::vector<std::pair<std::string, std::string>> values;
};

/// The one exception type of the model.
class Error : public std::exception
{
public:
    explicit Error(ErrorCode code, ErrorContext context = {});

    ErrorCode code() const noexcept { return m_code; }
    const ErrorContext& context() const noexcept { return m_context; }
    /// English, one line: "FILE: WHAT REMEDY (WHERE)".
    const char* what() const noexcept override { return m_what.c_str(); }

private:
    ErrorCode m_code;
    ErrorContext m_context;
    std::string m_what;
};

/// English sentence and remedy of a code; `{name}` stands for a value of the context.
struct ErrorMessage
{
    const char* sentence;
    const char* remedy;
};
ErrorMessage errorMessage(ErrorCode code);

/// Puts the context's values into a sentence of `errorMessage` (or a translation of it).
std::string fillMessage(std::string_view sentence, const ErrorContext& context);

/// A recoverable finding that is reported, not thrown: a gap in a numbering, triangulated polygons, …
struct Issue
{
    enum class Severity
    {
        Info,
        Warning,
    };
    enum class Code
    {
        NumberingGap,
        PolygonsTriangulated,
        NonManifoldEdges,
        DegenerateTriangles,
        UnusedVertices,
        DuplicateFaces,
        TextureMissing,
        TextureCountDiffers,
        MeshFound,
        FpsAssumed,
        FpsResampled,
        VerticesWelded,
        FileLarge,
        TexturesBeside,
        Other,
    };
    Severity severity = Severity::Warning;
    Code code = Code::Other;
    /// Values by the names that the sentence uses; "text" is the whole sentence for Code::Other.
    ErrorContext context;

    std::string toString() const;
};
ErrorMessage issueMessage(Issue::Code code);

} // namespace quadrille
