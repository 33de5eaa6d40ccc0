// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/jobs/jobrunner.h"
#include "editor/workspaces/variations/partcurvejobs.h"
#include "editor/workspaces/variations/partcurveroute.h"
#include "editor/workspaces/variations/partcurveview.h"
#include "editor/workspaces/variations/partedits.h"
#include "tests/model/geometry/surfaces.h"
#include "tests/qt/registry.h"

#include <QCoreApplication>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

constexpr std::uint32_t limbRing = 12; // vertices of a ring

/// A limb along y with a tip at each end: nine rings of radius 20 cm, 10 cm apart. It bends by 63 degrees at
/// its first and last ring.
std::shared_ptr<const SurfaceGraph> limb()
{
    return test::withTips(test::makeTube(limbRing, 9, 0.1F, 0.2F), limbRing, 0.1F).graph();
}

VertexIndex onRing(std::uint32_t ring, std::uint32_t k)
{
    return VertexIndex(ring * limbRing + k);
}

/// Around the limb, led by three points.
PartCurveEntry curveOnRing(const std::string& name, std::uint32_t ring)
{
    PartCurveEntry entry;
    entry.curve.name = name;
    for (std::uint32_t k = 0; k < limbRing; ++k)
        entry.curve.vertices.push_back(onRing(ring, k));
    entry.points = {onRing(ring, 0), onRing(ring, 4), onRing(ring, 8)};
    return entry;
}

PartEntry partOf(const std::string& name, const std::string& parent, const std::vector<std::string>& curves)
{
    PartEntry entry;
    entry.part.name = name;
    entry.part.parent = parent;
    entry.part.curves = curves;
    return entry;
}

/// The rings that a curve runs on, lowest and highest.
std::pair<std::uint32_t, std::uint32_t> ringsOf(const PartCurveEntry& entry)
{
    const auto [lowest, highest] = std::ranges::minmax(entry.curve.vertices);
    return {lowest.value / limbRing, highest.value / limbRing};
}

} // namespace

/// Curves and parts of a body – what is known of them, led over the surface, computed – without a window.
class TestPartCurves : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void curvesAreFoundByIndexAndName();
    void lengthsAreOfWholeCurves();
    void partsAreMadeOfLooseCurvesSideBySide();
    void newCurvesSurroundTheLimb();
    void pointsMoveAndLeaveTheCurveWhereTheyCannot();
    void curvesAreLedOnFromTheirLastPoint();
    void pointsJumpToFreeCreases();
    void curvesAreShownAsFarAsTheyGo();
    void secondCurvesGoWhereThereIsRoom();
    void newPartsGetASecondCurve();
    void curvesBecomeShorter();
    void theOtherSideIsNamed();
    void proposalsKnowTheHeight();
    void jobsTellWhatTheyComputed();
    void jobsOfAnotherBodyTellNothing();

private:
    widgets::SurfacePlace placeAt(VertexIndex vertex, bool snaps = true) const
    {
        widgets::SurfacePlace place;
        place.pick.triangle = m_content.graph->trianglesOf(vertex).front();
        const Triangle& triangle = m_content.graph->topology().triangles()[place.pick.triangle];
        for (std::size_t corner = 0; corner < 3; ++corner)
            place.pick.barycentric[corner] = triangle[corner] == vertex ? 1.0F : 0.0F;
        place.snaps = snaps;
        return place;
    }
    PartCurveEntry& curve(const std::string& name) { return *findCurve(m_content.body, name); }

    PartCurveContent m_content;
};

void TestPartCurves::init()
{
    m_content = {};
    m_content.graph = limb();
    m_content.body.curves = {curveOnRing("low", 2), curveOnRing("middle", 4), curveOnRing("high", 7)};
}

void TestPartCurves::curvesAreFoundByIndexAndName()
{
    QCOMPARE(m_content.indexOf("high"), 2);
    QCOMPARE(m_content.indexOf("none"), -1);
    QVERIFY(m_content.curveAt(1) == &curve("middle"));
    QVERIFY(m_content.curveAt(-1) == nullptr && m_content.curveAt(3) == nullptr);
    m_content.body.parts = {partOf("low", "", {})};
    m_content.selected = {PartSelection::Kind::Curve, "low"};
    QVERIFY(m_content.selectedCurve() == &curve("low") && m_content.selectedPart() == nullptr);
    m_content.selected.kind = PartSelection::Kind::Part;
    QVERIFY(m_content.selectedCurve() == nullptr);
    QVERIFY(m_content.selectedPart() == &m_content.body.parts.front());
}

