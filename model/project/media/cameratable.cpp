// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/media/cameratable.h"

#include "model/core/error.h"
#include "model/core/file.h"
#include "model/project/document/paths.h"
#include "model/project/json/objectreader.h"
#include "model/sequence/io/files/sourcefiles.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// The numbers of lists within lists, one after the other; nothing where there is something else.
bool addNumbers(const Json& value, std::vector<double>& numbers)
{
    if (value.is_number()) {
        numbers.push_back(value.get<double>());
        return true;
    }
    return value.is_array() &&
           std::ranges::all_of(value, [&](const Json& item) { return addNumbers(item, numbers); });
}

/// So many numbers, in rows or not; empty where they are not that, which is told.
std::vector<double> numbersOf(const ObjectReader& reader, const char* key, std::size_t count,
                              const std::string& expected)
{
    const Json* value = reader.find(key);
    std::vector<double> numbers;
    if (value == nullptr)
        reader.missing(key);
    else if (!addNumbers(*value, numbers) || numbers.size() != count)
        reader.wrongType(key, expected);
    else
        return numbers;
    return {};
}

void readMatrix(const ObjectReader& reader, PinholeCamera& camera)
{
    const std::vector<double> m = numbersOf(reader, "matrix", 9, "[[fx, 0, cx], [0, fy, cy], [0, 0, 1]]");
    if (m.empty())
        return;
    if (m[1] != 0 || m[3] != 0 || m[6] != 0 || m[7] != 0 || m[8] != 1)
        reader.invalid(reader.pointer("matrix"), "A camera that shears or scales otherwise is not known",
                       "Write [[fx, 0, cx], [0, fy, cy], [0, 0, 1]].");
    camera.fx = m[0];
    camera.fy = m[4];
    camera.cx = m[2];
    camera.cy = m[5];
}

void readDistortion(const ObjectReader& reader, PinholeCamera& camera)
{
    std::vector<double> numbers;
    const Json* value = reader.find("distortion");
    if (value == nullptr)
        return;
    if (!addNumbers(*value, numbers) || numbers.size() > camera.distortion.size())
        reader.wrongType("distortion", "up to five numbers: k1, k2, p1, p2 and k3, as OpenCV has them");
    else
        std::ranges::copy(numbers, camera.distortion.begin());
}

SourceFiles picturesAt(const fs::path& named)
{
    std::error_code error;
    if (fs::is_directory(named, error))
        return findPattern(named / "*");
    if (isPattern(named))
        return findPattern(named);
    if (!fs::exists(named, error))
        throw Error(ErrorCode::FileNotFound, {named, {}, {}});
    return {.path = named, .files = {named}};
}

std::map<std::int64_t, fs::path> readPictures(const ObjectReader& reader, const fs::path& folder)
{
    const std::string named = reader.requiredText("images");
    const auto first = reader.wholeNumber("first_frame");
    if (named.empty())
        return {};
    const SourceFiles source = picturesAt(resolvePath(named, folder));
    std::map<std::int64_t, fs::path> pictures;
    for (std::size_t i = 0; i < source.files.size(); ++i) {
        // Of one file alone the number does not matter.
        const std::int64_t frame = i < source.numbers.size()
                                       ? source.numbers[i] - first.value_or(source.numbers.front())
                                       : static_cast<std::int64_t>(i);
        pictures.emplace(frame, source.files[i]);
    }
    return pictures;
}

CameraSeries readCamera(const Json& item, const std::string& pointer, const fs::path& folder,
                        ProjectProblems& problems)
{
    const ObjectReader reader(item, pointer, problems);
    CameraSeries series;
    if (!reader.isObject()) // which the reader says
        return series;
    PinholeCamera& camera = series.camera;
    camera.name = reader.requiredText("name");
    if (const auto size = numbersOf(reader, "size", 2, "[width, height] of its pictures, in pixels");
        !size.empty()) {
        constexpr double largest = 1e6; // what fits whole numbers; what makes sense is looked at below
        camera.width = static_cast<int>(std::clamp(size[0], -largest, largest));
        camera.height = static_cast<int>(std::clamp(size[1], -largest, largest));
    }
    readMatrix(reader, camera);
    readDistortion(reader, camera);
    const auto rotation = numbersOf(reader, "rotation", 9, "three rows of three numbers");
    const auto translation = numbersOf(reader, "translation", 3, "three numbers");
    for (std::size_t i = 0; i < rotation.size(); ++i)
        camera.rotation(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) = rotation[i];
    for (std::size_t i = 0; i < translation.size(); ++i)
        camera.translation[static_cast<Eigen::Index>(i)] = translation[i];
    series.pictures = readPictures(reader, folder);
    const auto unknown = reader.unknown(
        {"name", "size", "matrix", "distortion", "rotation", "translation", "images", "first_frame"});
    if (!hasErrors(problems)) {
        if (const auto fault = faultOf(camera))
            reader.invalid(pointer, "The camera “" + camera.name + "” cannot be used. " + fault->reason,
                           fault->remedy);
    }
    return series;
}

} // namespace

fs::path CameraSeries::pictureOf(FrameIndex frame) const
{
    const auto found = pictures.find(frame.value);
    return found == pictures.end() ? fs::path() : found->second;
}

PinholeCamera converted(const PinholeCamera& camera, const CoordinateSystem& from, const CoordinateSystem& to)
{
    PinholeCamera result = camera;
    const Eigen::Matrix3d matrix = conversionMatrix(from, to).cast<double>();
    const double scale = matrix.row(0).norm();
    result.rotation = camera.rotation * (matrix / scale).transpose();
    result.translation = scale * camera.translation;
    return result;
}

std::vector<CameraSeries> readCameraTable(const fs::path& file, const std::optional<CoordinateSystem>& from,
                                          const CoordinateSystem& to)
{
    const FileContent content = readFile(file);
    const JsonText json = parseJson(content.text(), file);
    ProjectProblems problems;
    std::vector<CameraSeries> all;
    const ObjectReader reader(json.document, "", problems);
    reader.each("cameras", [&](const Json& item, const std::string& pointer) {
        CameraSeries series = readCamera(item, pointer, file.parent_path(), problems);
        if (std::ranges::any_of(
                all, [&](const CameraSeries& other) { return other.camera.name == series.camera.name; }))
            reader.invalid(pointer + "/name", "There are two cameras “" + series.camera.name + "”",
                           "Give each a name of its own.");
        if (from)
            series.camera = converted(series.camera, *from, to);
        all.push_back(std::move(series));
    });
    if (all.empty() && problems.empty())
        reader.invalid("", "There are no cameras here", "Write {\"cameras\": […]} with one object for each.");
    for (const ProjectProblem& problem : problems) {
        if (problem.severity != ProjectProblem::Severity::Error)
            continue;
        ErrorContext context = problem.context;
        context.file = file;
        context.place = problem.atKey ? json.placeOfKey(problem.pointer) : json.placeOf(problem.pointer);
        throw Error(problem.code, context);
    }
    return all;
}

} // namespace quadrille
