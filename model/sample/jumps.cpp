// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/takes.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

constexpr double gravity = 9.81;

struct JumpShape
{
    double rise = 0.2;     ///< of the centre of mass, metres
    double distance = 0;   ///< metres
    double crouch = 0.24;  ///< depth, metres
    double armsBack = 0.8; ///< radians
    double armsUp = 1.6;
    double tuck = 0.1; ///< knees drawn up in flight, metres
    double reach = 0;  ///< feet ahead of the hips on landing, metres
    double pace = 1;
};

double hermite(double a, double slopeA, double b, double slopeB, double span, double time)
{
    const double t = std::clamp(time / span, 0.0, 1.0);
    const double t2 = t * t;
    const double t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * span * slopeA + (3 * t2 - 2 * t3) * b +
           (t3 - t2) * span * slopeB;
}

/// A jump from standing to standing; the centre of mass flies on a parabola.
class Jump
{
public:
    Jump(const Skeleton& skeleton, const JumpShape& shape, Random& random)
        : m_skeleton(skeleton), m_shape(shape)
    {
        m_stand = standing(skeleton);
        m_end = standing(skeleton, 0.0, shape.distance);
        makePostures(random);
        makeTimes();
    }

    double duration() const { return m_rest; }
    double takeOff() const { return m_off; }
    double landing() const { return m_land; }

    Posture at(double time) const
    {
        if (time > m_off && time < m_land)
            return inFlight(time);
        Posture p = postureAt(m_keys, time);
        constexpr double h = 1e-3;
        if (time >= m_low && time <= m_off) {
            const Posture next = inFlight(m_off + h);
            const double span = m_off - m_low;
            p.hipY =
                hermite(m_crouch.hipY, 0, m_leave.hipY, (next.hipY - m_leave.hipY) / h, span, time - m_low);
            p.hipZ =
                hermite(m_crouch.hipZ, 0, m_leave.hipZ, (next.hipZ - m_leave.hipZ) / h, span, time - m_low);
        } else if (time >= m_land && time <= m_soft) {
            const Posture before = inFlight(m_land - h);
            const double span = m_soft - m_land;
            p.hipY = hermite(m_touch.hipY, (m_touch.hipY - before.hipY) / h, m_absorb.hipY, 0, span,
                             time - m_land);
            p.hipZ = hermite(m_touch.hipZ, (m_touch.hipZ - before.hipZ) / h, m_absorb.hipZ, 0, span,
                             time - m_land);
        }
        return p;
    }

private:
    static void bothSides(Posture& p, auto change)
    {
        for (SidePosture& side : p.sides)
            change(side);
    }

