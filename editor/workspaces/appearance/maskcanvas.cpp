// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/appearance/maskcanvas.h"

#include "editor/context/editorcontext.h"
#include "editor/pictures/pictures.h"
#include "editor/workspaces/appearance/texturecomparison.h"
#include "model/project/steps/completionmask.h"
#include "widgets/controls/comparedview.h"
#include "widgets/theme/theme.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille {

namespace {

constexpr int tintSide = 512; // pixels
constexpr int tintAlpha = 150;
constexpr int whiteFrom = 128;      ///< of a mask's picture
constexpr int chartRowGap = 2;      // texels
constexpr double chartRadius = 1.5; ///< of strokes over a chart, texels: rows that gap apart touch
constexpr int longestJump = 4;      ///< from row to row within a stroke, texels

/// A stretch of a row that belongs to a chart, texels.
struct ChartRun
{
    int row;
    int first;
    int last;
};

std::vector<ChartRun> runsOf(const UsedTexels& texels, std::uint16_t chart)
{
    std::vector<ChartRun> runs;
    for (std::size_t i = 0; i < texels.texels.size(); ++i) {
        if (texels.charts[i] != chart || texels.covered[i] == 0)
            continue;
        const int row = static_cast<int>(texels.texels[i]) / texels.width;
        const int column = static_cast<int>(texels.texels[i]) % texels.width;
        if (row % chartRowGap != 0)
            continue;
        if (!runs.empty() && runs.back().row == row && runs.back().last == column - 1)
            runs.back().last = column;
        else
            runs.push_back({row, column, column});
    }
    return runs;
}

} // namespace

std::vector<MaskStrokeEntry> strokesOver(const UsedTexels& texels, std::uint16_t chart)
{
    std::vector<MaskStrokeEntry> strokes;
    const auto u = [&](int column) { return (column + 0.5) / texels.width; };
    const auto v = [&](int row) { return 1 - (row + 0.5) / texels.height; };
    // Runs one below the other become one stroke, to and fro, as long as it need not leave the chart.
    struct Open
    {
        std::size_t stroke;
        ChartRun end;
        bool isAtLast;
    };
    std::vector<Open> open;
    for (const ChartRun& run : runsOf(texels, chart)) {
        const auto goesOn = [&](const Open& each) {
            const int from = each.isAtLast ? each.end.last : each.end.first;
            const int to = each.isAtLast ? run.last : run.first;
            return each.end.row == run.row - chartRowGap && std::abs(from - to) <= longestJump;
        };
        auto found = std::ranges::find_if(open, goesOn);
        if (found == open.end()) {
            strokes.push_back({.points = {}, .radius = chartRadius / texels.width});
            open.push_back({strokes.size() - 1, run, false});
            found = std::prev(open.end());
        }
        std::vector<double>& points = strokes[found->stroke].points;
        const int begin = found->isAtLast ? run.last : run.first;
        const int end = found->isAtLast ? run.first : run.last;
        points.insert(points.end(), {u(begin), v(run.row), u(end), v(run.row)});
        found->end = run;
        found->isAtLast = !found->isAtLast;
        std::erase_if(open, [&](const Open& each) { return each.end.row < run.row - chartRowGap; });
    }
    return strokes;
}

std::vector<std::uint8_t> paintedMask(const QImage& base, std::span<const MaskStrokeEntry> strokes, int side)
{
    const auto width = static_cast<std::size_t>(side);
    std::vector<std::uint8_t> mask(width * width);
    if (!base.isNull()) {
        const QImage grey = base.scaled(side, side).convertToFormat(QImage::Format_Grayscale8);
        for (int y = 0; y < side; ++y) {
            const std::uint8_t* from = grey.constScanLine(y);
            std::transform(from, from + side, mask.begin() + std::ptrdiff_t{y} * side,
                           [](std::uint8_t level) { return level >= whiteFrom ? 1 : 0; });
        }
    }
    paintStrokes(strokes, side, side, mask);
    return mask;
}

QImage maskTint(std::span<const std::uint8_t> mask, int side)
{
    QColor color = widgets::Theme::color(widgets::ColorRole::Error);
    color.setAlpha(tintAlpha);
    const QRgb marked = qPremultiply(color.rgba());
    QImage tint(side, side, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < side; ++y) {
        auto* row = reinterpret_cast<QRgb*>(tint.scanLine(y));
        const auto from = mask.begin() + std::ptrdiff_t{y} * side;
        std::transform(from, from + side, row,
                       [marked](std::uint8_t texel) { return texel != 0 ? marked : 0; });
    }
    return tint;
}

