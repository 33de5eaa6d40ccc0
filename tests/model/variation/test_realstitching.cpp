// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Stitching on a real body, cut into the proposed parts.
#include "model/variation/parts/partoverlap.h"
#include "model/variation/parts/proposedparts.h"
#include "model/variation/parts/stitching.h"
#include "tests/model/sequence/realtakes.h"
#include "tests/model/variation/creases.h"
#include "tests/model/variation/handmadeparts.h"

#include <gtest/gtest.h>
#include <numeric>
#include <random>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A take and the proposed parts of its body.
struct Walker
{
    std::vector<Vec3f> frames;
    std::shared_ptr<const Topology> topology;
    std::size_t vertexCount;
    double fps;
    BodyParts parts;

    explicit Walker(const MeshSequence& take)
        : frames(loadFrames(take))
        , topology(take.topology)
        , vertexCount(topology->vertexCount())
        , fps(take.fps)
    {
        const ProposedParts proposed = proposeParts(topology, frame(0));
        parts = cutIntoParts(*topology, frame(0), proposed.curves, proposed.parts);
    }
    Positions frame(std::size_t f) const { return Positions(frames).subspan(f * vertexCount, vertexCount); }
    std::size_t frameCount() const { return frames.size() / vertexCount; }
    /// Parts that lag behind each other by some frames.
    std::vector<std::vector<Vec3f>> lagging(std::size_t count, std::size_t lag) const
    {
        std::vector<std::vector<Vec3f>> sequences(parts.parts.size());
        for (std::size_t f = 0; f < count; ++f) {
            for (std::size_t p = 0; p < sequences.size(); ++p) {
                const std::vector<Vec3f> part = cutPose(parts, frame(f + lag * (p % 3)))[p];
                sequences[p].insert(sequences[p].end(), part.begin(), part.end());
            }
        }
        return sequences;
    }
};

std::optional<Walker> walker()
{
    const std::optional<MeshSequence> take = realTake("walk_1");
    return take ? std::optional<Walker>(std::in_place, *take) : std::nullopt;
}

/// Root mean square over the frames of the acceleration of some vertices, m/s².
double accelerationOf(const Walker& body, const std::vector<Vec3f>& frames,
                      const std::vector<VertexIndex>& vertices)
{
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t f = 1; f + 1 < frames.size() / body.vertexCount; ++f) {
        const auto at = [&](std::size_t frame, VertexIndex v) {
            return frames[frame * body.vertexCount + v.value];
        };
        for (const VertexIndex v : vertices)
            sum += static_cast<double>((at(f - 1, v) - 2 * at(f, v) + at(f + 1, v)).squaredNorm());
        count += vertices.size();
    }
    return std::sqrt(sum / static_cast<double>(count)) * body.fps * body.fps;
}

} // namespace

TEST(RealStitching, GivesBackAnUnchangedMesh)
{
    const auto body = walker();
    if (!body)
        GTEST_SKIP() << "no real data";
    const Stitching stitching(body->topology, body->parts, body->frame(0));
    for (std::size_t f = 0; f < body->frameCount(); f += 10) {
        std::vector<Vec3f> out(body->vertexCount);
        stitching.stitch(viewed(cutPose(body->parts, body->frame(f))), out);
        double largest = 0;
        for (std::size_t v = 0; v < out.size(); ++v)
            largest = std::max(largest, static_cast<double>((out[v] - body->frame(f)[v]).norm()));
        EXPECT_LT(largest, 1e-6) << f;
    }
}

// Limbs lag by up to 270 ms behind the trunk: shoulders and hips bend differently on either side. Within a
// degree; a sudden change of gradients at the seams leaves creases of up to 2.3 degrees here.
TEST(RealStitching, LeavesNoCreaseAlongTheSeams)
{
    const auto body = walker();
    if (!body)
        GTEST_SKIP() << "no real data";
    const Stitching stitching(body->topology, body->parts, body->frame(0));
    const EdgeNormals normals(*body->topology);
    for (const std::size_t lag : {1U, 2U, 4U}) {
        const std::vector<std::vector<Vec3f>> sequences = body->lagging(50, lag);
        const std::vector<Vec3f> frames = stitchFrames(stitching, viewed(sequences));
        const Stitching::Seams seams = stitching.bestSeams(viewed(sequences));
        for (std::size_t f = 0; f < 50; f += 2) {
            for (std::size_t p = 1; p < seams.curves.size(); ++p) {
                const std::vector<VertexIndex>& seam = seams.curves[p];
                for (std::size_t i = 0; i < seam.size(); ++i) {
                    const auto crease = [&](Positions pose) {
                        return normals.creaseAt(pose, seam[i], seam[(i + 1) % seam.size()]);
                    };
                    const double sharpest =
                        std::max(crease(body->frame(f)), crease(body->frame(f + lag * (p % 3))));
                    EXPECT_LT(crease(Positions(frames).subspan(f * body->vertexCount, body->vertexCount)),
                              sharpest + 0.017)
                        << lag << " " << f << " " << p << " " << i;
                }
            }
        }
    }
}