    void makePostures(Random& random)
    {
        const JumpShape& s = m_shape;
        m_crouch = m_stand;
        m_crouch.hipY -= s.crouch;
        m_crouch.hipZ -= 0.06;
        m_crouch.hipPitch = 0.32 + 0.4 * s.crouch;
        m_crouch.spineBend = 0.30 + 0.7 * s.crouch;
        m_crouch.headPitch = -0.32;
        bothSides(m_crouch, [&](SidePosture& a) {
            a.armFlex = -s.armsBack;
            a.armOut = 0.22;
            a.elbow = 0.30;
            a.footPitch = 0.10;
            a.kneeOut = 0.12;
        });
        m_leave = m_stand;
        m_leave.hipY = 0.995;
        m_leave.hipZ += 0.10 * s.distance + 0.01;
        m_leave.hipPitch = 0.05 + 0.10 * s.distance;
        m_leave.spineBend = -0.05;
        m_leave.headPitch = -0.15;
        bothSides(m_leave, [&](SidePosture& a) {
            a.armFlex = s.armsUp;
            a.armOut = 0.25;
            a.elbow = 0.45;
            a.footPitch = 0.78;
        });
        m_tuck = m_leave;
        m_tuck.hipPitch = 0.12 + 0.25 * s.distance;
        m_tuck.spineBend = 0.10 + 0.8 * s.tuck + 0.1 * s.distance;
        m_tuck.headPitch = 0.05;
        bothSides(m_tuck, [&](SidePosture& a) {
            a.armFlex = 0.85 * s.armsUp;
            a.armOut = 0.45;
            a.elbow = 0.5;
            a.footPitch = 0.55;
            a.kneeOut = 0.05;
        });
        m_touch = m_end;
        m_touch.hipY = 0.925;
        m_touch.hipZ -= 0.02 + s.reach;
        m_touch.hipPitch = 0.18 + 0.15 * s.distance;
        m_touch.spineBend = 0.18;
        m_touch.headPitch = 0.12;
        bothSides(m_touch, [&](SidePosture& a) {
            a.armFlex = 0.45 * s.armsUp;
            a.armOut = 0.42;
            a.elbow = 0.5;
            a.footPitch = s.reach > 0.05 ? -0.16 : 0.34;
        });
        m_absorb = m_end;
        m_absorb.hipY -= 0.10 + 0.42 * s.rise + 0.05 * s.distance;
        m_absorb.hipZ -= 0.03;
        m_absorb.hipPitch = 0.42;
        m_absorb.spineBend = 0.36;
        m_absorb.headPitch = -0.18;
        bothSides(m_absorb, [&](SidePosture& a) {
            a.armFlex = 0.15;
            a.armOut = 0.36;
            a.elbow = 0.55;
            a.kneeOut = 0.10;
        });
        // One arm a little before the other, a slight turn: nobody is a mirror.
        const double turn = random.between(-0.10, 0.10);
        for (Posture* p : {&m_leave, &m_tuck, &m_touch})
            p->spineTwist += turn;
        const double lead = random.between(-0.18, 0.18);
        for (Posture* p : {&m_crouch, &m_leave, &m_tuck, &m_touch, &m_absorb}) {
            p->sides[0].armFlex += lead;
            p->sides[1].armFlex -= lead;
        }
        m_crouch.hipX += random.between(-0.012, 0.012);
        m_absorb.hipX += random.between(-0.015, 0.015);
    }

    Vec3d massOffset(Posture p) const
    {
        for (SidePosture& side : p.sides) {
            side.footX -= p.hipX;
            side.footZ -= p.hipZ;
            side.footLift -= p.hipY;
        }
        p.hipX = p.hipY = p.hipZ = 0;
        return centreOfMass(m_skeleton, worldJoints(m_skeleton, solvePosture(m_skeleton, p)));
    }
    static Vec3d hips(const Posture& p) { return {p.hipX, p.hipY, p.hipZ}; }

    void makeTimes()
    {
        const double pace = m_shape.pace;
        m_from = hips(m_leave) + massOffset(m_leave);
        m_to = hips(m_touch) + massOffset(m_touch);
        const double up = std::sqrt(2 * gravity * m_shape.rise);
        const double drop = m_from.y() + m_shape.rise - m_to.y();
        const double flight = up / gravity + std::sqrt(2 * std::max(drop, 0.0) / gravity);
        m_velocity = (m_to - m_from) / flight;
        m_velocity.y() = up;
        m_low = 0.62 * pace;
        m_off = m_low + std::clamp(2.15 * (m_leave.hipY - m_crouch.hipY) / up, 0.20, 0.42);
        m_land = m_off + flight;
        const double down = gravity * flight - up;
        m_soft = m_land + std::clamp(2.2 * (m_touch.hipY - m_absorb.hipY) / down, 0.14, 0.36);
        const double settled = m_soft + 0.46 * pace;
        m_rest = settled + 0.10;
        Posture gather = m_stand; // a breath upwards before the crouch
        gather.hipY += 0.006;
        gather.spineBend = -0.03;
        gather.sides[0].armFlex = gather.sides[1].armFlex = 0.28;
        Posture over = m_end; // a little too far up before standing at ease
        over.hipY += 0.004;
        over.spineBend = -0.02;
        Posture planted = m_touch;
        planted.hipY = 0.5 * (m_touch.hipY + m_absorb.hipY);
        planted.sides[0].footPitch = planted.sides[1].footPitch = 0;
        m_keys = {{0, m_stand},          {0.22 * pace, gather},
                  {m_low, m_crouch},     {m_off, m_leave},
                  {m_land, m_touch},     {m_land + 0.6 * (m_soft - m_land), planted},
                  {m_soft, m_absorb},    {settled - 0.12 * pace, over},
                  {settled + 0.1, m_end}};
        // In between, by interpolation of its neighbours: only feet and the hips' way are set here.
        PostureArray mid = toArray(planted);
        const PostureArray a = toArray(m_touch);
        const PostureArray b = toArray(m_absorb);
        for (std::size_t c = 0; c < postureChannels; ++c)
            mid[c] = 0.4 * a[c] + 0.6 * b[c];
        Posture between = fromArray(mid);
        between.sides[0].footPitch = between.sides[1].footPitch = 0;
        m_keys[5].posture = between;
    }

