// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "resources/sample/maker/body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// Heights of the reference figure between which proportions change.
constexpr double ankleHeight = 0.10;
constexpr double hipHeight = 0.93;
constexpr double armLength = 0.525;
const Vec3d footAhead = Vec3d(std::sin(0.10), 0, std::cos(0.10));
const Vec3d footAcross = Vec3d(std::cos(0.10), 0, -std::sin(0.10));

} // namespace

BodyJoints referenceJoints()
{
    BodyJoints j;
    j.hips = {0, 0.97, 0.0};
    j.spine = {0, 1.09, -0.005};
    j.chest = {0, 1.24, -0.012};
    j.neck = {0, 1.445, -0.018};
    j.head = {0, 1.535, 0.0};
    j.headTop = {0, 1.745, 0.0};
    j.clavicle = {0.03, 1.405, 0.0};
    j.shoulder = {0.172, 1.405, -0.012};
    j.elbow = j.shoulder + 0.275 * bodyArmAlong;
    j.wrist = j.shoulder + armLength * bodyArmAlong;
    j.knuckles = j.wrist + 0.092 * bodyArmAlong;
    j.fingertips = j.wrist + 0.185 * bodyArmAlong;
    j.hip = {0.092, 0.93, 0.0};
    j.knee = {0.098, 0.51, 0.008};
    j.ankle = {0.104, 0.095, -0.022};
    j.ball = j.ankle + 0.125 * footAhead + Vec3d(0, -0.07, 0);
    j.toeTip = j.ankle + 0.20 * footAhead + Vec3d(0, -0.07, 0);
    return j;
}

Body::Body(const Proportions& proportions) : m_proportions(proportions)
{
    buildJoints();
    buildLofts();
}

double Body::height(double y) const
{
    const double legs = std::clamp(y, ankleHeight, hipHeight) - ankleHeight;
    const double torso = std::clamp(y, hipHeight, bodyNeckHeight) - hipHeight;
    const double head = std::max(y - bodyNeckHeight, 0.0);
    return std::min(y, ankleHeight) + legs * m_proportions.legs + torso * m_proportions.torso +
           head * m_proportions.head;
}

double Body::referenceHeight(double y) const
{
    const double hip = height(hipHeight);
    const double neck = height(bodyNeckHeight);
    if (y < ankleHeight)
        return y;
    if (y < hip)
        return ankleHeight + (y - ankleHeight) / m_proportions.legs;
    if (y < neck)
        return hipHeight + (y - hip) / m_proportions.torso;
    return bodyNeckHeight + (y - neck) / m_proportions.head;
}

Vec3d Body::fromReference(const Vec3d& p, FigurePart part) const
{
    const BodyJoints reference = referenceJoints();
    const double side = p.x() < 0 ? -1 : 1;
    const auto along = [&](const Vec3d& from, const Vec3d& to, double lengthFactor, double girth) {
        Vec3d q = p;
        q.x() *= side;
        q -= from;
        const double t = q.dot(bodyArmAlong);
        q = to + t * lengthFactor * bodyArmAlong + (q - t * bodyArmAlong) * girth;
        q.x() *= side;
        return q;
    };
    switch (part) {
    case FigurePart::Head:
        return {p.x() * m_proportions.head, height(p.y()), p.z() * m_proportions.head};
    case FigurePart::Torso:
        return {p.x() * m_proportions.girth, height(p.y()), p.z() * m_proportions.girth};
    case FigurePart::Arm:
        return along(reference.shoulder, m_joints.shoulder, m_proportions.arms, limbGirth());
    case FigurePart::Hand:
        return along(reference.wrist, m_joints.wrist, 1.0, 1.0);
    case FigurePart::Leg:
    case FigurePart::Foot:
        break;
    }
    const double girth = part == FigurePart::Foot ? 1.0 : limbGirth();
    const double shift = m_joints.hip.x() - reference.hip.x() * girth;
    return {p.x() * girth + side * shift, height(p.y()), p.z() * girth};
}

