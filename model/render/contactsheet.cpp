// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/contactsheet.h"

#include "model/core/error.h"
#include "model/core/message.h"
#include "model/render/renderframe.h"
#include "model/render/text.h"
#include "model/render/thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace quadrille {

namespace {

// Sizes in units of options.scale pixels, on a grid of four.
constexpr double margin = 24;
constexpr double gap = 8;
constexpr double titleHeight = 44;
constexpr double headingHeight = 28;
constexpr double rowGap = 20; // under the last pictures of a sequence
constexpr double cornerRadius = 6;

struct SheetColors
{
    std::uint32_t page;
    std::uint32_t text;
    std::uint32_t secondary;
};

SheetColors colorsOf(RenderOptions::Background background)
{
    if (background == RenderOptions::Background::Dark)
        return {0x1E1F22, 0xE6E7EA, 0xA4A8B0};
    return {0xFFFFFF, 0x1B1D21, 0x5A606B};
}

/// How much of a pixel lies inside a box with rounded corners, 0 … 255.
int roundedCover(int x, int y, const SheetBox& box, double radius)
{
    const double dx = std::max({radius - x - 0.5, x + 0.5 - (box.width - radius), 0.0});
    const double dy = std::max({radius - y - 0.5, y + 0.5 - (box.height - radius), 0.0});
    const double inside = radius + 0.5 - std::sqrt(dx * dx + dy * dy);
    return static_cast<int>(std::lrint(std::clamp(inside, 0.0, 1.0) * 255));
}

void place(Image& sheet, const Image& picture, const SheetBox& box, double radius)
{
    for (int y = 0; y < box.height; ++y) {
        for (int x = 0; x < box.width; ++x) {
            const int cover = roundedCover(x, y, box, radius);
            const std::uint8_t* from = picture.pixel(x, y);
            std::uint8_t* to = sheet.pixel(box.x + x, box.y + y);
            for (int i = 0; i < 4; ++i)
                to[i] = static_cast<std::uint8_t>((to[i] * (255 - cover) + from[i] * cover + 127) / 255);
        }
    }
}

std::string summaryOf(const MeshSequence& sequence)
{
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "%lld frames · %g fps · %.2f s",
                  static_cast<long long>(sequence.frameCount()), sequence.fps, sequence.duration().value);
    return text.data();
}

void writeHeading(Image& sheet, const MeshSequence& sequence, const SheetBox& box, double scale,
                  const SheetColors& colors)
{
    const TextStyle bold{13 * scale, true, colors.text};
    const TextStyle plain{11 * scale, false, colors.secondary};
    const std::string summary = summaryOf(sequence);
    const double room = box.width - textWidth(summary, plain) - 12 * scale;
    const std::string name = elided(sequence.name, std::max(room, box.width * 0.4), bold);
    const double baseline = box.y + box.height - 10 * scale;
    drawText(sheet, name, box.x, baseline, bold);
    const double x = box.x + textWidth(name, bold) + (name.empty() ? 0 : 12 * scale);
    drawText(sheet, elided(summary, box.x + box.width - x, plain), x, baseline, plain);
}

void check(std::span<const MeshSequence> sequences, const ContactSheetLayout& layout)
{
    const auto refuse = [](const char* reason, const char* remedy) {
        throw Error(ErrorCode::BadArgument, {{}, {}, {{"reason", reason}, {"remedy", remedy}}});
    };
    if (sequences.empty())
        refuse("A contact sheet needs a sequence", QUADRILLE_MESSAGE("Choose at least one."));
    constexpr int largest = 30000;
    if (layout.width > largest || layout.height > largest)
        refuse(QUADRILLE_MESSAGE("The contact sheet would be too large"),
               QUADRILLE_MESSAGE("Choose fewer sequences or smaller pictures."));
}

} // namespace

