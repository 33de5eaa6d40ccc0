// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/takes.h"

#include "model/core/smoothstep.h"
#include "model/sample/gait.h"
#include "model/sample/noise.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// A curve from 0 to 1 between two times with no speed at its ends.
double ramp(double time, double from, double to)
{
    return smoothStep(std::clamp((time - from) / (to - from), 0.0, 1.0));
}

/// Slow wandering of the upper body, as nobody holds still or repeats himself exactly.
void addLife(std::vector<Posture>& frames, std::uint64_t seed)
{
    for (std::size_t f = 0; f < frames.size(); ++f) {
        const double time = static_cast<double>(f) / sampleFps;
        int channel = 0;
        const auto drift = [&](double size) {
            ++channel;
            return size * valueNoise(time * 1.3, channel * 17.3, 0.5, seed);
        };
        Posture& p = frames[f];
        p.spineBend += drift(0.015);
        p.spineSide += drift(0.015);
        p.spineTwist += drift(0.02);
        p.headYaw += drift(0.05);
        p.headPitch += drift(0.03);
        p.headRoll += drift(0.02);
        for (SidePosture& side : p.sides) {
            side.armFlex += drift(0.025);
            side.armOut += 0.5 * std::abs(drift(0.03));
            side.elbow += drift(0.03);
            side.wrist += drift(0.06);
            side.curl += drift(0.08);
        }
    }
}

/// Lowers the hips, smoothly in time, where a standing foot would be out of reach.
void keepFeetInReach(const Skeleton& skeleton, std::vector<Posture>& frames)
{
    constexpr int radius = 3;
    const auto count = static_cast<int>(frames.size());
    std::vector<double> excess;
    excess.reserve(frames.size());
    for (const Posture& p : frames)
        excess.push_back(hipExcess(skeleton, p));
    for (int f = 0; f < count; ++f) {
        double sum = 0;
        double weights = 0;
        for (int d = -radius; d <= radius; ++d) {
            double most = 0;
            for (int e = -radius; e <= radius; ++e)
                most = std::max(most, excess[static_cast<std::size_t>(std::clamp(f + d + e, 0, count - 1))]);
            const double weight = radius + 1 - std::abs(d);
            sum += weight * most;
            weights += weight;
        }
        frames[static_cast<std::size_t>(f)].hipY -= sum / weights;
    }
}

} // namespace

const std::vector<std::string>& takeKinds()
{
    static const std::vector<std::string> kinds = {
        "walk",      "jog",       "left turn",  "right turn", "short jump", "long jump", "low jump",
        "high jump", "reach low", "reach high", "kick",       "idle",       "dance"};
    return kinds;
}

std::vector<Posture> framesOf(const std::vector<PostureKey>& keys, double duration)
{
    std::vector<Posture> frames;
    const auto count = std::lround(duration * sampleFps);
    for (long f = 0; f < count; ++f)
        frames.push_back(postureAt(keys, static_cast<double>(f) / sampleFps));
    return frames;
}

TakeMotion performTake(const Skeleton& skeleton, const std::string& kind, int variant, Random& random)
{
    const auto perform = [&] {
        if (kind.find("jump") != std::string::npos)
            return performJump(skeleton, kind, random);
        if (kind.find("reach") != std::string::npos)
            return performReach(skeleton, kind == "reach high", variant, random);
        if (kind == "kick")
            return performKick(skeleton, random);
        if (kind == "idle")
            return performIdle(skeleton, variant, random);
        if (kind == "dance")
            return performDance(skeleton, variant, random);
        return performGait(skeleton, kind, variant, random);
    };
    TakeMotion take = perform();
    take.kind = kind;
    addLife(take.frames, random.next());
    if (take.flight.count() == 0)
        keepFeetInReach(skeleton, take.frames);
    if (take.labels.empty())
        take.labels = {{kind, FrameRange::all(static_cast<std::int64_t>(take.frames.size()))}};
    return take;
}

