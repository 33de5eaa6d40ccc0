// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/motionspaceresults.h"

#include "model/project/steps/charactersteps.h"
#include "model/project/steps/motionspacework.h"
#include "model/project/steps/variationarrays.h"
#include "model/project/store/tablebuilder.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

DataArray wholesOf(const char* name, const char* description, const char* unit,
                   std::vector<std::int64_t> shape, std::vector<std::int64_t> values)
{
    return {.name = name,
            .description = description,
            .unit = unit,
            .shape = std::move(shape),
            .values = std::move(values)};
}

const std::vector<std::int64_t>& wholesIn(const Result& result, const std::string& name)
{
    return std::get<std::vector<std::int64_t>>(arrayOf(result, name).values);
}

const DataTable& tableIn(const Result& result, const std::string& name)
{
    return *std::ranges::find(result.tables, name, &DataTable::name);
}

bool isStored(const Result& result, const std::string& name)
{
    return std::ranges::find(result.arrays, name, &DataArray::name) != result.arrays.end();
}

void addTakes(Result& result, const MotionSpace& space)
{
    const auto takes = std::ssize(space.takes);
    const auto frames = static_cast<std::int64_t>(space.frameCount());
    TableBuilder table("takes", "The takes of the space, and which of their frames it has.");
    table.text("take").whole("first", "frame").whole("last", "frame");
    std::vector<float> poses;
    poses.reserve(space.takes.size() * space.frameCount() * space.vertexCount() * 3);
    std::vector<double> steps;
    std::vector<double> seconds;
    std::vector<double> warps;
    std::vector<double> playback;
    for (const SpaceTake& take : space.takes) {
        table.add({take.name, take.warp.frames.first.value, take.warp.frames.last.value});
        for (const Vec3f& p : take.poses)
            poses.insert(poses.end(), p.data(), p.data() + 3);
        for (const GroundMotion& step : take.steps)
            steps.insert(steps.end(), {step.turn, step.shift.x(), step.shift.y()});
        seconds.insert(seconds.end(), take.seconds.begin(), take.seconds.end());
        warps.insert(warps.end(), take.warp.positions.begin(), take.warp.positions.end());
        playback.insert(playback.end(), take.warp.playback.begin(), take.warp.playback.end());
    }
    result.tables.push_back(std::move(table).table());
    result.arrays.push_back({.name = "poses",
                             .description = "Takes × frames × vertices × coordinates: in common phase, over "
                                            "the origin of the ground.",
                             .unit = "m",
                             .shape = {takes, frames, static_cast<std::int64_t>(space.vertexCount()), 3},
                             .values = std::move(poses)});
    result.arrays.push_back(arrayOfDoubles("steps",
                                           "Takes × frames × (turn in radians, way along both axes of the "
                                           "ground in metres): the motion to the next frame.",
                                           "", {takes, frames, 3}, std::move(steps)));
    result.arrays.push_back(arrayOfDoubles("seconds", "Takes × frames: from each frame to the next one.", "s",
                                           {takes, frames}, std::move(seconds)));
    result.arrays.push_back(arrayOfDoubles("warps",
                                           "Takes × frames of the space: where each take is at each of them.",
                                           "frame", {takes, frames}, std::move(warps)));
    const auto played = std::ssize(playback);
    result.arrays.push_back(arrayOfDoubles(
        "playback", "Of each frame of a take, one take after the other, where on the space it is.", "frame",
        {played}, std::move(playback)));
}