ContactSheetLayout layoutContactSheet(std::span<const int> pictures, const ContactSheetOptions& options)
{
    const auto pixels = [&options](double units) {
        return static_cast<int>(std::lrint(units * options.scale));
    };
    const int most = pictures.empty() ? 1 : *std::max_element(pictures.begin(), pictures.end());
    const int columns = std::clamp(most, 1, std::max(options.columns, 1));
    const int stepX = pixels(options.cellWidth + gap);
    const int stepY = pixels(options.cellHeight + gap);
    const int cellWidth = pixels(options.cellWidth);
    const int cellHeight = pixels(options.cellHeight);
    const int edge = pixels(margin);
    ContactSheetLayout layout;
    layout.width = 2 * edge + (columns - 1) * stepX + cellWidth;
    const int inner = layout.width - 2 * edge;
    int y = edge;
    if (!options.title.empty()) {
        layout.title = {edge, y, inner, pixels(titleHeight)};
        y += layout.title.height;
    }
    for (const int count : pictures) {
        layout.headings.push_back({edge, y, inner, pixels(headingHeight)});
        y += layout.headings.back().height;
        std::vector<SheetBox>& cells = layout.cells.emplace_back();
        for (int i = 0; i < count; ++i)
            cells.push_back({edge + i % columns * stepX, y + i / columns * stepY, cellWidth, cellHeight});
        const int rows = (count + columns - 1) / columns;
        y += std::max(rows - 1, 0) * stepY + (rows > 0 ? cellHeight : 0) + pixels(rowGap);
    }
    layout.height = y - (pictures.empty() ? 0 : pixels(rowGap)) + edge;
    return layout;
}

Image contactSheet(std::span<const MeshSequence> sequences, const ContactSheetOptions& options,
                   const Progress& progress)
{
    std::vector<std::vector<FrameIndex>> frames;
    std::vector<int> pictures;
    for (const MeshSequence& sequence : sequences) {
        frames.push_back(evenFrames(sequence.frameCount(), std::max(options.framesPerSequence, 1)));
        pictures.push_back(static_cast<int>(frames.back().size()));
    }
    const ContactSheetLayout layout = layoutContactSheet(pictures, options);
    check(sequences, layout);

    const SheetColors colors = colorsOf(options.background);
    Image sheet(layout.width, layout.height);
    if (options.background != RenderOptions::Background::Transparent) {
        for (std::size_t i = 0; i < sheet.pixels.size(); i += 4) {
            sheet.pixels[i] = static_cast<std::uint8_t>(colors.page >> 16U);
            sheet.pixels[i + 1] = static_cast<std::uint8_t>(colors.page >> 8U & 0xFFU);
            sheet.pixels[i + 2] = static_cast<std::uint8_t>(colors.page & 0xFFU);
            sheet.pixels[i + 3] = 255;
        }
    }
    if (!options.title.empty()) {
        const TextStyle style{20 * options.scale, true, colors.text};
        drawText(sheet, elided(options.title, layout.title.width, style), layout.title.x,
                 layout.title.y + 20 * options.scale, style);
    }
    const TextStyle number{10 * options.scale, false, colors.secondary};
    for (std::size_t s = 0; s < sequences.size(); ++s) {
        const Progress part =
            progress.part(static_cast<double>(s) / static_cast<double>(sequences.size()),
                          static_cast<double>(s + 1) / static_cast<double>(sequences.size()));
        writeHeading(sheet, sequences[s], layout.headings[s], options.scale, colors);
        if (layout.cells[s].empty())
            continue;
        RenderOptions look = thumbnailLook(layout.cells[s][0].width, layout.cells[s][0].height,
                                           options.background, options.axes);
        look.shading = options.shading;
        const FrameRenderer renderer(sequences[s], look);
        const auto cameras = figureCameras(sequences[s], frames[s], look);
        for (std::size_t i = 0; i < cameras.size(); ++i) {
            part.report(static_cast<std::int64_t>(i), static_cast<std::int64_t>(cameras.size()));
            const SheetBox& box = layout.cells[s][i];
            place(sheet, renderer.render(frames[s][i], cameras[i]), box, cornerRadius * options.scale);
            drawText(sheet, std::to_string(frames[s][i].value), box.x + 8 * options.scale,
                     box.y + box.height - 8 * options.scale, number);
        }
    }
    progress.report(1.0);
    return sheet;
}

} // namespace quadrille
