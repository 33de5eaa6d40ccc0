// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/stances.h"

#include <algorithm>
#include <map>
#include <set>

namespace quadrille {

namespace {

bool isSame(const Texture& a, const Texture& b)
{
    return a.file == b.file && a.marks == b.marks && a.embedded == b.embedded && !a.made && !b.made;
}

bool isSame(const TextureSet& a, const TextureSet& b)
{
    return a.kind() == b.kind() &&
           std::ranges::equal(a.textures(), b.textures(),
                              [](const auto& x, const auto& y) { return isSame(x, y); });
}

/// A frame of a character's sequence.
struct Place
{
    const MeshSequence& sequence;
    FrameIndex frame;
};

Place placeOf(const CharacterFrames& character, NodeIndex node)
{
    const int sequence = character.layout().sequenceOf(node);
    return {character.sequences()[static_cast<std::size_t>(sequence)],
            FrameIndex(node - character.layout().firstOf(sequence))};
}

Texture textureAt(const Place& place)
{
    const TextureSet& set = place.sequence.textures;
    const int index = set.indexFor(place.sequence.sourceFrame(place.frame));
    return index < 0 ? Texture() : set.textures()[static_cast<std::size_t>(index)];
}

CapturedTexture capturedAt(const Place& place)
{
    return {place.sequence.name, place.frame, textureAt(place)};
}

/// What the textures' blender makes of a frame; empty where there is none, or the frame shows its own.
Texture blendedTexture(const FrameProvenance& origin, const CharacterFrames& character)
{
    const Place nearest = placeOf(character, origin.nearest());
    const std::shared_ptr<const TextureBlender>& blender = nearest.sequence.textures.blender();
    if (!blender)
        return {};
    if (origin.source != origin.destination) {
        Texture between = blender->between(capturedAt(placeOf(character, origin.source)),
                                           capturedAt(placeOf(character, origin.destination)), origin.lambda);
        if (!between.isEmpty())
            return between;
    }
    return blender->inPlaceOf(capturedAt(nearest));
}

/// What a frame shows that has a texture of its own, or one that was made for it.
Texture textureOf(const FrameProvenance& origin, const CharacterFrames& character)
{
    Texture blended = blendedTexture(origin, character);
    return blended.isEmpty() ? textureAt(placeOf(character, origin.nearest())) : blended;
}

/// The texture of a frame of a variation; empty where it is that of captured frames.
Texture variedTexture(const FrameProvenance& origin, const CharacterFrames& character,
                      const std::shared_ptr<const FrameSource>& poses, FrameIndex frame,
                      const Texture& captured)
{
    const double share = origin.variedShare();
    const auto& blender = placeOf(character, origin.nearest()).sequence.textures.blender();
    return share > 0 && blender ? blender->ofPose(poses, frame, share, captured) : Texture();
}

TextureSet texturesOf(std::span<const FrameProvenance> origins, const CharacterFrames& character,
                      const std::shared_ptr<const FrameSource>& poses)
{
    const TextureSet* common = nullptr;
    bool isCommon = true;
    std::vector<Texture> textures;
    for (const FrameProvenance& origin : origins) {
        const TextureSet& set = placeOf(character, origin.nearest()).sequence.textures;
        if (!common)
            common = &set;
        isCommon = isCommon && set.kind() != TextureSet::Kind::PerFrame && isSame(*common, set);
        Texture captured = textureOf(origin, character);
        Texture varied = variedTexture(origin, character, poses, FrameIndex(std::ssize(textures)), captured);
        textures.push_back(varied.isEmpty() ? std::move(captured) : std::move(varied));
    }
    if (isCommon)
        return common ? *common : TextureSet();
    return TextureSet::perFrame(std::move(textures));
}

template <typename Span>
std::set<std::string> namesAt(const std::vector<Span>& spans, std::string Span::*name, FrameIndex frame)
{
    std::set<std::string> names;
    for (const Span& span : spans) {
        if (span.frames.contains(frame))
            names.insert(span.*name);
    }
    return names;
}

std::set<std::string> labelsAt(const FrameProvenance& origin, const CharacterFrames& character)
{
    const Place place = placeOf(character, origin.nearest());
    return namesAt(place.sequence.labels, &LabelSpan::label, place.frame);
}

/// Spans of frames that have a name, by first frame, then by name.
template <typename Span>
std::vector<Span> spansOf(const std::vector<std::set<std::string>>& names)
{
    std::vector<Span> spans;
    std::map<std::string, std::size_t> open;
    for (std::size_t f = 0; f < names.size(); ++f) {
        std::map<std::string, std::size_t> still;
        for (const std::string& name : names[f]) {
            const auto found = open.find(name);
            if (found == open.end())
                spans.push_back({name, {FrameIndex(f), FrameIndex(f)}});
            const std::size_t index = found == open.end() ? spans.size() - 1 : found->second;
            spans[index].frames.last = FrameIndex(f);
            still[name] = index;
        }
        open = std::move(still);
    }
    return spans;
}

} // namespace

std::vector<ContactSpan> contactsOf(const Clip& clip, const CharacterFrames& character)
{
    return contactsOf(clip, givenStances(character));
}

Clip shownAsVariation(Clip clip)
{
    for (FrameProvenance& origin : clip.origins)
        origin.sourceVariation = origin.destinationVariation = 1;
    return clip;
}

MeshSequence toSequence(std::string name, Clip clip, const CharacterFrames& character)
{
    std::vector<std::set<std::string>> labels;
    for (const FrameProvenance& origin : clip.origins)
        labels.push_back(labelsAt(origin, character));
    std::vector<ContactSpan> contacts = contactsOf(clip, character);
    const std::uint32_t vertexCount = clip.topology->vertexCount();
    const auto poses = std::make_shared<const MemoryFrames>(std::move(clip.positions), vertexCount);
    TextureSet textures = texturesOf(clip.looks.empty() ? clip.origins : clip.looks, character, poses);
    MeshSequence sequence = makeSequence(std::move(name), std::move(clip.topology), poses, clip.fps);
    sequence.textures = std::move(textures);
    sequence.labels = spansOf<LabelSpan>(labels);
    sequence.contacts = std::move(contacts);
    return sequence;
}

} // namespace quadrille