void TestPartCurves::lengthsAreOfWholeCurves()
{
    const double side = 2 * 0.2 * std::sin(M_PI / limbRing);
    QVERIFY(std::abs(m_content.lengthOfCurve("low") - limbRing * side) < 1e-5);
    QCOMPARE(m_content.lengthOfCurve("none"), 0.0);
    curve("low").curve.vertices.pop_back(); // no edge leads over the gap
    QCOMPARE(m_content.lengthOfCurve("low"), 0.0);
    curve("middle").curve.vertices.back() = VertexIndex(9999);
    QCOMPARE(m_content.lengthOfCurve("middle"), 0.0);
    m_content.graph.reset();
    QCOMPARE(m_content.lengthOfCurve("high"), 0.0);
}

void TestPartCurves::partsAreMadeOfLooseCurvesSideBySide()
{
    using Names = std::vector<std::string>;
    QCOMPARE(m_content.curvesForPart(), (Names{"low", "middle"}));
    m_content.selected = {PartSelection::Kind::Curve, "high"};
    QCOMPARE(m_content.curvesForPart(), (Names{"high", "middle"}));
    m_content.body.parts = {partOf("body", "", {}), partOf("arm", "body", {"high", "middle"})};
    QCOMPARE(m_content.curvesForPart(), (Names{"low"})); // the selected one is taken
    QCOMPARE(m_content.looseCurves(), (Names{"low"}));
    m_content.body.parts.push_back(partOf("leg", "body", {"low"}));
    QVERIFY(m_content.curvesForPart().empty());
    m_content.body.parts.clear();
    m_content.graph.reset();
    QVERIFY(m_content.curvesForPart().empty());
}

void TestPartCurves::newCurvesSurroundTheLimb()
{
    PartCurveRoute route(m_content, nullptr, true);
    QVERIFY(route.name().empty());
    route.setName("new");
    route.insert(0, placeAt(onRing(5, 3), false));
    BodyPartsEntry body = m_content.body;
    route.putInto(body);
    QCOMPARE(body.curves.size(), 4U);
    QCOMPARE(body.curves.back().curve.name, std::string("new"));
    QCOMPARE(body.curves.back().points, std::vector{onRing(5, 3)});
    QCOMPARE(body.curves.back().curve.vertices.size(), std::size_t{limbRing});
    QCOMPARE(ringsOf(body.curves.back()), std::pair(5U, 5U));
    route.putInto(body);
    QCOMPARE(body.curves.size(), 4U); // in the place of the one before
}

void TestPartCurves::pointsMoveAndLeaveTheCurveWhereTheyCannot()
{
    PartCurveRoute route(m_content, &curve("middle"), true);
    QCOMPARE(route.name(), std::string("middle"));
    QVERIFY(!route.hasMoved());
    QVERIFY(!route.move(1, placeAt(onRing(4, 4), false))); // it is there
    QVERIFY(route.move(1, placeAt(onRing(5, 4), false)) && route.hasMoved());
    QCOMPARE(route.curve().points()[1], onRing(5, 4));
    QVERIFY(!route.move(1, placeAt(onRing(5, 4), false)));
    const auto vertices = route.curve().vertices();
    QVERIFY_EXCEPTION_THROWN(route.move(1, placeAt(onRing(2, 4), false)), Error); // on another curve
    QCOMPARE(route.curve().vertices(), vertices);
    QVERIFY(route.before() == m_content.body);
    route.remove(1);
    QCOMPARE(route.curve().points(), (std::vector{onRing(4, 0), onRing(4, 8)}));
}

void TestPartCurves::curvesAreLedOnFromTheirLastPoint()
{
    PartCurveEntry entry = curve("middle");
    entry.points.pop_back();
    PartCurveRoute route(m_content, &entry, true);
    route.leadTo(placeAt(onRing(4, 7), false));
    QCOMPARE(route.curve().points(), (std::vector{onRing(4, 0), onRing(4, 4), onRing(4, 7)}));
    route.leadTo(placeAt(onRing(4, 8), false)); // moves that point
    QCOMPARE(route.curve().points(), (std::vector{onRing(4, 0), onRing(4, 4), onRing(4, 8)}));
    std::vector<std::uint32_t> expected; // from the point before it to the first one
    for (std::uint32_t k = 4; k <= limbRing; ++k)
        expected.push_back(onRing(4, k % limbRing).value);
    QCOMPARE(route.lastPieces(), expected);
}

