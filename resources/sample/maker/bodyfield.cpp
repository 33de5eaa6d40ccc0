// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The surface of the figure: smooth unions of ellipsoids, tapered capsules and lofts.
#include "resources/sample/maker/body.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

Vec3d mirrored(const Vec3d& p)
{
    return {-p.x(), p.y(), p.z()};
}

/// Distance to a box, zero inside.
double boxDistance(const Vec3d& p, const Vec3d& low, const Vec3d& high)
{
    return (low - p).cwiseMax(p - high).cwiseMax(0.0).norm();
}

constexpr double legRound = 0.016;
constexpr double handRound = 0.016;
/// The box that the hand lies in, in its own axes; farther away than this the box stands for the hand.
const Vec3d handLow(-0.03, -0.06, -0.06);
const Vec3d handHigh(0.21, 0.10, 0.03);
constexpr double handNear = 0.05;
/// More than what sums of these sizes are off by.
constexpr double slack = 1e-9;

} // namespace

double Body::faceDistance(const Vec3d& p) const
{
    double d = ellipsoidDistance(p, {0, 1.648, -0.004}, {0.0765, 0.092, 0.097});
    d = smoothUnion(d, ellipsoidDistance(p, {0, 1.570, 0.032}, {0.0595, 0.066, 0.060}), 0.035);
    d = smoothUnion(d, ellipsoidDistance(p, {0, 1.519, 0.074}, {0.025, 0.017, 0.018}), 0.022);
    d = smoothUnion(d, sphereDistance(p, {0.043, 1.592, 0.062}, 0.023), 0.030);
    d = smoothUnion(
        d, taperedCapsuleDistance(p, {0.0, 1.640, 0.086}, {0.045, 0.0 + 1.641, 0.066}, 0.012, 0.010), 0.018);
    d = smoothIntersection(d, -ellipsoidDistance(p, {0.033, 1.6195, 0.098}, {0.020, 0.0125, 0.016}), 0.014);
    d = smoothUnion(d, sphereDistance(p, {0.0325, 1.619, 0.0705}, 0.0165), 0.004);
    const double bridge = taperedCapsuleDistance(p, {0, 1.632, 0.089}, {0, 1.586, 0.1105}, 0.0080, 0.0120);
    const double wing = sphereDistance(p, {0.0115, 1.5815, 0.101}, 0.0085);
    d = smoothUnion(d, smoothUnion(bridge, wing, 0.008), 0.010);
    d = smoothUnion(d, ellipsoidDistance(p, {0, 1.5515, 0.0845}, {0.025, 0.0115, 0.0115}), 0.010);
    const Vec3d ear = p - Vec3d(0.0820, 1.602, -0.006);
    const Vec3d turned(ear.x() * 0.93 + ear.z() * 0.37, ear.y(), ear.z() * 0.93 - ear.x() * 0.37);
    return smoothUnion(d, ellipsoidDistance(turned, {0.003, 0, 0}, {0.0115, 0.033, 0.021}), 0.006);
}

double Body::hairDistance(const Vec3d& p) const
{
    double d = ellipsoidDistance(p, {0, 1.662, -0.011}, {0.0865, 0.092, 0.103});
    d = smoothUnion(d, ellipsoidDistance(p, {0, 1.728, 0.054}, {0.060, 0.026, 0.040}), 0.020);
    // Keeps what lies above the hairline from forehead to sideburn, and above the nape.
    const double hairline = (p.y() - 1.700) * -0.563 + (p.z() - 0.092) * 0.827;
    d = smoothIntersection(d, hairline, 0.012);
    d = smoothIntersection(d, 1.567 - p.y() + 0.35 * (p.z() + 0.07), 0.014);
    return smoothIntersection(d, -ellipsoidDistance(p, {0.090, 1.598, 0.000}, {0.030, 0.043, 0.034}), 0.008);
}

bool Body::isHair(const Vec3d& p) const
{
    Vec3d q = toReference(p, FigurePart::Head);
    q.x() = std::abs(q.x());
    return hairDistance(q) < faceDistance(q);
}

double Body::headDistance(const Vec3d& p) const
{
    const double neckY = height(bodyNeckHeight);
    if (const double box =
            boxDistance(p, {0, neckY - 0.01, -0.13 * m_proportions.head},
                        {0.11 * m_proportions.head, m_joints.headTop.y() + 0.03, 0.14 * m_proportions.head});
        box > 0.06)
        return box;
    const Vec3d q = toReference(p, FigurePart::Head);
    return m_proportions.head * smoothUnion(faceDistance(q), hairDistance(q), 0.006);
}

