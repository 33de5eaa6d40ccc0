// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/surfaceview.h"

#include <QColor>
#include <QString>
#include <array>
#include <optional>
#include <vector>

namespace quadrille::widgets {

/// Triangles of two figures that belong together.
struct SurfacePair
{
    std::array<std::uint32_t, 2> triangles{};
    QColor color;
    bool isDoubtful = false; ///< shown as a cross
    QString name;            ///< said beside it while it is hovered or selected

    bool operator==(const SurfacePair&) const = default;
};

/// One end of a pair.
struct PairEnd
{
    int pair = -1; ///< none where negative
    int side = 0;  ///< which of the two figures

    bool isNone() const { return pair < 0; }
    bool operator==(const PairEnd&) const = default;
};

/// A triangle of one of the figures.
struct PairPlace
{
    int side = 0;
    std::uint32_t triangle = 0;

    bool operator==(const PairPlace&) const = default;
};

struct SurfacePairContent
{
    std::vector<SurfacePair> pairs;
    std::optional<PairPlace> begun; ///< the first end of a pair that is being made
    int selected = -1;
};

/// Which ends can be seen: for each pair of each side. Kept until camera, figures or pairs change.
using SeenEnds = std::optional<std::vector<std::array<bool, 2>>>;

/// Where the ends of pairs are on the view.
class SurfacePairLayout
{
public:
    SurfacePairLayout(const SurfacePairContent& content, std::array<SurfaceView, 2> views, SeenEnds& seen);

    const SurfacePairContent& content() const { return m_content; }
    const std::array<SurfaceView, 2>& views() const { return m_views; }
    bool isSeen(const PairEnd& end) const;
    /// None behind the camera, and where the figure has no such triangle; so for the next.
    std::optional<QPointF> pixelOf(const PairEnd& end) const;
    std::optional<QPointF> pixelOf(const PairPlace& place) const;
    /// The seen end under a pixel.
    PairEnd endAt(const QPointF& pixel) const;
    /// What of the figures is under it: of both the nearer.
    std::optional<PairPlace> placeAt(const QPointF& pixel) const;

private:
    bool has(const PairPlace& place) const;
    PairPlace placeOf(const PairEnd& end) const;
    const std::vector<std::array<bool, 2>>& seen() const;

    const SurfacePairContent& m_content;
    std::array<SurfaceView, 2> m_views;
    SeenEnds& m_seen;
};

} // namespace quadrille::widgets
