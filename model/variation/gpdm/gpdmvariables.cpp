// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/gpdm/gpdmvariables.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille {

namespace {

struct Parameter
{
    const char* name;
    double GpdmHyperparameters::*value;
};

/// All but α₂, which stays.
constexpr std::array<Parameter, 6> learned{{{"alpha1", &GpdmHyperparameters::alpha1},
                                            {"alpha3", &GpdmHyperparameters::alpha3},
                                            {"beta1", &GpdmHyperparameters::beta1},
                                            {"beta2", &GpdmHyperparameters::beta2},
                                            {"beta3", &GpdmHyperparameters::beta3},
                                            {"beta4", &GpdmHyperparameters::beta4}}};

/// L: hyperparameters lie within e^±L.
const double range = std::log(1e6);

} // namespace

GpdmVariables::GpdmVariables(std::span<const RowSpan> spans, Eigen::Index dimensions, double smoothness)
    : m_spans(spans.begin(), spans.end())
    , m_frames(m_spans.back().last() + 1)
    , m_dimensions(dimensions)
    , m_smoothness(smoothness)
{
    m_pivots.reserve(static_cast<std::size_t>(m_frames));
    for (const RowSpan& span : m_spans) {
        for (Eigen::Index i = span.first; i <= span.last(); ++i) {
            const int neighbours = (i > span.first ? 1 : 0) + (i < span.last() ? 1 : 0);
            const double before = i > span.first ? smoothness * smoothness / m_pivots.back() : 0;
            m_pivots.push_back(1 + smoothness * neighbours - before);
        }
    }
}

void GpdmVariables::smooth(Eigen::Map<RowMatrix> values) const
{
    const auto pivot = [this](Eigen::Index i) { return m_pivots[static_cast<std::size_t>(i)]; };
    for (const RowSpan& span : m_spans) {
        for (Eigen::Index i = span.first + 1; i <= span.last(); ++i)
            values.row(i) += m_smoothness / pivot(i - 1) * values.row(i - 1);
        values.row(span.last()) /= pivot(span.last());
        for (Eigen::Index i = span.last() - 1; i >= span.first; --i)
            values.row(i) = (values.row(i) + m_smoothness * values.row(i + 1)) / pivot(i);
    }
}

void GpdmVariables::write(const GpdmState& state, double* variables) const
{
    const RowMatrix& x = state.latents;
    Eigen::Map<RowMatrix> z(variables, m_frames, m_dimensions);
    z = x;
    for (const RowSpan& span : m_spans) {
        for (Eigen::Index i = span.first; i < span.last(); ++i) {
            z.row(i) += m_smoothness * (x.row(i) - x.row(i + 1));
            z.row(i + 1) += m_smoothness * (x.row(i + 1) - x.row(i));
        }
    }
    double* out = variables + z.size();
    for (const Parameter& parameter : learned)
        *out++ = range * std::atanh(std::log(state.hyperparameters.*parameter.value) / range);
}

GpdmState GpdmVariables::read(const double* variables) const
{
    GpdmState state;
    state.latents = Eigen::Map<const RowMatrix>(variables, m_frames, m_dimensions);
    smooth({state.latents.data(), m_frames, m_dimensions});
    const double* u = variables + state.latents.size();
    for (const Parameter& parameter : learned)
        state.hyperparameters.*parameter.value = std::exp(range * std::tanh(*u++ / range));
    return state;
}

void GpdmVariables::writeGradient(const GpdmState& state, const GpdmObjective::Gradient& gradient,
                                  double* out) const
{
    Eigen::Map<RowMatrix> byLatents(out, m_frames, m_dimensions);
    byLatents = gradient.latents;
    smooth(byLatents);
    out += byLatents.size();
    for (const Parameter& parameter : learned) {
        const double value = state.hyperparameters.*parameter.value;
        const double share = std::log(value) / range;
        *out++ = gradient.hyperparameters.*parameter.value * value * (1 - share * share);
    }
}

std::vector<std::string> hyperparametersAtBounds(const GpdmHyperparameters& parameters)
{
    constexpr double near = 0.999;
    std::vector<std::string> names;
    for (const Parameter& parameter : learned)
        if (std::abs(std::log(parameters.*parameter.value)) > near * range)
            names.emplace_back(parameter.name);
    return names;
}

} // namespace quadrille
