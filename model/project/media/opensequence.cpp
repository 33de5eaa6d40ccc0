// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/media/opensequence.h"

#include "model/core/message.h"
#include "model/project/document/clipdependencies.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/store/clipresult.h"
#include "model/project/store/projectionresult.h"
#include "model/project/store/resultstore.h"
#include "model/sequence/io/basemesh.h"
#include "model/sequence/io/mesh/findtextures.h"
#include "model/sequence/io/mesh/meshfile.h"
#include "model/sequence/io/registry.h"

#include <algorithm>
#include <charconv>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view sequencesSection = "sequences/";

std::string toText(double number)
{
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

/// The one sequence of a source that an entry means.
MeshSequence chooseClip(ImportResult&& imported, const SequenceEntry& entry, const fs::path& file)
{
    if (imported.sequences.size() == 1)
        return std::move(imported.sequences.front());
    std::string names;
    for (MeshSequence& sequence : imported.sequences) {
        if (sequence.name == entry.clip)
            return std::move(sequence);
        names += (names.empty() ? "" : ", ") + sequence.name;
    }
    throwInvalid(file, "“" + entry.name + "” does not say which of its source's clips it is",
                 "Name one of them as “clip”: " + names + ".");
}

/// Puts the textures that the project names onto a sequence that still has all frames of its source.
void applyTextures(OpenedSequence& opened, const TextureReference& reference, const fs::path& source,
                   const fs::path& folder)
{
    switch (reference.kind) {
    case TextureReference::Kind::None:
        return;
    case TextureReference::Kind::Single:
    case TextureReference::Kind::PerFrame: {
        TextureSearch search;
        search.take = findSource(source);
        search.frameCount = opened.sequence.source->frameCount();
        search.named = resolvePath(reference.paths.empty() ? "" : reference.paths.front(), folder);
        FoundTextures found = findTextures(search);
        opened.sequence.textures = std::move(found.textures);
        opened.issues.insert(opened.issues.end(), found.issues.begin(), found.issues.end());
        return;
    }
    case TextureReference::Kind::PerMaterial: {
        std::vector<Texture> textures;
        for (const std::string& path : reference.paths)
            textures.push_back({resolvePath(path, folder), nullptr});
        const auto materials = std::max<std::size_t>(opened.sequence.topology->data().materials.size(), 1);
        if (textures.size() != materials)
            throwInvalid(source,
                         std::to_string(textures.size()) + " textures for " + std::to_string(materials) +
                             " materials",
                         QUADRILLE_MESSAGE("Name one texture for each material."));
        opened.sequence.textures = TextureSet::perMaterial(std::move(textures));
        return;
    }
    }
}

/// Cuts spans to the frames that exist; what lies outside becomes a warning.
template <typename Span>
std::vector<Span> fittedSpans(const std::vector<Span>& spans, std::string Span::*text, std::int64_t count,
                              const SequenceEntry& entry, std::vector<Issue>& issues)
{
    std::vector<Span> fitted;
    for (Span span : spans) {
        if (span.frames.last.value >= count) {
            Issue issue;
            issue.context.values = {{"text", "“" + span.*text + "” of “" + entry.name + "” ends at frame " +
                                                 std::to_string(span.frames.last.value) +
                                                 ", but the sequence has only " + std::to_string(count) +
                                                 " frames."}};
            issues.push_back(std::move(issue));
            span.frames.last = FrameIndex(count - 1);
        }
        if (span.frames.count() > 0)
            fitted.push_back(std::move(span));
    }
    return fitted;
}

void addFile(std::vector<fs::path>& files, const fs::path& file)
{
    if (!file.empty() && std::find(files.begin(), files.end(), file) == files.end())
        files.push_back(file);
}

} // namespace

SequenceOpener::SequenceOpener(Project project, fs::path folder, fs::path results,
                               std::shared_ptr<SourceCache> sources)
    : m_project(std::move(project))
    , m_folder(std::move(folder))
    , m_results(std::move(results))
    , m_sources(sources ? std::move(sources) : std::make_shared<SourceCache>())
{
}

SequenceOpener::Slot& SequenceOpener::slot(const std::string& clip)
{
    const std::scoped_lock lock(m_mutex);
    return m_slots[clip];
}

std::shared_ptr<const OpenedSequence> SequenceOpener::open(const std::string& name, const Progress& progress)
{
    return openClip(std::string(sequencesSection) + name, progress);
}

