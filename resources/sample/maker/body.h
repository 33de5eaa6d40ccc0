// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "resources/sample/maker/field.h"

namespace quadrille {

/// How a body differs from the reference figure; factors on lengths and widths.
struct Proportions
{
    double legs = 1.0;
    double torso = 1.0;
    double arms = 1.0;
    double head = 1.0;
    double shoulders = 1.0; ///< distance of the shoulders
    double girth = 1.0;     ///< width and depth of the torso; the limbs follow by half
    double belly = 0.0;     ///< metres that the belly stands out
};

enum class FigurePart
{
    Head,
    Torso,
    Arm,
    Hand,
    Leg,
    Foot,
};

/// Joint centres of the left half, metres; mirrored in x for the right one.
struct BodyJoints
{
    Vec3d hips, spine, chest, neck, head, headTop;
    Vec3d clavicle, shoulder, elbow, wrist, knuckles, fingertips;
    Vec3d hip, knee, ankle, ball, toeTip;
};

/// A dressed figure in A-pose as a signed distance: y up, facing +z, its left at +x, soles at y = 0,
/// symmetric in x. The reference figure is 1.75 m tall.
class Body
{
public:
    explicit Body(const Proportions& proportions = {});

    const BodyJoints& joints() const { return m_joints; }
    /// Signed distance to the surface, metres; a bound far from it. Negative inside.
    double distance(const Vec3d& p) const;
    /// Unit gradient of `distance`.
    Vec3d normal(const Vec3d& p) const;
    /// Which part a surface point belongs to.
    FigurePart partAt(const Vec3d& p) const;
    /// Whether a point of the head lies on the hair.
    bool isHair(const Vec3d& p) const;
    /// The place of a point of a part on the reference figure (left half mirrored along).
    Vec3d toReference(const Vec3d& p, FigurePart part) const;
    /// The place on this figure of a point of the reference figure.
    Vec3d fromReference(const Vec3d& p, FigurePart part) const;

private:
    double headDistance(const Vec3d& p) const;
    double faceDistance(const Vec3d& p) const;
    double hairDistance(const Vec3d& p) const;
    double torsoDistance(const Vec3d& p) const;
    double armDistance(const Vec3d& p) const;
    double handDistance(const Vec3d& p) const;
    double footDistance(const Vec3d& p) const;
    double legsDistance(const Vec3d& p) const;
    // Numbers that the distances to the parts are not below, at a fraction of their cost. \pre p.x() ≥ 0
    double torsoAtLeast(const Vec3d& p) const;
    double legsAtLeast(const Vec3d& p) const;
    double armAtLeast(const Vec3d& p) const;
    Vec3d inHand(const Vec3d& p) const;

    void buildJoints();
    void buildLofts();
    /// Height on this figure of a height on the reference figure, and back.
    double height(double referenceHeight) const;
    double referenceHeight(double height) const;
    double limbGirth() const { return 0.5 + 0.5 * m_proportions.girth; }

    Proportions m_proportions;
    BodyJoints m_joints;
    Loft m_torso;
    Loft m_arm;
    Loft m_leg;
    Loft m_foot;
};

/// Height of the base of the neck of the reference figure.
constexpr double bodyNeckHeight = 1.47;
/// Of the left arm in A-pose: from shoulder to hand, and outwards away from the body.
inline const Vec3d bodyArmAlong = Vec3d(0.6428, -0.7660, 0);
inline const Vec3d bodyArmOut = Vec3d(0.7660, 0.6428, 0);

/// Joints of the reference figure.
BodyJoints referenceJoints();

} // namespace quadrille
