// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/animate/junctions.h"

#include <QTimer>
#include <QWidget>

class QLabel;
class QShortcut;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace quadrille {

class CurrentAnimation;
class JunctionInspector;
class TransitionPreview;

namespace widgets {
class MessageStrip;
} // namespace widgets

/// The transitions of the clip that is shown: where they are and what they cost, to be played, banned, locked
/// or exchanged for others nearby; and the decisions that were made about them.
class JunctionPanel : public QWidget
{
    Q_OBJECT

public:
    /// Registers the actions.
    explicit JunctionPanel(CurrentAnimation& animation, QWidget* parent = nullptr);

    /// What is looked at in place of the clip while another transition is chosen.
    TransitionPreview& preview() { return *m_preview; }
    /// Selects a transition of the walk by its number. \param junction  from 0.
    void select(int junction);
    /// Where the preview begins in the clip, frames; 0 where nothing tells.
    int previewStart() const;

signals:
    /// −1 when none is selected any more.
    void junctionSelected(int junction);

protected:
    void showEvent(QShowEvent* event) override;

private:
    struct KeptJunction
    {
        FramePair frames;
        int place = 0; ///< in the walk
    };

    void followVisibility(bool visible);
    void makeActions();
    void makeDecidingActions();
    void makeWalkActions();
    void makeLists();
    void arrangeWidgets();
    void retranslate();

    void refresh();
    void refreshJunctions();
    void keepCurrent();
    void refreshDecisions();
    void refreshAlternatives();
    void updateActions();
    void showDetails();
    void showQuality();
    void inspectCurrent();
    void showState();
    void previewAlternative(const QTreeWidgetItem* item);

    /// −1 where none is selected.
    int current() const;
    const ClipJunction* currentJunction() const;
    void step(int direction);
    void goTo(int junction);
    void playAround(int junction);
    void setChoosing(bool choosing);
    void chooseCurrent();
    void decide(const QString& text, const std::function<void(JunctionsEntry&)>& edit);
    void banCurrent();
    void banNeighbours();
    void toggleLock();
    void lockSegment();
    void removeDecision();
    void acceptWalk();
    void releaseWalk();

    CurrentAnimation& m_animation;
    TransitionPreview* m_preview;
    JunctionInspector* m_inspector;
    std::shared_ptr<const AnimationResult> m_result; ///< that the lists are of
    std::vector<ClipJunction> m_junctions;
    std::optional<KeptJunction> m_kept; ///< that the user selected
    std::vector<PricedJunction> m_alternatives;
    std::vector<JunctionEntry> m_decisions;
    QTimer m_delay; ///< before what is hovered is blended
    const QTreeWidgetItem* m_hovered = nullptr;
    std::vector<QShortcut*> m_escapes; ///< which end choosing, of the panel and the view
    bool m_isChoosing = false;
    bool m_isRefreshing = false;
    bool m_playsAround = false;

    widgets::MessageStrip* m_message;
    QTreeWidget* m_list;
    QLabel* m_details;
    QLabel* m_quality;
    QLabel* m_alternativesTitle;
    QTreeWidget* m_alternativesList;
    QLabel* m_decisionsTitle;
    QTreeWidget* m_decisionsList;
    QLabel* m_empty;
    QWidget* m_buttons;
};

} // namespace quadrille
