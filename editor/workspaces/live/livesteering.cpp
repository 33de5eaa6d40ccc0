// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/live/livesteering.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille {

namespace {

constexpr double secondsAcross = 1.5;

bool isSideways(SpaceMeasure measure)
{
    return measure == SpaceMeasure::Turning || measure == SpaceMeasure::Side;
}

} // namespace

void LiveSteering::setParameters(std::vector<SteeredParameter> parameters)
{
    for (std::size_t p = 0; p < m_parameters.size(); ++p)
        m_known[m_parameters[p].measure] = m_values.at(p);
    m_parameters = std::move(parameters);
    m_axes.clear();
    m_values = {};
    m_isHeld = {};
    std::array<bool, 3> isTaken{};
    for (std::size_t p = 0; p < m_parameters.size(); ++p) {
        const SteeredParameter& each = m_parameters[p];
        std::size_t axis = isSideways(each.measure) ? 0 : 1;
        if (isTaken[axis])
            axis = static_cast<std::size_t>(std::ranges::find(isTaken, false) - isTaken.begin());
        isTaken[axis] = true;
        m_axes.push_back(static_cast<SteeringAxis>(axis));
        const auto known = m_known.find(each.measure);
        const double first = known == m_known.end() ? each.least : known->second;
        m_values.at(p) = std::clamp(returns(p) ? 0 : first, each.least, each.greatest);
    }
}

bool LiveSteering::returns(std::size_t parameter) const
{
    const SteeredParameter& each = m_parameters[parameter];
    return isSideways(each.measure) && each.least < 0 && each.greatest > 0;
}

void LiveSteering::setValue(std::size_t parameter, double value)
{
    const SteeredParameter& each = m_parameters[parameter];
    m_values.at(parameter) = std::clamp(value, each.least, each.greatest);
    m_isHeld.at(parameter) = true;
}

double LiveSteering::target(std::size_t parameter, double deflection) const
{
    const SteeredParameter& each = m_parameters[parameter];
    if (returns(parameter))
        return deflection < 0 ? -deflection * each.least : deflection * each.greatest;
    return std::lerp(each.least, each.greatest, std::clamp(deflection, 0.0, 1.0));
}

void LiveSteering::advance(const SteeringState& state, double seconds)
{
    const bool isAnalog = state.isAnalog || (m_wasAnalog && state.isIdle());
    for (std::size_t p = 0; p < m_parameters.size(); ++p) {
        const SteeredParameter& each = m_parameters[p];
        double deflection = state.axes.at(static_cast<std::size_t>(m_axes[p]));
        if (isSideways(each.measure) && m_axes[p] == SteeringAxis::Horizontal)
            deflection = -deflection; // to the left is positive
        if (deflection != 0)
            m_isHeld.at(p) = false;
        if (m_isHeld.at(p))
            continue;
        const double reach = (each.greatest - each.least) * seconds / secondsAcross;
        double& value = m_values.at(p);
        double wanted = value;
        if (isAnalog || (deflection == 0 && returns(p)))
            wanted = target(p, deflection);
        else if (deflection != 0)
            wanted = value + deflection * reach;
        // A stick is as quick as it is moved; what it steers has limits of its own.
        value = isAnalog ? wanted : std::clamp(wanted, value - reach, value + reach);
        value = std::clamp(value, each.least, each.greatest);
    }
    m_wasAnalog = isAnalog;
}

} // namespace quadrille
