// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/appearancerates.h"

#include "model/appearance/appearancefile.h"
#include "model/appearance/buildappearance.h"
#include "model/core/error.h"
#include "model/film/h264decoder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace quadrille {

namespace {

Progress partOf(const Progress& progress, std::size_t index, std::size_t count)
{
    return progress.part(static_cast<double>(index) / static_cast<double>(count),
                         static_cast<double>(index + 1) / static_cast<double>(count));
}

PictureQuality meanQuality(const AppearanceSubject& subject, const RestoredTexture& restore,
                           const Progress& progress, const Executor& executor)
{
    AppearanceSubject unseen = subject;
    unseen.pictures = 0;
    std::vector<std::int64_t> all(static_cast<std::size_t>(subject.textures.count));
    std::iota(all.begin(), all.end(), std::int64_t{0});
    return restorationErrors(unseen, all, std::span(&restore, 1), progress, executor).front().texture;
}

/// The size of a model's file, which is not kept.
std::uint64_t fileSizeOf(const AppearanceModel& model, const std::filesystem::path& folder)
{
    const std::filesystem::path file = folder / "rates.h5";
    writeAppearanceFile(file, model);
    const std::uint64_t size = std::filesystem::file_size(file);
    std::filesystem::remove(file);
    return size;
}

/// A film of one quantizer.
AppearanceRate filmRate(const AppearanceSubject& subject, int quantizer, const Progress& progress)
{
    const UsedTexels& used = subject.charts->used();
    const std::int64_t count = subject.textures.count;
    constexpr double fps = 25; // quality does not depend on it
    H264Encoder encoder({used.width, used.height, fps, count}, {}, quantizer);
    H264Decoder decoder(encoder);
    AppearanceRate rate{.kind = "h264",
                        .setting = quantizer,
                        .bytes = encoder.sequenceSet().size() + encoder.pictureSet().size(),
                        .quality = {.similarity = 0}};
    for (std::int64_t texture = 0; texture < count; ++texture) {
        progress.report(texture, count);
        const auto captured = subject.textures.read(texture);
        const CompressedPicture compressed = encoder.encode(*captured);
        const PictureQuality quality = textureQuality(*captured, decoder.decode(compressed), used);
        rate.bytes += compressed.bytes.size();
        rate.quality.similarity += quality.similarity / static_cast<double>(count);
        rate.quality.meanSquaredError += quality.meanSquaredError / static_cast<double>(count);
    }
    return rate;
}

} // namespace

std::vector<AppearanceRate> modelRates(const AppearanceSubject& subject, TextureAlignment* alignment,
                                       const std::vector<AppearanceFrame>& frames,
                                       std::span<const std::int64_t> components, double textureShare,
                                       const Progress& progress, const Executor& executor)
{
    std::shared_ptr<TextureAlignment> captured;
    if (alignment == nullptr)
        captured = gatherTextures(subject.textures, *subject.charts, {.scratchFolder = subject.scratchFolder},
                                  progress.part(0, 0.1), executor);
    TextureAlignment& used = alignment == nullptr ? *captured : *alignment;
    LinearSpace warps =
        principalComponents(used.backwardSamples(), used.count(), progress.part(0.1, 0.15), executor);
    std::ranges::fill(warps.mean, 0.0F);
    std::vector<AppearanceRate> rates;
    for (const std::int64_t count : components) {
        const Progress own = partOf(progress.part(0.15, 1), rates.size(), components.size());
        const std::int64_t textures = textureComponents({.components = count, .textureShare = textureShare});
        const LinearSpace kept = firstComponents(warps, count - textures);
        if (alignment != nullptr)
            realignTextures(subject.textures, *subject.charts, kept, used, own.part(0, 0.5), executor);
        const LinearSpace space =
            principalComponents(used.alignedSamples(), textures, own.part(0.5, 0.7), executor);
        const auto model = std::make_shared<const AppearanceModel>(
            quantised(subject.charts->used(), used.grid(), space, kept, frames, own.part(0.7, 0.75)));
        const AppearanceDecoder decoder(model);
        const RestoredTexture restore = [&](std::int64_t texture) {
            return decoder.decode(coefficientsOf(*model, static_cast<std::size_t>(texture)));
        };
        rates.push_back({"model", count, fileSizeOf(*model, subject.scratchFolder),
                         meanQuality(subject, restore, own.part(0.75, 1), executor)});
    }
    return rates;
}

std::vector<AppearanceRate> jpegRates(const AppearanceSubject& subject, std::span<const int> qualities,
                                      const Progress& progress, const Executor& executor)
{
    std::vector<AppearanceRate> rates;
    for (const int quality : qualities) {
        std::vector<std::uint64_t> sizes(static_cast<std::size_t>(subject.textures.count));
        const RestoredTexture restore = [&](std::int64_t texture) {
            const auto bytes = encodeImage(*subject.textures.read(texture), ".jpg", quality);
            sizes[static_cast<std::size_t>(texture)] = bytes.size();
            return decodeImage(bytes);
        };
        const PictureQuality mean =
            meanQuality(subject, restore, partOf(progress, rates.size(), qualities.size()), executor);
        rates.push_back(
            {"jpeg", quality, std::accumulate(sizes.begin(), sizes.end(), std::uint64_t{0}), mean});
    }
    return rates;
}

std::vector<AppearanceRate> filmRates(const AppearanceSubject& subject, std::span<const int> quantizers,
                                      const Progress& progress)
{
    std::vector<AppearanceRate> rates;
    try {
        for (const int quantizer : quantizers)
            rates.push_back(filmRate(subject, quantizer, partOf(progress, rates.size(), quantizers.size())));
    } catch (const Error& error) {
        if (error.code() != ErrorCode::BadArgument)
            throw;
    }
    return rates;
}

std::optional<double> bytesAt(std::span<const AppearanceRate> rates, const std::string& kind,
                              double similarity)
{
    std::vector<std::array<double, 2>> points; // SSIM and bytes
    for (const AppearanceRate& rate : rates)
        if (rate.kind == kind)
            points.push_back({rate.quality.similarity, static_cast<double>(rate.bytes)});
    std::ranges::sort(points);
    const auto above = std::ranges::find_if(points, [&](const auto& each) { return each[0] >= similarity; });
    if (above == points.end())
        return std::nullopt;
    if (above == points.begin())
        return (*above)[1];
    const auto& below = *(above - 1);
    const double share = (similarity - below[0]) / ((*above)[0] - below[0]);
    return std::exp(std::lerp(std::log(below[1]), std::log((*above)[1]), share));
}

} // namespace quadrille
