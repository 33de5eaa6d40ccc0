// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/matrixpyramid.h"

#include <algorithm>

namespace quadrille::widgets {

namespace {

constexpr int rowsBetweenQuestions = 64;

class Shader
{
public:
    Shader(float minimum, float maximum)
        : m_minimum(minimum)
        , m_steps(maximum > minimum ? MatrixPyramid::colorSteps / (maximum - minimum) : 0.0F)
    {
    }
    /// \pre value is finite.
    int step(float value) const
    {
        const float step = (value - m_minimum) * m_steps;
        return static_cast<int>(std::clamp(step, 0.0F, MatrixPyramid::colorSteps - 1.0F));
    }

private:
    float m_minimum;
    float m_steps;
};

void shadeRow(const MatrixValues& table, int row, const Shader& shader, const MatrixFilter& filter,
              MatrixPyramid::Shade* shades)
{
    const auto start = static_cast<std::size_t>(row) * static_cast<std::size_t>(table.side);
    const float* values = table.values.get() + start;
    const std::uint16_t* lengths = table.lengths ? table.lengths.get() + start : nullptr;
    for (int column = 0; column < table.side; ++column) {
        const float value = values[column];
        if (!(value < std::numeric_limits<float>::infinity())) {
            shades[column] = MatrixPyramid::nothing;
            continue;
        }
        const int grey = filter.passes(value, lengths ? lengths[column] : 0) ? 0 : MatrixPyramid::firstGrey;
        shades[column] = static_cast<MatrixPyramid::Shade>(shader.step(value) + grey);
    }
}

/// Shades are ordered by what is seen first, so that a smaller copy takes the least of four.
void halveRow(const MatrixPyramid::Level& from, int row, MatrixPyramid::Shade* shades)
{
    const auto side = static_cast<std::size_t>(from.side);
    const MatrixPyramid::Shade* upper = from.shades.data() + static_cast<std::size_t>(row) * 2 * side;
    const MatrixPyramid::Shade* lower = 2 * row + 1 < from.side ? upper + side : upper;
    for (std::size_t column = 0; column + 1 < side; column += 2)
        shades[column / 2] =
            std::min(std::min(upper[column], upper[column + 1]), std::min(lower[column], lower[column + 1]));
    if (side % 2 != 0)
        shades[side / 2] = std::min(upper[side - 1], lower[side - 1]);
}

} // namespace

int MatrixPyramid::levelFor(double cells) const
{
    int level = 0;
    while (level + 1 < static_cast<int>(m_levels.size()) &&
           static_cast<double>(2 << halvings(level)) <= cells)
        ++level;
    return level;
}

/// \return false when cancelled.
bool MatrixPyramid::addLevels(const MatrixValues& finest, float minimum, float maximum,
                              const MatrixFilter& filter, const std::function<bool()>& isCancelled)
{
    const auto add = [&](int side, const auto& fillRow) {
        Level made{side, {}};
        made.shades.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
        for (int row = 0; row < side; ++row) {
            if (row % rowsBetweenQuestions == 0 && isCancelled && isCancelled())
                return false;
            fillRow(row, made.shades.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(side));
        }
        m_levels.push_back(std::move(made));
        return true;
    };
    if (finest.side <= 0)
        return true;
    const Shader shader(minimum, maximum);
    if (!add(finest.side, [&](int row, Shade* shades) { shadeRow(finest, row, shader, filter, shades); }))
        return false;
    while (m_levels.back().side > 1) {
        const Level& finer = m_levels.back();
        if (!add((finer.side + 1) / 2, [&](int row, Shade* shades) { halveRow(finer, row, shades); }))
            return false;
    }
    return true;
}

std::shared_ptr<const MatrixPyramid> buildMatrixPyramid(const MatrixValues& values, float minimum,
                                                        float maximum, const MatrixFilter& filter,
                                                        const std::function<bool()>& isCancelled)
{
    auto pyramid = std::make_shared<MatrixPyramid>();
    pyramid->m_side = std::max(values.side, 0);
    if (!pyramid->addLevels(values, minimum, maximum, filter, isCancelled))
        return nullptr;
    return pyramid;
}

std::shared_ptr<const MatrixPyramid> buildMatrixPyramid(const MatrixOverview& overview, float minimum,
                                                        float maximum)
{
    auto pyramid = std::make_shared<MatrixPyramid>();
    pyramid->m_side = overview.side;
    for (int each = overview.cellsEach; each > 1; each /= 2)
        ++pyramid->m_firstHalvings;
    pyramid->addLevels({overview.squares(), overview.least, nullptr}, minimum, maximum, {}, {});
    return pyramid;
}

} // namespace quadrille::widgets
