// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/scene/colladageometry.h"

#include "model/core/message.h"
#include "model/sequence/io/scene/colladadocument.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace quadrille {

namespace {

using XmlNode = pugi::xml_node;

/// Where an <accessor> finds its values.
struct Accessor
{
    std::int64_t count = 0;
    std::int64_t stride = 1;
    std::int64_t offset = 0;
    XmlNode array;
};

/// An <input> of a primitive or of weights: which number of each corner it takes, and how many there are.
struct Input
{
    std::string_view semantic;
    std::int64_t offset = 0;
    std::int64_t count = 0;
};

class ColladaChecker
{
public:
    ColladaChecker(std::string_view text, const std::filesystem::path& file) : m_document(text, file) {}

    std::vector<PolygonGeometry> run()
    {
        checkArrays();
        for (const XmlNode accessor : m_document.all("accessor"))
            readAccessor(accessor);
        checkNumbers();
        for (const XmlNode weights : m_document.all("vertex_weights"))
            checkWeights(weights);
        for (const XmlNode sampler : m_document.all("sampler"))
            checkSampler(sampler);
        checkCircles();
        std::vector<PolygonGeometry> geometries;
        for (const XmlNode mesh : m_document.all("mesh")) {
            if (auto geometry = readMesh(mesh))
                geometries.push_back(std::move(*geometry));
        }
        return geometries;
    }

private:
    /// Lists hold numbers, as many as they say.
    void checkArrays()
    {
        for (const XmlNode array : m_document.all("float_array"))
            checkCount(array, m_document.numbers(array).size());
        for (const char* name : {"Name_array", "IDREF_array"}) {
            for (const XmlNode array : m_document.all(name))
                checkCount(array, wordCount(array.child_value()));
        }
        for (const XmlNode array : m_document.all("int_array"))
            checkCount(array, m_document.integers(array).size());
    }

    void checkCount(XmlNode array, std::size_t found)
    {
        const auto promised = m_document.count(array, "count", 0);
        m_held[array] = promised;
        if (promised > static_cast<std::int64_t>(found)) {
            throw Error(
                ErrorCode::CountTooLarge,
                m_document.contextOf(array, {{"count", std::to_string(promised)}, {"what", "values"}}));
        }
    }

    static std::size_t wordCount(std::string_view text)
    {
        std::size_t words = 0;
        bool inWord = false;
        for (const char c : text) {
            const bool isSpace = c == ' ' || (c >= '\t' && c <= '\r');
            words += !isSpace && !inWord;
            inWord = !isSpace;
        }
        return words;
    }

    Accessor readAccessor(XmlNode element) const
    {
        Accessor accessor{.count = m_document.count(element, "count", 0),
                          .stride = m_document.count(element, "stride", 1),
                          .offset = m_document.count(element, "offset", 0),
                          .array = m_document.lookUp(element.attribute("source").value())};
        const std::string_view kind = accessor.array.name();
        if (!kind.ends_with("_array"))
            m_document.fail(element, std::string("there is no list “") + element.attribute("source").value() +
                                         "” for an <accessor>");
        const double needed = static_cast<double>(accessor.offset) +
                              static_cast<double>(accessor.count) * static_cast<double>(accessor.stride);
        const auto held = m_held.find(accessor.array);
        if (accessor.stride < 1 || held == m_held.end() || needed > static_cast<double>(held->second)) {
            throw Error(ErrorCode::CountTooLarge,
                        m_document.contextOf(
                            element, {{"count", std::to_string(accessor.count)}, {"what", "values"}}));
        }
        return accessor;
    }

    /// The accessor of the <source> that an element names.
    Accessor accessorOf(XmlNode input) const
    {
        const XmlNode source = m_document.find(input, input.attribute("source").value(), "source");
        const XmlNode accessor = source.child("technique_common").child("accessor");
        if (!accessor)
            m_document.fail(source, QUADRILLE_MESSAGE("a <source> has no <accessor>"));
        return readAccessor(accessor);
    }

    /// Elements whose text the importer reads as numbers without looking.
    void checkNumbers() const
    {
        for (const char* name :
             {"matrix", "translate", "rotate", "scale", "lookat", "skew", "bind_shape_matrix"}) {
            const std::size_t needed = std::string_view(name).ends_with("matrix") ? 16
                                       : std::string_view(name) == "lookat"       ? 9
                                       : std::string_view(name) == "skew"         ? 7
                                       : std::string_view(name) == "rotate"       ? 4
                                                                                  : 3;
            for (const XmlNode element : m_document.all(name)) {
                if (m_document.numbers(element).size() != needed)
                    m_document.fail(element, "<" + std::string(name) + "> needs " + std::to_string(needed) +
                                                 " numbers");
            }
        }
    }

    XmlNode verticesOf(XmlNode input) const
    {
        return m_document.find(input, input.attribute("source").value(), "vertices");
    }

