// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/takes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadrille {

namespace {

/// The wrist goes to a place; `weight` 0 leaves the arm to its angles.
void reachTo(Posture& p, std::size_t side, const Vec3d& place, double weight)
{
    p.sides[side].reach = weight;
    p.sides[side].reachX = place.x();
    p.sides[side].reachY = place.y();
    p.sides[side].reachZ = place.z();
}

/// Keys at other times, faster or slower.
std::vector<PostureKey> paced(std::vector<PostureKey> keys, double pace)
{
    for (PostureKey& key : keys)
        key.time *= pace;
    return keys;
}

} // namespace

TakeMotion performReach(const Skeleton& skeleton, bool high, int variant, Random& random)
{
    const std::size_t hand = variant % 2 == 0 ? 1 : 0;
    const double s = hand == 0 ? 1 : -1;
    const Posture stand = standing(skeleton);
    const double pace = random.between(0.9, 1.08);
    const Vec3d place =
        high ? Vec3d(s * random.between(0.12, 0.26), random.between(1.90, 1.99), random.between(0.16, 0.28))
             : Vec3d(s * random.between(0.10, 0.24), random.between(0.24, 0.32), random.between(0.36, 0.46));
    const Vec3d start(s * 0.24, 0.95, 0.12);
    Posture ready = stand;
    reachTo(ready, hand, start, 0);
    Posture look = ready;
    look.headPitch = high ? -0.42 : 0.40;
    look.headYaw = s * 0.22;
    look.hipY -= 0.012;
    look.spineBend = high ? 0.03 : -0.02;
    look.hipX = -s * 0.015;
    Posture way = look;
    reachTo(way, hand, high ? Vec3d(s * 0.25, 1.35, 0.42) : Vec3d(s * 0.28, 0.65, 0.34), 0.9);
    Posture there = ready;
    reachTo(there, hand, place, 1);
    SidePosture& other = there.sides[1 - hand];
    if (high) {
        way.sides[0].footPitch = way.sides[1].footPitch = 0.12;
        way.hipY += 0.01;
        there.hipY = 1.018;
        there.hipZ = 0.045;
        there.hipX = s * 0.02;
        there.hipRoll = s * 0.06;
        there.spineBend = -0.10;
        there.spineSide = s * 0.02;
        there.spineTwist = -s * 0.20;
        there.headPitch = -0.55;
        there.headYaw = s * 0.10;
        there.sides[0].footPitch = there.sides[1].footPitch = random.between(0.42, 0.52);
        there.sides[hand].shrug = 0.28;
        there.sides[hand].curl = 0.05;
        other.armOut = 0.30;
        other.armFlex = -0.15;
    } else {
        way.hipY -= 0.12;
        way.hipPitch = 0.30;
        way.spineBend = 0.28;
        way.hipZ = -0.05;
        there.hipY -= random.between(0.30, 0.36);
        there.hipZ = -0.13;
        there.hipPitch = 0.62;
        there.spineBend = 0.68;
        there.spineTwist = -s * 0.22;
        there.headPitch = -0.10;
        there.sides[0].kneeOut = there.sides[1].kneeOut = 0.20;
        there.sides[1 - hand].footPitch = 0.16;
        there.sides[hand].curl = 0.05;
        other.armFlex = 0.55;
        other.armOut = 0.40;
        other.elbow = 0.75;
    }
    Posture grasp = there;
    grasp.sides[hand].curl = 0.95;
    grasp.sides[hand].wrist = 0.25;
    Posture back = way;
    back.sides[hand].curl = 0.9;
    back.headPitch = high ? -0.1 : 0.15;
    Posture end = ready;
    end.sides[hand].curl = 0.5;
    const auto keys = paced({{0, ready},
                             {0.26, look},
                             {0.60, way},
                             {1.02, there},
                             {1.20, grasp},
                             {1.60, back},
                             {1.98, end},
                             {2.15, ready}},
                            pace);
    return {"", framesOf(keys, 2.12 * pace), {}, {}};
}