TEST(RealStitching, DoesNotFlickerAtTheSeams)
{
    const auto body = walker();
    if (!body)
        GTEST_SKIP() << "no real data";
    const Stitching stitching(body->topology, body->parts, body->frame(0));
    const std::vector<Vec3f> frames = stitchFrames(stitching, viewed(body->lagging(50, 1)));
    const std::vector<Vec3f> captured(body->frames.begin(), body->frames.begin() + frames.size());
    for (std::size_t p = 1; p < body->parts.parts.size(); ++p) {
        const std::vector<VertexIndex>& overlap = body->parts.parts[p].overlap;
        EXPECT_LT(accelerationOf(*body, frames, overlap), 1.15 * accelerationOf(*body, captured, overlap))
            << p;
    }
}

// Costs as they come: seams wind to and fro, and touch the rims.
TEST(RealStitching, CutsEachLimbRightAround)
{
    const auto body = walker();
    if (!body)
        GTEST_SKIP() << "no real data";
    std::mt19937 random(6);
    std::uniform_real_distribution<double> cost(0.01, 1.0);
    for (std::size_t p = 1; p < body->parts.parts.size(); ++p) {
        const BodyPart& part = body->parts.parts[p];
        const PartOverlap overlap(*body->topology, part, body->frame(0));
        for (int trial = 0; trial < 20; ++trial) {
            std::vector<double> costs(overlap.edgeCount());
            std::ranges::generate(costs, [&] { return cost(random); });
            const std::vector<std::uint32_t> seam = overlap.cheapestSeam(costs);
            std::set<std::array<std::uint32_t, 2>> cut;
            for (std::size_t i = 0; i < seam.size(); ++i) {
                const std::uint32_t next = seam[(i + 1) % seam.size()];
                cut.insert({std::min(seam[i], next), std::max(seam[i], next)});
            }
            ASSERT_EQ(std::set(seam.begin(), seam.end()).size(), seam.size());
            std::size_t found = 0;
            // Which triangles hang together without crossing the seam, by the smallest of each lot.
            std::vector<std::size_t> lot(overlap.triangles().size());
            std::iota(lot.begin(), lot.end(), 0);
            std::map<std::array<std::uint32_t, 2>, std::vector<std::size_t>> around;
            for (std::size_t t = 0; t < lot.size(); ++t) {
                for (std::size_t c = 0; c < 3; ++c) {
                    const auto [a, b] = std::minmax(overlap.triangles()[t][c].value,
                                                    overlap.triangles()[t][(c + 1) % 3].value);
                    around[{a, b}].push_back(t);
                }
            }
            for (bool changes = true; changes;) {
                changes = false;
                for (const auto& [edge, triangles] : around) {
                    if (triangles.size() < 2 || cut.contains(edge) || lot[triangles[0]] == lot[triangles[1]])
                        continue;
                    lot[triangles[0]] = lot[triangles[1]] = std::min(lot[triangles[0]], lot[triangles[1]]);
                    changes = true;
                }
            }
            const auto lotsAt = [&](const std::vector<VertexIndex>& curve) {
                std::set<std::size_t> lots;
                for (std::size_t i = 0; i < curve.size(); ++i) {
                    const auto placeOf = [&](VertexIndex v) {
                        return static_cast<std::uint32_t>(std::ranges::lower_bound(part.overlap, v) -
                                                          part.overlap.begin());
                    };
                    const std::uint32_t from = placeOf(curve[i]);
                    const std::uint32_t to = placeOf(curve[(i + 1) % curve.size()]);
                    const auto [a, b] = std::minmax(from, to);
                    if (!cut.contains({a, b}))
                        lots.insert(lot[around.at({a, b}).front()]);
                }
                return lots;
            };
            for (const auto& edge : cut)
                found += around.contains(edge) ? 1 : 0;
            EXPECT_EQ(found, seam.size());
            const std::set<std::size_t> inner = lotsAt(part.end);
            for (const std::size_t outer : lotsAt(part.parentEnd))
                EXPECT_FALSE(inner.contains(outer)) << p << " " << trial;
        }
    }
}
