// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/render/contactsheet.h"
#include "model/render/text.h"
#include "model/render/thumbnail.h"
#include "scenes.h"

#include <cstdlib>
#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

bool overlap(const SheetBox& a, const SheetBox& b)
{
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

int inkIn(const Image& image, const SheetBox& box)
{
    int count = 0;
    for (int y = box.y; y < box.y + box.height; ++y) {
        for (int x = box.x; x < box.x + box.width; ++x)
            count += image.pixel(x, y)[0] < 128;
    }
    return count;
}

int colouredIn(const Image& image, const SheetBox& box)
{
    int count = 0;
    for (int y = box.y; y < box.y + box.height; ++y) {
        for (int x = box.x; x < box.x + box.width; ++x)
            count += std::abs(image.pixel(x, y)[0] - image.pixel(x, y)[2]) > 40;
    }
    return count;
}

Image white(int width, int height)
{
    Image image(width, height);
    std::fill(image.pixels.begin(), image.pixels.end(), std::uint8_t{255});
    return image;
}

} // namespace

TEST(ContactSheet, LaysOutRowsThatNeitherOverlapNorLeaveTheSheet)
{
    for (const double scale : {0.5, 1.0, 1.37, 2.0}) {
        ContactSheetOptions options;
        options.title = "Title";
        options.columns = 4;
        options.scale = scale;
        const std::vector<int> pictures = {3, 9, 1};
        const auto layout = layoutContactSheet(pictures, options);
        std::vector<SheetBox> boxes = {layout.title};
        ASSERT_EQ(layout.cells.size(), 3U);
        for (std::size_t s = 0; s < 3; ++s) {
            boxes.push_back(layout.headings[s]);
            ASSERT_EQ(layout.cells[s].size(), static_cast<std::size_t>(pictures[s]));
            boxes.insert(boxes.end(), layout.cells[s].begin(), layout.cells[s].end());
        }
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            EXPECT_GE(boxes[i].x, 0);
            EXPECT_GE(boxes[i].y, 0);
            EXPECT_LE(boxes[i].x + boxes[i].width, layout.width);
            EXPECT_LE(boxes[i].y + boxes[i].height, layout.height);
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_FALSE(overlap(boxes[i], boxes[k])) << i << ", " << k;
        }
        // Even steps; the fifth picture begins the second row.
        const auto& cells = layout.cells[1];
        EXPECT_EQ(cells[1].x - cells[0].x, cells[3].x - cells[2].x);
        EXPECT_EQ(cells[4].x, cells[0].x);
        EXPECT_GT(cells[4].y, cells[0].y);
        // The margin is the same on the right as on the left.
        EXPECT_EQ(cells[0].x, layout.width - cells[3].x - cells[3].width);
    }
}

TEST(ContactSheet, HoldsTitleHeadingsNumbersAndFigures)
{
    const std::vector<MeshSequence> sequences = {ball(12, 5), ball(12, 2)};
    ContactSheetOptions options;
    options.title = "Two balls";
    options.framesPerSequence = 3;
    options.cellWidth = 80;
    options.cellHeight = 80;
    const std::vector<int> pictures = {3, 2};
    const auto layout = layoutContactSheet(pictures, options);
    const auto sheet = contactSheet(sequences, options);
    EXPECT_EQ(sheet.width, layout.width);
    EXPECT_EQ(sheet.height, layout.height);
    EXPECT_GT(inkIn(sheet, layout.title), 100);
    for (std::size_t s = 0; s < 2; ++s) {
        EXPECT_GT(inkIn(sheet, layout.headings[s]), 40);
        for (const SheetBox& cell : layout.cells[s]) {
            EXPECT_GT(colouredIn(sheet, {cell.x + 20, cell.y + 20, 40, 40}), 800);
            EXPECT_GT(inkIn(sheet, {cell.x + 6, cell.y + 60, 10, 14}), 5); // its number
            EXPECT_EQ(sheet.pixel(cell.x, cell.y)[0], 255);                // its corners are round
        }
    }
    EXPECT_EQ(sheet, contactSheet(sequences, options));
}