TakeMotion performKick(const Skeleton& skeleton, Random& random)
{
    const std::size_t leg = 1; // the right one
    const std::size_t other = 0;
    const double pace = random.between(0.92, 1.08);
    const double power = random.between(0.85, 1.12);
    const Posture stand = standing(skeleton);
    const double footX = stand.sides[leg].footX;
    // A short step with the standing leg, the swing, and back.
    Posture lean = stand;
    lean.hipX = -0.055;
    lean.hipZ = 0.03;
    lean.hipRoll = -0.03;
    lean.headPitch = 0.22;
    lean.sides[other].footLift = 0.04;
    lean.sides[other].footZ += 0.12;
    lean.sides[other].footPitch = 0.10;
    Posture planted = stand;
    planted.hipX = 0.045;
    planted.hipZ = 0.19;
    planted.hipY -= 0.035;
    planted.headPitch = 0.30;
    planted.sides[other].footZ += 0.26;
    planted.sides[leg].footPitch = 0.62;
    planted.sides[other].armFlex = 0.25;
    planted.sides[leg].armFlex = -0.1;
    Posture wind = planted;
    wind.hipX = 0.075;
    wind.hipZ = 0.25;
    wind.hipY -= 0.01;
    wind.hipYaw = -0.38;
    wind.hipPitch = 0.12;
    wind.spineTwist = 0.55;
    wind.spineBend = 0.06;
    wind.headYaw = -0.12;
    wind.sides[leg].footX = footX - 0.06;
    wind.sides[leg].footZ = -0.34 * power;
    wind.sides[leg].footLift = 0.30 * power;
    wind.sides[leg].footPitch = 1.15;
    wind.sides[other].armFlex = 0.85;
    wind.sides[other].armOut = 0.75;
    wind.sides[other].elbow = 0.45;
    wind.sides[leg].armFlex = -0.65;
    wind.sides[leg].armOut = 0.45;
    Posture strike = wind;
    strike.hipYaw = 0.16;
    strike.hipPitch = -0.06;
    strike.hipZ = 0.27;
    strike.spineTwist = -0.20;
    strike.spineBend = 0.16;
    strike.sides[leg].footX = footX + 0.03;
    strike.sides[leg].footZ = 0.50;
    strike.sides[leg].footLift = 0.09;
    strike.sides[leg].footPitch = 0.50;
    strike.sides[other].armFlex = 0.15;
    strike.sides[leg].armFlex = 0.15;
    Posture follow = strike;
    follow.hipYaw = 0.42;
    follow.hipPitch = -0.16;
    follow.hipZ = 0.30;
    follow.hipY -= 0.005;
    follow.spineTwist = -0.50;
    follow.spineBend = 0.30;
    follow.headPitch = 0.10;
    follow.headYaw = -0.05;
    follow.sides[leg].footX = footX + 0.12;
    follow.sides[leg].footZ = 0.92 + 0.04 * power;
    follow.sides[leg].footLift = 0.56 * power;
    follow.sides[leg].footPitch = 0.05;
    follow.sides[other].armFlex = -0.55;
    follow.sides[other].armOut = 0.60;
    follow.sides[leg].armFlex = 0.85;
    follow.sides[leg].armOut = 0.50;
    follow.sides[leg].elbow = 0.6;
    follow.sides[other].footPitch = 0.06;
    Posture recover = planted;
    recover.hipX = 0.05;
    recover.hipZ = 0.26;
    recover.sides[leg].footZ = 0.40;
    recover.sides[leg].footLift = 0.10;
    recover.sides[leg].footPitch = 0.25;
    recover.sides[leg].armFlex = 0.15;
    const double ankleZ = stand.sides[leg].footZ;
    Posture down = standing(skeleton, 0, 0.26);
    down.hipY -= 0.03;
    down.hipX = 0.012;
    down.headPitch = 0.1;
    down.sides[leg].footZ = ankleZ + 0.26;
    const Posture end = standing(skeleton, 0, 0.26);
    const auto keys = paced({{0, stand},
                             {0.20, lean},
                             {0.42, planted},
                             {0.68, wind},
                             {0.86, strike},
                             {1.04, follow},
                             {1.34, recover},
                             {1.56, down},
                             {1.95, end}},
                            pace);
    return {"", framesOf(keys, 2.0 * pace), {}, {}};
}

