// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/appearancetraining.h"

#include "model/core/error.h"
#include "model/core/message.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/document/throwinvalid.h"

#include <algorithm>
#include <map>

namespace quadrille {

namespace {

const MeshSequence& withUvs(const OpenedSequence& opened, const SequenceOpener& opener,
                            const std::string& name)
{
    if (opened.sequence.topology->data().uvs.empty()) {
        const CharacterEntry* character =
            characterOf(opener.project(), *findSequence(opener.project(), name));
        const bool hasMesh = character != nullptr && !character->mesh.empty();
        throw Error(ErrorCode::NoUvs,
                    {.file = hasMesh ? resolvePath(character->mesh, opener.folder()) : opened.files.front()});
    }
    return opened.sequence;
}

/// Gathers the textures of sequences, each once.
class TrainingGatherer
{
public:
    explicit TrainingGatherer(const AppearanceEntry& entry) : m_entry(entry) {}

    void add(const MeshSequence& sequence)
    {
        if (!m_training.topology)
            m_training.topology = sequence.topology;
        for (FrameIndex frame(0); frame.value < sequence.frameCount(); ++frame.value) {
            const int index = sequence.textures.indexFor(sequence.sourceFrame(frame));
            if (index < 0 || isIncomplete(sequence.name, frame))
                continue;
            const std::int64_t row = rowOf(sequence.textures.textures()[static_cast<std::size_t>(index)]);
            m_training.rows.push_back({sequence.name, frame, row});
            if (m_entry.reference == NamedFrame{sequence.name, frame})
                m_training.reference = row;
        }
    }

    AppearanceTraining take() { return std::move(m_training); }

private:
    bool isIncomplete(const std::string& sequence, FrameIndex frame) const
    {
        return std::ranges::find(m_entry.completions, NamedFrame{sequence, frame}, &CompletionEntry::frame) !=
               m_entry.completions.end();
    }

    std::int64_t rowOf(const Texture& texture)
    {
        const auto next = static_cast<std::int64_t>(m_training.textures.size());
        const auto [known, isNew] = m_rows.try_emplace({texture.file, texture.embedded.get()}, next);
        if (isNew)
            m_training.textures.push_back(texture);
        return known->second;
    }

    const AppearanceEntry& m_entry;
    AppearanceTraining m_training;
    std::map<std::pair<std::filesystem::path, const Image*>, std::int64_t> m_rows;
};

} // namespace

TextureSource AppearanceTraining::source() const
{
    const auto first = textures.front().load();
    return {.count = std::ssize(textures),
            .read = [all = textures, width = first->width, height = first->height](std::int64_t index) {
                const Texture& texture = all[static_cast<std::size_t>(index)];
                auto picture = texture.load();
                if (picture->width != width || picture->height != height)
                    throwInvalid(texture.file,
                                 "The texture has " + sizeText(picture->width, picture->height) +
                                     " texels, the first one " + sizeText(width, height),
                                 QUADRILLE_MESSAGE("Give all textures of the character one size."));
                return picture;
            }};
}

std::vector<AppearanceFrame> AppearanceTraining::frames() const
{
    std::vector<AppearanceFrame> first(textures.size());
    for (const AppearanceRow& each : rows) {
        AppearanceFrame& frame = first[static_cast<std::size_t>(each.row)];
        if (frame.sequence.empty())
            frame = {each.sequence, each.frame};
    }
    return first;
}

std::vector<std::string> trainingSequences(const Project& project, const AppearanceEntry& entry)
{
    if (!entry.sequences.empty())
        return entry.sequences;
    std::vector<std::string> names;
    const std::string character = characterNameOf(project, entry);
    for (const SequenceEntry& sequence : project.sequences) {
        const CharacterEntry* of = characterOf(project, sequence);
        if ((of ? of->name : "") == character && !shownClip(project, sequence))
            names.push_back(sequence.name);
    }
    return names;
}

AppearanceTraining appearanceTraining(SequenceOpener& opener, const AppearanceEntry& entry,
                                      const Progress& progress)
{
    TrainingGatherer gatherer(entry);
    const std::vector<std::string> names = trainingSequences(opener.project(), entry);
    for (std::size_t i = 0; i < names.size(); ++i) {
        progress.report(static_cast<std::int64_t>(i), std::ssize(names));
        const auto opened = opener.open(names[i]);
        if (opened->sequence.textures.kind() == TextureSet::Kind::PerFrame)
            gatherer.add(withUvs(*opened, opener, names[i]));
        else if (!entry.sequences.empty())
            throwInvalid("“" + names[i] + "” has no texture for each frame",
                         QUADRILLE_MESSAGE("Give it one for each frame, or leave the sequence out."));
    }
    AppearanceTraining training = gatherer.take();
    if (training.textures.empty())
        throwInvalid({},
                     "No sequence that “" + entry.name + "” could learn from has a texture for each frame",
                     QUADRILLE_MESSAGE("Give sequences a folder of textures, one for each frame."));
    if (entry.reference && !training.reference)
        throwInvalid("The reference of “" + entry.name + "” is none of the frames that are learned",
                     QUADRILLE_MESSAGE("Name another one, or leave it out."));
    return training;
}

} // namespace quadrille