TEST(ContactSheet, RefusesNothingAndTooMuch)
{
    EXPECT_THROW(contactSheet({}), Error);
    ContactSheetOptions options;
    options.scale = 100;
    const std::vector<MeshSequence> sequences = {ball(4, 9)};
    EXPECT_THROW(contactSheet(sequences, options), Error);
}

TEST(ContactSheet, CanBeCancelled)
{
    CancelToken token;
    const Progress progress(token, [&](double fraction) {
        if (fraction > 0.4)
            token.cancel();
    });
    ContactSheetOptions options;
    options.cellWidth = options.cellHeight = 40;
    const std::vector<MeshSequence> sequences = {ball(4, 9)};
    try {
        contactSheet(sequences, options, progress);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Cancelled);
    }
}

TEST(Thumbnail, ChoosesEvenFrames)
{
    const auto values = [](std::int64_t count, int number) {
        std::vector<std::int64_t> result;
        for (const FrameIndex f : evenFrames(count, number))
            result.push_back(f.value);
        return result;
    };
    EXPECT_EQ(values(9, 3), (std::vector<std::int64_t>{0, 4, 8}));
    EXPECT_EQ(values(3, 8), (std::vector<std::int64_t>{0, 1, 2}));
    EXPECT_EQ(values(1, 1), (std::vector<std::int64_t>{0}));
    EXPECT_TRUE(values(5, 0).empty());
}

TEST(Thumbnail, KeepsTheFigureInTheMiddleWhileItTravels)
{
    const auto sequence = ball(16, 30); // travels three metres
    const auto look = thumbnailLook(60, 60, RenderOptions::Background::Transparent);
    const auto strip = thumbnailStrip(sequence, 5, look);
    ASSERT_EQ(strip.size(), 5U);
    for (const Image& picture : strip) {
        int left = 60;
        int right = 0;
        for (int y = 0; y < 60; ++y) {
            for (int x = 0; x < 60; ++x) {
                if (picture.pixel(x, y)[3] < 255)
                    continue;
                left = std::min(left, x);
                right = std::max(right, x);
            }
        }
        EXPECT_NEAR(left + right, 59, 6);
        EXPECT_GT(right - left, 40);
    }
    EXPECT_NE(strip[0], strip[1]);
    EXPECT_EQ(thumbnail(sequence, look).width, 60);
}

TEST(Text, MeasuresAndDrawsTheSame)
{
    const TextStyle style{16, false, 0x000000};
    Image image = white(200, 40);
    drawText(image, "Größe", 10, 28, style);
    const double width = textWidth("Größe", style);
    EXPECT_GT(inkIn(image, {0, 0, 200, 40}), 60);
    EXPECT_EQ(inkIn(image, {0, 0, 10, 40}), 0);
    const int end = static_cast<int>(10 + width) + 1;
    EXPECT_EQ(inkIn(image, {end, 0, 200 - end, 40}), 0);
    EXPECT_GT(inkIn(image, {end - 12, 0, 12, 40}), 5);
    EXPECT_NEAR(textWidth("Größe", {32, false, 0}), 2 * width, 0.5); // 1/64 pixel per letter
    EXPECT_GT(textWidth("Größe", {16, true, 0}), width);
}

TEST(Text, StaysInsideTheImageAndTakesBrokenUtf8)
{
    Image image = white(20, 10);
    drawText(image, "Overflowing everywhere", -5, 2, {24, true, 0});
    drawText(image, "\xFF\xC3(\xE2\x82", 0, 9, {8, false, 0});
    EXPECT_GT(inkIn(image, {0, 0, 20, 10}), 0);
    EXPECT_EQ(textWidth("", {12, false, 0}), 0);
}

TEST(Text, ElidesWhatDoesNotFit)
{
    const TextStyle style{12, false, 0};
    EXPECT_EQ(elided("short", 200, style), "short");
    const std::string cut = elided("ééééééééééééééééééééé", 60, style);
    EXPECT_LE(textWidth(cut, style), 60);
    EXPECT_GT(textWidth(cut, style), 40);
    EXPECT_TRUE(cut.ends_with("é…"));
    EXPECT_EQ(elided("anything", 0, style), "");
}