MaskCanvas::MaskCanvas(ShownTexture& shown, TextureComparison& comparison, QObject* parent)
    : QObject(parent), m_shown(shown), m_comparison(comparison)
{
    connect(&shown, &ShownTexture::changed, this, &MaskCanvas::refresh);
    connect(&widgets::Theme::instance(), &widgets::Theme::changed, this, &MaskCanvas::refresh);
    connect(&comparison.view(), &widgets::ComparedView::strokePainted, this, &MaskCanvas::paint);
    connect(&comparison.view(), &widgets::ComparedView::strokeCancelled, this, &MaskCanvas::refresh);
}

const CompletionEntry* MaskCanvas::completion() const
{
    const AppearanceEntry* entry = m_shown.appearance().entry();
    const auto frame = m_shown.appearance().frame();
    if (entry == nullptr || !frame)
        return nullptr;
    const auto found = std::ranges::find(entry->completions, *frame, &CompletionEntry::frame);
    return found == entry->completions.end() ? nullptr : &*found;
}

void MaskCanvas::setPainting(bool painting)
{
    if (painting == m_isPainting)
        return;
    m_isPainting = painting;
    if (painting) {
        m_shown.setContent(TextureContent::Completed);
        m_shown.setMode(TextureMode::First);
    }
    refresh();
    emit changed();
}

void MaskCanvas::setTool(MaskTool tool)
{
    m_tool = tool;
    refresh();
    emit changed();
}

void MaskCanvas::setRadius(double radius)
{
    m_radius = radius;
    refresh();
    emit changed();
}

void MaskCanvas::refresh()
{
    const bool isSeen = m_shown.content() == TextureContent::Completed;
    if (!isSeen && std::exchange(m_isPainting, false))
        emit changed();
    const double radius = m_tool == MaskTool::FillChart ? 0.004 : m_radius; // there it only points
    m_comparison.view().setBrush(m_isPainting && m_shown.appearance().entry() != nullptr
                                     ? std::optional(widgets::TextureBrush{radius, m_tool == MaskTool::Erase})
                                     : std::nullopt);
    const CompletionEntry* own = completion();
    if (own != nullptr && own->mask != m_maskFile)
        loadMask(own->mask);
    // Before it is completed, and while it is painted: afterwards what was filled in is to be seen.
    const bool isTinted = isSeen && own != nullptr && (m_isPainting || m_shown.mode() == TextureMode::First);
    m_painted = isTinted ? paintedMask(own->mask.empty() ? QImage() : m_mask, own->strokes, tintSide)
                         : std::vector<std::uint8_t>();
    m_comparison.view().setTint(isTinted ? maskTint(m_painted, tintSide) : QImage());
}

void MaskCanvas::loadMask(const std::string& file)
{
    m_maskFile = file;
    m_mask = {};
    if (file.empty())
        return;
    CurrentAppearance& appearance = m_shown.appearance();
    appearance.context().jobs.start(
        {.name = tr("Reading a mask"),
         .receiver = this,
         .stillStands = [this, file] { return m_maskFile == file; },
         .background = true},
        [file](const Progress&) { return toQImage(readImage(file)); },
        [this](QImage mask) {
            m_mask = std::move(mask);
            refresh();
        });
}

/// While it is painted, over those that were painted before.
void MaskCanvas::showStroke(const MaskStrokeEntry& stroke)
{
    std::vector<std::uint8_t> mask = m_painted;
    mask.resize(std::size_t{tintSide} * tintSide);
    paintStrokes(std::span(&stroke, 1), tintSide, tintSide, mask);
    m_comparison.view().setTint(maskTint(mask, tintSide));
}

MaskStrokeEntry MaskCanvas::strokeOf(const QList<QPointF>& points) const
{
    MaskStrokeEntry stroke;
    stroke.radius = m_radius;
    stroke.erases = m_tool == MaskTool::Erase;
    const auto inside = [](double value) {
        constexpr double tenThousand = 1e4; // finer than any texel
        return std::round(std::clamp(value, 0.0, 1.0) * tenThousand) / tenThousand;
    };
    for (const QPointF& point : points) {
        const double u = inside(point.x());
        const double v = inside(point.y());
        const std::size_t size = stroke.points.size();
        if (size >= 2 && stroke.points[size - 2] == u && stroke.points[size - 1] == v)
            continue;
        stroke.points.insert(stroke.points.end(), {u, v});
    }
    return stroke;
}

