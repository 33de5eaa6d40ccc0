// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/bakedparts.h"

#include "model/sequence/topology.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

void bakeTopology(auto& bytes, auto& data)
{
    bytes(data.vertexCount);
    bytes.list(data.triangles);
    bytes.list(data.uvs);
    bytes.list(data.triangleUvs);
    bytes.each(
        data.materials, [&](auto& name) { bytes(name); }, sizeof(std::uint64_t));
    bytes.list(data.triangleMaterials);
}

void bakeTake(auto& bytes, auto& take)
{
    bytes(take.name);
    bytes.list(take.poses);
    bytes.each(
        take.steps, [&](auto& step) { bakeMotion(bytes, step); }, 3 * sizeof(double));
    bytes.list(take.seconds);
}

void bakeReference(auto& bytes, auto& reference)
{
    bytes.list(reference.starts);
    bytes.list(reference.vertices);
    bytes.list(reference.displacements);
    bytes(reference.unit);
}

/// What WeightSpace is made from.
struct WeightParts
{
    std::int32_t dimension = 0;
    std::size_t takes = 0;
    std::vector<WeightSpace::Node> nodes;
    std::vector<std::array<int, 4>> simplices;
};

WeightParts partsOf(const WeightSpace& weights)
{
    WeightParts parts{weights.dimension(), weights.takeCount(), weights.nodes(), {}};
    for (const WeightSpace::Simplex& simplex : weights.simplices())
        parts.simplices.push_back(simplex.nodes);
    return parts;
}

void bakeWeights(auto& bytes, auto& parts)
{
    bytes(parts.dimension);
    bakeSize(bytes, parts.takes);
    const auto bakeShare = [&](auto& share) {
        bakeSize(bytes, share.take);
        bytes(share.share);
    };
    bytes.each(
        parts.nodes,
        [&](auto& node) {
            bakePoint(bytes, node.place);
            bytes.each(node.shares, bakeShare, 2 * sizeof(std::uint64_t));
        },
        4 * sizeof(std::uint64_t));
    bytes.list(parts.simplices);
}

void bakeParameter(auto& bytes, auto& parameter)
{
    bytes(parameter.name);
    bakeAll(bytes, parameter.measure, parameter.vertex.value);
}

void bakeMatrix(BakedWriter& bytes, const Eigen::MatrixXd& matrix)
{
    bakeSize(bytes, static_cast<std::size_t>(matrix.cols()));
    bytes.list(std::vector<double>(matrix.data(), matrix.data() + matrix.size()));
}
void bakeMatrix(BakedReader& bytes, Eigen::MatrixXd& matrix)
{
    std::size_t columns = 0;
    bakeSize(bytes, columns);
    std::vector<double> values;
    bytes.list(values);
    if (columns == 0 ? !values.empty() : values.size() % columns != 0)
        bytes.refuse("the numbers of a matrix do not fill it");
    const auto rows = columns == 0 ? 0 : static_cast<Eigen::Index>(values.size() / columns);
    matrix = Eigen::Map<const Eigen::MatrixXd>(values.data(), rows, static_cast<Eigen::Index>(columns));
}

void bakeMap(auto& bytes, auto& map)
{
    bytes(map.dimension);
    bakeMatrix(bytes, map.coefficients);
    for (auto* point : {&map.least, &map.greatest, &map.meanResidual, &map.worstResidual})
        bakePoint(bytes, *point);
}

void bakeSpace(auto& bytes, auto& space, auto& weights)
{
    bytes(space.name);
    bakeAll(bytes, space.up, space.fps, space.isCyclic);
    bytes.each(
        space.takes, [&](auto& take) { bakeTake(bytes, take); }, 4 * sizeof(std::uint64_t));
    bakeWeights(bytes, weights);
    bytes.each(
        space.references, [&](auto& reference) { bakeReference(bytes, reference); },
        3 * sizeof(std::uint64_t));
    bytes.each(
        space.parameters, [&](auto& parameter) { bakeParameter(bytes, parameter); }, sizeof(std::uint64_t));
    bakeMap(bytes, space.map);
}

