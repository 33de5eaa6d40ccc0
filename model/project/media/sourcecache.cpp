// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/media/sourcecache.h"

#include "model/project/document/paths.h"
#include "model/project/media/opensequence.h"
#include "model/project/store/appearanceresult.h"
#include "model/project/store/resultstore.h"

#include <algorithm>
#include <tbb/task_arena.h>

namespace quadrille {

SourceCache::Key SourceCache::keyOf(const SequenceEntry& entry, const CharacterEntry* character,
                                    const ProjectSettings& settings, const std::filesystem::path& folder)
{
    const auto place = [&](std::string& path) {
        if (!path.empty())
            path = resolvePath(path, folder).generic_string();
    };
    const auto placeTexture = [&](TextureReference& texture) { std::ranges::for_each(texture.paths, place); };
    Key key;
    key.entry.source = entry.source;
    place(key.entry.source);
    key.entry.clip = entry.clip;
    key.entry.sourceFps = entry.sourceFps.value_or(settings.fps);
    key.entry.sourceAxes = entry.sourceAxes;
    key.entry.texture = entry.texture;
    placeTexture(key.entry.texture);
    if (character != nullptr) {
        key.character.mesh = character->mesh;
        key.character.texture = character->texture;
        place(key.character.mesh);
        placeTexture(key.character.texture);
    }
    key.settings.axes = settings.axes;
    return key;
}

std::shared_ptr<SourceCache::Slot> SourceCache::slot(Key key)
{
    const std::scoped_lock lock(m_mutex);
    const auto found = std::ranges::find(m_slots, key, &std::pair<Key, std::shared_ptr<Slot>>::first);
    if (found != m_slots.end())
        return found->second;
    // Nobody holds or opens these any more.
    std::erase_if(m_slots, [](const auto& each) {
        return each.second.use_count() == 1 && each.second->opened.expired();
    });
    return m_slots.emplace_back(std::move(key), std::make_shared<Slot>()).second;
}

std::shared_ptr<const OpenedSequence> SourceCache::open(const SequenceEntry& entry,
                                                        const CharacterEntry* character,
                                                        const ProjectSettings& settings,
                                                        const std::filesystem::path& folder,
                                                        const Progress& progress)
{
    const std::shared_ptr<Slot> own = slot(keyOf(entry, character, settings, folder));
    const std::scoped_lock lock(own->mutex);
    const auto isAsOpened = [](const auto& file) {
        const auto now = stampOf(file.first);
        return now && now->hasContentOf(file.second);
    };
    if (auto opened = own->opened.lock(); opened && std::ranges::all_of(own->files, isAsOpened))
        return opened;
    // A thread that waits inside must not begin with something else that waits for this source.
    auto opened = tbb::this_task_arena::isolate([&] {
        return std::make_shared<const OpenedSequence>(
            openSource(entry, character, settings, folder, progress));
    });
    ++m_opened;
    own->files.clear();
    for (const std::filesystem::path& file : opened->files) {
        if (const auto stamp = stampOf(file))
            own->files.emplace_back(file, *stamp);
    }
    own->opened = opened;
    return opened;
}

std::shared_ptr<const TextureBlender> SourceCache::blender(const AppearanceEntry& entry,
                                                           const std::filesystem::path& results,
                                                           const std::filesystem::path& folder)
{
    BlenderKey key{.name = entry.name, .varied = entry.varied, .results = results, .folder = folder};
    key.completed.reserve(entry.completions.size());
    for (const CompletionEntry& completion : entry.completions)
        key.completed.push_back(completion.frame);
    const ResultStore store(results);
    for (const std::string& step : {appearanceModelStep(entry.name), appearanceCompletionsStep(entry.name),
                                    appearancePosesStep(entry.name)})
        key.files.push_back(stampOf(store.fileOf(step)));
    const std::scoped_lock lock(m_mutex);
    std::erase_if(m_blenders, [](const auto& each) { return each.second.expired(); });
    const auto known = std::ranges::find(m_blenders, key, &decltype(m_blenders)::value_type::first);
    if (known != m_blenders.end()) {
        if (auto shared = known->second.lock())
            return shared;
        m_blenders.erase(known);
    }
    auto made = std::make_shared<const ModelTextures>(
        [results, folder, entry] { return readAppearances(results, folder, entry); });
    m_blenders.emplace_back(std::move(key), made);
    return made;
}

} // namespace quadrille
