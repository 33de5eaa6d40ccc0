// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/transferwork.h"

#include "model/core/contains.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/fields/writefields.h"
#include "model/project/media/sequencesettings.h"

namespace quadrille {

TransferWork::TransferWork(std::shared_ptr<SequenceOpener> opener, TransferEntry entry)
    : m_opener(std::move(opener)), m_entry(std::move(entry))
{
}

std::string TransferWork::character() const
{
    return characterOfClip(project(), clipName());
}

std::vector<std::filesystem::path> TransferWork::files(const Progress& progress) const
{
    std::vector<std::filesystem::path> all;
    for (const std::string& sequence : sequences()) {
        const auto own = m_opener->filesOf(sequence, progress);
        all.insert(all.end(), own.begin(), own.end());
    }
    return all;
}

std::string TransferWork::settings() const
{
    TransferEntry entry = m_entry;
    entry.name.clear();
    entry.clip.clear();
    entry.truth.clear(); // the target's name is in the clip
    if (entry.reference)
        entry.reference->sequence.clear();
    std::string text = settingsText(entry);
    for (const std::string& name : sequences()) {
        if (const SequenceEntry* sequence = findSequence(project(), name))
            text += sequenceSettings(project(), *sequence) + contactSettings(*sequence);
    }
    return text;
}

std::vector<std::string> TransferWork::inputs() const
{
    std::vector<std::string> steps = clipStepsOf(project(), m_entry.clip);
    for (std::string& step : clipInputs(project(), sequences())) {
        if (!contains(steps, step))
            steps.push_back(std::move(step));
    }
    return steps;
}

std::vector<std::string> TransferWork::sequences() const
{
    std::vector<std::string> names{m_entry.target.sequence};
    const auto add = [&](const std::string& name) {
        if (!contains(names, name))
            names.push_back(name);
    };
    for (const std::string& name : templateSequences(project(), m_entry))
        add(name);
    if (const auto name = nameOfClip(m_entry.clip, "sequences"))
        add(*name);
    return names;
}

} // namespace quadrille