void MaskCanvas::paint(const QList<QPointF>& points, bool committed)
{
    if (points.isEmpty())
        return;
    if (m_tool == MaskTool::FillChart) {
        if (committed)
            fillChart(points.front());
        return;
    }
    if (!committed) {
        showStroke(strokeOf(points));
        return;
    }
    addStrokes(m_tool == MaskTool::Erase ? tr("Erase a stroke of a mask") : tr("Paint a stroke of a mask"),
               {strokeOf(points)});
}

void MaskCanvas::addStrokes(const QString& text, const std::vector<MaskStrokeEntry>& strokes)
{
    const auto frame = m_shown.appearance().frame();
    if (!frame || strokes.empty())
        return;
    m_shown.appearance().edit(text, QStringLiteral("strokes"), [&](AppearanceEntry& entry) {
        auto found = std::ranges::find(entry.completions, *frame, &CompletionEntry::frame);
        if (found == entry.completions.end()) {
            entry.completions.push_back({.frame = *frame});
            found = std::prev(entry.completions.end());
        }
        found->strokes.insert(found->strokes.end(), strokes.begin(), strokes.end());
    });
}

/// Which texels a chart has is found in a job: there may be no model yet that knows.
void MaskCanvas::fillChart(const QPointF& place)
{
    CurrentAppearance& appearance = m_shown.appearance();
    const auto frame = appearance.frame();
    const MeshSequence* sequence =
        appearance.context().media.sequence(appearance.context().selection.shownSequence());
    const QSize size = m_comparison.view().image().size();
    if (!frame || sequence == nullptr || size.isEmpty())
        return;
    appearance.context().jobs.start(
        {.name = tr("Filling a chart"),
         .receiver = this,
         .stillStands = [this, frame] { return m_shown.appearance().frame() == frame; },
         .background = true},
        [topology = sequence->topology, size, place](const Progress&) {
            const UsedTexels texels = usedTexels(*topology, size.width(), size.height());
            const auto x =
                static_cast<std::uint32_t>(std::clamp(place.x() * size.width(), 0.0, size.width() - 1.0));
            const auto y = static_cast<std::uint32_t>(
                std::clamp((1 - place.y()) * size.height(), 0.0, size.height() - 1.0));
            const auto texel = y * static_cast<std::uint32_t>(size.width()) + x;
            const auto found = std::ranges::lower_bound(texels.texels, texel);
            if (found == texels.texels.end() || *found != texel)
                return std::vector<MaskStrokeEntry>();
            return strokesOver(texels,
                               texels.charts[static_cast<std::size_t>(found - texels.texels.begin())]);
        },
        [this](const std::vector<MaskStrokeEntry>& strokes) { addStrokes(tr("Mask a chart"), strokes); });
}

void MaskCanvas::add()
{
    const auto frame = m_shown.appearance().frame();
    if (!frame || completion() != nullptr)
        return;
    m_shown.appearance().edit(
        tr("Complete frame %1").arg(frameText(*frame)), QStringLiteral("completions"),
        [&](AppearanceEntry& entry) { entry.completions.push_back({.frame = *frame}); });
    m_shown.setContent(TextureContent::Completed);
}

void MaskCanvas::remove()
{
    const auto frame = m_shown.appearance().frame();
    if (!frame)
        return;
    m_shown.appearance().edit(tr("Do not complete frame %1").arg(frameText(*frame)),
                              QStringLiteral("completions"), [&](AppearanceEntry& entry) {
                                  std::erase_if(entry.completions, [&](const CompletionEntry& each) {
                                      return each.frame == *frame;
                                  });
                              });
}

void MaskCanvas::clear()
{
    const auto frame = m_shown.appearance().frame();
    if (completion() == nullptr)
        return;
    m_shown.appearance().edit(tr("Clear a mask"), QStringLiteral("strokes"), [&](AppearanceEntry& entry) {
        const auto found = std::ranges::find(entry.completions, *frame, &CompletionEntry::frame);
        found->strokes.clear();
        found->mask.clear();
    });
}

} // namespace quadrille

#include "moc_maskcanvas.cpp"
