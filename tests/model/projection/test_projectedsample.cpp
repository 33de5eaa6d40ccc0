// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/texturequality.h"
#include "model/projection/projectclip.h"
#include "model/sample/appearance.h"
#include "tests/model/projection/photographs.h"
#include "tests/model/projection/plainprojection.h"

#include <algorithm>
#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::AllOf;
using ::testing::Each;
using ::testing::Ge;
using ::testing::Le;

namespace {

constexpr int atlasSide = 512;
constexpr int pictureWidth = 1280;
constexpr int pictureHeight = 960;

/// Frames of the sample's walk with their own textures, as eight cameras show them.
class ProjectedSample : public ::testing::Test
{
protected:
    ProjectedSample()
    {
        const SampleCharacter sample = makeSampleCharacter({.textureSize = 2 * atlasSide, .takesPerKind = 1});
        const SampleBody body = forTexturesOf(atlasSide, sample.body);
        const TexelMap texels = mapTexels(body.topology->data(), atlasSide, 4);
        const auto walk = std::ranges::find_if(
            sample.takes, [](const SampleTake& take) { return take.appearance.has_value(); });
        std::vector<Vec3f> positions;
        std::vector<Texture> textures;
        for (const std::int64_t f : {7, 25}) {
            const Frame posed = walk->sequence.frame(FrameIndex(f));
            positions.insert(positions.end(), posed.positions().begin(), posed.positions().end());
            truths.push_back(std::make_shared<const Image>(
                frameTexture(body, texels, posed.positions(), *walk->appearance, FrameIndex(f))));
            textures.push_back({{}, truths.back()});
        }
        clip = makeSequence("walk", body.topology,
                            std::make_shared<MemoryFrames>(positions, body.topology->vertexCount()), 25);
        clip.textures = TextureSet::perFrame(textures);
        cameras = ringOfCameras(boundsOf(clip), 8, double{pictureWidth} / pictureHeight);
    }

    void takePictures()
    {
        for (FrameIndex f(0); f.value < clip.frameCount(); ++f)
            pictures.push_back(photographs(clip, f, cameras, pictureWidth, pictureHeight));
    }

    /// SSIM over the texels that some camera sees, of each frame.
    std::vector<double> similarities(const std::vector<PinholeCamera>& calibrated, std::size_t step = 1)
    {
        std::vector<PinholeCamera> used;
        for (std::size_t c = 0; c < calibrated.size(); c += step)
            used.push_back(calibrated[c]);
        const TextureProjector projector(clip.topology, used, atlasSide, atlasSide);
        std::vector<double> found(truths.size());
        coverage.assign(truths.size(), 0);
        for (FrameIndex f(0); f.value < clip.frameCount(); ++f) {
            const auto at = static_cast<std::size_t>(f.value);
            std::vector<std::shared_ptr<const Image>> seen;
            for (std::size_t c = 0; c < calibrated.size(); c += step)
                seen.push_back(pictures[at][c]);
            const ProjectedTexels texels = projector.project(clip.frame(f).positions(), seen);
            const Image baked = filledTexture(projector.atlas(), texels.colours, texels.colours);
            std::vector<std::uint8_t> mask(static_cast<std::size_t>(atlasSide * atlasSide));
            for (std::size_t t = 0; t < texels.colours.size(); ++t)
                mask[projector.atlas().places[t].texel] = texels.colours[t].trust > 0 ? 1 : 0;
            found[at] = pictureQuality(*truths[at], baked, mask).similarity;
            coverage[at] = static_cast<double>(texels.seen) / static_cast<double>(texels.colours.size());
        }
        return found;
    }

    MeshSequence clip;
    std::vector<std::shared_ptr<const Image>> truths;
    std::vector<Camera> cameras;
    std::vector<std::vector<std::shared_ptr<const Image>>> pictures;
    std::vector<double> coverage;
};

} // namespace

// One test, because it takes long to take the pictures.
TEST_F(ProjectedSample, IsMetWhereCamerasSeeItAndSuffersFromOneThatIsWrong)
{
    takePictures();
    auto calibrated = pinholesOf(cameras, pictureWidth, pictureHeight);
    // Measured: 0.983 to 0.986 of 94 to 97 % of the texels; of 90 to 94 % with four cameras. Rendering and
    // looking up blur, which costs the rest.
    EXPECT_THAT(similarities(calibrated), Each(Ge(0.98)));
    EXPECT_THAT(coverage, Each(Ge(0.92)));
    // Half of the cameras see less, and that as well.
    EXPECT_THAT(similarities(calibrated, 2), Each(Ge(0.98)));
    EXPECT_THAT(coverage, Each(AllOf(Ge(0.88), Le(0.96))));

    // Measured: 0.976 to 0.980 for one pixel, 0.956 to 0.959 for three.
    calibrated.front().cx += 1;
    const std::vector<double> off = similarities(calibrated);
    EXPECT_THAT(off, Each(Ge(0.97)));
    calibrated.front().cx += 2;
    const std::vector<double> farOff = similarities(calibrated);
    for (std::size_t f = 0; f < off.size(); ++f)
        EXPECT_LT(farOff[f], off[f] - 0.01);
}

// Rays know no margins. What is trusted they see. What they see from the front is seen without margins, but
// for two pixels at edges, which show what lies in front or behind as well: about a twentieth of a body.
TEST_F(ProjectedSample, IsSeenWhereRaysSeeIt)
{
    const auto calibrated = pinholesOf(cameras, pictureWidth, pictureHeight);
    const Topology& mesh = *clip.topology;
    const AtlasTexels atlas = atlasTexels(mesh, atlasSide, atlasSide);
    const Frame frame = clip.frame(FrameIndex(0));
    const std::vector<Vec3f> normals = vertexNormals(
        frame.positions(), mesh.triangles(), trianglesOfVertices(mesh.triangles(), mesh.vertexCount()));
    int seen = 0;
    int leaking = 0;
    int missed = 0;
    for (std::size_t c = 0; c < calibrated.size(); c += 3) {
        const CameraView view(calibrated[c], frame.positions(), mesh.triangles());
        const CameraView bare(calibrated[c], frame.positions(), mesh.triangles(),
                              {.grazing = 0, .facing = 1e-3, .edgeMargin = 1e-3, .borderMargin = 1e-3});
        for (std::size_t t = 0; t < atlas.places.size(); t += 37) {
            const AtlasTexels::Place& place = atlas.places[t];
            const SurfaceSample sample{
                pointOf(place, frame.positions(), mesh.triangles()),
                normals[mesh.triangles()[place.triangle.value][0].value].cast<double>(), place.triangle};
            const bool isFree = plainlySees(calibrated[c], place, frame.positions(), mesh.triangles());
            leaking += view.sightOf(sample) && !isFree ? 1 : 0;
            if (isFree && sample.normal.dot((calibrated[c].centre() - sample.point).normalized()) > 0.5) {
                ++seen;
                missed += bare.sightOf(sample) ? 0 : 1;
            }
        }
    }
    EXPECT_GT(seen, 2000);
    EXPECT_LE(leaking, 3); // measured: none
    EXPECT_LE(missed, seen / 12);
}
