// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace quadrille::widgets {

/// A square table of numbers, row by row, shared and never changed. Infinite cells hold nothing, and so do
/// all where there are no values.
struct MatrixValues
{
    int side = 0;
    std::shared_ptr<const float> values;          ///< side × side
    std::shared_ptr<const std::uint16_t> lengths; ///< side × side, a second number of each cell; may be null

    float value(int row, int column) const { return values.get()[offset(row, column)]; }
    /// 0 where there are no lengths.
    int length(int row, int column) const { return lengths ? lengths.get()[offset(row, column)] : 0; }
    bool has(int row, int column) const
    {
        return values && value(row, column) < std::numeric_limits<float>::infinity();
    }

private:
    std::size_t offset(int row, int column) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
               static_cast<std::size_t>(column);
    }
};

/// What is known of a table before its numbers are there: the least number of each square of cells.
struct MatrixOverview
{
    int side = 0;                       ///< of the table
    int cellsEach = 1;                  ///< along each side of a square, a power of two
    std::shared_ptr<const float> least; ///< of as many squares as cover the table, row by row

    int squares() const { return (side + cellsEach - 1) / cellsEach; }
};

/// Which cells are shown in colour; the others that hold something are greyed.
struct MatrixFilter
{
    float largestValue = std::numeric_limits<float>::infinity();
    int leastLength = 0;
    int greatestLength = std::numeric_limits<int>::max();

    bool passes(float value, int length) const
    {
        return value <= largestValue && length >= leastLength && length <= greatestLength;
    }
    bool operator==(const MatrixFilter&) const = default;
};

/// The cells as shades in one byte each, and ever smaller copies in which a cell stands for up to four of the
/// level below: for the one that is seen first – cells that pass the filter before greyed ones before empty
/// ones, cheap ones before dear ones. The first level is never kept, but made of the values where it is
/// looked at: of a large table it would take as much as all that is seen of it otherwise.
class MatrixPyramid
{
public:
    using Shade = std::uint8_t;
    static constexpr int colorSteps = 127;         ///< shades 0 … 126: in colour, from the least value on
    static constexpr Shade firstGrey = colorSteps; ///< 127 … 253: greyed, in the same steps
    static constexpr Shade nothing = 255;

    /// The whole table first, or the finest that is known of it, then halves of it down to a single cell.
    /// None for a table without cells.
    int levelCount() const;
    /// Cells along each side of a level.
    int sideOf(int level) const;
    int side() const { return m_side; }
    /// How often the table was halved for a level.
    int halvings(int level) const { return m_firstHalvings + level; }
    /// The coarsest level of which a cell covers at most `cells` of the table's along each side, or the
    /// first.
    int levelFor(double cells) const;
    /// The shades of cells in a row of a level, from a column on. \pre The level has these cells.
    void read(int level, int row, int column, std::span<Shade> shades) const;

private:
    friend std::shared_ptr<const MatrixPyramid> buildMatrixPyramid(const MatrixValues& values, float minimum,
                                                                   float maximum, const MatrixFilter& filter,
                                                                   const std::function<bool()>& isCancelled);
    friend std::shared_ptr<const MatrixPyramid> buildMatrixPyramid(const MatrixOverview& overview,
                                                                   float minimum, float maximum);
    MatrixPyramid(int side, const MatrixValues& finest, int firstHalvings, float minimum, float maximum,
                  const MatrixFilter& filter);
    bool addHalves(const std::function<bool()>& isCancelled);

    struct Level
    {
        int side = 0;
        std::vector<Shade> shades; ///< side × side
    };

    int m_side;            ///< of the table
    MatrixValues m_finest; ///< of the first level
    int m_firstHalvings;   ///< of the first level
    float m_minimum;
    float m_steps; ///< shades for each unit of values
    MatrixFilter m_filter;
    bool m_passesAll;            ///< lengths are not looked at
    std::vector<Level> m_halves; ///< all levels but the first
};

/// \param minimum  the value of the first shade. \param maximum  that of the last; larger ones look the same.
/// \param isCancelled  asked every few milliseconds; may be empty.
/// \return null when cancelled; holds the values. Any thread. Cost: O(side²), about 55 ms for 4,000 ×
/// 4,000 cells on one core.
std::shared_ptr<const MatrixPyramid> buildMatrixPyramid(const MatrixValues& values, float minimum,
                                                        float maximum, const MatrixFilter& filter = {},
                                                        const std::function<bool()>& isCancelled = {});
/// The same levels without the finest ones, which are not known.
std::shared_ptr<const MatrixPyramid> buildMatrixPyramid(const MatrixOverview& overview, float minimum,
                                                        float maximum);

} // namespace quadrille::widgets
