// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/workspace.h"
#include "model/transition/framepair.h"

#include <QTimer>
#include <optional>

class QLabel;
class QMenu;
class QStackedWidget;
class QTabWidget;

namespace quadrille {

class FramePictures;
class GapsPanel;
class GraphBar;
class GraphChartsPanel;
class GraphExplorer;
class GraphMap;
class GraphSettingsPanel;
class GraphStatePage;
class TransitionPanel;
class PairPreview;
class TransitionSpeeds;
struct EditorContext;

namespace widgets {
class MessageStrip;
struct TimelineSpan;
} // namespace widgets

/// The workspace in which transitions between all frames of a character are looked at: a map of their costs
/// beside a view of the frames and of the transition that is chosen.
class GraphWorkspace : public Workspace
{
    Q_OBJECT

public:
    explicit GraphWorkspace(EditorContext& context, QWidget* parent = nullptr);

    SceneView& view() override { return *m_view; }
    std::vector<Panel> panels() override { return m_panels; }
    void setActive(bool active) override;

    GraphExplorer& explorer() { return *m_explorer; }
    GraphMap& map() { return *m_map; }
    GraphBar& bar() { return *m_bar; }
    /// Chooses a transition and plays it. Where there is none between the frames, both frames are shown.
    /// Nothing happens before a graph is opened.
    void activate(const FramePair& pair);

private:
    void makeActions();
    void makeShowingActions();
    void makeModes();
    void makeMenuActions();
    void followSelection();
    void askWhatToDo(const FramePair& pair, const QPoint& globalPosition);
    void askAboutTakes(int from, int to, const QPoint& globalPosition);
    void addTakes(QMenu& menu, int from, int to);
    void listBest(int from, int to);
    void addBan(QMenu& menu, const FramePair& pair);
    void copyFrames();
    void makePanels();
    void arrangeWidgets();
    void connectParts();
    void followGraph();
    void showState();
    void showOverview();
    void updateActions();
    void choose(const FramePair& pair);
    void hover(const std::optional<FramePair>& pair);
    void showFrames(const FramePair& pair);
    void showClip();
    void showStrip(std::vector<widgets::TimelineSpan> spans);
    void stepAlpha(double factor);
    void saveTables();
    QString readOut(const FramePair& pair) const;
    void showReadOut();

    EditorContext& m_context;
    SceneView* m_view;
    GraphExplorer* m_explorer;
    PairPreview* m_preview;
    TransitionSpeeds* m_speeds;
    FramePictures* m_pictures;
    GraphBar* m_bar;
    GraphMap* m_map;
    GraphStatePage* m_statePage;
    widgets::MessageStrip* m_message;
    QLabel* m_readOut;
    QStackedWidget* m_pages;
    QTabWidget* m_tabs;
    TransitionPanel* m_transition;
    GraphChartsPanel* m_charts;
    GapsPanel* m_gaps;
    GraphSettingsPanel* m_settings;
    std::vector<Panel> m_panels;
    std::optional<FramePair> m_hovered;
    std::optional<FramePair> m_chosen;
    QTimer m_dwell; ///< how long the pointer must rest until frames are shown instead of a clip
    bool m_isActive = false;
    bool m_hasOverview = false; ///< shows costs from afar: the graph is being opened
};

} // namespace quadrille
