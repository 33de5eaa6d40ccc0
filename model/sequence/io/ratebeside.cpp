// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/ratebeside.h"

#include "model/core/file.h"
#include "model/sequence/io/bvh.h"
#include "model/sequence/io/files/sourcefiles.h"
#include "model/sequence/io/mdd.h"
#include "model/sequence/io/pc2.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <vector>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

using Evidence = RateBeside::Evidence;

constexpr double lowest = 1;
constexpr double highest = 1000;
constexpr std::array<const char*, 6> takeEndings{".pc2", ".mdd", ".npy", ".bvh", ".h5", ".glb"};
/// Files of one kind that are looked into; more say nothing new.
constexpr std::size_t mostFiles = 24;
constexpr std::uintmax_t mostBytesOfNotes = 1'000'000;

bool isPlausible(double fps)
{
    return fps >= lowest && fps <= highest;
}

bool areAlike(double a, double b)
{
    constexpr double rounding = 1e-3;
    return std::abs(a - b) <= rounding * b;
}

/// Where what speaks of a take may lie.
struct TakePlace
{
    std::vector<fs::path> names; ///< of the take, as paths without an ending
    fs::path folder;             ///< that holds its files
    fs::path above;              ///< the folder of a series' folder; empty for a single file
};

TakePlace placeOf(const fs::path& source)
{
    std::error_code error;
    fs::path file = fs::absolute(source).lexically_normal();
    if (!file.has_filename())
        file = file.parent_path();
    if (fs::is_directory(file, error))
        return {{file, file / file.filename()}, file, file.parent_path()};
    const fs::path folder = file.parent_path();
    if (!isPattern(file))
        return {{folder / file.stem()}, folder, {}};
    std::string stem = file.stem().string();
    stem.erase(std::min(stem.find_first_of("#%*?["), stem.size()));
    stem.erase(stem.find_last_not_of("_-. ") + 1);
    return {{folder / stem, folder}, folder, folder.parent_path()};
}

fs::path withEnding(fs::path name, const char* ending)
{
    name += ending;
    return name;
}

/// Regular files of a folder with one of some endings, by name.
std::vector<fs::path> filesWith(const fs::path& folder, std::initializer_list<std::string_view> endings)
{
    std::vector<fs::path> files;
    std::error_code error;
    for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        std::error_code unreadable;
        const std::string ending = lowerExtension(entry->path());
        if (entry->is_regular_file(unreadable) &&
            std::find(endings.begin(), endings.end(), ending) != endings.end())
            files.push_back(entry->path());
    }
    std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
        return naturalLess(a.filename().string(), b.filename().string());
    });
    if (files.size() > mostFiles)
        files.resize(mostFiles);
    return files;
}