    XmlNode positionInput(XmlNode vertices) const
    {
        for (const XmlNode input : vertices.children("input")) {
            if (std::string_view(input.attribute("semantic").value()) == "POSITION")
                return input;
        }
        m_document.fail(vertices, QUADRILLE_MESSAGE("<vertices> has no positions"));
    }

    std::vector<Input> readInputs(XmlNode element) const
    {
        std::vector<Input> inputs;
        constexpr std::int64_t largestOffset = 64;
        for (const XmlNode input : element.children("input")) {
            const std::string_view semantic = input.attribute("semantic").value();
            const std::int64_t offset = m_document.count(input, "offset", 0);
            if (offset > largestOffset)
                m_document.fail(input, QUADRILLE_MESSAGE("the offset of an <input> is too large"));
            const XmlNode values = semantic == "VERTEX" ? positionInput(verticesOf(input)) : input;
            inputs.push_back({semantic, offset, accessorOf(values).count});
        }
        return inputs;
    }

    static std::int64_t strideOf(const std::vector<Input>& inputs)
    {
        std::int64_t stride = 1;
        for (const Input& input : inputs)
            stride = std::max(stride, input.offset + 1);
        return stride;
    }

    /// \param lowest  −1 where the format allows "none", otherwise 0.
    void checkIndices(XmlNode element, const std::vector<std::int64_t>& indices,
                      const std::vector<Input>& inputs, std::int64_t lowest) const
    {
        const auto stride = static_cast<std::size_t>(strideOf(inputs));
        for (const Input& input : inputs) {
            for (auto i = static_cast<std::size_t>(input.offset); i < indices.size(); i += stride) {
                if (indices[i] >= lowest && indices[i] < input.count)
                    continue;
                throw Error(ErrorCode::IndexOutOfRange,
                            m_document.contextOf(
                                element, {{"what", input.semantic == "VERTEX" ? std::string("vertex")
                                                                              : std::string(input.semantic)},
                                          {"index", std::to_string(indices[i])},
                                          {"count", std::to_string(input.count)}}));
            }
        }
    }

    /// The lengths of polygons or of weight lists, whose sum must be what the list of indices has.
    std::vector<std::int64_t> readLengths(XmlNode element, std::size_t indices, std::int64_t stride) const
    {
        auto lengths = m_document.integers(element.child("vcount"));
        std::int64_t sum = 0;
        for (const std::int64_t length : lengths) {
            if (length < 0 || length > static_cast<std::int64_t>(indices))
                m_document.fail(element.child("vcount"), "<vcount> holds " + std::to_string(length));
            sum += length;
        }
        if (sum * stride != static_cast<std::int64_t>(indices)) {
            m_document.fail(element, "<vcount> asks for " + std::to_string(sum * stride) +
                                         " indices, and there are " + std::to_string(indices));
        }
        return lengths;
    }

    void checkWeights(XmlNode weights) const
    {
        const auto inputs = readInputs(weights);
        const auto indices = m_document.integers(weights.child("v"));
        const auto lengths = readLengths(weights, indices.size(), strideOf(inputs));
        const auto promised = m_document.count(weights, "count", static_cast<std::int64_t>(lengths.size()));
        if (promised != static_cast<std::int64_t>(lengths.size()))
            m_document.fail(weights,
                            QUADRILLE_MESSAGE("the count of <vertex_weights> is not that of its <vcount>"));
        checkIndices(weights.child("v"), indices, inputs, -1);
    }

    /// Keys and values of an animation: as many of one as of the other.
    void checkSampler(XmlNode sampler) const
    {
        std::optional<std::int64_t> keys;
        for (const XmlNode input : sampler.children("input")) {
            const std::string_view semantic = input.attribute("semantic").value();
            if (semantic != "INPUT" && semantic != "OUTPUT")
                continue;
            const std::int64_t count = accessorOf(input).count;
            if (keys && *keys != count)
                m_document.fail(sampler, "an animation has " + std::to_string(*keys) + " and " +
                                             std::to_string(count) + " keys and values");
            keys = count;
        }
    }

    /// Nodes that contain themselves through <instance_node>, controllers that deform themselves.
    void checkCircles() const
    {
        std::set<XmlNode> finished;
        for (const char* name : {"node", "controller"}) {
            for (const XmlNode start : m_document.all(name)) {
                std::vector<XmlNode> path;
                followReferences(start, path, finished);
            }
        }
    }

