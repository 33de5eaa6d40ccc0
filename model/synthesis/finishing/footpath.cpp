// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/finishing/footpath.h"

#include "model/synthesis/clips/soles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

std::size_t at(std::int64_t index)
{
    return static_cast<std::size_t>(index);
}

/// A length up to a limit: as it is up to two thirds of it, then ever less.
double limited(double length, double limit)
{
    const double free = limit * 2 / 3;
    return length <= free ? length : free + (limit - free) * std::tanh((length - free) / (limit - free));
}

double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// The shifts of one contact.
class Contact
{
public:
    Contact(std::vector<Sole> soles, double height) : m_soles(std::move(soles))
    {
        for (std::size_t k = 0; k + 1 < m_soles.size(); ++k)
            m_touches.push_back(touchOf(m_soles[k], m_soles[k + 1], height));
    }

    std::vector<FootShift> shifts(const ContactCorrectionSettings& settings, double height) const
    {
        std::vector<FootShift> shifts(m_soles.size());
        setTurns(shifts, settings);
        setShifts(shifts, settings, height);
        std::vector<double> heights;
        for (const Sole& sole : m_soles)
            heights.push_back(sole.height);
        const double level = medianOf(heights);
        const double most = settings.greatestLift * height;
        for (std::size_t k = 0; k < shifts.size(); ++k)
            shifts[k].lift = most > 0 ? settings.strength * most * std::tanh((level - heights[k]) / most) : 0;
        return shifts;
    }

private:
    void setTurns(std::vector<FootShift>& shifts, const ContactCorrectionSettings& settings) const
    {
        double mean = 0;
        for (std::size_t k = 0; k < shifts.size(); ++k) {
            shifts[k].pivot = m_soles[k].middle;
            shifts[k].turn = k == 0 ? 0 : shifts[k - 1].turn - m_touches[k - 1].turn;
            mean += shifts[k].turn / static_cast<double>(shifts.size());
        }
        for (FootShift& shift : shifts) {
            const double turn = shift.turn - mean;
            const double most = settings.greatestTurn;
            shift.turn =
                most > 0 ? settings.strength * std::copysign(limited(std::abs(turn), most), turn) : 0;
        }
    }

    /// With the turns known: each frame's foot is put where what touches stays in its place.
    void setShifts(std::vector<FootShift>& shifts, const ContactCorrectionSettings& settings,
                   double height) const
    {
        Vec2d mean = Vec2d::Zero();
        for (std::size_t k = 1; k < shifts.size(); ++k) {
            const FootShift& before = shifts[k - 1];
            FootShift& now = shifts[k];
            const Touch& touch = m_touches[k - 1];
            const Vec2d place =
                before.pivot + before.shift + Eigen::Rotation2Dd(before.turn) * (touch.before - before.pivot);
            now.shift = place - now.pivot - Eigen::Rotation2Dd(now.turn) * (touch.after - now.pivot);
            mean += now.shift / static_cast<double>(shifts.size());
        }
        const double most = settings.greatestShift * height;
        for (FootShift& shift : shifts) {
            shift.shift -= mean;
            const double length = shift.shift.norm();
            shift.shift *= length > 0 ? settings.strength * limited(length, most) / length : 0;
        }
    }

    std::vector<Sole> m_soles;
    std::vector<Touch> m_touches;
};

/// The cubic from a value with its slope to another with its own, over a length.
struct Ease
{
    double first;
    double firstSlope;
    double last;
    double lastSlope;
    double length;

    double operator()(double place) const
    {
        const double t = place / length;
        const double rise = last - first;
        const double a = firstSlope * length;
        const double b = lastSlope * length;
        return first + t * (a + t * (3 * rise - 2 * a - b + t * (a + b - 2 * rise)));
    }
};

/// Lifts a foot over the ground where it goes from one contact to the next inside a blend, as in a step
/// between two poses that both stand, unless it clears the ground by itself.
class StepLift
{
public:
    /// \param middles  of the foot in each frame, with its shift.
    StepLift(const Clip& clip, const FootContacts& foot, std::span<const Vec2d> middles, double height,
             const Ground& ground)
        : m_clip(clip), m_foot(foot), m_middles(middles), m_height(height), m_ground(ground)
    {
    }

    /// \param most  metres.
    void addTo(std::span<double> lifts, double most) const
    {
        for (std::size_t s = 0; s + 1 < m_foot.spans.size(); ++s) {
            const std::int64_t from = m_foot.spans[s].last.value;
            const std::int64_t to = m_foot.spans[s + 1].first.value;
            const double clearance =
                std::min(most, clearanceFor((m_middles[at(to)] - m_middles[at(from)]).norm()));
            if (!isInBlend(from + 1, to - 1) || 2 * ownClearance(from, to) > clearance)
                continue;
            for (std::int64_t f = from + 1; f < to; ++f) {
                const double t = static_cast<double>(f - from) / static_cast<double>(to - from);
                lifts[at(f)] += clearance * 16 * t * t * (1 - t) * (1 - t);
            }
        }
    }

private:
    /// A step of 20 cm goes 5 cm high.
    double clearanceFor(double way) const { return 0.01 * m_height + 0.15 * way; }
    bool isInBlend(std::int64_t first, std::int64_t last) const
    {
        const auto origins = std::span(m_clip.origins).subspan(at(first), at(last - first + 1));
        return std::ranges::none_of(origins, &FrameProvenance::isSingle);
    }
    /// How high the foot goes without help, over its contacts.
    double ownClearance(std::int64_t from, std::int64_t to) const
    {
        const auto heightAt = [&](std::int64_t f) {
            return soleOf(m_clip.frame(f), m_foot.vertices, m_height, m_ground).height;
        };
        const double level = std::max(heightAt(from), heightAt(to));
        double most = 0;
        for (std::int64_t f = from + 1; f < to; ++f)
            most = std::max(most, heightAt(f) - level);
        return most;
    }

