// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"
#include "model/core/mediacache.h"
#include "model/core/units.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace quadrille {

class FrameSource;

/// One texture: a file, a picture embedded in a scene file, or one that is made when it is asked for.
struct Texture
{
    std::filesystem::path file;
    std::shared_ptr<const Image> embedded;
    /// Called from any thread; the same picture each time. What it throws reaches who asked.
    std::function<Image()> made;
    ColourMarks marks = ColourMarks::Followed; ///< of its file

    bool isEmpty() const { return file.empty() && !embedded && !made; }
    /// The picture, read or made now. \pre !isEmpty() \throws Error what readImage throws.
    std::shared_ptr<const Image> load() const;
};

/// The texture of a captured frame.
struct CapturedTexture
{
    std::string sequence; ///< its name
    FrameIndex frame;     ///< of the sequence
    Texture texture;
};

/// Makes the textures of frames that were not captured (SMCAS §5.3). Safe from any thread.
class TextureBlender
{
public:
    virtual ~TextureBlender() = default;
    /// The texture between those of two captured frames. \param weight  of the second, 0 … 1.
    /// \return an empty one where it does not know both.
    virtual Texture between(const CapturedTexture& first, const CapturedTexture& second,
                            double weight) const = 0;
    /// What is shown in place of a captured frame's own texture, such as one that was completed; an empty one
    /// where that is its own.
    virtual Texture inPlaceOf(const CapturedTexture& texture) const = 0;
    /// The texture of a pose that nobody captured, as textures vary with poses. \param share  0 … 1, how much
    /// of the pose was not captured. \param captured  what the rest of it has.
    /// \return an empty one where it knows nothing of poses.
    virtual Texture ofPose(const std::shared_ptr<const FrameSource>& poses, FrameIndex frame, double share,
                           const Texture& captured) const = 0;
};

/// The textures of a sequence: none, one, one per frame, or one per material. Cheap to copy; read when asked
/// for.
class TextureSet
{
public:
    enum class Kind
    {
        None,
        Single,
        PerFrame,
        PerMaterial,
    };

    TextureSet() = default;
    static TextureSet single(Texture texture);
    /// \param textures one for each frame of the source, in frame order; the same files may come again.
    static TextureSet perFrame(std::vector<Texture> textures);
    /// \param textures one for each material of the topology; empty ones where a material has none.
    static TextureSet perMaterial(std::vector<Texture> textures);

    /// The same textures, with what makes those in between in clips. \param blender  may be null.
    TextureSet blendedBy(std::shared_ptr<const TextureBlender> blender) const;

    Kind kind() const { return m_kind; }
    /// May be null: then a frame in between has the texture of the nearer one.
    const std::shared_ptr<const TextureBlender>& blender() const { return m_blender; }
    const std::vector<Texture>& textures() const { return m_textures; }
    /// Index into `textures()` for a source frame and a material, the first where the same file comes several
    /// times, so that it is read and kept once; −1 when there is none.
    int indexFor(FrameIndex sourceFrame, int material = 0) const;
    /// The picture, from the cache or read now; null when index is −1 or the texture empty.
    /// \throws Error what readImage throws.
    std::shared_ptr<const Image> image(int index, MediaCache& cache = *MediaCache::shared()) const;

private:
    TextureSet(Kind kind, std::vector<Texture> textures);

    Kind m_kind = Kind::None;
    std::vector<Texture> m_textures;
    std::vector<int> m_firsts; ///< per frame: where its file comes first
    std::shared_ptr<const TextureBlender> m_blender;
    MediaId m_id;
};

} // namespace quadrille
