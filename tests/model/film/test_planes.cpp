// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/film/planes.h"
#include "tests/model/film/pictures.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

// Values of ITU-R BT.709 at 8 bits.
TEST(Planes, AreThoseOfBt709InTheRangeOfFilms)
{
    struct Known
    {
        Color color;
        std::array<int, 3> planes;
    };
    for (const Known& known : {Known{{0, 0, 0}, {16, 128, 128}}, Known{{255, 255, 255}, {235, 128, 128}},
                               Known{{255, 0, 0}, {63, 102, 240}}, Known{{0, 255, 0}, {173, 42, 26}},
                               Known{{0, 0, 255}, {32, 240, 118}}, Known{{128, 128, 128}, {126, 128, 128}}}) {
        Planes planes;
        toPlanes(plain(6, 4, known.color), planes);
        EXPECT_TRUE(std::ranges::all_of(planes.luma, [&](int value) { return value == known.planes[0]; }))
            << int{planes.luma[0]};
        EXPECT_TRUE(std::ranges::all_of(planes.blueness, [&](int value) { return value == known.planes[1]; }))
            << int{planes.blueness[0]};
        EXPECT_TRUE(std::ranges::all_of(planes.redness, [&](int value) { return value == known.planes[2]; }))
            << int{planes.redness[0]};
    }
}

TEST(Planes, TakeOddSizesAndLieWhereTheyShould)
{
    for (const int width : {1, 2, 5}) {
        for (const int height : {1, 2, 7}) {
            Planes planes;
            toPlanes(plain(width, height, {255, 0, 0}), planes);
            EXPECT_EQ(planes.luma.size(), static_cast<std::size_t>(width * height));
            EXPECT_EQ(planes.colorWidth, (width + 1) / 2);
            EXPECT_EQ(planes.redness.size(), static_cast<std::size_t>((width + 1) / 2 * ((height + 1) / 2)));
            EXPECT_EQ(planes.redness.back(), 240);
        }
    }
    // A red column at an odd place is a quarter of both samples beside it; at an even one half of its own.
    Image image = plain(8, 2, {0, 0, 0});
    Planes planes;
    const auto rednessWith = [&](int column) {
        Image changed = image;
        for (int y = 0; y < 2; ++y)
            changed.pixel(column, y)[0] = 255;
        toPlanes(changed, planes);
        return planes.redness;
    };
    EXPECT_EQ(rednessWith(3), (std::vector<std::uint8_t>{128, 156, 156, 128}));
    EXPECT_EQ(rednessWith(4), (std::vector<std::uint8_t>{128, 128, 184, 128}));
}

TEST(Planes, GiveBackThePictureThatTheyWereMadeOf)
{
    for (const Color& color :
         {Color{0, 0, 0}, Color{255, 255, 255}, Color{200, 40, 90}, Color{3, 250, 120}}) {
        Planes planes;
        const Image picture = plain(5, 3, color);
        toPlanes(picture, planes);
        const Image back = fromPlanes(planes);
        ASSERT_EQ(back.width, 5);
        ASSERT_EQ(back.pixels.size(), picture.pixels.size());
        for (std::size_t i = 0; i < back.pixels.size(); ++i)
            EXPECT_NEAR(back.pixels[i], picture.pixels[i], 3) << i;
    }
}