Vec3d Body::toReference(const Vec3d& p, FigurePart part) const
{
    const BodyJoints reference = referenceJoints();
    const double side = p.x() < 0 ? -1 : 1;
    const auto along = [&](const Vec3d& from, const Vec3d& to, double lengthFactor, double girth) {
        Vec3d q = p;
        q.x() *= side;
        q -= from;
        const double t = q.dot(bodyArmAlong);
        q = to + t / lengthFactor * bodyArmAlong + (q - t * bodyArmAlong) / girth;
        q.x() *= side;
        return q;
    };
    switch (part) {
    case FigurePart::Head:
        return {p.x() / m_proportions.head, referenceHeight(p.y()), p.z() / m_proportions.head};
    case FigurePart::Torso:
        return {p.x() / m_proportions.girth, referenceHeight(p.y()), p.z() / m_proportions.girth};
    case FigurePart::Arm:
        return along(m_joints.shoulder, reference.shoulder, m_proportions.arms, limbGirth());
    case FigurePart::Hand:
        return along(m_joints.wrist, reference.wrist, 1.0, 1.0);
    case FigurePart::Leg:
    case FigurePart::Foot:
        break;
    }
    const double girth = part == FigurePart::Foot ? 1.0 : limbGirth();
    const double shift = m_joints.hip.x() - reference.hip.x() * girth;
    return {(p.x() - side * shift) / girth, referenceHeight(p.y()), p.z() / girth};
}

void Body::buildJoints()
{
    const BodyJoints r = referenceJoints();
    m_joints = r;
    for (Vec3d* joint : {&m_joints.hips, &m_joints.spine, &m_joints.chest, &m_joints.neck, &m_joints.head,
                         &m_joints.headTop, &m_joints.clavicle, &m_joints.shoulder})
        joint->y() = height(joint->y());
    m_joints.shoulder.x() *= m_proportions.shoulders;
    m_joints.elbow = m_joints.shoulder + 0.275 * m_proportions.arms * bodyArmAlong;
    m_joints.wrist = m_joints.shoulder + armLength * m_proportions.arms * bodyArmAlong;
    m_joints.knuckles = m_joints.wrist + (r.knuckles - r.wrist);
    m_joints.fingertips = m_joints.wrist + (r.fingertips - r.wrist);
    const Vec3d shift((m_proportions.girth - 1) * 0.085, 0, 0);
    for (Vec3d* joint : {&m_joints.hip, &m_joints.knee, &m_joints.ankle, &m_joints.ball, &m_joints.toeTip}) {
        joint->y() = height(joint->y());
        *joint += shift;
    }
}

