// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/parametric/parameters.h"

#include <array>
#include <map>
#include <vector>

namespace quadrille {

/// What keys or a stick say at a moment.
struct SteeringState
{
    std::array<double, 3> axes{}; ///< by SteeringAxis, each −1 … 1
    bool isAnalog = false;        ///< of a stick: it says where a parameter is, not which way it goes

    bool isIdle() const { return axes == std::array<double, 3>{}; }
    bool operator==(const SteeringState&) const = default;
};

/// What steers a parameter.
enum class SteeringAxis
{
    Horizontal, ///< right is positive
    Vertical,   ///< up is positive
    Third,      ///< Page up is positive
};

/// A parameter that is steered.
struct SteeredParameter
{
    SpaceMeasure measure = SpaceMeasure::Speed;
    double least = 0;
    double greatest = 0;
};

/// Turns keys and sticks into values of a space's parameters. What goes to the sides is steered by the
/// horizontal axis, the rest by the vertical one and then by those that are left.
///
/// Keys move a value over its range in one and a half seconds; turns go back to straight on as soon as no key
/// is held. A stick says the value itself; where it is let go, turns go back, and other values to their
/// least.
class LiveSteering
{
public:
    /// Another space: what its parameters measure keeps the value that it had last, whatever was steered
    /// since; what goes back by itself begins in the middle.
    void setParameters(std::vector<SteeredParameter> parameters);
    const std::vector<SteeredParameter>& parameters() const { return m_parameters; }

    /// \pre There is such a parameter, so for all below.
    SteeringAxis axisOf(std::size_t parameter) const { return m_axes[parameter]; }
    /// Whether a value goes back to the middle by itself: one whose range has both sides of nothing.
    bool returns(std::size_t parameter) const;
    const SpacePoint& values() const { return m_values; }
    /// As by a slider; values are kept to their range. One that is set so stays, also where it would return,
    /// until it is steered again.
    void setValue(std::size_t parameter, double value);
    /// As they were, to be steered on from there.
    void setValues(const SpacePoint& values) { m_values = values; }
    /// \param seconds  since the last time.
    void advance(const SteeringState& state, double seconds);

private:
    double target(std::size_t parameter, double deflection) const;

    std::vector<SteeredParameter> m_parameters;
    std::vector<SteeringAxis> m_axes;
    SpacePoint m_values{};
    std::map<SpaceMeasure, double> m_known; ///< values of spaces before
    std::array<bool, 3> m_isHeld{};         ///< set by a slider
    bool m_wasAnalog = false;
};

} // namespace quadrille