std::vector<SpaceTake> takesOf(const Result& stored)
{
    const DataArray& poses = arrayOf(stored, "poses");
    const auto frames = static_cast<std::size_t>(poses.shape[1]);
    const auto vertices = static_cast<std::size_t>(poses.shape[2]);
    const float* p = std::get<std::vector<float>>(poses.values).data();
    const double* step = doublesOf(stored, "steps").data();
    const double* second = doublesOf(stored, "seconds").data();
    const double* warp = doublesOf(stored, "warps").data();
    const double* played = doublesOf(stored, "playback").data();
    const DataTable& table = tableIn(stored, "takes");
    const std::vector<std::string> names = columnNamed<TextColumn>(table, "take").list();
    const auto& first = columnNamed<std::vector<std::int64_t>>(table, "first");
    const auto& last = columnNamed<std::vector<std::int64_t>>(table, "last");
    std::vector<SpaceTake> takes(names.size());
    for (std::size_t t = 0; t < takes.size(); ++t) {
        SpaceTake& take = takes[t];
        take.name = names[t];
        take.warp.frames = {FrameIndex(first[t]), FrameIndex(last[t])};
        const auto own = static_cast<std::size_t>(take.warp.frames.count());
        take.warp.positions.assign(warp, warp + frames);
        take.warp.playback.assign(played, played + own);
        take.seconds.assign(second, second + frames);
        take.poses.reserve(frames * vertices);
        for (std::size_t i = 0; i < frames * vertices; ++i, p += 3)
            take.poses.emplace_back(p[0], p[1], p[2]);
        for (std::size_t f = 0; f < frames; ++f, step += 3)
            take.steps.push_back({step[0], {step[1], step[2]}});
        warp += frames;
        second += frames;
        played += own;
    }
    return takes;
}

void addWeights(Result& result, const WeightSpace& weights)
{
    const auto nodes = std::ssize(weights.nodes());
    const auto takes = static_cast<std::int64_t>(weights.takeCount());
    const std::int64_t corners = weights.dimension() + 1;
    std::vector<double> places;
    std::vector<double> shares(weights.nodes().size() * weights.takeCount());
    for (std::size_t n = 0; n < weights.nodes().size(); ++n) {
        const WeightSpace::Node& node = weights.nodes()[n];
        places.insert(places.end(), node.place.begin(), node.place.end());
        for (const BlendShare& share : node.shares)
            shares[n * weights.takeCount() + share.take] = share.share;
    }
    std::vector<std::int64_t> simplices;
    for (const WeightSpace::Simplex& simplex : weights.simplices())
        simplices.insert(simplices.end(), simplex.nodes.begin(), simplex.nodes.begin() + corners);
    result.arrays.push_back(arrayOfDoubles(
        "places", "Nodes × 3: values of the parameters of the takes, then of the references; else 0.", "",
        {nodes, std::int64_t{3}}, std::move(places)));
    result.arrays.push_back(arrayOfDoubles("shares", "Nodes × takes: shares of the takes in each node.", "",
                                           {nodes, takes}, std::move(shares)));
    result.arrays.push_back(wholesOf("simplices",
                                     "Simplices × their nodes: intervals, triangles or tetrahedra.", "node",
                                     {std::ssize(weights.simplices()), corners}, std::move(simplices)));
}

WeightSpace weightsOf(const Result& stored)
{
    const DataArray& shares = arrayOf(stored, "shares");
    const auto takes = static_cast<std::size_t>(shares.shape[1]);
    const double* share = doublesOf(stored, "shares").data();
    const double* place = doublesOf(stored, "places").data();
    std::vector<WeightSpace::Node> nodes(static_cast<std::size_t>(shares.shape[0]));
    for (WeightSpace::Node& node : nodes) {
        std::copy(place, place + 3, node.place.begin());
        for (std::size_t t = 0; t < takes; ++t) {
            if (share[t] > 0)
                node.shares.push_back({t, share[t]});
        }
        place += 3;
        share += takes;
    }
    const DataArray& corners = arrayOf(stored, "simplices");
    const std::int64_t* corner = wholesIn(stored, "simplices").data();
    std::vector<std::array<int, 4>> simplices(static_cast<std::size_t>(corners.shape[0]));
    for (std::array<int, 4>& simplex : simplices) {
        std::transform(corner, corner + corners.shape[1], simplex.begin(),
                       [](std::int64_t node) { return static_cast<int>(node); });
        corner += corners.shape[1];
    }
    return {static_cast<int>(corners.shape[1]) - 1, takes, std::move(nodes), simplices};
}