    /// Feet go with the hips from take-off through the tuck to landing.
    Posture inFlight(double time) const
    {
        const double flight = m_land - m_off;
        const double t = (time - m_off) / flight;
        const auto relative = [](Posture p, double lift, double forward) {
            for (SidePosture& side : p.sides) {
                side.footX -= p.hipX;
                side.footZ += forward - p.hipZ;
                side.footLift += lift - p.hipY;
            }
            p.hipX = p.hipY = p.hipZ = 0;
            return p;
        };
        const double feetBack = -0.10 * (m_shape.tuck > 0.12) - 0.06;
        const std::vector<PostureKey> keys = {{0, relative(m_leave, 0, 0)},
                                              {0.48, relative(m_tuck, m_shape.tuck, feetBack)},
                                              {1, relative(m_touch, 0, 0)}};
        Posture p = postureAt(keys, t);
        const double s = time - m_off;
        Vec3d mass = m_from + s * m_velocity;
        mass.y() -= 0.5 * gravity * s * s;
        const Vec3d place = mass - massOffset(p);
        p.hipX = place.x();
        p.hipY = place.y();
        p.hipZ = place.z();
        for (SidePosture& side : p.sides) {
            side.footX += p.hipX;
            side.footZ += p.hipZ;
            side.footLift += p.hipY;
        }
        return p;
    }

    const Skeleton& m_skeleton;
    JumpShape m_shape;
    Posture m_stand, m_crouch, m_leave, m_tuck, m_touch, m_absorb, m_end;
    Vec3d m_from, m_to, m_velocity;
    double m_low = 0, m_off = 0, m_land = 0, m_soft = 0, m_rest = 0;
    std::vector<PostureKey> m_keys;
};

} // namespace

TakeMotion performJump(const Skeleton& skeleton, const std::string& kind, Random& random)
{
    JumpShape shape;
    if (kind == "short jump")
        shape = {.rise = 0.13,
                 .distance = 0.55,
                 .crouch = 0.20,
                 .armsBack = 0.75,
                 .armsUp = 1.15,
                 .tuck = 0.07,
                 .reach = 0.06};
    else if (kind == "long jump")
        shape = {.rise = 0.24,
                 .distance = 1.35,
                 .crouch = 0.30,
                 .armsBack = 1.05,
                 .armsUp = 2.0,
                 .tuck = 0.20,
                 .reach = 0.24};
    else if (kind == "low jump")
        shape = {.rise = 0.11, .distance = 0, .crouch = 0.17, .armsBack = 0.45, .armsUp = 0.8, .tuck = 0.03};
    else
        shape = {.rise = 0.36, .distance = 0, .crouch = 0.33, .armsBack = 0.95, .armsUp = 2.65, .tuck = 0.14};
    shape.rise *= random.between(0.9, 1.1);
    shape.distance *= random.between(0.92, 1.08);
    shape.crouch *= random.between(0.92, 1.08);
    shape.armsUp *= random.between(0.92, 1.06);
    shape.tuck *= random.between(0.8, 1.2);
    shape.pace = random.between(0.88, 1.08);
    const Jump jump(skeleton, shape, random);
    TakeMotion take;
    const auto count = std::lround(jump.duration() * sampleFps);
    for (long f = 0; f < count; ++f)
        take.frames.push_back(jump.at(static_cast<double>(f) / sampleFps));
    take.flight = {FrameIndex(static_cast<std::int64_t>(std::ceil(jump.takeOff() * sampleFps + 1e-9))),
                   FrameIndex(static_cast<std::int64_t>(std::floor(jump.landing() * sampleFps - 1e-9)))};
    return take;
}

} // namespace quadrille