double Body::torsoDistance(const Vec3d& p) const
{
    const double g = m_proportions.girth;
    const auto at = [&](double x, double y, double z) { return Vec3d(x * g, height(y), z * g); };
    double d = m_torso.distance(p);
    const double chest = ellipsoidDistance(p, at(0.078, 1.315, 0.075), Vec3d(0.072, 0.055, 0.045) * g);
    d = smoothUnion(d, chest, 0.045);
    d = smoothUnion(d, ellipsoidDistance(p, at(0.080, 1.335, -0.085), Vec3d(0.070, 0.085, 0.042) * g), 0.04);
    const double seat = ellipsoidDistance(p, at(0.076, 0.895, -0.068), Vec3d(0.078, 0.085, 0.064) * g);
    const double otherSeat =
        ellipsoidDistance(mirrored(p), at(0.076, 0.895, -0.068), Vec3d(0.078, 0.085, 0.064) * g);
    d = smoothUnion(d, smoothUnion(seat, otherSeat, 0.02), 0.035);
    const Vec3d& s = m_joints.shoulder;
    const double slope = taperedCapsuleDistance(p, {0.02, height(1.44), -0.022}, s + Vec3d(-0.012, 0.0, 0),
                                                0.052, 0.050 * limbGirth());
    d = smoothUnion(d, slope, 0.045);
    const double throat = taperedCapsuleDistance(p, {0, height(1.40), -0.024}, {0, height(1.545), -0.004},
                                                 0.054 * m_proportions.head, 0.0495 * m_proportions.head);
    d = smoothUnion(d, throat, 0.016);
    // Collar: a ring that leans forward around the neck.
    const Vec3d c = p - Vec3d(0, height(1.462), -0.012);
    const double lean = 0.32;
    const double along = c.y() * std::cos(lean) + c.z() * std::sin(lean);
    const double ahead = c.z() * std::cos(lean) - c.y() * std::sin(lean);
    const double ring =
        std::hypot(std::hypot(c.x(), ahead * 0.94) - 0.067 * m_proportions.head, along * 0.62) - 0.0105;
    return smoothUnion(d, ring, 0.012);
}

/// Along the hand, to its thumb, off its palm.
Vec3d Body::inHand(const Vec3d& p) const
{
    const Vec3d q = p - m_joints.wrist;
    return {q.dot(bodyArmAlong), q.z(), q.dot(bodyArmOut)};
}

double Body::handDistance(const Vec3d& p) const
{
    const Vec3d h = inHand(p);
    if (const double box = boxDistance(h, handLow, handHigh); box > handNear)
        return box;
    double palm = ellipsoidDistance(h, {0.050, 0.001, 0.0}, {0.058, 0.042, 0.0170});
    palm =
        smoothUnion(palm, taperedCapsuleDistance(h, {0.0, 0.0, 0.0}, {0.05, 0.002, 0}, 0.022, 0.020), 0.02);
    palm = smoothUnion(palm, ellipsoidDistance(h, {0.035, 0.024, -0.012}, {0.030, 0.016, 0.014}), 0.014);
    struct Finger
    {
        double offset, spread, length, radius;
    };
    double fingers = 1;
    for (const Finger& f : {Finger{0.0300, 0.15, 0.078, 0.0094}, Finger{0.0100, 0.035, 0.086, 0.0096},
                            Finger{-0.0105, -0.10, 0.080, 0.0093}, Finger{-0.0300, -0.27, 0.066, 0.0086}}) {
        const Vec3d base(0.090 - std::abs(f.offset) * 0.25, f.offset, 0.000);
        const Vec3d direction(std::cos(f.spread), std::sin(f.spread), 0);
        const Vec3d middle = base + 0.5 * f.length * direction + Vec3d(0, 0, -0.004);
        const Vec3d tip = base + 0.98 * f.length * direction + Vec3d(0, 0, -0.017);
        fingers = std::min(
            fingers, std::min(taperedCapsuleDistance(h, base, middle, f.radius, f.radius * 0.95),
                              taperedCapsuleDistance(h, middle, tip, f.radius * 0.95, f.radius * 0.86)));
    }
    const double thumb =
        std::min(taperedCapsuleDistance(h, {0.018, 0.024, -0.010}, {0.052, 0.056, -0.019}, 0.015, 0.0118),
                 taperedCapsuleDistance(h, {0.052, 0.056, -0.019}, {0.083, 0.073, -0.022}, 0.0115, 0.0085));
    return smoothUnion(smoothUnion(palm, fingers, 0.006), thumb, 0.010);
}