void addReferences(Result& result, const MotionSpace& space)
{
    TableBuilder table("references", "The non-linear blends that are stored, each as what it adds to the "
                                     "linear one: of how many vertices in all frames, and what that takes.");
    table.whole("node").real("place-1").real("place-2").real("place-3").whole("vertices");
    table.whole("bytes", "byte").real("unit", "m");
    std::vector<std::int64_t> starts;
    std::vector<std::int64_t> vertices;
    std::vector<double> displacements;
    for (std::size_t r = 0; r < space.references.size(); ++r) {
        const SpaceReference& reference = space.references[r];
        const std::size_t node = space.takes.size() + r;
        const SpacePoint& place = space.weights.nodes()[node].place;
        table.add({static_cast<std::int64_t>(node), place[0], place[1], place[2],
                   std::ssize(reference.vertices), static_cast<std::int64_t>(reference.memory()),
                   static_cast<double>(reference.unit)});
        starts.insert(starts.end(), reference.starts.begin(), reference.starts.end());
        vertices.insert(vertices.end(), reference.vertices.begin(), reference.vertices.end());
        for (const std::array<std::int16_t, 3>& each : reference.displacements)
            for (const std::int16_t coordinate : each)
                displacements.push_back(coordinate);
    }
    result.tables.push_back(std::move(table).table());
    if (vertices.empty())
        return;
    const auto count = std::ssize(vertices);
    result.arrays.push_back(wholesOf(
        "reference-starts", "References × (frames + 1): where the displacements of each frame begin.", "",
        {std::ssize(space.references), static_cast<std::int64_t>(space.frameCount()) + 1},
        std::move(starts)));
    result.arrays.push_back(wholesOf("reference-vertices",
                                     "The vertices that are displaced, one reference after the other.", "",
                                     {count}, std::move(vertices)));
    result.arrays.push_back(arrayOfDoubles("reference-displacements",
                                           "Of each such vertex, in units of its reference.", "", {count, 3},
                                           std::move(displacements)));
}

std::vector<SpaceReference> referencesOf(const Result& stored, std::size_t frames)
{
    const DataTable& table = tableIn(stored, "references");
    const auto& counts = columnNamed<std::vector<std::int64_t>>(table, "vertices");
    const auto& units = columnNamed<std::vector<double>>(table, "unit");
    std::vector<SpaceReference> references(counts.size());
    if (!isStored(stored, "reference-starts")) { // none displaces anything
        for (std::size_t r = 0; r < references.size(); ++r) {
            references[r].starts.assign(frames + 1, 0);
            references[r].unit = static_cast<float>(units[r]);
        }
        return references;
    }
    const std::int64_t* start = wholesIn(stored, "reference-starts").data();
    const std::int64_t* vertex = wholesIn(stored, "reference-vertices").data();
    const double* displacement = doublesOf(stored, "reference-displacements").data();
    for (std::size_t r = 0; r < references.size(); ++r) {
        SpaceReference& reference = references[r];
        reference.unit = static_cast<float>(units[r]);
        for (std::size_t f = 0; f <= frames; ++f)
            reference.starts.push_back(static_cast<std::uint32_t>(*start++));
        for (std::int64_t i = 0; i < counts[r]; ++i, displacement += 3) {
            reference.vertices.push_back(static_cast<std::uint32_t>(*vertex++));
            std::array<std::int16_t, 3>& own = reference.displacements.emplace_back();
            std::transform(displacement, displacement + 3, own.begin(),
                           [](double value) { return static_cast<std::int16_t>(value); });
        }
    }
    return references;
}