void TestPartCurves::pointsJumpToFreeCreases()
{
    m_content.drawing = {.snaps = true, .snapRadius = 0.15};
    m_content.body.curves.clear();
    const auto pointAt = [this](bool snaps) {
        PartCurveRoute route(m_content, nullptr, true);
        route.insert(0, placeAt(onRing(7, 3), snaps));
        return route.curve().points().front();
    };
    QCOMPARE(pointAt(true), onRing(8, 3));
    QCOMPARE(pointAt(false), onRing(7, 3));
    m_content.drawing.snapRadius = 0.05; // too far away
    QCOMPARE(pointAt(true), onRing(7, 3));
    m_content.drawing = {.snaps = false, .snapRadius = 0.15};
    QCOMPARE(pointAt(true), onRing(7, 3));
    m_content.drawing.snaps = true;
    m_content.body.curves = {curveOnRing("end", 8)};
    QCOMPARE(pointAt(true), onRing(7, 3)); // another curve lies there
}

void TestPartCurves::curvesAreShownAsFarAsTheyGo()
{
    const auto whole = shownCurve(m_content.graph, curve("middle"));
    QVERIFY(whole.isClosed && whole.name == QLatin1String("middle"));
    QCOMPARE(whole.vertices.size(), std::size_t{limbRing});
    QCOMPARE(whole.points, (std::vector<std::size_t>{0, 4, 8}));
    PartCurveEntry entry = curve("middle");
    entry.points.clear();
    QVERIFY(shownCurve(m_content.graph, entry).points.size() >= 3); // it gets some
    entry.curve.vertices[5] = VertexIndex(9999);
    const auto broken = shownCurve(m_content.graph, entry);
    QVERIFY(!broken.isClosed && broken.points.empty());
    QCOMPARE(broken.vertices.size(), std::size_t{limbRing - 1});
    entry = {.curve = {}, .points = {onRing(1, 1), onRing(1, 2)}, .unknown = {}};
    QCOMPARE(shownCurve(m_content.graph, entry).points, (std::vector<std::size_t>{0, 1}));
    QVERIFY(shownCurve(nullptr, entry).vertices.empty());
}

void TestPartCurves::secondCurvesGoWhereThereIsRoom()
{
    const auto second = [this](const char* first, double metres) {
        const BodyPartsEntry body =
            withSecondCurve(m_content.body, m_content.graph, curve(first), "second", metres);
        return *findCurve(body, "second");
    };
    const PartCurveEntry near = second("low", 0.1); // towards the nearer end
    QVERIFY(isWholeCurve(*m_content.graph, near.curve.vertices));
    QCOMPARE(ringsOf(near), std::pair(1U, 1U));
    QVERIFY(near.points.size() >= 3);
    m_content.body.curves.erase(m_content.body.curves.begin() + 1); // "middle"
    QVERIFY(ringsOf(second("low", 0.45)).first > 2);                // the limb ends before
    QVERIFY_EXCEPTION_THROWN(second("low", 5), Error);
}

void TestPartCurves::newPartsGetASecondCurve()
{
    const NewPart part{.name = "hand", .root = "body", .parent = {}, .curve = curve("low")};
    const BodyPartsEntry body = withNewPart(m_content.body, m_content.graph, part, 0.1);
    QCOMPARE(body.curves.size(), 4U);
    QCOMPARE(rootOf(body)->part.name, std::string("body"));
    QCOMPARE(findPart(body, "hand")->part.parent, std::string("body"));
    QCOMPARE(findPart(body, "hand")->part.curves,
             (std::vector<std::string>{"low", body.curves.back().curve.name}));
}

void TestPartCurves::curvesBecomeShorter()
{
    curve("middle").points.clear();
    auto& vertices = curve("middle").curve.vertices;
    vertices.insert(vertices.begin() + 6, onRing(5, 5)); // there and back
    const double before = m_content.lengthOfCurve("middle");
    m_content.body = withShortenedCurve(m_content.body, m_content.graph, "middle", 0.15);
    QVERIFY(m_content.lengthOfCurve("middle") < before - 0.1);
    QVERIFY(curve("middle").points.size() >= 3);
    QCOMPARE(ringsOf(curve("low")), std::pair(2U, 2U));
}

