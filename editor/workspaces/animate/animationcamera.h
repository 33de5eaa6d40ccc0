// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"

#include <QObject>

namespace quadrille {

class CurrentAnimation;

namespace widgets {
class MomentLane;
} // namespace widgets

/// The camera of the animation that is worked on: its keys in a lane below the timeline, its actions, and the
/// view through it.
class AnimationCamera : public QObject
{
    Q_OBJECT

public:
    explicit AnimationCamera(CurrentAnimation& animation, QObject* parent = nullptr);

    /// Makes what is seen now a key at the playhead; in the place of one that stands there. A camera key
    /// counts as standing there within half a frame.
    void addKey();
    /// Makes the chosen key what is seen now. Nothing happens without one.
    void replaceKey();
    /// \param key  among those of the animation, from 0; −1: nothing happens.
    void removeKey(int key);
    /// The camera of the view follows the keys with the playhead; following the figure is switched off.
    void setLookingThrough(bool looks);
    widgets::MomentLane& lane() { return *m_lane; }

private:
    void makeActions();
    void refresh();
    void addKeyAt(double time);
    void moveKey(int key, double seconds, EditPhase phase);
    void goToKey(int key);
    void look();
    void updateActions();
    double fps() const;
    double playhead() const;

    CurrentAnimation& m_animation;
    widgets::MomentLane* m_lane;
    bool m_looksThrough = false;
};

} // namespace quadrille
