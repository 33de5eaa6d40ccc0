// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "model/project/document/animationentry.h"
#include "widgets/timeline/draggedframes.h"

#include <QWidget>

class QPushButton;
class QScrollArea;

namespace quadrille {

class ActionForm;
class CurrentAnimation;
class FramePictures;
class LabelList;

namespace widgets {
class Storyboard;
struct StoryCard;
} // namespace widgets

/// What is performed in the animation, one after the other: labels to take from, cards, and the values of the
/// card that is selected.
class StoryboardPanel : public QWidget
{
    Q_OBJECT

public:
    StoryboardPanel(CurrentAnimation& animation, FramePictures& pictures, QWidget* parent = nullptr);

    /// Puts takes and labels behind the card that is selected, or at the end.
    void add(const std::vector<widgets::DraggedFrames>& frames);

signals:
    /// An action is to be seen where the clip performs it; output frames.
    void actionChosen(const quadrille::FrameRange& frames);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void connectBoard();
    void refresh();
    void fit();
    void fillLabelMenu();
    void showAction();
    void insert(int before, const std::vector<widgets::DraggedFrames>& frames);
    void move(int card, int before);
    void copy(int card, int before);
    void remove(int card);
    void set(std::vector<ActionEntry> actions, const QString& text, int current);
    void showMenu(int card, const QPoint& position);
    void goTo(int card);
    std::vector<ActionEntry> actions() const;
    widgets::StoryCard cardOf(const ActionEntry& action, const std::optional<FrameRange>& obtained) const;
    std::optional<NamedFrame> poseOf(const FrameChoice& frames) const;

    CurrentAnimation& m_animation;
    FramePictures& m_pictures;
    LabelList* m_labels;
    widgets::Storyboard* m_board;
    ActionForm* m_form;
    QScrollArea* m_values; ///< around the form
    QPushButton* m_addLabel;
};

} // namespace quadrille
