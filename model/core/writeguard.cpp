// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/writeguard.h"

#include "model/core/contenthash.h"
#include "model/core/error.h"
#include "model/core/file.h"
#include "model/core/message.h"

#include <algorithm>
#include <utility>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// Why a file may not be written, and what to do.
struct Refusal
{
    const char* reason;
    const char* remedy;
};
constexpr Refusal isInput{QUADRILLE_MESSAGE("“{name}” is an input ({what}): inputs are never written over"),
                          QUADRILLE_MESSAGE("Write to another file.")};
constexpr Refusal isElsewhere{
    QUADRILLE_MESSAGE("“{name}” would lie outside of the project's folder, {what}"),
    QUADRILLE_MESSAGE("Choose a place inside, or allow this one (--allow-outside on the command line).")};
constexpr Refusal isWrittenTwice{QUADRILLE_MESSAGE("“{name}” is written by {what}, too"),
                                 QUADRILLE_MESSAGE("Give one of them another path.")};

[[noreturn]] void refuse(const Refusal& refusal, const fs::path& file, const std::string& what)
{
    throw Error(ErrorCode::BadArgument, {file,
                                         {},
                                         {{"reason", refusal.reason},
                                          {"remedy", refusal.remedy},
                                          {"name", file.filename().string()},
                                          {"what", what}}});
}

bool isThere(const fs::path& file)
{
    std::error_code error;
    return fs::exists(fs::symlink_status(file, error));
}

/// A link is not the file that was written, wherever it points.
bool holds(const fs::path& file, const std::string& hash)
{
    std::error_code error;
    return fs::is_regular_file(fs::symlink_status(file, error)) && hashFile(file) == hash;
}

} // namespace

bool NumberedNames::contains(const std::string& name) const
{
    if (name.size() <= before.size() + after.size() || !name.starts_with(before) || !name.ends_with(after))
        return false;
    const auto digits =
        std::string_view(name).substr(before.size(), name.size() - before.size() - after.size());
    return std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
}

void WriteGuard::protect(const ProtectedFile& input)
{
    const std::scoped_lock lock(m_mutex);
    m_inputs.emplace(resolvedPlace(input.file), input.what);
    m_inputs.emplace(resolvedFolder(input.file), input.what);
    if (const auto identity = identityOf(input.file))
        m_inputFiles.emplace(*identity, input.what);
}

void WriteGuard::protectFolder(const ProtectedFile& folder)
{
    m_folders.emplace(resolvedFolder(folder.file), folder.what);
}

void WriteGuard::protectNames(const ProtectedFile& folder, std::function<bool(const std::string&)> belongs)
{
    m_names.push_back({resolvedFolder(folder.file), folder.what, std::move(belongs)});
}

void WriteGuard::protectLater(std::function<std::vector<ProtectedFile>()> find)
{
    m_findInputs = std::move(find);
}

void WriteGuard::confineTo(const fs::path& folder)
{
    m_root = resolvedFolder(folder);
}

void WriteGuard::know(const fs::path& file, const std::string& hash)
{
    m_known[resolvedPlace(file)] = hash;
}

void WriteGuard::findLateInputs()
{
    const std::scoped_lock lock(m_mutex);
    if (const auto find = std::exchange(m_findInputs, nullptr)) {
        for (const ProtectedFile& input : find())
            protect(input);
    }
}

const std::string* WriteGuard::inputAt(const fs::path& file, const fs::path& place) const
{
    const std::scoped_lock lock(m_mutex);
    if (const auto input = m_inputs.find(place); input != m_inputs.end())
        return &input->second;
    if (const auto identity = identityOf(file)) {
        if (const auto input = m_inputFiles.find(*identity); input != m_inputFiles.end())
            return &input->second;
    }
    for (const auto& [folder, what] : m_folders) {
        if (liesIn(place, folder))
            return &what;
    }
    const auto names = std::find_if(m_names.begin(), m_names.end(), [&](const Names& each) {
        return each.folder == place.parent_path() && each.belongs(place.filename().string());
    });
    return names == m_names.end() ? nullptr : &names->what;
}

bool WriteGuard::isOutside(const fs::path& file) const
{
    return m_root && !liesIn(resolvedPlace(file).parent_path(), *m_root);
}

void WriteGuard::checkFolder(const fs::path& folder) const
{
    if (m_root && !m_permissions.outside && !liesIn(resolvedFolder(folder), *m_root))
        refuse(isElsewhere, folder, m_root->string());
}

void WriteGuard::checkPlace(const fs::path& file)
{
    const fs::path place = resolvedPlace(file);
    if (isOutside(file) && !m_permissions.outside)
        refuse(isElsewhere, file, m_root->string());
    if (isThere(file))
        findLateInputs();
    if (const std::string* what = inputAt(file, place))
        refuse(isInput, file, *what);
}

void WriteGuard::checkSeries(const NumberedNames& series)
{
    const fs::path folder = resolvedFolder(series.folder);
    checkPlace(series.folder / (series.before + "0000" + series.after));
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        if (series.contains(entry->path().filename().string()))
            checkPlace(entry->path());
    }
    const std::scoped_lock lock(m_mutex);
    for (const auto& [place, what] : m_inputs) {
        if (place.parent_path() == folder && series.contains(place.filename().string()))
            refuse(isInput, place, what);
    }
}

void refuseTwice(const fs::path& file, const std::string& name, const std::string& other)
{
    refuse(isWrittenTwice, file.parent_path() / name, other);
}

void refuseExisting(const fs::path& file)
{
    constexpr Refusal isForeign{
        QUADRILLE_MESSAGE("“{name}” is there already, and the program did not write it as it is"),
        QUADRILLE_MESSAGE("Move it away, or allow to replace it (--overwrite on the command line).")};
    refuse(isForeign, file, {});
}

bool WriteGuard::isForeign(const fs::path& file) const
{
    if (!isThere(file))
        return false;
    const auto known = m_known.find(resolvedPlace(file));
    return known == m_known.end() || !holds(file, known->second);
}

void WriteGuard::checkPut(const Move& move, const std::string& hash)
{
    checkPlace(move.to);
    if (!isThere(move.to) || holds(move.to, hash))
        return;
    if (m_written.contains(resolvedPlace(move.to)))
        refuse(isWrittenTwice, move.to, "another export");
    if (!m_permissions.overwrite && isForeign(move.to))
        refuseExisting(move.to);
}

void WriteGuard::put(std::span<const Move> moves)
{
    std::vector<std::string> hashes;
    hashes.reserve(moves.size());
    for (const Move& move : moves)
        hashes.push_back(hashFile(move.from));
    const std::scoped_lock lock(m_mutex);
    for (std::size_t i = 0; i < moves.size(); ++i)
        checkPut(moves[i], hashes[i]);
    for (std::size_t i = 0; i < moves.size(); ++i) {
        std::error_code error;
        fs::create_directories(moves[i].to.parent_path(), error);
        if (!error)
            fs::rename(moves[i].from, moves[i].to, error);
        if (error)
            throwSystemError(moves[i].to, error.value(), ErrorCode::WriteFailed);
        m_written[resolvedPlace(moves[i].to)] = hashes[i];
    }
}

std::map<fs::path, std::string> WriteGuard::written() const
{
    const std::scoped_lock lock(m_mutex);
    return m_written;
}

} // namespace quadrille