    const Clip& m_clip;
    const FootContacts& m_foot;
    std::span<const Vec2d> m_middles;
    double m_height;
    const Ground& m_ground;
};

} // namespace

bool FootShift::isNothing() const
{
    // A micrometre: the rounding of positions.
    constexpr double least = 1e-6;
    return std::abs(turn) < least && shift.cwiseAbs().maxCoeff() < least && std::abs(lift) < least;
}

Vec3d FootShift::operator()(const Vec3d& point, const Ground& ground) const
{
    const Vec2d moved = pivot + shift + Eigen::Rotation2Dd(turn) * (ground.of(point) - pivot);
    return ground.at(moved, ground.heightOf(point) + lift);
}

void easeBetween(std::span<double> values, std::span<const FrameRange> spans, std::int64_t ease)
{
    const auto count = static_cast<std::int64_t>(values.size());
    std::vector<double> eased(values.size(), 0);
    const auto slopeAfter = [&](const FrameRange& span) {
        return span.count() > 1 ? values[at(span.last.value)] - values[at(span.last.value - 1)] : 0;
    };
    const auto slopeBefore = [&](const FrameRange& span) {
        return span.count() > 1 ? values[at(span.first.value + 1)] - values[at(span.first.value)] : 0;
    };
    const auto fill = [&](std::int64_t from, const Ease& way, std::int64_t first, std::int64_t last) {
        for (std::int64_t f = std::max<std::int64_t>(first, 0); f <= std::min(last, count - 1); ++f)
            eased[at(f)] = way(static_cast<double>(f - from));
    };
    for (std::size_t s = 0; s < spans.size(); ++s) {
        const std::int64_t first = spans[s].first.value;
        const std::int64_t last = spans[s].last.value;
        for (std::int64_t f = first; f <= last; ++f)
            eased[at(f)] = values[at(f)];
        const double begin = values[at(first)];
        const double end = values[at(last)];
        const std::int64_t next = s + 1 < spans.size() ? spans[s + 1].first.value : count + 2 * ease;
        if (next - last < 2 * ease) {
            const Ease way{end, slopeAfter(spans[s]), values[at(next)], slopeBefore(spans[s + 1]),
                           static_cast<double>(next - last)};
            fill(last, way, last + 1, next - 1);
        } else {
            fill(last, {end, slopeAfter(spans[s]), 0, 0, static_cast<double>(ease)}, last + 1,
                 last + ease - 1);
        }
        const std::int64_t before = s > 0 ? spans[s - 1].last.value : -2 * ease - 1;
        if (first - before >= 2 * ease)
            fill(first - ease, {0, 0, begin, slopeBefore(spans[s]), static_cast<double>(ease)},
                 first - ease + 1, first - 1);
    }
    std::ranges::copy(eased, values.begin());
}

std::vector<FootShift> footShifts(const Clip& clip, const FootContacts& foot,
                                  const ContactCorrectionSettings& settings, double height,
                                  const Ground& ground)
{
    const auto count = at(clip.frameCount());
    std::vector<FootShift> shifts(count);
    std::vector<double> turns(count, 0);
    std::vector<double> along(count, 0);
    std::vector<double> across(count, 0);
    std::vector<double> lifts(count, 0);
    for (const FrameRange& span : foot.spans) {
        std::vector<Sole> soles;
        for (std::int64_t f = span.first.value; f <= span.last.value; ++f)
            soles.push_back(soleOf(clip.frame(f), foot.vertices, height, ground));
        const std::vector<FootShift> found = Contact(std::move(soles), height).shifts(settings, height);
        for (std::size_t k = 0; k < found.size(); ++k) {
            const std::size_t f = at(span.first.value) + k;
            turns[f] = found[k].turn;
            along[f] = found[k].shift.x();
            across[f] = found[k].shift.y();
            lifts[f] = found[k].lift;
        }
    }
    const auto ease = std::max<std::int64_t>(1, std::llround(settings.easeSeconds * clip.fps));
    for (std::vector<double>* values : {&turns, &along, &across, &lifts})
        easeBetween(*values, foot.spans, ease);
    std::vector<Vec2d> middles(count);
    for (std::size_t f = 0; f < count; ++f) {
        const Positions pose = clip.frame(static_cast<std::int64_t>(f));
        Vec2d middle = Vec2d::Zero();
        for (const std::uint32_t v : foot.vertices)
            middle += ground.of(pose[v].cast<double>()) / static_cast<double>(foot.vertices.size());
        shifts[f] = {.pivot = middle, .turn = turns[f], .shift = {along[f], across[f]}};
        middles[f] = middle + shifts[f].shift;
    }
    StepLift(clip, foot, middles, height, ground)
        .addTo(lifts, settings.strength * settings.greatestLift * height);
    for (std::size_t f = 0; f < count; ++f)
        shifts[f].lift = lifts[f];
    return shifts;
}

} // namespace quadrille
