// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/resultstore.h"

#include "model/core/error.h"

namespace quadrille {

std::filesystem::path ResultStore::fileOf(const std::string& stage) const
{
    return m_folder / (stage + ".h5");
}

ResultStore::Entry ResultStore::load(const std::string& stage, const std::string& key) const
{
    const auto file = fileOf(stage);
    std::error_code error;
    if (!std::filesystem::exists(file, error))
        return {State::Missing, {}};
    try {
        const ResultHeader header = readResultHeader(file);
        Result result = readResultFile(file);
        const bool fits = header.key == key && header.stage == stage;
        return {fits ? State::Fresh : State::OtherKey, std::move(result)};
    } catch (const Error& failure) {
        if (failure.code() != ErrorCode::ResultDamaged && failure.code() != ErrorCode::FileEmpty)
            throw;
        return {State::Damaged, {}};
    }
}

void ResultStore::save(const std::string& stage, const std::string& key, const Result& result) const
{
    writeResultFile(fileOf(stage), {stage, key}, result);
}

} // namespace quadrille
