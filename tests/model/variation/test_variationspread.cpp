// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/geometry/procrustes.h"
#include "model/variation/variationspread.h"
#include "tests/model/codeof.h"
#include "tests/model/variation/handmadeparts.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double length = 2.0;

/// Frames of a bar whose left half is thicker or thinner: nothing turns or moves as a whole.
std::vector<Vec3f> run(const PartedBar& parted, std::initializer_list<double> thickness)
{
    std::vector<Vec3f> frames;
    for (const double factor : thickness) {
        for (const Vec3f& p : parted.bar.positions) {
            const auto scale = static_cast<float>(p.x() < length / 2 ? 1 + factor : 1);
            frames.emplace_back(p.x(), scale * p.y(), scale * p.z());
        }
    }
    return frames;
}

/// Mean distance of a part's left half from the axis, over all its vertices.
double meanRadius(const PartedBar& parted, std::size_t part)
{
    const std::vector<VertexIndex>& vertices = parted.parts.parts[part].vertices;
    double sum = 0;
    for (const VertexIndex v : vertices) {
        const Vec3f& p = parted.bar.positions[v.value];
        sum += p.x() < length / 2 ? std::hypot(p.y(), p.z()) : 0;
    }
    return sum / static_cast<double>(vertices.size());
}

std::vector<Positions> views(const std::vector<std::vector<Vec3f>>& runs)
{
    return {runs.begin(), runs.end()};
}

} // namespace

TEST(VariationSpread, IsTheMeanDistanceFromTheMean)
{
    const PartedBar parted(31, 2);
    // Two runs apart by ±10 % and ±20 %; three by −30, 0 and 30 % in both frames.
    const std::vector<std::vector<Vec3f>> variations{run(parted, {0.1, 0.2}), run(parted, {-0.1, -0.2})};
    const std::vector<std::vector<Vec3f>> takes{run(parted, {-0.3, -0.3}), run(parted, {0, 0}),
                                                run(parted, {0.3, 0.3})};
    const std::vector<PartSpread> spreads =
        variationSpread(parted.parts, parted.bar.positions.size(), views(variations), views(takes));
    ASSERT_EQ(spreads.size(), 6U);
    for (std::size_t p = 0; p < 5; ++p) {
        EXPECT_EQ(spreads[p].part, parted.parts.parts[p].name);
        const double radius = meanRadius(parted, p);
        EXPECT_NEAR(spreads[p].variations.value(), std::sqrt(2.0) * 0.15 * radius, 1e-6) << p;
        EXPECT_NEAR(spreads[p].takes.value(), std::sqrt(1.5) * 0.2 * radius, 1e-6) << p;
    }
    EXPECT_NEAR(spreads[1].ratio().value(), std::sqrt(2.0) * 0.15 / (std::sqrt(1.5) * 0.2), 1e-5);
    EXPECT_EQ(spreads[5].part, "");
    EXPECT_GT(spreads[5].variations.value(), spreads[2].variations.value());
    EXPECT_LT(spreads[5].variations.value(), spreads[1].variations.value());
}

TEST(VariationSpread, DoesNotDependOnWhereTheFigureStands)
{
    const PartedBar parted(31, 2);
    std::vector<std::vector<Vec3f>> runs{run(parted, {0.1, 0.2}), run(parted, {-0.1, 0}),
                                         run(parted, {0, 0.3})};
    const std::size_t count = parted.bar.positions.size();
    const std::vector<PartSpread> before = variationSpread(parted.parts, count, views(runs), {});
    for (std::size_t r = 0; r < runs.size(); ++r) {
        for (std::size_t i = 0; i < runs[r].size(); ++i) {
            const RigidMotion motion{
                Eigen::Quaterniond(
                    Eigen::AngleAxisd(0.7 * static_cast<double>(r + i / count), Vec3d(1, 2, 3).normalized())),
                Vec3d(static_cast<double>(r), 0.5 * static_cast<double>(i / count), 2)};
            runs[r][i] = motion(runs[r][i].cast<double>()).cast<float>();
        }
    }
    const std::vector<PartSpread> after = variationSpread(parted.parts, count, views(runs), {});
    for (std::size_t p = 0; p < before.size(); ++p)
        EXPECT_NEAR(after[p].variations.value(), before[p].variations.value(), 2e-6) << p;
}

TEST(VariationSpread, OfLimbsThatSwingLeavesTheRestAlone)
{
    const PartedBar parted(31, 2, 2.0F, 0.3F, true, 4);
    std::vector<std::vector<Vec3f>> runs;
    for (const double swing : {-0.1, 0.1}) {
        runs.push_back(moved(parted.bar.positions, [&](const Vec3d& p) -> Vec3d {
            return {p.x(), p.y() + swing * std::max(0.0, 0.5 - p.x()), p.z()};
        }));
    }
    const std::vector<PartSpread> spreads =
        variationSpread(parted.parts, parted.bar.positions.size(), views(runs), {});
    EXPECT_LT(spreads[0].variations.value(), 1e-6);
    EXPECT_LT(spreads[2].variations.value(), 1e-6);
    EXPECT_GT(spreads[3].variations.value(), 0.01);
}

TEST(VariationSpread, NeedsTwoRunsOfEach)
{
    const PartedBar parted(31, 2);
    const std::vector<std::vector<Vec3f>> one{run(parted, {0.1})};
    const std::vector<PartSpread> spreads =
        variationSpread(parted.parts, parted.bar.positions.size(), views(one), {});
    EXPECT_FALSE(spreads.front().variations.has_value());
    EXPECT_FALSE(spreads.front().takes.has_value());
    EXPECT_FALSE(spreads.front().ratio().has_value());
}

TEST(VariationSpread, StopsWhenCancelled)
{
    const PartedBar parted(31, 2);
    const std::vector<std::vector<Vec3f>> runs{run(parted, {0.1}), run(parted, {0.2})};
    CancelToken token;
    token.cancel();
    EXPECT_EQ(test::codeOf([&] {
                  variationSpread(parted.parts, parted.bar.positions.size(), views(runs), {},
                                  Progress(token));
              }),
              ErrorCode::Cancelled);
}
