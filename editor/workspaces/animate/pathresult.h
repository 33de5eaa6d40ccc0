// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/walks/pathfollowing.h"
#include "widgets/viewport/scenemarks.h"

#include <QObject>

namespace quadrille {

class CurrentAnimation;
struct AnimationResult;

/// Draws the way of a result into the view: captured parts drawn through, synthetic ones dashed, and for each
/// frame how far it is from where the path wants it.
class PathResult : public QObject
{
    Q_OBJECT

public:
    /// Registers the action that shows deviations.
    explicit PathResult(CurrentAnimation& animation, QObject* parent = nullptr);

    /// Lines from where the body is to where it was to be.
    void setDeviationShown(bool shown);

private:
    void refresh();
    widgets::SceneMarks marks(const AnimationResult& result) const;
    void addWay(const AnimationResult& result, widgets::SceneMarks& marks) const;
    void addDeviation(const AnimationResult& result, widgets::SceneMarks& marks) const;
    widgets::SceneLabel worstLabel(const AnimationResult& result) const;
    void showFrame();

    CurrentAnimation& m_animation;
    bool m_isDeviationShown = true;
    bool m_isFrameMarked = false;
    std::vector<FollowedFrame> m_followed;      ///< of the frames of the result that is drawn
    std::optional<widgets::SceneLabel> m_worst; ///< where the clip is farthest from the path
};

} // namespace quadrille
