// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/subject.h"

#include "model/core/badargument.h"
#include "model/variation/latentblend.h"

#include <algorithm>

namespace quadrille {

namespace {

/// Corners of a square at (weight, across) = (0, 0), (1, 0), (0, 1), (1, 1): the first bit of their places
/// tells the weight, the second one the weight across.
using Square = std::array<std::size_t, 4>;
constexpr std::size_t weightBit = 1;
constexpr std::size_t acrossBit = 2;

struct LearnedWeight
{
    double weight = 0;
    std::size_t take = 0;
};

std::size_t takeOf(const Movement& movement, std::size_t preblend)
{
    return movement.capturedCount() + preblend;
}

/// The learned trajectories from one take to another, ascending by weight.
std::vector<LearnedWeight> learnedWeights(const Movement& movement, std::size_t from, std::size_t to)
{
    std::vector<LearnedWeight> learned{{0, from}, {1, to}};
    for (std::size_t p = 0; p < movement.preblends.size(); ++p) {
        const Preblend& point = movement.preblends[p];
        const std::vector<BlendShare> shares = sharesOf(movement.blends[point.blend], point);
        if (shares.size() != 2)
            continue;
        const auto& [first, second] = std::array{shares[0], shares[1]};
        if (first.take == from && second.take == to)
            learned.push_back({second.share, takeOf(movement, p)});
        else if (first.take == to && second.take == from)
            learned.push_back({1 - second.share, takeOf(movement, p)});
    }
    std::ranges::sort(learned, {}, &LearnedWeight::weight);
    return learned;
}

std::vector<BlendShare> alongPair(const Movement& movement, std::size_t from, std::size_t to, double weight)
{
    const std::vector<LearnedWeight> learned = learnedWeights(movement, from, to);
    std::vector<double> weights;
    weights.reserve(learned.size());
    for (const LearnedWeight& each : learned)
        weights.push_back(each.weight);
    const BlendNeighbours between = blendNeighbours(weights, weight);
    const double second = 1 - between.share;
    std::vector<BlendShare> shares;
    if (second < 1)
        shares.push_back({learned[between.first].take, 1 - second});
    if (second > 0)
        shares.push_back({learned[between.second].take, second});
    return shares;
}

/// Where a grid lies over a square: begun at any corner, turned or mirrored.
class GridPlace
{
public:
    /// Nothing where the corners of the blend are others, or neighbours elsewhere.
    static std::optional<GridPlace> find(const MovementBlend& blend, const Square& square)
    {
        if (!blend.across)
            return std::nullopt;
        const Square own{blend.from, blend.to, blend.across->from, blend.across->to};
        Square places{};
        for (std::size_t c = 0; c < square.size(); ++c) {
            const auto found = std::ranges::find(own, square[c]);
            if (found == own.end())
                return std::nullopt;
            places[c] = static_cast<std::size_t>(found - own.begin());
        }
        if ((places[0] ^ places[3]) != (weightBit | acrossBit))
            return std::nullopt;
        return GridPlace(places[0], (places[0] ^ places[1]) == acrossBit);
    }

    /// A point of the grid by the weights of the square.
    LearnedNode node(const Preblend& point, std::size_t take) const
    {
        const double weight = (m_origin & weightBit) != 0 ? 1 - point.weight : point.weight;
        const double across = (m_origin & acrossBit) != 0 ? 1 - point.across : point.across;
        return m_isTransposed ? LearnedNode{across, weight, take} : LearnedNode{weight, across, take};
    }

private:
    GridPlace(std::size_t origin, bool isTransposed) : m_origin(origin), m_isTransposed(isTransposed) {}

    std::size_t m_origin; ///< place in the blend of the corner where the square begins
    bool m_isTransposed;
};

std::vector<double> valuesOf(const std::vector<LearnedNode>& nodes, double LearnedNode::*member)
{
    std::vector<double> values;
    values.reserve(nodes.size());
    for (const LearnedNode& node : nodes)
        values.push_back(node.*member);
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

std::vector<BlendShare> inSquare(const Movement& movement, const VariationSubject& subject)
{
    const std::vector<LearnedNode> nodes = learnedNodes(movement.blends, movement.capturedCount(), subject);
    const std::vector<double> columns = valuesOf(nodes, &LearnedNode::weight);
    const std::vector<double> rows = valuesOf(nodes, &LearnedNode::across);
    const BlendCell cell = blendCell(columns, rows, subject.weight, subject.across->weight);
    const std::array<double, 4> shares = cell.shares();
    std::vector<BlendShare> takes;
    for (std::size_t c = 0; c < shares.size(); ++c) {
        if (shares[c] == 0)
            continue;
        const double column = columns[(c & weightBit) != 0 ? cell.across.second : cell.across.first];
        const double row = rows[(c & acrossBit) != 0 ? cell.along.second : cell.along.first];
        const auto node = std::ranges::find_if(
            nodes, [&](const LearnedNode& each) { return each.weight == column && each.across == row; });
        takes.push_back({node->take, shares[c]});
    }
    return takes;
}

void checkWeight(double weight)
{
    if (!(weight >= 0 && weight <= 1))
        refuse("the weight of the blend is outside of 0 … 1", "choose a weight between 0 and 1");
}

} // namespace

std::vector<BlendShare> capturedShares(const Movement& movement, const VariationSubject& subject)
{
    const SubjectAcross across = subject.across.value_or(SubjectAcross{subject.take, subject.take, 0});
    for (const std::size_t take : {subject.take, subject.to.value_or(0), across.take, across.to}) {
        if (take >= movement.capturedCount())
            refuse("There is no such take to vary", "Name one of the takes that were learned.");
    }
    if (!subject.to && subject.across)
        refuse("Two takes lie across from one alone", "Name four takes.");
    if (!subject.to)
        return {{subject.take, 1}};
    checkWeight(subject.weight);
    checkWeight(across.weight);
    return squareShares({subject.take, *subject.to, across.take, across.to}, subject.weight, across.weight);
}

std::vector<BlendShare> subjectTakes(const Movement& movement, const VariationSubject& subject)
{
    std::vector<BlendShare> captured = capturedShares(movement, subject);
    if (captured.size() == 1)
        return captured;
    if (captured.size() == 2)
        return alongPair(movement, captured[0].take, captured[1].take, captured[1].share);
    return inSquare(movement, subject);
}

std::vector<LearnedNode> learnedNodes(std::span<const MovementBlend> blends, std::size_t takes,
                                      const VariationSubject& subject)
{
    const Square square{subject.take, *subject.to, subject.across->take, subject.across->to};
    std::vector<LearnedNode> nodes{
        {0, 0, square[0]}, {1, 0, square[1]}, {0, 1, square[2]}, {1, 1, square[3]}};
    const std::vector<Preblend> preblends = preblendsOf(blends);
    for (std::size_t b = 0; b < blends.size(); ++b) {
        const auto place = GridPlace::find(blends[b], square);
        if (!place)
            continue;
        for (std::size_t p = 0; p < preblends.size(); ++p) {
            if (preblends[p].blend == b)
                nodes.push_back(place->node(preblends[p], takes + p));
        }
        break;
    }
    return nodes;
}

} // namespace quadrille
