// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/tiles.h"

#include "model/render/rasterizer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// Vertices farther out than this many samples are cut off, so that all edge values fit 64 bits.
constexpr double guard = 1 << 20;
/// Triangles that one task prepares; a constant, so that the order never depends on the threads.
constexpr std::size_t chunkSize = 2048;

struct Chunk
{
    std::vector<ScreenTriangle> triangles;
    std::vector<PieceCorners> pieces;
};

std::int32_t toFixed(double samples)
{
    return static_cast<std::int32_t>(std::lrint(samples * 256));
}

/// First and last sample whose middle lies between two coordinates; empty when last < first.
std::pair<int, int> sampleSpan(std::int32_t low, std::int32_t high)
{
    return {(low + 127) >> 8, (high - 128) >> 8};
}

std::pair<std::int32_t, std::int32_t> extent(const std::array<std::int32_t, 3>& c)
{
    return {std::min({c[0], c[1], c[2]}), std::max({c[0], c[1], c[2]})};
}

/// Makes a triangle drawable.
/// \return false when it has no area or covers no sample of the picture.
bool makeScreenTriangle(const std::array<ScreenVertex, 3>& v, std::uint32_t index, int width, int height,
                        ScreenTriangle& t)
{
    for (std::size_t i = 0; i < 3; ++i) {
        t.x[i] = toFixed(v[i].x);
        t.y[i] = toFixed(v[i].y);
        t.nearness[i] = static_cast<float>(v[i].nearness);
    }
    const auto [minX, maxX] = extent(t.x);
    const auto [minY, maxY] = extent(t.y);
    const auto [firstX, lastX] = sampleSpan(minX, maxX);
    const auto [firstY, lastY] = sampleSpan(minY, maxY);
    if (std::max(firstX, 0) > std::min(lastX, width - 1) || std::max(firstY, 0) > std::min(lastY, height - 1))
        return false;
    const std::int64_t area =
        std::int64_t{t.x[1] - t.x[0]} * (t.y[2] - t.y[0]) - std::int64_t{t.y[1] - t.y[0]} * (t.x[2] - t.x[0]);
    if (area == 0)
        return false;
    t.triangle = index;
    t.piece = ScreenTriangle::noPiece;
    t.order = {0, 1, 2};
    t.isBack = area > 0;
    if (area < 0) {
        std::swap(t.x[1], t.x[2]);
        std::swap(t.y[1], t.y[2]);
        std::swap(t.nearness[1], t.nearness[2]);
        std::swap(t.order[1], t.order[2]);
    }
    return true;
}

/// A corner while a triangle is cut.
struct Corner
{
    Vec3d view; ///< right, up, forward
    Vec3f weights;
};

/// A triangle cut by five planes.
struct Polygon
{
    std::array<Corner, 8> corners;
    std::size_t count = 0;
};

/// Keeps the part where `plane · (view, 1)` is not negative. New corners are computed from the kept end of an
/// edge, so that triangles which share the edge get the same ones.
Polygon cut(const Polygon& in, const Eigen::Vector4d& plane)
{
    const auto distance = [&plane](const Corner& c) { return plane.head<3>().dot(c.view) + plane[3]; };
    Polygon out;
    for (std::size_t i = 0; i < in.count; ++i) {
        const Corner& a = in.corners[i];
        const Corner& b = in.corners[(i + 1) % in.count];
        const double da = distance(a);
        const double db = distance(b);
        if (da >= 0)
            out.corners[out.count++] = a;
        if ((da >= 0) == (db >= 0))
            continue;
        const Corner& kept = da >= 0 ? a : b;
        const Corner& lost = da >= 0 ? b : a;
        const double t = (da >= 0 ? da : db) / std::abs(da - db);
        out.corners[out.count++] = {kept.view + t * (lost.view - kept.view),
                                    kept.weights + static_cast<float>(t) * (lost.weights - kept.weights)};
    }
    return out;
}

ScreenVertex toScreen(const Vec3d& view, const Projection& p)
{
    const double nearness = 1 / view.z();
    return {p.centerX + p.focal * view.x() * nearness, p.centerY - p.focal * view.y() * nearness, nearness};
}