void addParameters(Result& result, const MotionSpace& space)
{
    const ParameterMap& map = space.map;
    TableBuilder table("axes", "What steers the space, from where to where, and by how much it is missed.");
    table.text("parameter").whole("measure").whole("vertex").real("least").real("greatest");
    table.real("mean-residual").real("worst-residual");
    for (std::size_t d = 0; d < space.parameters.size(); ++d) {
        const SpaceParameter& parameter = space.parameters[d];
        table.add({parameter.name, static_cast<std::int64_t>(parameter.measure),
                   std::int64_t{parameter.vertex.value}, map.least[d], map.greatest[d], map.meanResidual[d],
                   map.worstResidual[d]});
    }
    result.tables.push_back(std::move(table).table());
    if (map.coefficients.size() > 0)
        result.arrays.push_back(
            matrixArray("map",
                        "Coordinates of the place × coefficients of the polynomial in parameters that are "
                        "scaled to 0 … 1: 1, each of them, and their products.",
                        "", map.coefficients));
    std::vector<double> values;
    for (std::size_t t = 0; t < space.takes.size(); ++t) {
        const SpacePoint& place = space.weights.nodes()[t].place;
        values.insert(values.end(), place.begin(), place.begin() + std::ssize(space.parameters));
    }
    if (!values.empty())
        result.arrays.push_back(
            arrayOfDoubles("parameters", "Takes × parameters: where on the axes each take is.", "",
                           {std::ssize(space.takes), std::ssize(space.parameters)}, std::move(values)));
}

void readParameters(const Result& stored, MotionSpace& space)
{
    const DataTable& table = tableIn(stored, "axes");
    const std::vector<std::string> names = columnNamed<TextColumn>(table, "parameter").list();
    const auto& measure = columnNamed<std::vector<std::int64_t>>(table, "measure");
    const auto& vertex = columnNamed<std::vector<std::int64_t>>(table, "vertex");
    const auto numbers = [&](const char* column, std::size_t d) {
        return columnNamed<std::vector<double>>(table, column)[d];
    };
    space.map.dimension = space.weights.dimension();
    for (std::size_t d = 0; d < names.size(); ++d) {
        space.parameters.push_back({.name = names[d],
                                    .measure = static_cast<SpaceMeasure>(measure[d]),
                                    .vertex = VertexIndex(static_cast<std::uint32_t>(vertex[d]))});
        space.map.least[d] = numbers("least", d);
        space.map.greatest[d] = numbers("greatest", d);
        space.map.meanResidual[d] = numbers("mean-residual", d);
        space.map.worstResidual[d] = numbers("worst-residual", d);
    }
    if (!isStored(stored, "map"))
        return;
    const DataArray& map = arrayOf(stored, "map");
    space.map.coefficients =
        Eigen::Map<const RowMatrix>(doublesOf(stored, "map").data(), map.shape[0], map.shape[1]);
}

} // namespace

Result motionSpaceResult(const MotionSpace& space)
{
    Result result;
    TableBuilder table("space", "How fast the frames of the space follow each other, whether the first "
                                "follows the last, and what references take.");
    table.whole("frames").real("rate", "1/s").whole("cyclic").whole("bytes", "byte");
    std::size_t bytes = 0;
    for (const SpaceReference& reference : space.references)
        bytes += reference.memory();
    table.add({static_cast<std::int64_t>(space.frameCount()), space.fps, std::int64_t{space.isCyclic},
               static_cast<std::int64_t>(bytes)});
    result.tables.push_back(std::move(table).table());
    addTakes(result, space);
    addWeights(result, space.weights);
    addReferences(result, space);
    addParameters(result, space);
    return result;
}

MotionSpace motionSpaceOf(const Result& stored)
{
    MotionSpace space;
    const DataTable& table = tableIn(stored, "space");
    space.fps = columnNamed<std::vector<double>>(table, "rate").front();
    space.isCyclic = columnNamed<std::vector<std::int64_t>>(table, "cyclic").front() != 0;
    space.takes = takesOf(stored);
    space.weights = weightsOf(stored);
    space.references = referencesOf(stored, space.frameCount());
    readParameters(stored, space);
    return space;
}

} // namespace quadrille
