// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/timelineintents.h"
#include "widgets/timeline/timelinelayout.h"

namespace quadrille::widgets {

/// Understands keys over a timeline; which ones is said there. It changes nothing itself.
class TimelineKeyboard : public TimelineIntents
{
    Q_OBJECT
public:
    /// \param layout  outlives the keyboard.
    explicit TimelineKeyboard(const TimelineLayout& layout) : m_layout(layout), m_content(layout.content()) {}
    /// Whether a key acts on what is selected, and so comes before shortcuts of the window.
    bool comesFirst(int key, Qt::KeyboardModifiers modifiers) const;
    /// \return whether the key means something.
    bool press(int key, Qt::KeyboardModifiers modifiers);

private:
    bool pressForSelected(int key, Qt::KeyboardModifiers modifiers);
    void moveSelected(int step, Qt::KeyboardModifiers modifiers);
    void selectNeighbour(int step);
    void setEndHere(bool isStart);
    void create();

    const TimelineLayout& m_layout;
    const TimelineContent& m_content;
};

} // namespace quadrille::widgets
