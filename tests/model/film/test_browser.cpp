// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/audio/soundtrack.h"
#include "model/film/mp4film.h"
#include "tests/model/audio/tone.h"
#include "tests/model/core/temporaryfolder.h"
#include "tests/model/film/pictures.h"

#include <cstdio>
#include <gtest/gtest.h>
#include <map>
#include <sstream>
#include <sys/wait.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// What a program prints, and how it ends.
struct Printed
{
    std::string text;
    int status = -1;
};

Printed run(const std::string& command)
{
    Printed printed;
    std::FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr)
        return printed;
    std::array<char, 4096> buffer{};
    while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), pipe))
        printed.text.append(buffer.data(), size);
    printed.status = WEXITSTATUS(::pclose(pipe));
    return printed;
}

} // namespace

/// A second of four colours, with a tone from 0.25 to 0.75 s.
TEST(Browser, PlaysFilmsWithTheirColorsAndTheirSound)
{
    const TemporaryFolder folder;
    const FilmFormat format{320, 180, 25, 25};
    const Sound sound = soundOfClip(tone(0.5), {{}, 0.25, 0}, 1);
    Mp4Film film(folder / "film.mp4", folder / "film.mp4", format, encodeMp3(sound));
    for (std::int64_t frame = 0; frame < format.frames; ++frame)
        film.add(quarters(format.width, format.height));
    film.finish();

    const Printed said = run(QUADRILLE_PLAY " " + (folder / "film.mp4").string());
    constexpr int noBrowser = 77;
    if (said.status == noBrowser)
        GTEST_SKIP() << said.text;
    ASSERT_EQ(said.status, 0);
    std::multimap<std::string, std::vector<double>> lines;
    std::istringstream text(said.text);
    for (std::string line; std::getline(text, line);) {
        std::istringstream values(line);
        std::string word;
        values >> word;
        auto& numbers = lines.emplace(word, std::vector<double>{})->second;
        for (double value = 0; values >> value;)
            numbers.push_back(value);
    }
    for (const auto& [word, count] : {std::pair{"size", 2U}, {"time", 2U}, {"bytes", 2U}, {"sound", 4U}}) {
        ASSERT_TRUE(lines.contains(word)) << said.text;
        ASSERT_EQ(lines.find(word)->second.size(), count) << said.text;
    }
    EXPECT_EQ(lines.find("size")->second, (std::vector<double>{320, 180}));
    EXPECT_NEAR(lines.find("time")->second[0], 1, 0.001);
    EXPECT_NEAR(lines.find("time")->second[1], 1, 0.001);
    EXPECT_GT(lines.find("bytes")->second[0], 0);
    EXPECT_GT(lines.find("bytes")->second[1], 0);
    ASSERT_EQ(lines.count("color"), 4U) << said.text;
    auto color = lines.find("color");
    for (const Color& expected : quarterColors) {
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(color->second.at(c), expected.at(c), 8) << said.text; // lost by compression
        ++color;
    }
    const auto& heard = lines.find("sound")->second;
    EXPECT_NEAR(heard[0], 0.25, 0.0005);
    EXPECT_NEAR(heard[1], 0.75, 0.0005);
    EXPECT_NEAR(heard[2], 0.5, 0.05);
}