std::shared_ptr<const OpenedSequence> SequenceOpener::openClip(const std::string& clip,
                                                               const Progress& progress)
{
    const std::string name = clip.substr(clip.find('/') + 1);
    const bool isMade = isMadeClip(clip);
    const SequenceEntry* entry = isMade ? nullptr : findSequence(m_project, name);
    if (!isMade && entry == nullptr)
        throwInvalid({}, "There is no sequence “" + name + "”", QUADRILLE_MESSAGE("Correct the name."));
    Slot& own = slot(clip);
    const std::scoped_lock lock(own.mutex);
    if (!own.opened)
        own.opened = std::make_shared<const OpenedSequence>(isMade ? openMadeClip(clip, progress)
                                                                   : openEntry(*entry, progress));
    return own.opened;
}

std::vector<fs::path> SequenceOpener::filesOf(const std::string& name, const Progress& progress)
{
    const SequenceEntry* entry = findSequence(m_project, name);
    if (entry != nullptr && shownClip(m_project, *entry))
        return {};
    return open(name, progress)->files;
}

OpenedSequence SequenceOpener::openProjection(const ProjectionEntry& entry, const Progress& progress)
{
    if (isMadeOfItself(m_project, "projections/" + entry.name))
        throwInvalid("“" + entry.name + "” is made of itself", QUADRILLE_MESSAGE("Break the circle."));
    OpenedSequence opened = *openClip(entry.clip, progress);
    MeshSequence& sequence = opened.sequence;
    auto textures = projectedTextures(m_results, m_folder, entry.name, sequence);
    if (!textures)
        throwInvalid({}, "The clip “projections/" + entry.name + "” is not computed yet",
                     QUADRILLE_MESSAGE("Rebuild the project."));
    sequence.name = entry.name;
    sequence.textures = std::move(*textures);
    return opened;
}

OpenedSequence SequenceOpener::openMadeClip(const std::string& clip, const Progress& progress)
{
    if (const ProjectionEntry* projection = projectionOfClip(m_project, clip))
        return openProjection(*projection, progress);
    const std::vector<std::string> names = sequencesOfClip(m_project, clip);
    if (names.empty())
        throwInvalid({}, "There is no clip “" + clip + "”", QUADRILLE_MESSAGE("Correct the name."));
    std::vector<MeshSequence> sequences;
    sequences.reserve(names.size());
    for (const std::string& sequence : names)
        sequences.push_back(open(sequence, progress)->sequence);
    auto made = readClip(m_results, clip, sequences, m_project.settings.fps);
    const auto varied = variationOfClip(clip);
    if (!made && varied &&
        ResultStore(m_results).load(clipStepOf(clip), {}).state != ResultStore::State::Missing)
        throw Error(ErrorCode::VariationMissing, {.values = {{"number", std::to_string(varied->number)}}});
    if (!made)
        throwInvalid({}, "The clip “" + clip + "” is not computed yet",
                     QUADRILLE_MESSAGE("Rebuild the project."));
    if (const TransferEntry* transfer = transferOfClip(m_project, clip)) {
        // What the template does, the target does in the same frames.
        const auto source = openClip(transfer->clip, progress);
        made->labels = source->sequence.labels;
        made->contacts = source->sequence.contacts;
    }
    return {.sequence = std::move(*made)};
}

OpenedSequence SequenceOpener::openEntry(const SequenceEntry& entry, const Progress& progress)
{
    const CharacterEntry* character = characterOf(m_project, entry);
    OpenedSequence opened;
    if (const auto clip = clipOfSource(entry.source)) {
        if (!clip->starts_with(sequencesSection) && !isMadeClip(*clip))
            throwInvalid({}, "Clips of “" + *clip + "” cannot be used by this version", "");
        if (isMadeOfItself(m_project, std::string(sequencesSection) + entry.name))
            throwInvalid({}, "“" + entry.name + "” is its own source",
                         QUADRILLE_MESSAGE("Break the circle."));
        opened = *openClip(*clip, progress);
        opened.issues.clear();
    } else {
        opened = openFile(entry, character, progress);
    }
    MeshSequence& sequence = opened.sequence;
    sequence.name = entry.name;
    if (entry.range)
        sequence = sequence.cutTo(*entry.range);
    if (sequence.fps != m_project.settings.fps && sequence.frameCount() > 1) {
        Issue issue{Issue::Severity::Info, Issue::Code::FpsResampled, {}};
        issue.context.file = opened.files.empty() ? fs::path() : opened.files.front();
        issue.context.values = {{"from", toText(sequence.fps)}, {"to", toText(m_project.settings.fps)}};
        opened.issues.push_back(std::move(issue));
    }
    sequence = resampled(sequence, m_project.settings.fps);
    if (!entry.labels.empty())
        sequence.labels =
            fittedSpans(entry.labels, &LabelSpan::label, sequence.frameCount(), entry, opened.issues);
    if (!entry.contacts.empty())
        sequence.contacts =
            fittedSpans(entry.contacts, &ContactSpan::foot, sequence.frameCount(), entry, opened.issues);
    return opened;
}

