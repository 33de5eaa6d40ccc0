// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/quantisedspace.h"
#include "model/core/image.h"
#include "model/core/symmetriceigen.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>

namespace quadrille {

namespace {

namespace fs = std::filesystem;
using Samples = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Every other frame of a capture, one row per frame, of used texels in every fourth row of the textures.
Samples realTextures(const fs::path& folder)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "textures")) {
        if (entry.path().extension() == ".jpg")
            files.push_back(entry.path());
    }
    std::ranges::sort(files);
    const Image mask = readImage(folder / "texture_mask.png");
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < mask.pixels.size() / 4; ++i) {
        if (mask.pixels[4 * i] > 127 && i / static_cast<std::size_t>(mask.width) % 4 == 0)
            used.push_back(i);
    }
    Samples samples(static_cast<Eigen::Index>((files.size() + 1) / 2),
                    static_cast<Eigen::Index>(3 * used.size()));
    for (Eigen::Index s = 0; s < samples.rows(); ++s) {
        const Image texture = readImage(files[static_cast<std::size_t>(2 * s)]);
        for (std::size_t i = 0; i < used.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c)
                samples(s, static_cast<Eigen::Index>(3 * i + c)) = texture.pixels[4 * used[i] + c];
        }
    }
    return samples;
}

LinearSpace principalSpace(Samples samples, Eigen::Index count)
{
    LinearSpace space;
    const Eigen::RowVectorXf mean = samples.colwise().mean();
    samples.rowwise() -= mean;
    space.mean.assign(mean.begin(), mean.end());
    const Eigen::MatrixXd products = (samples * samples.transpose()).cast<double>();
    const SymmetricEigen solved = symmetricEigen(products);
    const Eigen::MatrixXd vectors = solved.vectors.rightCols(count).rowwise().reverse();
    const Eigen::VectorXd lengths = solved.values.tail(count).reverse().cwiseSqrt();
    const Samples components =
        (vectors * lengths.cwiseInverse().asDiagonal()).transpose().cast<float>() * samples;
    space.components.assign(components.data(), components.data() + components.size());
    for (Eigen::Index s = 0; s < samples.rows(); ++s) {
        for (Eigen::Index c = 0; c < count; ++c)
            space.coefficients.push_back(vectors(s, c) * lengths(c));
    }
    return space;
}

TEST(QuantisedSpace, AddsLessThanATenthOfAGreyLevelToRealTextures)
{
    const fs::path folder = fs::path(QUADRILLE_DATA_DIR) / "characters" / "liam";
    if (!fs::exists(folder / "texture_mask.png"))
        GTEST_SKIP() << "no captures in " << QUADRILLE_DATA_DIR;
    constexpr Eigen::Index count = 50;
    const LinearSpace space = principalSpace(realTextures(folder), count);
    const QuantisedSpace rounded = quantised(space);
    const Eigen::Map<const Samples> components(space.components.data(), count, space.size());
    const Eigen::Map<const Eigen::RowVectorXf> mean(space.mean.data(), space.size());
    double worst = 0;
    for (std::int64_t s = 0; s < space.samples(); s += 5) {
        const Eigen::Map<const Eigen::VectorXd> coefficients(space.coefficients.data() + s * count, count);
        const Eigen::VectorXf inSingle = coefficients.cast<float>();
        const Eigen::RowVectorXf exact = inSingle.transpose() * components + mean;
        const std::vector<float> values = combined(rounded, std::span<const float>(inSingle.data(), count));
        const Eigen::Map<const Eigen::RowVectorXf> found(values.data(), space.size());
        worst = std::max(worst, std::sqrt(static_cast<double>((exact - found).squaredNorm()) /
                                          static_cast<double>(space.size())));
    }
    RecordProperty("worst", std::to_string(worst));
    EXPECT_GT(worst, 0.01);
    EXPECT_LT(worst, 0.1);
}

} // namespace

} // namespace quadrille