void bakeTable(auto& bytes, auto& table)
{
    for (auto* size : {&table.sourceFrames, &table.targetFrames, &table.sourceNodes, &table.targetNodes})
        bakeSize(bytes, *size);
    bytes.list(table.distances);
    bytes.list(table.leasts);
    bytes(table.greatest);
}

void bakeInput(auto& bytes, auto& input)
{
    bakeSize(bytes, input.space);
    bakePoint(bytes, input.parameters);
    bytes(input.isResponsive);
}

void bakeFrame(auto& bytes, auto& frame)
{
    bytes(frame.sequence);
    bakeAll(bytes, frame.frame, frame.isMirrored, frame.picture);
}

/// All of a player but its graph.
void bakeRest(auto& bytes, auto& player)
{
    auto& settings = player.settings;
    bakeAll(bytes, settings.ticksPerFrame, settings.search.depth, settings.search.latencyWeight,
            settings.search.steps, settings.responsiveWeight, settings.fadeSeconds, settings.secondsAcross,
            settings.earliestLeave, settings.latestArrival);
    auto& start = player.start;
    bakeSize(bytes, start.space);
    bakePoint(bytes, start.parameters);
    bytes(start.frame);
    bakeMotion(bytes, start.root);
    constexpr std::size_t ofInput = 4 * sizeof(std::uint64_t);
    bytes.each(
        player.inputs, [&](auto& input) { bakeInput(bytes, input); }, ofInput);
    bakeAll(bytes, player.from, player.metresPerUnit);
    const auto bakeTakeFrames = [&](auto& take) {
        bytes.each(
            take, [&](auto& frame) { bakeFrame(bytes, frame); }, 2 * sizeof(std::uint64_t));
    };
    const auto bakeSpaceFrames = [&](auto& space) {
        bytes.each(space, bakeTakeFrames, sizeof(std::uint64_t));
    };
    bytes.each(player.frames, bakeSpaceFrames, sizeof(std::uint64_t));
    bakeSize(bytes, player.pictureCount);
}

/// Says why not, where something that was read does not fit together.
class FitCheck
{
public:
    explicit FitCheck(const BakedReader& bytes) : m_bytes(bytes) {}

    void operator()(bool holds, const char* reason) const
    {
        if (!holds)
            m_bytes.refuse(reason);
    }
    void weights(const WeightParts& parts, std::size_t takes) const;
    void space(const MotionSpace& space) const;
    void table(const SimilarityTable& table, const MotionSpace& source, const MotionSpace& target) const;
    void rest(const BakedPlayer& player) const;

private:
    const BakedReader& m_bytes;
};

bool areFinite(const auto& values)
{
    return std::ranges::all_of(values, [](auto value) { return std::isfinite(value); });
}

/// Whether a frame may last so long, seconds: a tick goes over all frames that end within it.
bool isTime(double seconds)
{
    constexpr double least = 1e-5;
    constexpr double most = 100;
    return seconds >= least && seconds <= most;
}

void FitCheck::weights(const WeightParts& parts, std::size_t takes) const
{
    const FitCheck& fits = *this;
    fits(parts.dimension >= 0 && parts.dimension <= 3, "a space has more than three parameters");
    fits(takes >= 1 && takes <= WeightSpace::mostTakes && parts.takes == takes &&
             parts.nodes.size() >= takes && !parts.simplices.empty(),
         "takes and places of a space do not fit");
    for (const WeightSpace::Node& node : parts.nodes) {
        fits(areFinite(node.place) && !node.shares.empty(), "a place of a space is nowhere");
        for (const BlendShare& share : node.shares)
            fits(share.take < takes && std::isfinite(share.share), "a place is a blend of no takes");
    }
    const auto nodes = static_cast<int>(parts.nodes.size());
    for (const std::array<int, 4>& simplex : parts.simplices)
        fits(std::ranges::all_of(simplex, [&](int node) { return node >= 0 && node < nodes; }),
             "a simplex has a corner that is no place");
}

