// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/shapeappearance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille {

namespace {

constexpr std::size_t shapeWays = 3;
/// Nearest, mean, learned.
using ShapePictures = std::array<PictureQuality, shapeWays>;

/// The poses of one take, found from those of the others.
class TakeFromOthers
{
public:
    TakeFromOthers(const ShapeSubject& subject, const AppearanceModel& model,
                   const Eigen::MatrixXd& distances, std::int64_t take)
        : m_distances(distances)
        , m_textures(coefficientRows(model.textures, subject.textures))
        , m_warps(coefficientRows(model.warps, subject.textures))
    {
        for (std::size_t pose = 0; pose < subject.takes.size(); ++pose) {
            (subject.takes[pose] == take ? m_out : m_kept).push_back(static_cast<Eigen::Index>(pose));
            if (subject.takes[pose] != take)
                m_groups.push_back(subject.takes[pose]);
        }
    }

    const std::vector<Eigen::Index>& out() const { return m_out; }
    Eigen::Index nearestTo(Eigen::Index out) const
    {
        return *std::ranges::min_element(m_kept, {}, [&](Eigen::Index kept) {
            return m_distances(m_out[static_cast<std::size_t>(out)], kept);
        });
    }

    /// Coefficients of all ways, out × components each.
    struct Found
    {
        RegressionScale scale;
        std::array<Eigen::MatrixXd, shapeWays> ways;
        std::array<double, shapeWays> errors{}; ///< root mean square over values
    };
    Found textures(double size, const Progress& progress, const Executor& executor) const
    {
        return found(m_textures, size, progress, executor);
    }
    Found warps(double size, const Progress& progress, const Executor& executor) const
    {
        return found(m_warps, size, progress, executor);
    }

private:
    Found found(const Eigen::MatrixXd& coefficients, double size, const Progress& progress,
                const Executor& executor) const
    {
        const Eigen::MatrixXd among = m_distances(m_kept, m_kept);
        const Eigen::MatrixXd known = coefficients(m_kept, Eigen::all);
        const Eigen::MatrixXd wanted = coefficients(m_out, Eigen::all);
        Found result{.scale = foundScale(among, known, m_groups, progress, executor)};
        const KernelRegression regression(among, known, result.scale);
        result.ways.fill(wanted);
        for (Eigen::Index i = 0; i < wanted.rows(); ++i) {
            const Eigen::Index pose = m_out[static_cast<std::size_t>(i)];
            result.ways[0].row(i) = coefficients.row(nearestTo(i));
            result.ways[1].row(i) = known.colwise().mean();
            result.ways[2].row(i) = regression.at(m_distances(pose, m_kept).transpose()).transpose();
        }
        for (std::size_t way = 0; way < shapeWays; ++way)
            result.errors[way] = std::sqrt((result.ways[way] - wanted).squaredNorm() /
                                           (static_cast<double>(wanted.rows()) * size));
        return result;
    }

    const Eigen::MatrixXd& m_distances;
    Eigen::MatrixXd m_textures;
    Eigen::MatrixXd m_warps;
    std::vector<Eigen::Index> m_out;
    std::vector<Eigen::Index> m_kept;
    std::vector<std::int64_t> m_groups;
};

AppearanceCoefficients coefficientsIn(const TakeFromOthers::Found& textures,
                                      const TakeFromOthers::Found& warps, std::size_t way, Eigen::Index row)
{
    const Eigen::VectorXf ofTextures = textures.ways[way].row(row).cast<float>();
    const Eigen::VectorXf ofWarps = warps.ways[way].row(row).cast<float>();
    return {{ofTextures.begin(), ofTextures.end()}, {ofWarps.begin(), ofWarps.end()}};
}

/// The mean over some frames of a take.
ShapePictures pictureErrors(const ShapeSubject& subject, const AppearanceDecoder& decoder,
                            const TakeFromOthers& take, const TakeFromOthers::Found& textures,
                            const TakeFromOthers::Found& warps, const Progress& progress,
                            const Executor& executor)
{
    const auto frames = std::ssize(take.out());
    const std::int64_t count = std::min(frames, subject.pictures);
    std::vector<PictureQuality> each(static_cast<std::size_t>(count) * shapeWays);
    const auto read = [&](Eigen::Index pose) {
        return subject.source.read(subject.textures[static_cast<std::size_t>(pose)]);
    };
    executor.run(makeTasks<PictureQuality>(
                     count,
                     [&](std::int64_t task, const Progress& own) {
                         const Eigen::Index row = task * frames / count;
                         const auto truth = read(take.out()[static_cast<std::size_t>(row)]);
                         const UsedTexels& texels = decoder.model().texels;
                         std::vector<PictureQuality> ways{
                             textureQuality(*truth, *read(take.nearestTo(row)), texels)};
                         for (std::size_t way = 1; way < shapeWays; ++way) {
                             own.report(static_cast<std::int64_t>(way), shapeWays);
                             ways.push_back(textureQuality(
                                 *truth, decoder.decode(coefficientsIn(textures, warps, way, row)), texels));
                         }
                         return ways;
                     },
                     [&](std::int64_t task, std::span<const PictureQuality> ways) {
                         std::ranges::copy(ways, each.begin() + task * std::ssize(ways));
                     }),
                 progress);
    ShapePictures means;
    for (std::size_t way = 0; way < shapeWays; ++way) {
        means[way].similarity = 0;
        for (std::size_t i = way; i < each.size(); i += shapeWays) {
            means[way].similarity += each[i].similarity / static_cast<double>(count);
            means[way].meanSquaredError += each[i].meanSquaredError / static_cast<double>(count);
        }
    }
    return means;
}

} // namespace

std::vector<LeftOutTake> leftOutTakes(const ShapeSubject& subject, const AppearanceDecoder& decoder,
                                      const Progress& progress, const Executor& executor)
{
    constexpr double comparing = 0.1;
    const Eigen::MatrixXd distances = squaredDistances(subject.places, progress.part(0, comparing));
    const AppearanceModel& model = decoder.model();
    const std::int64_t count = subject.takes.back() + 1;
    std::vector<LeftOutTake> takes;
    for (std::int64_t take = 0; take < count; ++take) {
        const double share = (1 - comparing) / static_cast<double>(count);
        const double from = comparing + share * static_cast<double>(take);
        const Progress own = progress.part(from, from + share);
        const TakeFromOthers others(subject, model, distances, take);
        const auto textures =
            others.textures(static_cast<double>(model.textures.size), own.part(0, 0.3), executor);
        const auto warps = others.warps(static_cast<double>(model.warps.size), own.part(0.3, 0.6), executor);
        const ShapePictures pictures =
            pictureErrors(subject, decoder, others, textures, warps, own.part(0.6, 1), executor);
        const auto errors = [&](std::size_t way) {
            return ShapeErrors{textures.errors[way], warps.errors[way], pictures[way]};
        };
        takes.push_back({.frames = std::ssize(others.out()),
                         .scales = {textures.scale, warps.scale},
                         .nearest = errors(0),
                         .mean = errors(1),
                         .learned = errors(2)});
    }
    return takes;
}

} // namespace quadrille
