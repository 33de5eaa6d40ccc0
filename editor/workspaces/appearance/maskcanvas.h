// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/appearance/showntexture.h"

namespace quadrille {

class TextureComparison;

/// What a press on the texture does while masks are painted.
enum class MaskTool
{
    Paint,
    Erase,
    FillChart,
};

/// The mask of the texture that is looked at: shown as a tint over the texture view, and painted there. Every
/// stroke is an edit of its own.
class MaskCanvas : public QObject
{
    Q_OBJECT

public:
    /// Refers to both.
    MaskCanvas(ShownTexture& shown, TextureComparison& comparison, QObject* parent = nullptr);

    /// Null where the texture is not to be completed.
    const CompletionEntry* completion() const;
    bool isPainting() const { return m_isPainting; }
    /// With it the texture before completing is shown.
    void setPainting(bool painting);
    MaskTool tool() const { return m_tool; }
    void setTool(MaskTool tool);
    /// In widths of the texture.
    double radius() const { return m_radius; }
    void setRadius(double radius);

    /// Marks the texture of the frame as one to be completed; nothing happens where it is one.
    void add();
    /// Takes it out of the completions again, with its mask.
    void remove();
    /// Takes all strokes away.
    void clear();

signals:
    /// Tool, radius, or whether it is painted.
    void changed();

private:
    void refresh();
    void paint(const QList<QPointF>& points, bool committed);
    void fillChart(const QPointF& place);
    void addStrokes(const QString& text, const std::vector<MaskStrokeEntry>& strokes);
    MaskStrokeEntry strokeOf(const QList<QPointF>& points) const;
    void showStroke(const MaskStrokeEntry& stroke);
    void loadMask(const std::string& file);

    ShownTexture& m_shown;
    TextureComparison& m_comparison;
    bool m_isPainting = false;
    MaskTool m_tool = MaskTool::Paint;
    double m_radius = 0.02;
    std::string m_maskFile; ///< of `m_mask`
    QImage m_mask;          ///< the picture that strokes lie over; null for none
    std::vector<std::uint8_t>
        m_painted; ///< mask and strokes as the tint shows them; empty: nothing is tinted
};

/// Strokes that cover a chart: lines to and fro, some texels apart. \param chart  as in UsedTexels.
/// Cost: O(texels).
std::vector<MaskStrokeEntry> strokesOver(const UsedTexels& texels, std::uint16_t chart);

/// side × side, 1 where a mask marks. \param base  white where it does; may be null. \param strokes  over it,
/// in order.
std::vector<std::uint8_t> paintedMask(const QImage& base, std::span<const MaskStrokeEntry> strokes, int side);
/// A mask in colour, to be laid over a texture. \param mask  side × side.
QImage maskTint(std::span<const std::uint8_t> mask, int side);

} // namespace quadrille