void Body::buildLofts()
{
    const auto scaled = [](std::vector<LoftKey> keys, double along, double girth) {
        for (LoftKey& key : keys) {
            key.at *= along;
            key.width *= girth;
            key.front *= girth;
            key.back *= girth;
        }
        return keys;
    };
    // Heights become those of this figure; the belly stands out around its own height.
    const auto upright = [&](std::vector<LoftKey> keys, double girth, double belly) {
        keys = scaled(std::move(keys), 1.0, girth);
        for (LoftKey& key : keys) {
            const double bulge = belly * std::exp(-std::pow((key.at - 1.10) / 0.11, 2));
            key.front += bulge;
            key.width += 0.5 * bulge;
            key.at = height(key.at);
        }
        return keys;
    };
    m_torso = Loft({},
                   upright({{0.790, 0.030, 0.020, 0.020},
                            {0.815, 0.080, 0.050, 0.056},
                            {0.85, 0.128, 0.078, 0.088},
                            {0.89, 0.157, 0.098, 0.110},
                            {0.94, 0.166, 0.105, 0.115},
                            {0.985, 0.159, 0.106, 0.106},
                            {1.005, 0.159, 0.108, 0.102},
                            {1.05, 0.153, 0.106, 0.094},
                            {1.12, 0.145, 0.102, 0.089},
                            {1.20, 0.151, 0.107, 0.098},
                            {1.28, 0.164, 0.115, 0.112},
                            {1.34, 0.170, 0.115, 0.118},
                            {1.39, 0.150, 0.099, 0.111},
                            {1.43, 0.108, 0.075, 0.092},
                            {1.455, 0.070, 0.053, 0.070}},
                           m_proportions.girth, m_proportions.belly),
                   2.35);
    const Loft::Frame armFrame{m_joints.shoulder, bodyArmAlong, bodyArmOut, Vec3d::UnitZ()};
    m_arm = Loft(armFrame, scaled({{-0.045, 0.030, 0.038, 0.036},
                                   {-0.02, 0.047, 0.050, 0.048},
                                   {0.03, 0.056, 0.056, 0.056},
                                   {0.08, 0.055, 0.057, 0.058},
                                   {0.14, 0.052, 0.057, 0.058},
                                   {0.182, 0.053, 0.058, 0.059},
                                   {0.200, 0.045, 0.047, 0.047},
                                   {0.24, 0.041, 0.043, 0.042},
                                   {0.275, 0.039, 0.040, 0.041},
                                   {0.32, 0.042, 0.044, 0.041},
                                   {0.36, 0.041, 0.044, 0.040},
                                   {0.43, 0.034, 0.038, 0.034},
                                   {0.49, 0.0255, 0.031, 0.029},
                                   {0.535, 0.022, 0.029, 0.027},
                                   {0.56, 0.016, 0.026, 0.024}},
                                  m_proportions.arms, limbGirth()));
    const double shift = m_joints.hip.x() - referenceJoints().hip.x();
    std::vector<LoftKey> leg = upright({{0.066, 0.050, 0.056, 0.050, 0.105, -0.020},
                                        {0.080, 0.053, 0.060, 0.055, 0.105, -0.020},
                                        {0.13, 0.053, 0.055, 0.056, 0.104, -0.018},
                                        {0.24, 0.053, 0.052, 0.060, 0.103, -0.012},
                                        {0.35, 0.057, 0.055, 0.069, 0.102, -0.006},
                                        {0.44, 0.057, 0.056, 0.062, 0.100, 0.002},
                                        {0.51, 0.058, 0.062, 0.056, 0.099, 0.006},
                                        {0.60, 0.066, 0.070, 0.068, 0.098, 0.004},
                                        {0.72, 0.076, 0.083, 0.083, 0.097, 0.002},
                                        {0.82, 0.083, 0.093, 0.098, 0.095, 0.000},
                                        {0.90, 0.080, 0.093, 0.108, 0.090, -0.002},
                                        {0.95, 0.060, 0.070, 0.090, 0.085, 0.000}},
                                       limbGirth(), 0.0);
    for (LoftKey& key : leg)
        key.offset += shift;
    m_leg = Loft({}, leg, 2.15);
    const Vec3d heel(m_joints.ankle.x(), 0, m_joints.ankle.z());
    m_foot = Loft({heel, footAhead, footAcross, Vec3d::UnitY()},
                  {{-0.072, 0.016, 0.020, 0.06, 0, 0.01},
                   {-0.064, 0.030, 0.058, 0.06, 0, 0.01},
                   {-0.035, 0.038, 0.092, 0.06, 0, 0.01},
                   {0.0, 0.040, 0.098, 0.06, 0, 0.01},
                   {0.04, 0.041, 0.085, 0.06, 0.000, 0.01},
                   {0.09, 0.046, 0.060, 0.06, -0.001, 0.01},
                   {0.13, 0.048, 0.046, 0.06, -0.003, 0.01},
                   {0.17, 0.042, 0.038, 0.06, -0.006, 0.01},
                   {0.192, 0.029, 0.029, 0.06, -0.008, 0.01},
                   {0.204, 0.010, 0.015, 0.06, -0.009, 0.01}},
                  2.4);
}

Vec3d Body::normal(const Vec3d& p) const
{
    constexpr double step = 5e-4;
    Vec3d g;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3d offset = step * Vec3d::Unit(axis);
        g[axis] = distance(p + offset) - distance(p - offset);
    }
    const double length = g.norm();
    return length > 0 ? Vec3d(g / length) : Vec3d::UnitY();
}

FigurePart Body::partAt(const Vec3d& point) const
{
    const Vec3d p(std::abs(point.x()), point.y(), point.z());
    const double along = (p - m_joints.shoulder).dot(bodyArmAlong);
    const double fromAxis = (p - m_joints.shoulder - along * bodyArmAlong).norm();
    const Vec3d armhole = p - m_joints.shoulder;
    if (along > 0.535 * m_proportions.arms && fromAxis < 0.12)
        return FigurePart::Hand;
    if (armhole.dot(Vec3d(0.93, -0.37, 0)) > 0.004 && fromAxis < 0.085 * limbGirth() &&
        m_arm.distance(p) < m_torso.distance(p))
        return FigurePart::Arm;
    const Vec3d collar = p - Vec3d(0, height(1.468), -0.012);
    const bool isAtNeck =
        std::hypot(collar.x(), collar.z()) < 0.076 * m_proportions.head || p.y() > height(1.50);
    if (isAtNeck && collar.y() * 0.95 + collar.z() * 0.31 > 0 && p.y() > height(1.40))
        return FigurePart::Head;
    if (p.y() > height(0.990))
        return FigurePart::Torso;
    if (p.y() < 0.09 && footDistance(p) < m_leg.distance(p))
        return FigurePart::Foot;
    return FigurePart::Leg;
}

} // namespace quadrille