void FitCheck::space(const MotionSpace& space) const
{
    const FitCheck& fits = *this;
    const std::size_t vertices = space.vertexCount();
    const std::size_t frames = space.takes.front().steps.size();
    fits(frames >= 1 && isTime(1 / space.fps), "a space has no frames or no rate");
    fits(space.up >= UpAxis::X && space.up <= UpAxis::Z, "an axis is none of three");
    for (const SpaceTake& take : space.takes) {
        fits(take.poses.size() == frames * vertices && take.steps.size() == frames &&
                 take.seconds.size() == frames,
             "takes of a space differ in length");
        fits(std::ranges::all_of(take.seconds, isTime), "a frame takes no time, or forever");
        for (const GroundMotion& step : take.steps)
            fits(std::isfinite(step.turn) && step.shift.allFinite(), "a step leads nowhere");
    }
    fits(space.references.size() + space.takes.size() == space.weights.nodes().size(),
         "places and references of a space do not fit");
    for (const SpaceReference& reference : space.references) {
        fits(reference.starts.size() == frames + 1 && std::ranges::is_sorted(reference.starts) &&
                 reference.starts.back() == reference.vertices.size() &&
                 reference.displacements.size() == reference.vertices.size() && std::isfinite(reference.unit),
             "parts of a reference do not fit");
        fits(std::ranges::all_of(reference.vertices, [&](std::uint32_t v) { return v < vertices; }),
             "a reference displaces a vertex that is not there");
    }
    const auto dimension = static_cast<std::size_t>(space.weights.dimension());
    const std::size_t coefficients = 1 + dimension + dimension * (dimension + 1) / 2;
    fits(space.parameters.size() == dimension && space.map.dimension == space.weights.dimension(),
         "a space has not as many parameters as dimensions");
    for (const SpaceParameter& parameter : space.parameters)
        fits(parameter.measure >= SpaceMeasure::Speed && parameter.measure <= SpaceMeasure::ByHand &&
                 parameter.vertex.value < vertices,
             "a parameter measures what is not there");
    fits(dimension == 0 || (static_cast<std::size_t>(space.map.coefficients.rows()) == dimension &&
                            static_cast<std::size_t>(space.map.coefficients.cols()) == coefficients &&
                            space.map.coefficients.allFinite() && areFinite(space.map.least) &&
                            areFinite(space.map.greatest)),
         "the map of a space's parameters does not fit");
}

void FitCheck::table(const SimilarityTable& table, const MotionSpace& source, const MotionSpace& target) const
{
    const std::size_t pairs = source.frameCount() * target.frameCount();
    (*this)(table.sourceFrames == source.frameCount() && table.targetFrames == target.frameCount() &&
                table.sourceNodes == source.weights.nodes().size() &&
                table.targetNodes == target.weights.nodes().size() && table.leasts.size() == pairs &&
                table.distances.size() == pairs * table.sourceNodes * table.targetNodes &&
                std::isfinite(table.greatest) && areFinite(table.distances) && areFinite(table.leasts),
            "a table does not fit the spaces that it compares");
}