TakeMotion performIdle(const Skeleton& skeleton, int variant, Random& random)
{
    const Posture stand = standing(skeleton);
    const double s = variant % 2 == 0 ? 1 : -1;
    Posture shifted = stand;
    shifted.hipX = s * random.between(0.035, 0.05);
    shifted.hipRoll = s * 0.05;
    shifted.spineSide = s * 0.05;
    shifted.hipYaw = s * 0.06;
    shifted.headYaw = s * random.between(0.25, 0.45);
    shifted.headRoll = -s * 0.05;
    shifted.sides[variant % 2 == 0 ? 1 : 0].kneeOut = 0.15;
    Posture looks = shifted;
    looks.headYaw = -s * random.between(0.35, 0.55);
    looks.spineTwist = -s * 0.16;
    looks.headPitch = -0.06;
    Posture gesture = looks;
    const std::size_t hand = variant % 2 == 0 ? 1 : 0;
    // A hand to the hip, or to the chin.
    SidePosture& arm = gesture.sides[hand];
    if (variant % 2 == 0) {
        arm.armFlex = -0.35;
        arm.armOut = 0.62;
        arm.armTwist = 0.55;
        arm.elbow = 1.35;
        arm.curl = 0.6;
    } else {
        arm.armFlex = 0.62;
        arm.armOut = 0.12;
        arm.armTwist = 0.45;
        arm.elbow = 1.95;
        arm.curl = 0.7;
        gesture.headPitch = 0.12;
    }
    gesture.headYaw = s * 0.1;
    const double pace = random.between(0.92, 1.08);
    const auto keys = paced(
        {{0, stand}, {0.50, shifted}, {0.92, looks}, {1.30, gesture}, {1.55, gesture}, {2.05, stand}}, pace);
    return {"", framesOf(keys, 2.05 * pace), {}, {}};
}

TakeMotion performDance(const Skeleton& skeleton, int variant, Random& random)
{
    constexpr double pi = std::numbers::pi;
    const double beat = 60.0 / random.between(116, 128);
    const double size = random.between(0.9, 1.15);
    const int halfBeats = 8;
    std::vector<PostureKey> keys;
    const Posture home = standing(skeleton);
    for (int i = 0; i <= halfBeats; ++i) {
        // On the beat the knees give; in between the body comes up. Two beats to the left, two to the right.
        const double phase = i * 0.5;
        const double s = static_cast<int>(std::floor((phase + 0.5) / 2)) % 2 == 0 ? 1.0 : -1.0;
        const bool onBeat = i % 2 == 0;
        const double wave = std::sin(0.5 * pi * phase);
        Posture p = home;
        p.hipY = home.hipY - (onBeat ? 0.055 : 0.012) * size;
        p.hipX = 0.11 * size * wave;
        p.hipRoll = 0.09 * size * wave;
        p.spineSide = 0.13 * size * wave;
        p.headRoll = -0.08 * wave;
        p.headPitch = onBeat ? 0.14 : -0.06;
        p.spineBend = onBeat ? 0.10 : 0.0;
        p.hipYaw = 0.16 * size * std::cos(0.5 * pi * phase);
        for (std::size_t side = 0; side < 2; ++side) {
            const double sign = side == 0 ? 1 : -1;
            SidePosture& limb = p.sides[side];
            limb.kneeOut = 0.12;
            const double swing = std::sin(pi * phase + (side == 0 ? 0 : pi));
            if (variant == 0) {
                // Bent arms pump against each other; feet step apart and together.
                limb.armFlex = 0.55 + 0.45 * swing;
                limb.elbow = 1.45 + 0.25 * swing;
                limb.armOut = 0.38;
            } else if (variant == 1) {
                // A twist: hips against shoulders, one arm up in turn.
                const double up = std::max(0.0, sign * wave);
                limb.armFlex = 0.35 + 1.9 * up;
                limb.armOut = 0.55 + 0.35 * up;
                limb.elbow = 0.95 - 0.45 * up;
            } else {
                // Both arms wave from side to side overhead.
                limb.armFlex = 0.25;
                limb.armOut = 1.95 + 0.50 * sign * wave;
                limb.elbow = 0.75 - 0.25 * sign * wave;
            }
            limb.curl = 0.7;
            // The free foot rises between beats and touches beside.
            const double free = sign * s < 0 ? 1.0 : 0.0;
            if (variant == 1) {
                limb.footPitch = 0.30 + 0.10 * sign * wave;
            } else {
                limb.footPitch = free * (onBeat ? 0.30 : 0.75);
                limb.footLift = free * (onBeat ? 0.0 : 0.085 * size);
                limb.footZ += free * (variant == 2 && !onBeat ? 0.10 : 0.0);
            }
        }
        if (variant == 1) {
            p.hipYaw = 0.42 * size * wave;
            p.spineTwist = -0.75 * size * wave;
            p.headYaw = 0.30 * size * wave;
            p.hipY -= 0.03;
        }
        keys.push_back({(i + 1.0) * 0.5 * beat + 0.25, p});
    }
    keys.insert(keys.begin(), {0, home});
    keys.push_back({keys.back().time + 0.35, home});
    return {"", framesOf(keys, keys.back().time), {}, {}};
}

} // namespace quadrille