bool isInside(const Vec3d& view, const Projection& p)
{
    const double limit = guard / 2 * view.z();
    return view.z() >= p.nearDistance && std::abs(p.focal * view.x()) <= limit &&
           std::abs(p.focal * view.y()) <= limit;
}

/// Cuts a triangle that reaches too near or too far out, and adds what is left.
void addPieces(const std::array<Vec3d, 3>& view, std::uint32_t index, const Projection& p, int width,
               int height, Chunk& chunk)
{
    Polygon polygon;
    for (int i = 0; i < 3; ++i)
        polygon.corners[polygon.count++] = {view[static_cast<std::size_t>(i)], Vec3f::Unit(i)};
    const double slope = guard / 2 / p.focal;
    polygon = cut(polygon, {0, 0, 1, -p.nearDistance});
    for (const double side : {-1.0, 1.0}) {
        polygon = cut(polygon, {side, 0, slope, 0});
        polygon = cut(polygon, {0, side, slope, 0});
    }
    for (std::size_t i = 2; i < polygon.count; ++i) {
        const std::array<const Corner*, 3> c = {&polygon.corners[0], &polygon.corners[i - 1],
                                                &polygon.corners[i]};
        ScreenTriangle t;
        if (!makeScreenTriangle({toScreen(c[0]->view, p), toScreen(c[1]->view, p), toScreen(c[2]->view, p)},
                                index, width, height, t))
            continue;
        t.piece = static_cast<std::uint32_t>(chunk.pieces.size());
        chunk.pieces.push_back({c[t.order[0]]->weights, c[t.order[1]]->weights, c[t.order[2]]->weights});
        chunk.triangles.push_back(t);
    }
}

ScreenScene joinChunks(std::vector<Chunk>& chunks)
{
    ScreenScene scene;
    for (Chunk& chunk : chunks) {
        const auto firstPiece = static_cast<std::uint32_t>(scene.pieces.size());
        for (ScreenTriangle& t : chunk.triangles) {
            if (t.piece != ScreenTriangle::noPiece)
                t.piece += firstPiece;
        }
        scene.triangles.insert(scene.triangles.end(), chunk.triangles.begin(), chunk.triangles.end());
        scene.pieces.insert(scene.pieces.end(), chunk.pieces.begin(), chunk.pieces.end());
    }
    return scene;
}

/// Calls visit(tile) for each tile that the triangle's box touches.
template <typename Visit>
void forEachTile(const ScreenScene& scene, const ScreenTriangle& t, const Visit& visit)
{
    const auto [minX, maxX] = extent(t.x);
    const auto [minY, maxY] = extent(t.y);
    const auto [firstX, lastX] = sampleSpan(minX, maxX);
    const auto [firstY, lastY] = sampleSpan(minY, maxY);
    const int left = std::max(firstX, 0) / scene.tileSize;
    const int right = std::min(lastX, scene.width - 1) / scene.tileSize;
    const int bottom = std::min(lastY, scene.height - 1) / scene.tileSize;
    for (int row = std::max(firstY, 0) / scene.tileSize; row <= bottom; ++row) {
        for (int column = left; column <= right; ++column)
            visit(row * scene.tilesAcross + column);
    }
}

void sortIntoTiles(ScreenScene& scene, int width, int height, int tileSize)
{
    scene.width = width;
    scene.height = height;
    scene.tileSize = tileSize;
    scene.tilesAcross = (width + tileSize - 1) / tileSize;
    scene.tilesDown = (height + tileSize - 1) / tileSize;
    scene.tileStarts.assign(static_cast<std::size_t>(scene.tileCount()) + 1, 0);
    for (const ScreenTriangle& t : scene.triangles)
        forEachTile(scene, t, [&](int tile) { ++scene.tileStarts[static_cast<std::size_t>(tile) + 1]; });
    for (std::size_t tile = 1; tile < scene.tileStarts.size(); ++tile)
        scene.tileStarts[tile] += scene.tileStarts[tile - 1];
    scene.tileItems.resize(scene.tileStarts.back());
    std::vector<std::uint32_t> next(scene.tileStarts.begin(), scene.tileStarts.end() - 1);
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
        forEachTile(scene, scene.triangles[i],
                    [&](int tile) { scene.tileItems[next[static_cast<std::size_t>(tile)]++] = i; });
    }
}