    void followReferences(XmlNode at, std::vector<XmlNode>& path, std::set<XmlNode>& finished) const
    {
        if (finished.contains(at))
            return;
        constexpr std::size_t longestChain = 2000;
        if (std::find(path.begin(), path.end(), at) != path.end() || path.size() > longestChain)
            m_document.fail(at, QUADRILLE_MESSAGE("elements refer to each other in a circle"));
        path.push_back(at);
        for (const XmlNode child : at.children()) {
            const std::string_view name = child.name();
            XmlNode next = name == "node" || name == "skin" || name == "morph" ? child : XmlNode();
            if (name == "instance_node")
                next = m_document.lookUp(child.attribute("url").value());
            if (next)
                followReferences(next, path, finished);
        }
        if (const XmlNode source = m_document.lookUp(at.attribute("source").value());
            std::string_view(source.name()) == "controller")
            followReferences(source, path, finished);
        path.pop_back();
        finished.insert(at);
    }

    /// Checks every primitive of a mesh.
    /// \return nothing where it has strips, fans or no polygons, or two lists of positions.
    std::optional<PolygonGeometry> readMesh(XmlNode mesh) const
    {
        PolygonGeometry geometry;
        std::set<XmlNode> vertices;
        bool isPlain = true;
        std::int32_t material = 0;
        for (const XmlNode primitive : mesh.children()) {
            const std::string_view name = primitive.name();
            const bool isList = name == "triangles" || name == "polylist" || name == "polygons";
            const bool isOther =
                name == "tristrips" || name == "trifans" || name == "lines" || name == "linestrips";
            if (!isList && !isOther)
                continue;
            isPlain = isPlain && isList;
            for (const XmlNode input : primitive.children("input")) {
                if (std::string_view(input.attribute("semantic").value()) == "VERTEX")
                    vertices.insert(verticesOf(input));
            }
            readPrimitive(primitive, material++, geometry);
        }
        if (!isPlain || vertices.size() != 1 || geometry.polygonVertices.empty())
            return std::nullopt;
        geometry.controlPoints = readPositions(*vertices.begin());
        return geometry;
    }

    std::vector<double> readPositions(XmlNode vertices) const
    {
        const XmlNode input = positionInput(vertices);
        const Accessor accessor = accessorOf(input);
        const auto values = m_document.numbers(accessor.array);
        if (accessor.stride < 3)
            m_document.fail(input, QUADRILLE_MESSAGE("positions need three numbers"));
        std::vector<double> points;
        for (std::int64_t p = 0; p < accessor.count; ++p) {
            for (std::int64_t axis = 0; axis < 3; ++axis) {
                const double value =
                    values[static_cast<std::size_t>(accessor.offset + p * accessor.stride + axis)];
                if (!std::isfinite(static_cast<float>(value))) {
                    throw Error(ErrorCode::NonFiniteCoordinate,
                                m_document.contextOf(accessor.array, {{"vertex", std::to_string(p)}}));
                }
                points.push_back(value);
            }
        }
        return points;
    }

    void readPrimitive(XmlNode primitive, std::int32_t material, PolygonGeometry& geometry) const
    {
        const auto inputs = readInputs(primitive);
        const auto vertex = std::find_if(inputs.begin(), inputs.end(),
                                         [](const Input& input) { return input.semantic == "VERTEX"; });
        if (vertex == inputs.end())
            m_document.fail(primitive, QUADRILLE_MESSAGE("a list of polygons names no vertices"));
        const std::int64_t stride = strideOf(inputs);
        for (const XmlNode list : primitive.children("p")) {
            const auto indices = m_document.integers(list);
            checkIndices(list, indices, inputs, 0);
            const auto corners = static_cast<std::int64_t>(indices.size()) / stride;
            if (corners * stride != static_cast<std::int64_t>(indices.size()))
                m_document.fail(list, "the number of indices is no multiple of " + std::to_string(stride));
            std::size_t at = static_cast<std::size_t>(vertex->offset);
            for (const std::int64_t length : polygonLengths(primitive, indices.size(), corners, stride)) {
                for (std::int64_t c = 0; c < length; ++c, at += static_cast<std::size_t>(stride)) {
                    const auto point = static_cast<std::int32_t>(indices[at]);
                    geometry.polygonVertices.push_back(c + 1 < length ? point : -1 - point);
                }
                geometry.polygonMaterials.push_back(material);
            }
        }
    }

    std::vector<std::int64_t> polygonLengths(XmlNode primitive, std::size_t indices, std::int64_t corners,
                                             std::int64_t stride) const
    {
        const std::string_view name = primitive.name();
        if (name == "polylist")
            return readLengths(primitive, indices, stride);
        if (name != "triangles")
            return {corners};
        if (corners % 3 != 0)
            m_document.fail(primitive, "<triangles> has " + std::to_string(corners) + " corners");
        return std::vector<std::int64_t>(static_cast<std::size_t>(corners / 3), 3);
    }

    ColladaDocument m_document;
    std::map<XmlNode, std::int64_t> m_held; ///< values that each list says it has
};

} // namespace

std::vector<PolygonGeometry> readColladaGeometries(std::string_view text, const std::filesystem::path& file)
{
    return ColladaChecker(text, file).run();
}

} // namespace quadrille
