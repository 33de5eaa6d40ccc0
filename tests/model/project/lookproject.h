// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"
#include "model/project/store/appearanceresult.h"
#include "model/project/store/resultplaces.h"
#include "tests/model/appearance/shiftedtextures.h"
#include "tests/model/project/stripproject.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace quadrille::test {

/// The strip with UVs: one chart, 4 texels from the edges of an atlas of 64².
inline std::string texturedStrip(const std::string& strip)
{
    std::string text = strip.substr(0, strip.find("f "));
    for (int row = 0; row < 5; ++row) {
        for (const int side : {0, 1})
            text += "vt " + std::to_string((4 + 56 * side) / 64.0) + " " +
                    std::to_string((4 + 14 * row) / 64.0) + "\n";
    }
    for (int row = 1; row < 8; row += 2) {
        const auto corner = [&](int i) {
            const std::string number = std::to_string(row + i);
            return number + "/" + number + " ";
        };
        text += "f " + corner(0) + corner(1) + corner(3) + "\nf " + corner(0) + corner(3) + corner(2) + "\n";
    }
    return text;
}

/// A picture of 64² of the pattern moved by x texels to the left, and half as far up.
inline Image movedPattern(double shift)
{
    Image image(64, 64);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double grey = std::clamp(patternAt(x + shift, y + 0.5 * shift), 0.0, 255.0);
            std::fill_n(image.pixel(x, y), 3, static_cast<std::uint8_t>(std::lround(grey)));
            image.pixel(x, y)[3] = 255;
        }
    }
    return image;
}

/// The strips with a texture per frame that moves as they bend, and a model of their appearance, “look”.
class LookProject : public StripProject
{
protected:
    static constexpr int slowFrames = 14;
    static constexpr int quickFrames = 9;

    LookProject()
    {
        for (int f = 0; f < slowFrames; ++f) {
            rewrite("slow", f, bentStrip(0.3 * std::sin(0.35 * f)));
            writeImage(slowPattern(f), textureFile("slow", f));
        }
        for (int f = 0; f < quickFrames; ++f) {
            rewrite("quick", f, bentStrip(0.35 * std::sin(0.7 * f + 0.1)));
            writeImage(quickPattern(f), textureFile("quick", f));
        }
        for (SequenceEntry& sequence : project.sequences)
            sequence.texture = textureOf(TextureReference::Kind::PerFrame, {"looks/" + sequence.name});
        AppearanceEntry entry;
        entry.name = "look";
        entry.components = 9;
        entry.flow = FlowMethod::Dis;
        project.appearances = {entry};
    }

    static const Image& slowPattern(int frame)
    {
        static const std::vector<Image> patterns = patternsOf(slowFrames, 0.35, 0);
        return patterns[static_cast<std::size_t>(frame)];
    }
    static const Image& quickPattern(int frame)
    {
        static const std::vector<Image> patterns = patternsOf(quickFrames, 0.7, 0.1);
        return patterns[static_cast<std::size_t>(frame)];
    }
    std::filesystem::path textureFile(const std::string& sequence, int frame) const
    {
        std::array<char, 16> name{};
        std::snprintf(name.data(), name.size(), "/%04d.png", frame);
        return folder / ("looks/" + sequence + name.data());
    }
    std::filesystem::path projectFile() const { return folder / "p.quadrille"; }
    std::filesystem::path results() const { return cacheFolder(projectFile()); }
    std::filesystem::path filesOfLook() const { return appearanceFolder(results(), "look"); }
    AppearanceEntry& look() { return project.appearances.front(); }
    /// What the first step that fails says.
    std::optional<Error> failure(const std::string& target = "appearance")
    {
        for (const StepReport& step : run(target).steps) {
            if (step.error)
                return step.error;
        }
        return std::nullopt;
    }

private:
    static std::vector<Image> patternsOf(int count, double pace, double start)
    {
        std::vector<Image> patterns;
        for (int f = 0; f < count; ++f)
            patterns.push_back(movedPattern(2.5 * std::sin(pace * f + start)));
        return patterns;
    }
    void rewrite(const std::string& sequence, int frame, const std::string& strip) const
    {
        folder.write(sequence + "/f_" + std::to_string(frame) + ".obj", texturedStrip(strip));
    }
};

} // namespace quadrille::test
