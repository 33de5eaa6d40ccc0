// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/matrixpyramid.h"

#include <algorithm>
#include <bit>

namespace quadrille::widgets {

namespace {

constexpr int rowsBetweenQuestions = 32;

/// Shades are ordered by what is seen first, so that a smaller copy takes the least of four.
void halve(std::span<const MatrixPyramid::Shade> upper, std::span<const MatrixPyramid::Shade> lower,
           MatrixPyramid::Shade* shades)
{
    const std::size_t side = upper.size();
    for (std::size_t column = 0; column + 1 < side; column += 2)
        shades[column / 2] =
            std::min(std::min(upper[column], upper[column + 1]), std::min(lower[column], lower[column + 1]));
    if (side % 2 != 0)
        shades[side / 2] = std::min(upper[side - 1], lower[side - 1]);
}

} // namespace

MatrixPyramid::MatrixPyramid(int side, const MatrixValues& finest, int firstHalvings, float minimum,
                             float maximum, const MatrixFilter& filter)
    : m_side(side)
    , m_finest(finest)
    , m_firstHalvings(firstHalvings)
    , m_minimum(minimum)
    , m_steps(maximum > minimum ? colorSteps / (maximum - minimum) : 0.0F)
    , m_filter(filter)
    , m_passesAll(filter == MatrixFilter())
{
}

int MatrixPyramid::levelCount() const
{
    return m_finest.side > 0 ? static_cast<int>(m_halves.size()) + 1 : 0;
}

int MatrixPyramid::sideOf(int level) const
{
    return level == 0 ? m_finest.side : m_halves[static_cast<std::size_t>(level) - 1].side;
}

int MatrixPyramid::levelFor(double cells) const
{
    int level = 0;
    while (level + 1 < levelCount() && static_cast<double>(2 << halvings(level)) <= cells)
        ++level;
    return level;
}

void MatrixPyramid::read(int level, int row, int column, std::span<Shade> shades) const
{
    const auto start = static_cast<std::size_t>(row) * static_cast<std::size_t>(sideOf(level)) +
                       static_cast<std::size_t>(column);
    if (level > 0) {
        const Shade* kept = m_halves[static_cast<std::size_t>(level) - 1].shades.data() + start;
        std::copy_n(kept, shades.size(), shades.begin());
        return;
    }
    const float* values = m_finest.values.get() + start;
    const std::uint16_t* lengths =
        m_finest.lengths && !m_passesAll ? m_finest.lengths.get() + start : nullptr;
    for (std::size_t i = 0; i < shades.size(); ++i) {
        const float value = values[i];
        if (!(value < std::numeric_limits<float>::infinity())) {
            shades[i] = nothing;
            continue;
        }
        const float step = std::clamp((value - m_minimum) * m_steps, 0.0F, colorSteps - 1.0F);
        const int grey = m_passesAll || m_filter.passes(value, lengths ? lengths[i] : 0) ? 0 : firstGrey;
        shades[i] = static_cast<Shade>(static_cast<int>(step) + grey);
    }
}

/// \return false when cancelled.
bool MatrixPyramid::addHalves(const std::function<bool()>& isCancelled)
{
    std::vector<Shade> rows;
    for (int level = 0; level < levelCount() && sideOf(level) > 1; ++level) {
        const int side = sideOf(level);
        const int half = (side + 1) / 2;
        Level made{half, {}};
        made.shades.resize(static_cast<std::size_t>(half) * static_cast<std::size_t>(half));
        rows.resize(2 * static_cast<std::size_t>(side));
        const std::span<Shade> upper(rows.data(), static_cast<std::size_t>(side));
        const std::span<Shade> lower(rows.data() + side, static_cast<std::size_t>(side));
        for (int row = 0; row < half; ++row) {
            if (row % rowsBetweenQuestions == 0 && isCancelled && isCancelled())
                return false;
            read(level, 2 * row, 0, upper);
            read(level, std::min(2 * row + 1, side - 1), 0, lower);
            halve(upper, lower,
                  made.shades.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(half));
        }
        m_halves.push_back(std::move(made));
    }
    return true;
}

std::shared_ptr<const MatrixPyramid> buildMatrixPyramid(const MatrixValues& values, float minimum,
                                                        float maximum, const MatrixFilter& filter,
                                                        const std::function<bool()>& isCancelled)
{
    const std::shared_ptr<MatrixPyramid> pyramid(
        new MatrixPyramid(std::max(values.side, 0), values, 0, minimum, maximum, filter));
    return pyramid->addHalves(isCancelled) ? pyramid : nullptr;
}

std::shared_ptr<const MatrixPyramid> buildMatrixPyramid(const MatrixOverview& overview, float minimum,
                                                        float maximum)
{
    const int halvings = std::countr_zero(static_cast<unsigned>(overview.cellsEach));
    const std::shared_ptr<MatrixPyramid> pyramid(new MatrixPyramid(
        overview.side, {overview.squares(), overview.least, nullptr}, halvings, minimum, maximum, {}));
    pyramid->addHalves({});
    return pyramid;
}

} // namespace quadrille::widgets
