// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/viewtool.h"

#include <QPointF>
#include <algorithm>
#include <vector>

class QKeyEvent;
class QMouseEvent;

namespace quadrille::widgets {

/// A tool with handles that are selected, dragged and walked over by keys, and with modes in which something
/// is drawn. Here is what events and keys mean in all such tools; what they do is said by each.
class HandleTool : public ViewTool
{
    Q_OBJECT
public:
    using ViewTool::ViewTool;

    bool handle(QEvent& event) override;

    virtual bool isDragging() const = 0;
    virtual bool isDrawing() const = 0;
    /// Whether the pointer went far enough from a press for it to be no click. Positions are pixels of the
    /// view.
    static bool isDrag(const QPointF& pressedAt, const QPointF& position);

protected:
    /// Whether events are for the tool at all.
    virtual bool isReady() const = 0;
    virtual bool press(const QMouseEvent& event) = 0;
    virtual bool move(const QMouseEvent& event) = 0;
    virtual bool release(const QMouseEvent& event) = 0;
    virtual bool doubleClick(const QMouseEvent& event) = 0;
    /// The pointer left the view.
    virtual void leave() = 0;
    /// Whether a key is the tool's now.
    virtual bool wantsKey(const QKeyEvent& event) const = 0;
    /// \param commit  false: all is as it was before the drag.
    virtual void endDrag(bool commit) = 0;
    virtual void leaveDrawing() = 0;
    virtual void clearSelection() = 0;
    /// Return: ends drawing, or acts on what is selected.
    virtual void confirm() = 0;
    virtual void insertByKey() = 0;
    virtual void askMenuByKey() = 0;
    /// Delete and Backspace: take back, or away what is selected.
    virtual bool removeByKey() = 0;
    /// Tab. \return false at the end, so that the keyboard goes on to another widget.
    virtual bool selectNext(int step) = 0;
    /// Any other key that wantsKey() takes.
    virtual bool pressOther(const QKeyEvent& event) = 0;

    /// The part so many steps from the selected one; a part that is none beyond the ends.
    template <typename Part>
    static Part partAfter(const std::vector<Part>& parts, const Part& selected, int step)
    {
        const auto found = std::find(parts.begin(), parts.end(), selected);
        const auto count = static_cast<int>(parts.size());
        const int next = found != parts.end() ? static_cast<int>(found - parts.begin()) + step
                         : step > 0           ? 0
                                              : count - 1;
        return next >= 0 && next < count ? parts[static_cast<std::size_t>(next)] : Part{};
    }

private:
    bool pressKey(const QKeyEvent& event);
};

} // namespace quadrille::widgets
