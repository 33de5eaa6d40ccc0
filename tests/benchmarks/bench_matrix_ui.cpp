// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What a table of costs takes to show: building its pyramid, and a picture of the widget while it is moved at
// several zooms, with marks; beside a picture of the whole table that is scaled for every picture. And arcs.
#include "widgets/graph/arcview.h"
#include "widgets/graph/matrixview.h"
#include "widgets/theme/theme.h"

#include <QPainter>
#include <benchmark/benchmark.h>
#include <map>
#include <random>

namespace quadrille::widgets {
namespace {

MatrixValues valuesOf(int side)
{
    static std::map<int, MatrixValues> known;
    if (const auto found = known.find(side); found != known.end())
        return found->second;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> value(0, 1.2F);
    auto values =
        std::make_shared<std::vector<float>>(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (float& cell : *values) {
        cell = value(random);
        if (cell > 1)
            cell = std::numeric_limits<float>::infinity();
    }
    return known[side] = {side, std::shared_ptr<const float>(values, values->data()), nullptr};
}

/// So many in each row.
MatrixMarkRow marksOf(int side, int each = 10)
{
    std::mt19937 random(2);
    auto marks = std::make_shared<std::vector<MatrixMark>>();
    for (int i = 0; i < side * each; ++i)
        marks->push_back({i / each, static_cast<int>(random() % static_cast<unsigned>(side)),
                          static_cast<float>(random() % 100)});
    return [marks, each](int row, std::vector<MatrixMark>& ofRow) {
        const auto first = marks->begin() + std::ptrdiff_t{row} * each;
        ofRow.insert(ofRow.end(), first, first + each);
    };
}

void pyramid(benchmark::State& state)
{
    const MatrixValues values = valuesOf(static_cast<int>(state.range(0)));
    for ([[maybe_unused]] const auto& each : state)
        benchmark::DoNotOptimize(buildMatrixPyramid(values, 0, 1));
}

/// The second argument is how far it is zoomed in, the third the pixels of the screen for each logical one.
void matrix(benchmark::State& state)
{
    const int side = static_cast<int>(state.range(0));
    const MatrixValues values = valuesOf(side);
    MatrixView view;
    view.resize(1000, 800);
    view.setMatrix(values, buildMatrixPyramid(values, 0, 1), {});
    view.setMarks(MatrixView::Layer::First, QStringLiteral("A"), marksOf(side));
    view.setMarks(MatrixView::Layer::Second, QStringLiteral("B"), marksOf(side));
    view.zoomAbout(view.matrixArea().center(), static_cast<double>(state.range(1)));
    const auto ratio = static_cast<double>(state.range(2));
    QImage screen((QSizeF(view.size()) * ratio).toSize(), QImage::Format_RGB32);
    screen.setDevicePixelRatio(ratio);
    for ([[maybe_unused]] const auto& each : state) {
        view.zoomAbout({300, 300}, 1.0001);
        QPainter painter(&screen);
        view.render(&painter);
    }
}

/// A picture with a pixel for each cell, scaled whole for each picture.
void scaledImage(benchmark::State& state)
{
    const int side = static_cast<int>(state.range(0));
    const MatrixValues values = valuesOf(side);
    QImage image(side, side, QImage::Format_RGB32);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            image.setPixel(column, row, mapColor(ColorMap::Sequential, values.value(row, column)).rgb());
    QImage screen(1000, 800, QImage::Format_RGB32);
    for ([[maybe_unused]] const auto& each : state) {
        QPainter painter(&screen);
        painter.drawImage(0, 0, image.scaled(780, 780, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    }
}

void arcs(benchmark::State& state)
{
    ArcView view;
    view.resize(1000, 400);
    std::vector<ArcSequence> sequences;
    for (int i = 0; i < 20; ++i)
        sequences.push_back({QString::number(i), 50, Theme::categorical(i)});
    view.setSequences(sequences);
    std::mt19937 random(3);
    auto edges = std::make_shared<std::vector<Arc>>();
    for (int i = 0; i < state.range(0); ++i)
        edges->push_back({static_cast<int>(random() % 1000), static_cast<int>(random() % 1000),
                          static_cast<float>(random() % 100)});
    view.setArcs(ArcView::Side::Above, QStringLiteral("A"), edges);
    view.setArcs(ArcView::Side::Below, QStringLiteral("B"), edges);
    QImage screen(view.size(), QImage::Format_RGB32);
    for ([[maybe_unused]] const auto& each : state) {
        view.zoomBy(1.0001);
        QPainter painter(&screen);
        view.render(&painter);
    }
}

BENCHMARK(pyramid)->ArgName("side")->Arg(1000)->Arg(4000)->Unit(benchmark::kMillisecond);
BENCHMARK(matrix)
    ->ArgNames({"side", "zoom", "ratio"})
    ->Args({1000, 1, 1})
    ->Args({4000, 1, 1})
    ->Args({4000, 1, 2})
    ->Args({4000, 4, 1})
    ->Args({4000, 40, 1})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(scaledImage)->ArgName("side")->Arg(1000)->Arg(4000)->Unit(benchmark::kMillisecond);
BENCHMARK(arcs)->ArgName("edges")->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace quadrille::widgets