OpenedSequence SequenceOpener::openFile(const SequenceEntry& entry, const CharacterEntry* character,
                                        const Progress& progress)
{
    const auto source = m_sources->open(entry, character, m_project.settings, m_folder, progress);
    OpenedSequence opened = *source;
    {
        const std::scoped_lock lock(m_mutex);
        m_held.push_back(source);
    }
    if (character != nullptr)
        shareTopology(opened, *character);
    TextureSet& textures = opened.sequence.textures;
    if (textures.kind() == TextureSet::Kind::PerFrame)
        textures = textures.blendedBy(blenderOf(character != nullptr ? character->name : ""));
    return opened;
}

std::shared_ptr<const TextureBlender> SequenceOpener::blenderOf(const std::string& character)
{
    const AppearanceEntry* entry = appearanceOf(m_project, character);
    if (entry == nullptr || m_results.empty())
        return nullptr;
    const std::scoped_lock lock(m_mutex);
    std::shared_ptr<const TextureBlender>& blender = m_blenders[entry->name];
    if (!blender)
        blender = m_sources->blender(*entry, m_results, m_folder);
    return blender;
}

void SequenceOpener::shareTopology(OpenedSequence& opened, const CharacterEntry& character)
{
    Mesh* shared = nullptr;
    {
        const std::scoped_lock lock(m_mutex);
        shared = &m_meshes[character.name];
    }
    const std::scoped_lock lock(shared->mutex);
    if (!shared->topology && !character.mesh.empty())
        shared->topology = readBaseMesh(resolvePath(character.mesh, m_folder)).topology;
    if (!shared->topology) {
        shared->topology = opened.sequence.topology;
        return;
    }
    if (shared->topology == opened.sequence.topology)
        return;
    checkSameTopology(shared->topology->data(), opened.sequence.topology->data(),
                      opened.files.empty() ? fs::path() : opened.files.front());
    opened.sequence.topology = shared->topology;
}

OpenedSequence openSource(const SequenceEntry& entry, const CharacterEntry* character,
                          const ProjectSettings& settings, const fs::path& folder, const Progress& progress)
{
    const fs::path source = resolvePath(entry.source, folder);
    const fs::path mesh = character == nullptr ? fs::path() : resolvePath(character->mesh, folder);
    ImportOptions options;
    options.mesh = mesh;
    options.fps = entry.sourceFps.value_or(settings.fps);
    options.from = entry.sourceAxes;
    options.to = settings.axes;
    options.clip = entry.clip;
    ImportResult imported = openSequences(source, options, progress);
    OpenedSequence opened;
    opened.issues = std::move(imported.issues);
    std::erase_if(opened.issues, [](const Issue& issue) { return issue.code == Issue::Code::FpsAssumed; });
    opened.sequence = chooseClip(std::move(imported), entry, source);
    for (const fs::path& file : findSource(source).files)
        addFile(opened.files, file);
    addFile(opened.files, mesh);
    if (entry.texture.kind != TextureReference::Kind::None)
        applyTextures(opened, entry.texture, source, folder);
    else if (character != nullptr)
        applyTextures(opened, character->texture, source, folder);
    for (const Texture& texture : opened.sequence.textures.textures())
        addFile(opened.files, texture.file);
    return opened;
}

OpenedSequence openSequence(const Project& project, const fs::path& folder, const SequenceEntry& entry,
                            const Progress& progress)
{
    // The entry may be an edited one that the project does not have yet.
    Project with = project;
    const auto same = std::find_if(with.sequences.begin(), with.sequences.end(),
                                   [&](const SequenceEntry& other) { return other.name == entry.name; });
    if (same == with.sequences.end())
        with.sequences.push_back(entry);
    else
        *same = entry;
    return *SequenceOpener(std::move(with), folder).open(entry.name, progress);
}

} // namespace quadrille