/// Runs add(triangle index, chunk) over all triangles and joins the results in order.
template <typename Add>
ScreenScene prepare(std::size_t count, const Add& add)
{
    std::vector<Chunk> chunks((count + chunkSize - 1) / chunkSize);
    tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t c) {
        const std::size_t end = std::min((c + 1) * chunkSize, count);
        for (std::size_t i = c * chunkSize; i < end; ++i)
            add(static_cast<std::uint32_t>(i), chunks[c]);
    });
    return joinChunks(chunks);
}

void drawTriangle(const ScreenTriangle& t, int left, int top, int right, int bottom, int tileSize,
                  TileBuffer& buffer, std::uint32_t item)
{
    const auto [minX, maxX] = extent(t.x);
    const auto [minY, maxY] = extent(t.y);
    const auto [spanLeft, spanRight] = sampleSpan(minX, maxX);
    const auto [spanTop, spanBottom] = sampleSpan(minY, maxY);
    const int firstX = std::max(spanLeft, left);
    const int lastX = std::min(spanRight, right - 1);
    const int firstY = std::max(spanTop, top);
    const int lastY = std::min(spanBottom, bottom - 1);
    if (firstX > lastX || firstY > lastY)
        return;

    std::array<std::int64_t, 3> row = edgeValues(t, firstX, firstY);
    std::array<std::int64_t, 3> stepX;
    std::array<std::int64_t, 3> stepY;
    std::array<std::int64_t, 3> minimum; // an edge that is neither top nor left must be exceeded
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = (i + 1) % 3;
        const std::size_t b = (i + 2) % 3;
        const std::int64_t dx = t.x[b] - t.x[a];
        const std::int64_t dy = t.y[b] - t.y[a];
        stepX[i] = -dy * 256;
        stepY[i] = dx * 256;
        minimum[i] = dy < 0 || (dy == 0 && dx > 0) ? 0 : 1;
    }
    const float scale = 1.0F / static_cast<float>(row[0] + row[1] + row[2]);
    const std::array<float, 3> nearness = {t.nearness[0] * scale, t.nearness[1] * scale,
                                           t.nearness[2] * scale};
    for (int y = firstY; y <= lastY; ++y) {
        std::int64_t e0 = row[0];
        std::int64_t e1 = row[1];
        std::int64_t e2 = row[2];
        const std::size_t start = static_cast<std::size_t>(y - top) * static_cast<std::size_t>(tileSize);
        for (int x = firstX; x <= lastX; ++x) {
            if (((e0 - minimum[0]) | (e1 - minimum[1]) | (e2 - minimum[2])) >= 0) {
                const float n = static_cast<float>(e0) * nearness[0] + static_cast<float>(e1) * nearness[1] +
                                static_cast<float>(e2) * nearness[2];
                const std::size_t sample = start + static_cast<std::size_t>(x - left);
                if (n > buffer.nearness[sample]) {
                    buffer.nearness[sample] = n;
                    buffer.items[sample] = item;
                }
            }
            e0 += stepX[0];
            e1 += stepX[1];
            e2 += stepX[2];
        }
        for (std::size_t i = 0; i < 3; ++i)
            row[i] += stepY[i];
    }
}

} // namespace

Projection::Projection(const Camera& camera, int width, int height)
    : eye(camera.eye)
    , centerX(width / 2.0)
    , centerY(height / 2.0)
    , nearDistance(camera.nearDistance)
    , farDistance(camera.farDistance)
{
    forward = (camera.target - camera.eye).normalized();
    right = forward.cross(camera.up);
    if (right.squaredNorm() < 1e-16 * camera.up.squaredNorm())
        right = forward.cross(Vec3d(camera.up.z(), camera.up.x(), camera.up.y()));
    right.normalize();
    up = right.cross(forward);
    const auto [sine, cosine] = sineCosine(camera.verticalFovDegrees / 720.0);
    focal = height / 2.0 * cosine / sine;
}