void FitCheck::rest(const BakedPlayer& player) const
{
    const FitCheck& fits = *this;
    const LiveGraph& graph = *player.graph;
    const auto isOne = [&](std::size_t space, const SpacePoint& parameters) {
        return space < graph.spaces.size() && areFinite(parameters);
    };
    const TransitionSearchSettings& search = player.settings.search;
    constexpr int most = 1000;
    fits(search.depth >= 1 && search.depth <= most && search.steps >= 1 && search.steps <= most &&
             player.settings.ticksPerFrame <= most,
         "a setting is out of its range");
    fits(isOne(player.start.space, player.start.parameters) && std::isfinite(player.start.frame) &&
             std::isfinite(player.start.root.turn) && player.start.root.shift.allFinite(),
         "the start is nowhere");
    fits(player.start.frame >= 0 &&
             player.start.frame < static_cast<double>(graph.spaces[player.start.space]->frameCount()),
         "the start is in no frame");
    for (const LiveInput& input : player.inputs)
        fits(isOne(input.space, input.parameters), "the recording wants what is not there");
    fits(player.frames.size() == graph.spaces.size(), "spaces and their captured frames do not fit");
    for (std::size_t s = 0; s < graph.spaces.size(); ++s) {
        const MotionSpace& space = *graph.spaces[s];
        fits(player.frames[s].size() == space.takes.size(), "takes and their captured frames do not fit");
        for (const std::vector<BakedFrame>& take : player.frames[s]) {
            fits(take.size() == space.frameCount(), "frames and captured frames do not fit");
            for (const BakedFrame& frame : take)
                fits(
                    frame.picture == BakedFrame::noPicture ||
                        (frame.picture >= 0 && static_cast<std::size_t>(frame.picture) < player.pictureCount),
                    "a frame has a picture that is not there");
        }
    }
}

} // namespace

void bake(BakedWriter& bytes, const BakedPlayer& player)
{
    const LiveGraph& graph = *player.graph;
    bytes(graph.fps);
    bakeTopology(bytes, graph.topology().data());
    bakeSize(bytes, graph.spaces.size());
    for (const auto& space : graph.spaces) {
        const WeightParts weights = partsOf(space->weights);
        bakeSpace(bytes, *space, weights);
    }
    for (const auto& row : graph.tables) {
        for (const auto& table : row) {
            const bool leads = table != nullptr;
            bytes(leads);
            if (leads)
                bakeTable(bytes, *table);
        }
    }
    bakeRest(bytes, player);
}

void bake(BakedReader& bytes, BakedPlayer& player)
{
    const FitCheck fits(bytes);
    LiveGraph graph;
    bytes(graph.fps);
    fits(isTime(1 / graph.fps), "there is no rate");
    TopologyData data;
    bakeTopology(bytes, data);
    std::shared_ptr<const Topology> topology;
    try {
        topology = std::make_shared<const Topology>(std::move(data));
    } catch (const Error& error) {
        bytes.refuse(error.what());
    }
    std::size_t count = 0;
    bakeSize(bytes, count);
    constexpr std::size_t most = 1000;
    fits(count >= 1 && count <= most, "there are no spaces, or too many");
    for (std::size_t s = 0; s < count; ++s) {
        auto space = std::make_shared<MotionSpace>();
        space->topology = topology;
        WeightParts weights;
        bakeSpace(bytes, *space, weights);
        fits.weights(weights, space->takes.size());
        space->weights =
            WeightSpace(weights.dimension, weights.takes, std::move(weights.nodes), weights.simplices);
        fits.space(*space);
        fits(graph.spaces.empty() || space->up == graph.up(), "spaces stand on different axes");
        graph.spaces.push_back(std::move(space));
    }
    graph.tables.resize(count);
    for (std::size_t source = 0; source < count; ++source) {
        for (std::size_t target = 0; target < count; ++target) {
            bool leads = false;
            bytes(leads);
            std::shared_ptr<SimilarityTable> table;
            if (leads) {
                table = std::make_shared<SimilarityTable>();
                bakeTable(bytes, *table);
                fits.table(*table, *graph.spaces[source], *graph.spaces[target]);
            }
            graph.tables[source].push_back(std::move(table));
        }
    }
    player.graph = std::make_shared<const LiveGraph>(std::move(graph));
    bakeRest(bytes, player);
    fits.rest(player);
    fits(bytes.isAtEnd(), "there is more than should be");
}

} // namespace quadrille
