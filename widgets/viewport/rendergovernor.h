// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

namespace quadrille::widgets {

/// How well pictures are drawn.
struct RenderQuality
{
    int samples = 4;               ///< of each pixel; 0: edges are not smoothed by samples
    bool smoothsEdges = false;     ///< afterwards, by looking for steps in the picture
    double shadowCoarseness = 1.0; ///< see ShadowWish
    double scale = 1.0;            ///< pixels drawn along each side for one of the screen; at most 1

    bool operator==(const RenderQuality&) const = default;
};

/// Chooses how well pictures that follow each other are drawn, so that they come in time: steps down as soon
/// as they take too long, and up again when there has been room for a while. What a step cost before is
/// remembered, so that it is not tried in vain again and again. Pure logic.
class RenderGovernor
{
public:
    static constexpr int levels = 8;
    /// What a picture may take, milliseconds, where so many a second are wanted: 25 leave 40, of which
    /// reading and the rest of the window need some. No more for fewer, and no less than what is worth it for
    /// more.
    static double budgetFor(double picturesPerSecond);
    /// That of 25 a second unless set.
    void setBudget(double milliseconds) { m_budget = milliseconds; }

    /// 0 is the best.
    int level() const { return m_level; }
    RenderQuality quality() const { return qualityOf(m_level); }
    static RenderQuality qualityOf(int level);
    /// A picture of the current level was drawn while others follow it.
    void drawn(double milliseconds);
    /// Pictures stood still: what comes next follows nothing.
    void rested();

private:
    void step(int by);

    double m_budget = budgetFor(0); ///< milliseconds
    int m_level = 1;
    int m_pictures = 0; ///< of this level since it was chosen
    int m_roomy = 0;    ///< those of them, one after the other, that left time for a better level
    double m_mean = 0;  ///< milliseconds, of the last few
    /// How many times longer a picture of a level takes than one of the next; where known.
    std::array<std::optional<double>, levels> m_ratios;
    double m_left = 0; ///< what pictures took when the level was last left, milliseconds
    int m_from = 1;    ///< that level
};

} // namespace quadrille::widgets