ScreenScene projectScene(Positions positions, std::span<const Triangle> triangles,
                         const Projection& projection, int width, int height, int tileSize)
{
    struct Projected
    {
        Vec3d view;
        ScreenVertex screen;
        bool inside;
    };
    std::vector<Projected> vertices(positions.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, positions.size(), 1024), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            const Vec3d offset = positions[i].cast<double>() - projection.eye;
            Projected& v = vertices[i];
            v.view = {projection.right.dot(offset), projection.up.dot(offset),
                      projection.forward.dot(offset)};
            v.inside = isInside(v.view, projection);
            if (v.inside)
                v.screen = toScreen(v.view, projection);
        }
    });
    ScreenScene scene = prepare(triangles.size(), [&](std::uint32_t index, Chunk& chunk) {
        const std::array<const Projected*, 3> v = {&vertices[triangles[index][0].value],
                                                   &vertices[triangles[index][1].value],
                                                   &vertices[triangles[index][2].value]};
        ScreenTriangle t;
        if (!(v[0]->inside && v[1]->inside && v[2]->inside))
            addPieces({v[0]->view, v[1]->view, v[2]->view}, index, projection, width, height, chunk);
        else if (makeScreenTriangle({v[0]->screen, v[1]->screen, v[2]->screen}, index, width, height, t))
            chunk.triangles.push_back(t);
    });
    sortIntoTiles(scene, width, height, tileSize);
    return scene;
}

ScreenScene projectScene(std::span<const ScreenVertex> vertices, std::span<const Triangle> triangles,
                         int width, int height, int tileSize)
{
    ScreenScene scene = prepare(triangles.size(), [&](std::uint32_t index, Chunk& chunk) {
        const Triangle& corners = triangles[index];
        ScreenTriangle t;
        if (makeScreenTriangle(
                {vertices[corners[0].value], vertices[corners[1].value], vertices[corners[2].value]}, index,
                width, height, t))
            chunk.triangles.push_back(t);
    });
    sortIntoTiles(scene, width, height, tileSize);
    return scene;
}

TileBuffer::TileBuffer(int size)
    : tileSize(static_cast<std::size_t>(size)), items(tileSize * tileSize), nearness(items.size())
{
}

void drawTile(const ScreenScene& scene, int tile, TileBuffer& buffer, float lowest)
{
    std::fill(buffer.items.begin(), buffer.items.end(), noTriangle);
    std::fill(buffer.nearness.begin(), buffer.nearness.end(), lowest);
    const int left = tile % scene.tilesAcross * scene.tileSize;
    const int top = tile / scene.tilesAcross * scene.tileSize;
    const int right = std::min(left + scene.tileSize, scene.width);
    const int bottom = std::min(top + scene.tileSize, scene.height);
    const auto t = static_cast<std::size_t>(tile);
    for (std::uint32_t i = scene.tileStarts[t]; i < scene.tileStarts[t + 1]; ++i) {
        const std::uint32_t item = scene.tileItems[i];
        drawTriangle(scene.triangles[item], left, top, right, bottom, scene.tileSize, buffer, item);
    }
}

Vec3f surfaceWeights(const ScreenScene& scene, const ScreenTriangle& triangle, int x, int y)
{
    const auto edges = edgeValues(triangle, x, y);
    std::array<float, 3> shares;
    float sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += shares[i] = static_cast<float>(edges[i]) * triangle.nearness[i];
    const float scale = 1.0F / sum;
    if (triangle.piece != ScreenTriangle::noPiece) {
        const PieceCorners& corners = scene.pieces[triangle.piece];
        return (corners[0] * shares[0] + corners[1] * shares[1] + corners[2] * shares[2]) * scale;
    }
    Vec3f weights;
    for (std::size_t i = 0; i < 3; ++i)
        weights[triangle.order[i]] = shares[i] * scale;
    return weights;
}

} // namespace quadrille