void TestPartCurves::theOtherSideIsNamed()
{
    const auto plan = [this] {
        return mirrorPlan(m_content, [](const std::string& name) { return name + "*"; });
    };
    using Names = std::map<std::string, std::string>;
    QVERIFY(!plan());
    m_content.selected = {PartSelection::Kind::Curve, "low"};
    QCOMPARE(plan()->names, (Names{{"low", "low*"}}));
    QVERIFY(!plan()->part && plan()->selection == (PartSelection{PartSelection::Kind::Curve, "low*"}));
    m_content.body.parts = {partOf("left leg", "", {"low", "left knee"}),
                            partOf("left foot", "left leg", {})};
    m_content.selected = {PartSelection::Kind::Part, "left foot"};
    QVERIFY(!plan()); // it has no curves
    m_content.body.parts[1].part.curves = {"left ankle", "low"};
    QCOMPARE(plan()->names, (Names{{"left ankle", "right ankle"}, {"low", "low*"}}));
    QCOMPARE(plan()->part->part.curves, (std::vector<std::string>{"right ankle", "low*"}));
    QCOMPARE(plan()->selection.name, std::string("right foot"));
    QCOMPARE(plan()->part->part.parent, std::string("left leg")); // there is no other leg yet
    m_content.body.parts.push_back(partOf("right leg", "", {}));
    QCOMPARE(plan()->part->part.parent, std::string("right leg"));
}

void TestPartCurves::proposalsKnowTheHeight()
{
    const ProposalSettings upright = proposalSettings(*m_content.graph, UpAxis::Y, 0.05);
    QVERIFY(upright.up == UpAxis::Y && std::abs(upright.overlap - 0.05) < 1e-6); // 80 cm and two tips
    const ProposalSettings lying = proposalSettings(*m_content.graph, UpAxis::Z, 0.05);
    QVERIFY(lying.up == UpAxis::Z && std::abs(lying.overlap - 0.125) < 1e-6);
}

void TestPartCurves::jobsTellWhatTheyComputed()
{
    JobRunner runner;
    PartCurveJobs jobs(m_content, runner);
    QSignalSpy begun(&jobs, &PartCurveJobs::begun);
    QSignalSpy busy(&jobs, &PartCurveJobs::busyChanged);
    jobs.addSecondCurve(); // to nothing
    QVERIFY(!jobs.isBusy() && begun.isEmpty());
    std::optional<BodyPartsEntry> told;
    PartSelection selected;
    connect(&jobs, &PartCurveJobs::computed, this,
            [&](const QString&, const BodyPartsEntry& body, const PartSelection& selection) {
                told = body;
                selected = selection;
            });
    std::optional<ErrorCode> failed;
    connect(&jobs, &PartCurveJobs::failed, this, [&](const Error& error) { failed = error.code(); });
    m_content.selected = {PartSelection::Kind::Curve, "low"};
    m_content.drawing.overlap = 0.1;
    jobs.addSecondCurve();
    QVERIFY(jobs.isBusy() && begun.size() == 1);
    jobs.addSecondCurve(); // one after the other
    QCOMPARE(begun.size(), 1);
    QTRY_VERIFY(!jobs.isBusy());
    QCOMPARE(busy.size(), 2);
    QVERIFY(told && !failed);
    QCOMPARE(told->curves.size(), 4U);
    QCOMPARE(selected, (PartSelection{PartSelection::Kind::Curve, told->curves.back().curve.name}));
    m_content.drawing.overlap = 5; // longer than the limb
    jobs.addSecondCurve();
    QTRY_VERIFY(!jobs.isBusy());
    QVERIFY(failed == ErrorCode::CurveNoParallel);
    m_content.graph.reset();
    jobs.shorten();
    QVERIFY(!jobs.isBusy());
}

void TestPartCurves::jobsOfAnotherBodyTellNothing()
{
    JobRunner runner;
    PartCurveJobs jobs(m_content, runner);
    QSignalSpy computed(&jobs, &PartCurveJobs::computed);
    m_content.selected = {PartSelection::Kind::Curve, "middle"};
    jobs.shorten();
    QVERIFY(jobs.isBusy());
    m_content.body.curves.pop_back();
    QTRY_VERIFY(!jobs.isBusy());
    QCOMPARE(computed.size(), 0);
}

} // namespace quadrille

QUADRILLE_QT_TEST_IN(QCoreApplication, quadrille::TestPartCurves);
#include "tst_partcurves.moc"