double Body::armDistance(const Vec3d& p) const
{
    return smoothUnion(m_arm.distance(p), handDistance(p), handRound);
}

double Body::footDistance(const Vec3d& p) const
{
    const Vec3d& a = m_joints.ankle;
    if (const double box =
            boxDistance(p, {a.x() - 0.08, 0, a.z() - 0.09}, {a.x() + 0.09, 0.12, a.z() + 0.22});
        box > 0.05)
        return box;
    const double shoe = m_foot.distance(p);
    // The sole stands out below a height of 22 mm and is flat underneath.
    const double sole = smoothIntersection(shoe - 0.0040, p.y() - 0.022, 0.008);
    const double both = smoothUnion(shoe, sole, 0.004);
    const double toeSpring = 0.010 * std::pow(std::max(0.0, (p.z() - a.z() - 0.14) / 0.06), 2);
    return smoothIntersection(both, toeSpring - p.y(), 0.020);
}

double Body::legsDistance(const Vec3d& p) const
{
    const double own = m_leg.distance(p);
    const Vec3d other = mirrored(p);
    return m_leg.atLeast(other) > own + legRound + slack ? own
                                                         : smoothUnion(own, m_leg.distance(other), legRound);
}

double Body::legsAtLeast(const Vec3d& p) const
{
    return std::min(m_leg.atLeast(p), m_leg.atLeast(mirrored(p))) - 0.25 * legRound - slack;
}

double Body::torsoAtLeast(const Vec3d& p) const
{
    constexpr double rounds = 0.054; // more than a quarter of what its unions round over
    const double g = m_proportions.girth;
    const auto ellipsoid = [&](double x, double y, double z, double least, double most) {
        return least / most * (p - Vec3d(x * g, height(y), z * g)).norm() - most * g;
    };
    const double chest = ellipsoid(0.078, 1.315, 0.075, 0.045, 0.072);
    const double back = ellipsoid(0.080, 1.335, -0.085, 0.042, 0.085);
    const double seat = ellipsoid(0.076, 0.895, -0.068, 0.064, 0.085);
    // Shoulders, throat and collar; the collar is measured shorter along its axis.
    constexpr double shortened = 0.62;
    constexpr double thickest = 0.09;
    const double upper = shortened * boxDistance(p, {0, height(1.40), -0.03},
                                                 {std::max(m_joints.shoulder.x(), 0.02), height(1.55), 0.0}) -
                         thickest;
    return std::min({m_torso.atLeast(p), chest, back, seat, upper}) - rounds;
}

double Body::armAtLeast(const Vec3d& p) const
{
    constexpr double near = -1e9;
    const Vec3d h = inHand(p);
    const double hand = boxDistance(h, handLow, handHigh);
    return std::min(m_arm.atLeast(p), hand > handNear ? hand : near) - 0.25 * handRound - slack;
}

/// A union leaves a part as it is where the other is farther than what it rounds over. Parts that are sure to
/// be so far are not looked at, which changes no bit of the result.
double Body::distance(const Vec3d& point) const
{
    const Vec3d p(std::abs(point.x()), point.y(), point.z());
    constexpr double legsRound = 0.045;
    constexpr double headRound = 0.022;
    constexpr double armRound = 0.035;
    constexpr double footRound = 0.010;
    const double torsoBound = torsoAtLeast(p);
    const double legsBound = legsAtLeast(p);
    const double armBound = armAtLeast(p);
    const double head = headDistance(p);
    const double others =
        std::min(std::min(torsoBound, legsBound) - 0.25 * legsRound, head) - 0.25 * headRound - slack;
    double arm = armBound;
    if (armBound < others) {
        arm = armDistance(p);
        if (others > arm + armRound)
            return smoothUnion(arm, footDistance(p), footRound);
    }
    double d = 0;
    if (legsBound < torsoBound) {
        d = legsDistance(p);
        if (torsoBound <= d + legsRound)
            d = smoothUnion(torsoDistance(p), d, legsRound);
    } else {
        d = torsoDistance(p);
        if (legsBound <= d + legsRound)
            d = smoothUnion(d, legsDistance(p), legsRound);
    }
    d = smoothUnion(d, head, headRound);
    if (armBound <= d + armRound)
        d = smoothUnion(d, armBound < others ? arm : armDistance(p), armRound);
    return smoothUnion(d, footDistance(p), footRound);
}

} // namespace quadrille