std::optional<Bvh> motionIn(const fs::path& file)
{
    std::error_code error;
    if (!fs::is_regular_file(file, error))
        return std::nullopt;
    try {
        Bvh bvh = readBvh(file);
        return isPlausible(bvh.fps) ? std::optional(std::move(bvh)) : std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// The rate of a take whose motion has so many frames at a rate: the same where the counts agree, a whole
/// part of it where the motion was captured more finely.
std::optional<double> rateFrom(const Bvh& motion, std::int64_t frameCount)
{
    if (frameCount < 2 || std::abs(motion.frameCount - frameCount) <= 1)
        return motion.fps;
    const double finer = static_cast<double>(motion.frameCount) / static_cast<double>(frameCount);
    const double times = std::round(finer);
    constexpr double cut = 0.02; // a frame or two may be missing at the end
    if (times >= 1 && std::abs(finer - times) <= cut * times && isPlausible(motion.fps / times))
        return motion.fps / times;
    return std::nullopt;
}

std::optional<RateBeside> fromOwnMotion(const TakePlace& take, std::int64_t frameCount)
{
    for (const fs::path& name : take.names) {
        const fs::path file = withEnding(name, ".bvh");
        if (const auto motion = motionIn(file)) {
            if (const auto fps = rateFrom(*motion, frameCount))
                return RateBeside{*fps, Evidence::OwnMotion, file};
        }
    }
    return std::nullopt;
}

/// The rate that all of some files name; nothing where none does, or two differ.
template <typename Rate>
std::optional<RateBeside> agreed(const std::vector<fs::path>& files, Evidence evidence, const Rate& rateOf)
{
    std::optional<RateBeside> found;
    for (const fs::path& file : files) {
        const std::optional<double> fps = rateOf(file);
        if (!fps)
            continue;
        if (found && !areAlike(*fps, found->fps))
            return std::nullopt;
        if (!found)
            found = RateBeside{*fps, evidence, file};
    }
    return found;
}

/// The rate that the members of a JSON object name, as frames a second or as seconds of a frame.
void addRates(const nlohmann::json& json, int depth, std::vector<double>& rates)
{
    constexpr int deepest = 3;
    if (!json.is_object() || depth > deepest)
        return;
    for (const auto& [key, value] : json.items()) {
        std::string word;
        for (const char c : key) {
            if (c != '_' && c != '-' && c != ' ')
                word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
        if (value.is_number() && (word == "fps" || word == "framerate" || word == "framespersecond"))
            rates.push_back(value.get<double>());
        else if (value.is_number() && word == "frametime" && value.get<double>() > 0)
            rates.push_back(1 / value.get<double>());
        addRates(value, depth + 1, rates);
    }
}

std::optional<double> onlyRate(const std::vector<double>& rates)
{
    const bool isOne = !rates.empty() && std::all_of(rates.begin(), rates.end(), [&](double rate) {
        return isPlausible(rate) && areAlike(rate, rates.front());
    });
    return isOne ? std::optional(rates.front()) : std::nullopt;
}

std::optional<double> rateInNotes(const fs::path& file)
{
    std::error_code error;
    if (fs::file_size(file, error) > mostBytesOfNotes || error)
        return std::nullopt;
    try {
        const FileContent content = readFile(file);
        std::vector<double> rates;
        if (lowerExtension(file) == ".json") {
            addRates(nlohmann::json::parse(content.text(), nullptr, false), 0, rates);
            return onlyRate(rates);
        }
        const std::string text(content.text());
        static const std::regex said(R"((\d+(?:\.\d+)?) ?(?:fps|frames ?(?:/ ?s|per second|a second))\b)",
                                     std::regex::icase);
        for (std::sregex_iterator at(text.begin(), text.end(), said), end; at != end; ++at)
            rates.push_back(std::stod((*at)[1].str()));
        return onlyRate(rates);
    } catch (const Error&) {
        return std::nullopt;
    } catch (const std::exception&) { // of numbers beyond all bounds, and of texts too intricate to search
        return std::nullopt;
    }
}

std::optional<RateBeside> fromOwnNotes(const TakePlace& take)
{
    for (const fs::path& name : take.names) {
        for (const char* ending : {".json", ".txt"}) {
            if (auto found = agreed({withEnding(name, ending)}, Evidence::Notes, rateInNotes))
                return found;
        }
    }
    return std::nullopt;
}

/// Whether a file speaks of all takes of its folder: a JSON file that bears no take's name, or a read-me.
bool isAboutAll(const fs::path& file)
{
    std::error_code error;
    if (lowerExtension(file) == ".json")
        return std::none_of(takeEndings.begin(), takeEndings.end(), [&](const char* ending) {
            return fs::exists(fs::path(file).replace_extension(ending), error);
        });
    std::string stem = file.stem().string();
    std::transform(stem.begin(), stem.end(), stem.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return stem.starts_with("readme") || stem == "notes" || stem == "info" || stem == "about";
}

/// Notes in the folder of the take; above that of a series only read-mes.
std::optional<RateBeside> fromNotes(const TakePlace& take)
{
    std::vector<fs::path> notes = filesWith(take.folder, {".json", ".txt", ".md"});
    std::erase_if(notes, [](const fs::path& file) { return !isAboutAll(file); });
    if (auto found = agreed(notes, Evidence::Notes, rateInNotes))
        return found;
    if (take.above.empty())
        return std::nullopt;
    notes = filesWith(take.above, {".txt", ".md"});
    std::erase_if(notes, [](const fs::path& file) { return !isAboutAll(file); });
    return agreed(notes, Evidence::Notes, rateInNotes);
}

std::optional<double> rateOfCache(const fs::path& file)
{
    try {
        const InputFile input(file);
        const auto fps = (lowerExtension(file) == ".mdd" ? readMddLayout(input) : readPc2Layout(input)).fps;
        return fps && isPlausible(*fps) ? fps : std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

std::optional<double> rateOfMotion(const fs::path& file)
{
    const auto motion = motionIn(file);
    return motion ? std::optional(motion->fps) : std::nullopt;
}

} // namespace

std::string RateBeside::toString() const
{
    std::array<char, 32> text{};
    constexpr int digits = 6;
    const auto* end =
        std::to_chars(text.data(), text.data() + text.size(), fps, std::chars_format::general, digits).ptr;
    return std::string(text.data(), static_cast<std::size_t>(end - text.data())) + " fps, as in " +
           file.filename().string() + " beside it";
}

std::optional<RateBeside> rateBeside(const fs::path& source, std::int64_t frameCount)
{
    const TakePlace take = placeOf(source);
    if (auto found = fromOwnMotion(take, frameCount))
        return found;
    if (auto found = fromOwnNotes(take))
        return found;
    if (auto found = agreed(filesWith(take.folder, {".bvh"}), Evidence::OtherMotions, rateOfMotion))
        return found;
    if (auto found = fromNotes(take))
        return found;
    return agreed(filesWith(take.folder, {".pc2", ".mdd"}), Evidence::OtherTakes, rateOfCache);
}

} // namespace quadrille
