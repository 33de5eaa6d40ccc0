// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/parts/bodyparts.h"
#include "tests/model/codeof.h"
#include "tests/model/geometry/surfaces.h"

#include <array>
#include <gmock/gmock.h>

namespace quadrille {
namespace {

using namespace test;
using test::codeOf;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::uint32_t around = 8;

PartCurve ringCurve(const std::string& name, std::uint32_t r)
{
    return {name, ring(around, r)};
}

const PartDescription torso{.name = "torso", .parent = {}, .curves = {}};

/// Torso, arm and forearm of a limb of 40 rings: they overlap at rings 10–14 and 24–27.
std::vector<PartCurve> armCurves()
{
    return {ringCurve("shoulder", 10), ringCurve("sleeve", 14), ringCurve("cuff", 27),
            ringCurve("elbow", 24)};
}

std::vector<PartDescription> armParts()
{
    return {{"forearm", "arm", {"cuff", "elbow"}}, torso, {"arm", "torso", {"sleeve", "shoulder"}}};
}

BodyParts cut(const Surface& surface, const std::vector<PartCurve>& curves,
              const std::vector<PartDescription>& parts)
{
    return cutIntoParts(*surface.topology(), surface.pose, curves, parts);
}

std::vector<ErrorCode> codes(const Surface& surface, const std::vector<PartCurve>& curves,
                             const std::vector<PartDescription>& parts)
{
    std::vector<ErrorCode> found;
    for (const PartProblem& problem : partProblems(*surface.topology(), curves, parts))
        found.push_back(problem.error.code());
    return found;
}

/// How many parts each triangle belongs to.
std::vector<int> sharers(const Surface& surface, const BodyParts& parts)
{
    std::vector<int> found(surface.data.triangles.size());
    for (const BodyPart& part : parts.parts) {
        for (const TriangleIndex t : part.triangles)
            ++found[t.value];
    }
    return found;
}

TEST(BodyParts, OfALimbOverlapBetweenTheirCurves)
{
    const Surface limb = makeTube(around, 40, 1, 1);
    const BodyParts parts = cut(limb, armCurves(), armParts());
    ASSERT_EQ(parts.parts.size(), 3U);
    EXPECT_EQ(parts.parts[0].name, "torso");
    EXPECT_EQ(parts.parts[1].name, "arm");
    EXPECT_EQ(parts.parts[2].name, "forearm");
    EXPECT_EQ(parts.parts[0].parent, -1);
    EXPECT_EQ(parts.parts[1].parent, 0);
    EXPECT_EQ(parts.parts[2].parent, 1);
    // Rings 0–14, 10–27 and 24–39.
    EXPECT_EQ(parts.parts[0].vertices.size(), 15 * around);
    EXPECT_EQ(parts.parts[1].vertices.size(), 18 * around);
    EXPECT_EQ(parts.parts[2].vertices.size(), 16 * around);
    EXPECT_EQ(parts.parts[0].triangles.size(), 14 * 2 * around);
    EXPECT_EQ(parts.parts[1].overlap.size(), 5 * around);
    EXPECT_EQ(parts.parts[1].overlapTriangles.size(), 4 * 2 * around);
    EXPECT_EQ(parts.parts[1].overlap.front(), VertexIndex(10 * around));
    EXPECT_EQ(parts.parts[1].end, ring(around, 10));
    EXPECT_EQ(parts.parts[1].parentEnd, ring(around, 14));
    EXPECT_EQ(parts.parts[2].end, ring(around, 24));
    EXPECT_EQ(parts.parts[2].parentEnd, ring(around, 27));
    EXPECT_THAT(parts.parts[0].overlap, IsEmpty());
    for (const BodyPart& part : parts.parts) {
        EXPECT_TRUE(std::ranges::is_sorted(part.vertices));
        EXPECT_TRUE(std::ranges::is_sorted(part.triangles));
        EXPECT_TRUE(std::ranges::is_sorted(part.overlap));
        EXPECT_TRUE(std::ranges::includes(part.vertices, part.overlap));
        EXPECT_TRUE(std::ranges::includes(part.triangles, part.overlapTriangles));
    }
    const std::vector<int> shared = sharers(limb, parts);
    EXPECT_EQ(std::ranges::count(shared, 1), (10 + 10 + 12) * 2 * around);
    EXPECT_EQ(std::ranges::count(shared, 2), (4 + 3) * 2 * around);
}

TEST(BodyParts, TellWhereAVertexBelongs)
{
    const Surface limb = makeTube(around, 40, 1, 1);
    const BodyParts parts = cut(limb, armCurves(), armParts());
    const std::vector<VertexPart> where = partOfVertex(parts, limb.data.vertexCount);
    const auto at = [&](std::uint32_t r) {
        return std::pair(where[r * around].part, where[r * around].overlap);
    };
    EXPECT_EQ(at(9), std::pair(0, -1));
    EXPECT_EQ(at(10), std::pair(1, 1));
    EXPECT_EQ(at(14), std::pair(1, 1));
    EXPECT_EQ(at(15), std::pair(1, -1));
    EXPECT_EQ(at(24), std::pair(2, 2));
    EXPECT_EQ(at(28), std::pair(2, -1));
}

TEST(BodyParts, AreOneWholeWithoutDescriptions)
{
    const Surface limb = makeTube(around, 5, 1, 1);
    const BodyParts parts = cut(limb, {ringCurve("unused", 2)}, {});
    ASSERT_EQ(parts.parts.size(), 1U);
    EXPECT_EQ(parts.parts[0].name, "body");
    EXPECT_EQ(parts.parts[0].vertices.size(), limb.data.vertexCount);
    EXPECT_EQ(parts.parts[0].triangles.size(), limb.data.triangles.size());
    EXPECT_EQ(cut(limb, {}, {torso}).parts[0].name, "torso");
}

TEST(BodyParts, TakeTheGreaterPieceForTheRootOfTwo)
{
    const std::vector<PartDescription> two{torso, {"arm", "torso", {"one", "other"}}};
    for (const std::uint32_t first : {10U, 25U}) {
        const BodyParts parts =
            cut(makeTube(around, 40, 1, 1), {ringCurve("one", first), ringCurve("other", first + 3)}, two);
        EXPECT_EQ(parts.parts[1].end, ring(around, first == 10 ? 13 : 10 + 15)) << first;
        EXPECT_EQ(parts.parts[1].vertices.size(), (first == 10 ? 14 : 15) * around);
    }
}

TEST(BodyParts, GrowFromOneRootInManyDirections)
{
    // Two arms at the ends and the torso between.
    const Surface limb = makeCapsule(around, 40);
    const BodyParts parts =
        cut(limb, {ringCurve("a", 5), ringCurve("b", 8), ringCurve("c", 30), ringCurve("d", 35)},
            {torso, {"left", "torso", {"a", "b"}}, {"right", "torso", {"d", "c"}}});
    EXPECT_EQ(parts.parts[1].end, ring(around, 8));
    EXPECT_EQ(parts.parts[1].parentEnd, ring(around, 5));
    EXPECT_EQ(parts.parts[2].end, ring(around, 30));
    EXPECT_EQ(parts.parts[0].vertices.size(), 31 * around);
    EXPECT_EQ(parts.parts[1].vertices.size(), 9 * around + 1);
}

TEST(BodyParts, DoNotDependOnNumbersOrDirections)
{
    const Surface limb = makeCapsule(around, 40);
    const auto places = shuffledPlaces(limb.data.vertexCount, 8);
    std::vector<PartCurve> curves = armCurves();
    const BodyParts here = cut(limb, curves, armParts());
    for (PartCurve& curve : curves) {
        for (VertexIndex& v : curve.vertices)
            v = VertexIndex(places[v.value]);
    }
    std::ranges::reverse(curves[1].vertices);
    std::ranges::reverse(curves);
    const BodyParts there = cut(renumbered(limb, places), curves, armParts());
    for (std::size_t p = 0; p < here.parts.size(); ++p) {
        std::set<VertexIndex> expected;
        for (const VertexIndex v : here.parts[p].vertices)
            expected.emplace(places[v.value]);
        EXPECT_EQ(setOf(there.parts[p].vertices), expected);
        EXPECT_EQ(there.parts[p].triangles, here.parts[p].triangles);
        EXPECT_EQ(there.parts[p].overlapTriangles, here.parts[p].overlapTriangles);
    }
}

TEST(BodyParts, TakeLoosePiecesToTheNearestPart)
{
    Surface limb = makeTube(around, 40, 1, 1);
    Surface ball = makeCapsule(5, 3);
    for (Vec3f& p : ball.pose)
        p = p * 0.1F + Vec3f(1.5F, 35, 0); // beside the forearm
    limb = together(limb, ball);
    limb.pose.emplace_back(-2.0F, 1.0F, 0.0F); // a vertex without triangles, beside the torso
    limb.data.vertexCount += 1;
    const BodyParts parts = cut(limb, armCurves(), armParts());
    EXPECT_EQ(parts.parts[2].vertices.size(), 16 * around + ball.data.vertexCount);
    EXPECT_EQ(parts.parts[0].vertices.size(), 15 * around + 1);
    EXPECT_EQ(parts.parts[0].vertices.back().value, limb.data.vertexCount - 1);
    EXPECT_EQ(std::ranges::count(sharers(limb, parts), 0), 0);
}

TEST(BodyParts, OfClothesInSeveralPiecesFollowTheSameTree)
{
    // A jacket with sleeves and trousers with legs: the torso is both.
    Surface jacket = makeTube(around, 40, 1, 1);
    Surface trousers = makeTube(around, 40, 1, 1);
    for (Vec3f& p : trousers.pose)
        p.y() -= 50;
    const Surface clothes = together(jacket, trousers);
    const std::uint32_t second = 40;
    const BodyParts parts =
        cut(clothes,
            {ringCurve("a", 5), ringCurve("b", 8), ringCurve("c", second + 5), ringCurve("d", second + 8)},
            {torso, {"arm", "torso", {"a", "b"}}, {"leg", "torso", {"c", "d"}}});
    EXPECT_EQ(parts.parts[0].vertices.size(), 2 * 35 * around);
    EXPECT_EQ(parts.parts[1].vertices.size(), 9 * around);
    EXPECT_EQ(parts.parts[2].vertices.size(), 9 * around);
}

TEST(BodyParts, MayBeThreeVerticesThin)
{
    const Surface thin = makeTube(3, 12, 1, 0.1F);
    const BodyParts parts =
        cut(thin, {{"a", ring(3, 5)}, {"b", ring(3, 6)}}, {torso, {"arm", "torso", {"a", "b"}}});
    EXPECT_EQ(parts.parts[0].vertices.size(), 7U * 3);
    EXPECT_EQ(parts.parts[1].overlapTriangles.size(), 6U);
}

TEST(BodyParts, MayTouchHoles)
{
    // A curve that passes through two vertices of the rim of a hole: a triangle beside the ring is missing.
    Surface limb = makeTube(around, 20, 1, 1);
    limb.data.triangles.erase(limb.data.triangles.begin() + 8 * 2 * around);
    const BodyParts parts =
        cut(limb, {ringCurve("a", 8), ringCurve("b", 11)}, {torso, {"arm", "torso", {"a", "b"}}});
    EXPECT_EQ(parts.parts[1].overlapTriangles.size(), 3 * 2 * around - 1);
    EXPECT_EQ(std::ranges::count(sharers(limb, parts), 0), 0);
    // Two gaps take the row between two curves to pieces, which stay one overlap.
    Surface gaps = makeTube(around, 20, 1, 1);
    gaps.data.triangles.erase(gaps.data.triangles.begin() + 8 * 2 * around + 6);
    gaps.data.triangles.erase(gaps.data.triangles.begin() + 8 * 2 * around);
    const BodyParts thin =
        cut(gaps, {ringCurve("a", 8), ringCurve("b", 9)}, {torso, {"arm", "torso", {"a", "b"}}});
    EXPECT_EQ(thin.parts[1].overlapTriangles.size(), 2 * around - 2);
}

TEST(PartProblems, AreNoneWhereAllIsWell)
{
    EXPECT_THAT(codes(makeTube(around, 40, 1, 1), armCurves(), armParts()), IsEmpty());
    EXPECT_THAT(codes(makeTube(around, 40, 1, 1), {}, {}), IsEmpty());
}

TEST(PartProblems, OfCurvesNameEachWithItsPlace)
{
    const Surface limb = makeTube(around, 40, 1, 1);
    PartCurve open = ringCurve("open", 3);
    std::swap(open.vertices[2], open.vertices[5]);
    PartCurve twice = ringCurve("twice", 6);
    twice.vertices.insert(twice.vertices.begin() + 4, twice.vertices[0]);
    PartCurve crossing = ringCurve("crossing", 9);
    crossing.vertices.insert(crossing.vertices.begin() + 1,
                             {VertexIndex(10 * around), VertexIndex(10 * around + 1)});
    crossing.vertices.erase(crossing.vertices.begin() + 3);
    PartCurve patch{"line", {VertexIndex(20 * around), VertexIndex(20 * around + 1)}};
    PartCurve outside = ringCurve("outside", 15);
    outside.vertices[3] = VertexIndex(5000);
    const std::vector<PartCurve> curves{open,  twice,   ringCurve("good", 10), crossing,
                                        patch, outside, ringCurve("good", 30)};
    const auto problems = partProblems(*limb.topology(), curves, {});
    const auto find = [&](const std::string& name, ErrorCode code) -> const PartProblem* {
        const auto found = std::ranges::find_if(
            problems, [&](const PartProblem& p) { return p.curve == name && p.error.code() == code; });
        return found == problems.end() ? nullptr : &*found;
    };
    const PartProblem* problem = find("open", ErrorCode::CurveOpen);
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->error.context().values, (std::vector<std::pair<std::string, std::string>>{
                                                   {"curve", "open"}, {"from", "25"}, {"to", "29"}}));
    EXPECT_EQ(problem->at.front(), VertexIndex(25));
    problem = find("twice", ErrorCode::CurveMeetsItself);
    ASSERT_TRUE(problem);
    EXPECT_THAT(problem->at, ElementsAre(VertexIndex(6 * around)));
    problem = find("crossing", ErrorCode::CurveMeetsOther);
    ASSERT_TRUE(problem);
    EXPECT_THAT(problem->at, ElementsAre(VertexIndex(10 * around), VertexIndex(10 * around + 1)));
    EXPECT_TRUE(find("line", ErrorCode::CurveShort));
    EXPECT_TRUE(find("outside", ErrorCode::CurveVertexOutside));
    EXPECT_TRUE(find("good", ErrorCode::CurveNameTaken));
    EXPECT_FALSE(find("crossing", ErrorCode::CurveOpen));
}

TEST(PartProblems, NoticeACurveThatDoesNotSeparate)
{
    const Surface torus = makeTorus(around, 20, 4, 1);
    EXPECT_THAT(codes(torus, {ringCurve("meridian", 3)}, {}), ElementsAre(ErrorCode::CurveDoesNotSeparate));
    // Along the rim of an open tube there is nothing on the other side.
    EXPECT_THAT(codes(makeTube(around, 9, 1, 1), {ringCurve("rim", 0)}, {}),
                ElementsAre(ErrorCode::CurveDoesNotSeparate));
}

TEST(PartProblems, OfATree)
{
    const Surface limb = makeTube(around, 40, 1, 1);
    const auto curves = armCurves();
    const auto of = [&](const std::vector<PartDescription>& parts) { return codes(limb, curves, parts); };
    const PartDescription arm{"arm", "torso", {"shoulder", "sleeve"}};
    EXPECT_THAT(of({torso, arm, {"arm", "torso", {"cuff", "elbow"}}}), ElementsAre(ErrorCode::PartNameTaken));
    EXPECT_THAT(of({torso, arm, {"head", "", {}}}), ElementsAre(ErrorCode::PartRootTwice));
    EXPECT_THAT(of({{"arm", "hand", {"shoulder", "sleeve"}}, torso}),
                ElementsAre(ErrorCode::PartParentUnknown));
    EXPECT_THAT(of({torso, {"arm", "hand", {"shoulder", "sleeve"}}, {"hand", "arm", {"cuff", "elbow"}}}),
                ElementsAre(ErrorCode::PartCycle, ErrorCode::PartCycle));
    EXPECT_THAT(of({{"arm", "hand", {"shoulder", "sleeve"}}, {"hand", "arm", {"cuff", "elbow"}}}),
                ElementsAre(ErrorCode::PartCycle, ErrorCode::PartCycle, ErrorCode::PartRootMissing));
    for (const auto& bad : std::vector<std::vector<std::string>>{{"shoulder"}, {2, "shoulder"}})
        EXPECT_THAT(of({torso, {"arm", "torso", bad}}), ElementsAre(ErrorCode::PartCurveCount));
    EXPECT_THAT(of({{"torso", "", {"shoulder"}}}), ElementsAre(ErrorCode::PartCurveCount));
    EXPECT_THAT(of({torso, {"arm", "torso", {"shoulder", "neck"}}}),
                ElementsAre(ErrorCode::PartCurveUnknown));
    EXPECT_THAT(of({torso, arm, {"hand", "arm", {"sleeve", "elbow"}}}),
                ElementsAre(ErrorCode::PartCurveShared));
}

TEST(PartProblems, OfPlaces)
{
    const Surface limb = makeTube(around, 40, 1, 1);
    auto curves = armCurves();
    // Another pair of curves lies between.
    EXPECT_THAT(codes(limb, curves,
                      {torso, {"arm", "torso", {"shoulder", "cuff"}}, {"hand", "arm", {"sleeve", "elbow"}}}),
                ElementsAre(ErrorCode::PartCurvesApart));
    // Curves around two components.
    const Surface two = together(limb, limb);
    EXPECT_THAT(codes(two, {ringCurve("a", 5), ringCurve("b", 45)}, {torso, {"arm", "torso", {"a", "b"}}}),
                ElementsAre(ErrorCode::PartCurvesApart));
    // Hand and arm in a row cannot both hang on the torso, which would have to be between and beyond.
    curves = {ringCurve("a", 5),  ringCurve("b", 7),  ringCurve("c", 15),
              ringCurve("d", 17), ringCurve("e", 25), ringCurve("f", 27)};
    EXPECT_THAT(codes(limb, curves,
                      {torso,
                       {"arm", "torso", {"a", "b"}},
                       {"hand", "torso", {"c", "d"}},
                       {"finger", "hand", {"e", "f"}}}),
                IsEmpty());
    EXPECT_THAT(codes(limb, curves,
                      {torso,
                       {"arm", "torso", {"a", "b"}},
                       {"finger", "hand", {"c", "d"}},
                       {"hand", "torso", {"e", "f"}}}),
                ElementsAre(ErrorCode::PartMisplaced));
    // Nothing is left between two overlaps but an edge's width.
    EXPECT_THAT(codes(limb, {ringCurve("a", 10), ringCurve("b", 14), ringCurve("c", 15), ringCurve("d", 19)},
                      {torso, {"arm", "torso", {"a", "b"}}, {"hand", "arm", {"c", "d"}}}),
                ElementsAre(ErrorCode::PartEmpty));
}

TEST(PartProblems, NoticeALimbThatStandsBetweenTwoCurves)
{
    constexpr std::uint32_t wide = 20;
    // The vertices some steps from one in the middle of a tube's side.
    const auto patch = [](const std::string& name, std::uint32_t steps) {
        PartCurve curve{name, {}};
        std::uint32_t ring = 20;
        std::uint32_t place = 10 + steps;
        const std::array<std::array<int, 2>, 6> ways{{{1, -1}, {0, -1}, {-1, 0}, {-1, 1}, {0, 1}, {1, 0}}};
        for (const auto& [up, along] : ways) {
            for (std::uint32_t i = 0; i < steps; ++i) {
                curve.vertices.emplace_back(ring * wide + place);
                ring = static_cast<std::uint32_t>(static_cast<int>(ring) + up);
                place = static_cast<std::uint32_t>(static_cast<int>(place) + along);
            }
        }
        return curve;
    };
    const Surface limb = makeTube(wide, 40, 1, 1);
    const std::vector<PartCurve> curves{
        {"a", ring(wide, 10)}, {"b", ring(wide, 30)}, patch("c", 2), patch("d", 4)};
    const PartDescription arm{"arm", "torso", {"a", "b"}};
    const PartDescription button{"button", "torso", {"c", "d"}};
    EXPECT_THAT(codes(limb, curves, {torso, arm}), IsEmpty());
    EXPECT_THAT(codes(limb, curves, {torso, button}), IsEmpty());
    EXPECT_THAT(codes(limb, curves, {torso, arm, button}), ElementsAre(ErrorCode::PartCurvesApart));
}

TEST(PartProblems, SayNothingOfWhatFollowsFromAnother)
{
    auto curves = armCurves();
    curves[0].vertices.pop_back();
    EXPECT_THAT(codes(makeTube(around, 40, 1, 1), curves, armParts()), ElementsAre(ErrorCode::CurveOpen));
}

TEST(BodyParts, AreNotCutByFaultyDescriptions)
{
    const Surface limb = makeTube(around, 40, 1, 1);
    auto curves = armCurves();
    curves[2].vertices.pop_back();
    EXPECT_EQ(codeOf([&] { cut(limb, curves, armParts()); }), ErrorCode::CurveOpen);
    // A faulty curve that no part uses does no harm.
    EXPECT_EQ(cut(limb, curves, {torso, {"arm", "torso", {"shoulder", "sleeve"}}}).parts.size(), 2U);
    EXPECT_THAT(unusedCurves(curves, std::vector{torso, {"arm", "torso", {"shoulder", "sleeve"}}}),
                ElementsAre("cuff", "elbow"));
    try {
        cut(limb, curves, armParts());
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("“cuff”"), std::string::npos) << error.what();
    }
}

} // namespace
} // namespace quadrille
