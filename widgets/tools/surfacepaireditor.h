// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/handletool.h"
#include "widgets/tools/surfacepairlayout.h"
#include "widgets/viewport/viewport.h"

namespace quadrille::widgets {

/// Pairs triangles of two figures: a click on one figure, then on the other, makes a pair; ends are dragged
/// over their figure. Shows the pairs that it was given, and tells what the user wants.
/// Keys: Tab goes from pair to pair, Delete removes the selected one, the arrow keys move the end that was
/// taken hold of last over the surface, Return asks for the missing end of a pair that was begun, Escape
/// gives it up. Ctrl leaves clicks to the camera.
class SurfacePairEditor : public HandleTool
{
    Q_OBJECT

public:
    explicit SurfacePairEditor(Viewport& viewport, QObject* parent = nullptr);

    /// The figures whose triangles are paired; none where one of them is negative.
    void setFigures(int first, int second);
    void setPairs(std::vector<SurfacePair> pairs);
    const std::vector<SurfacePair>& pairs() const { return m_content.pairs; }
    /// Shows the pairs and takes the clicks.
    void setActive(bool active);
    bool isActive() const { return m_active; }
    /// By its number; −1: none.
    void setSelected(int pair);
    int selected() const { return m_content.selected; }
    /// The first end of a pair that is being made.
    const std::optional<PairPlace>& begun() const { return m_content.begun; }
    void giveUpBegun();
    /// What is written at the lower end of the view; empty for nothing.
    void setHint(const QString& text);
    const QString& hint() const { return m_hint; }
    /// Where a pair's end is on the view; none where it cannot be seen.
    std::optional<QPointF> pixelOf(const PairEnd& end) const;

    void paint(QPainter& painter) const override;
    bool isDragging() const override { return m_drag.has_value(); }
    bool isDrawing() const override { return m_content.begun.has_value(); }

signals:
    /// The user paired two triangles.
    void pairRequested(std::uint32_t first, std::uint32_t second);
    /// One end is to be at another triangle. \param committed  false while it is dragged.
    void moveRequested(int pair, int side, std::uint32_t triangle, bool committed);
    void removalRequested(int pair);
    void selectionChanged(int pair);
    /// A pair was begun, made or given up.
    void begunChanged();
    /// The missing end of the pair that was begun is to be proposed.
    void counterpartRequested();
    void contextMenuRequested(int pair, const QPoint& globalPosition);

protected:
    void viewChanged() override { m_seen.reset(); }
    bool isReady() const override { return m_active && layout(); }
    bool press(const QMouseEvent& event) override;
    bool move(const QMouseEvent& event) override;
    bool release(const QMouseEvent& event) override;
    bool doubleClick(const QMouseEvent& /*event*/) override { return false; }
    void leave() override { m_hovered = {}; }
    bool wantsKey(const QKeyEvent& event) const override;
    void endDrag(bool commit) override;
    void leaveDrawing() override { giveUpBegun(); }
    void clearSelection() override { setSelected(-1); }
    void confirm() override;
    void insertByKey() override {}
    void askMenuByKey() override;
    bool removeByKey() override;
    bool selectNext(int step) override;
    bool pressOther(const QKeyEvent& event) override;

private:
    struct Drag
    {
        PairEnd end;
        std::uint32_t before = 0; ///< the triangle that it was at
        QPointF pressedAt;
        bool isMoved = false;
    };

    /// None where there are no two figures to look at.
    std::optional<SurfacePairLayout> layout() const;
    void click(const PairPlace& place);

    Viewport& m_viewport;
    std::array<int, 2> m_figures{-1, -1};
    SurfacePairContent m_content;
    mutable SeenEnds m_seen;
    bool m_active = false;
    PairEnd m_hovered;
    int m_side = 1; ///< of the end that keys move
    std::optional<Drag> m_drag;
    std::optional<QPointF> m_pressedAt; ///< of a press that was left to the camera
    QPointF m_pointer;
    QString m_hint;
};

} // namespace quadrille::widgets
