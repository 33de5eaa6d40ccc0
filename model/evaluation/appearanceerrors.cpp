// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/appearanceerrors.h"

#include "model/evaluation/silhouettes.h"

#include <algorithm>
#include <optional>

namespace quadrille {

namespace {

/// A mean that is added up.
struct QualitySum
{
    PictureQuality sum{.similarity = 0};
    double count = 0;

    void add(const PictureQuality& quality)
    {
        sum.similarity += quality.similarity;
        sum.meanSquaredError += quality.meanSquaredError;
        count += 1;
    }
    PictureQuality mean() const { return {sum.similarity / count, sum.meanSquaredError / count}; }
};

/// The captured texture with covered texels of another: what is around charts is the same in both, and does
/// not tell in pictures.
std::shared_ptr<const Image> restoredOver(const Image& captured, const UsedTexels& used,
                                          const Image& restored)
{
    auto texture = std::make_shared<Image>(captured);
    for (std::size_t t = 0; t < used.texels.size(); ++t) {
        if (used.covered[t] != 0) {
            const std::size_t place = std::size_t{4} * used.texels[t];
            std::copy_n(restored.pixels.begin() + static_cast<std::ptrdiff_t>(place), 3,
                        texture->pixels.begin() + static_cast<std::ptrdiff_t>(place));
        }
    }
    return texture;
}

std::shared_ptr<const AppearanceModel> emptyModel(const UsedTexels& used, const WarpGrid& grid)
{
    auto model = std::make_shared<AppearanceModel>();
    model->texels = used;
    model->grid = grid;
    return model;
}

/// Of each representation, of one texture.
std::vector<AppearanceErrors> errorsOf(const AppearanceSubject& subject, std::int64_t texture,
                                       bool isPictured, std::span<const RestoredTexture> representations,
                                       const Progress& progress)
{
    const auto captured = subject.textures.read(texture);
    const Frame frame = subject.frame(texture);
    std::optional<Silhouettes> silhouettes;
    if (isPictured)
        silhouettes.emplace(frame.positions(), subject.topology->data(),
                            ringOfCameras(frame.positions(), subject.up, subject.cameras), subject.up,
                            captured);
    const UsedTexels& used = subject.charts->used();
    std::vector<AppearanceErrors> errors;
    for (const RestoredTexture& restore : representations) {
        const auto step = static_cast<double>(errors.size());
        const auto steps = static_cast<double>(representations.size());
        const Progress own = progress.part(step / steps, (step + 1) / steps);
        own.report(0);
        const auto restored = restoredOver(*captured, used, restore(texture));
        errors.push_back({.texture = textureQuality(*captured, *restored, used)});
        if (silhouettes)
            errors.back().image = silhouettes->compare(restored, own);
    }
    return errors;
}

} // namespace

std::vector<AppearanceErrors> restorationErrors(const AppearanceSubject& subject,
                                                std::span<const std::int64_t> textures,
                                                std::span<const RestoredTexture> representations,
                                                const Progress& progress, const Executor& executor)
{
    const std::size_t count = representations.size();
    const std::int64_t pictures = std::min(subject.pictures, std::ssize(textures));
    const auto isPictured = [&](std::int64_t task) {
        return task * pictures / std::ssize(textures) < (task + 1) * pictures / std::ssize(textures);
    };
    std::vector<AppearanceErrors> all(textures.size() * count);
    executor.run(makeTasks<AppearanceErrors>(
                     std::ssize(textures),
                     [&](std::int64_t task, const Progress& own) {
                         return errorsOf(subject, textures[static_cast<std::size_t>(task)], isPictured(task),
                                         representations, own);
                     },
                     [&](std::int64_t task, std::span<const AppearanceErrors> errors) {
                         std::ranges::copy(errors, all.begin() + task * static_cast<std::int64_t>(count));
                     }),
                 progress);
    std::vector<AppearanceErrors> means;
    for (std::size_t way = 0; way < count; ++way) {
        QualitySum texture;
        QualitySum image;
        for (std::int64_t task = 0; task < std::ssize(textures); ++task) {
            const AppearanceErrors& each = all[static_cast<std::size_t>(task) * count + way];
            texture.add(each.texture);
            if (isPictured(task))
                image.add(each.image);
        }
        means.push_back({texture.mean(), image.mean()});
    }
    return means;
}

Image atlasPicture(const UsedTexels& used, std::span<const std::uint8_t> colours)
{
    Image picture(used.width, used.height);
    for (std::size_t t = 0; t < used.texels.size(); ++t) {
        std::uint8_t* pixel = picture.pixels.data() + std::size_t{4} * used.texels[t];
        std::copy_n(colours.begin() + static_cast<std::ptrdiff_t>(3 * t), 3, pixel);
        pixel[3] = 255;
    }
    return picture;
}

Dealigner::Dealigner(const UsedTexels& used, const WarpGrid& grid)
    : m_decoder(emptyModel(used, grid), Image(used.width, used.height))
{
}

Image Dealigner::dealigned(std::span<const std::uint8_t> colours, std::span<const float> warp) const
{
    return m_decoder.dealigned(colours, warp);
}

} // namespace quadrille