TakeMotion performGait(const Skeleton& skeleton, const std::string& kind, int variant, Random& random)
{
    GaitPlan plan;
    GaitStyle& s = plan.style;
    if (kind == "jog") {
        s = {.speed = 2.55,
             .cycles = 1.36,
             .duty = 0.37,
             .stepWidth = 0.11,
             .hipHeight = 0.925,
             .bounce = 0.034,
             .lowest = 0.19,
             .sway = 0.010,
             .hipTwist = 0.13,
             .hipDrop = 0.05,
             .lean = 0.20,
             .chestTwist = 0.30,
             .armSwing = 0.62,
             .armBase = -0.10,
             .armOut = 0.20,
             .elbow = 1.45,
             .elbowSwing = 0.25,
             .strike = 0.12,
             .toeOff = 0.90,
             .lift = 0.16,
             .heelLift = 0.65,
             .headNod = 0.02};
    }
    const double size = random.between(0.95, 1.05);
    s.speed *= random.between(0.94, 1.06) * (variant == 1 ? 0.93 : 1.0);
    s.cycles *= random.between(0.97, 1.03) * (variant == 1 ? 0.97 : 1.0);
    s.armSwing *= random.between(0.85, 1.2);
    s.bounce *= random.between(0.9, 1.15);
    s.sway *= random.between(0.85, 1.25);
    s.chestTwist *= random.between(0.85, 1.15);
    s.hipDrop *= size;
    s.lean += random.between(-0.02, 0.03);
    s.asymmetry = random.between(-0.12, 0.12);
    s.phase = random.unit();
    plan.duration = 2.04;
    if (kind == "jog")
        plan.duration = 1.6;
    if (kind == "walk" && variant == 2) {
        // From standing, a few steps, to standing.
        s.phase = s.duty - 0.5;
        plan.duration = 3.2;
        plan.speed = [](double t) { return ramp(t, 0.25, 0.95) * (1 - ramp(t, 1.75, 2.35)); };
        plan.cadence = [](double t) { return ramp(t, 0.20, 0.50) * (1 - ramp(t, 2.55, 2.85)) + 1e-4; };
    }
    if (kind == "left turn" || kind == "right turn") {
        const double angle = (kind == "left turn" ? 1 : -1) * random.between(1.35, 1.75);
        const double middle = random.between(0.9, 1.2);
        const double width = random.between(0.36, 0.46);
        s.speed *= 0.82;
        plan.turning = [=](double t) {
            const double x = (t - middle) / width;
            return angle * std::exp(-0.5 * x * x) / (width * std::sqrt(6.283185307179586));
        };
        plan.speed = [=](double t) {
            const double x = (t - middle) / width;
            return 1 - 0.22 * std::exp(-0.5 * x * x);
        };
    }
    GaitMotion motion = makeGait(skeleton, plan, sampleFps);
    return {kind, std::move(motion.frames), {}, {}};
}

std::vector<ContactSpan> contactsOf(const TakeMotion& take)
{
    const std::vector<Posture>& frames = take.frames;
    std::vector<ContactSpan> spans;
    const auto count = static_cast<std::int64_t>(frames.size());
    for (std::size_t side = 0; side < 2; ++side) {
        const auto moves = [&](std::int64_t a, std::int64_t b) {
            if (a < 0 || b >= count)
                return false;
            const SidePosture& p = frames[static_cast<std::size_t>(a)].sides[side];
            const SidePosture& q = frames[static_cast<std::size_t>(b)].sides[side];
            return std::hypot(p.footX - q.footX, p.footZ - q.footZ) > 0.004;
        };
        std::int64_t first = -1;
        for (std::int64_t f = 0; f <= count; ++f) {
            const bool stands = f < count && !take.flight.contains(FrameIndex(f)) &&
                                frames[static_cast<std::size_t>(f)].sides[side].footLift < 0.004 &&
                                !(moves(f - 1, f) && moves(f, f + 1)) && !(f == 0 && moves(0, 1)) &&
                                !(f + 1 == count && moves(f - 1, f));
            if (stands && first < 0)
                first = f;
            if (stands || first < 0)
                continue;
            if (f - first >= 2)
                spans.push_back({side == 0 ? "left" : "right", {FrameIndex(first), FrameIndex(f - 1)}});
            first = -1;
        }
    }
    std::stable_sort(spans.begin(), spans.end(), [](const ContactSpan& a, const ContactSpan& b) {
        return a.frames.first < b.frames.first;
    });
    return spans;
}

} // namespace quadrille
