// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/jobs/job.h"
#include "model/graph/costoverview.h"
#include "model/transition/framepair.h"
#include "model/transition/posedistancesettings.h"
#include "widgets/graph/matrixpyramid.h"
#include "widgets/theme/colormap.h"

#include <QPointer>
#include <QWidget>
#include <optional>

class QDoubleSpinBox;
class QAction;
class QHBoxLayout;
class QLabel;
class QSpinBox;
class QStackedWidget;
class QToolButton;

namespace quadrille {

class FramePictures;
class GraphExplorer;
class JobRunner;

namespace widgets {
class ArcView;
class MatrixView;
class TakeGraphView;
} // namespace widgets

/// The transitions of a character to be picked: as a table of costs with the edges of both graphs, as arcs
/// over the sequences, or counted between them; with filters for what the table shows in colour.
class GraphMap : public QWidget
{
    Q_OBJECT

public:
    enum class Mode
    {
        Matrix,
        Arcs,
        Takes,
    };

    GraphMap(GraphExplorer& explorer, FramePictures& pictures, JobRunner& jobs, QWidget* parent = nullptr);

    /// Puts buttons of actions above the map; a null one is a gap.
    void addTools(const QList<QAction*>& actions);

    widgets::MatrixView& matrix() { return *m_matrix; }
    widgets::ArcView& arcs() { return *m_arcs; }
    widgets::TakeGraphView& takes() { return *m_takes; }
    void setMode(Mode mode);
    void setEdgesVisible(bool essential, bool motion);
    /// Shows costs from afar until a character is there, whose own come in their place. They cannot be
    /// pointed at. \param overview  null for none. \param sequences  names, as many as it has.
    void showOverview(std::shared_ptr<const CostOverview> overview, const QStringList& sequences,
                      PoseMetric metric);
    /// The rate of the project, for lengths in seconds.
    void setFps(double fps);
    /// Shows what is chosen; emits nothing.
    void setCurrent(const std::optional<FramePair>& pair);

signals:
    void hovered(const std::optional<quadrille::FramePair>& pair);
    /// A cell or an arc was clicked, or activated by keyboard.
    void activated(const quadrille::FramePair& pair);
    /// The keyboard moved to a cell.
    void moved(const quadrille::FramePair& pair);
    /// What can be done with a cell is asked for.
    void menuRequested(const quadrille::FramePair& pair, const QPoint& globalPosition);
    /// What can be done with a take, or with the transitions from one to another, is asked for. \param from,
    /// to  places of takes in the character's layout; equal for a take itself.
    void takesMenuRequested(int from, int to, const QPoint& globalPosition);
    /// All takes are to be looked at again.
    void filterDropped();

private:
    void makeFilters();
    void makeTakeFilter();
    void connectViews();
    void followCharacter();
    void followReplacement();
    void followGraphs();
    void showArcs();
    void showTakes();
    void showMode();
    void showTakeFilter();
    void showPictures();
    void followFilter();
    void buildPicture();
    widgets::MatrixValues values() const;
    widgets::MatrixFilter filter() const;
    void retranslate();

    GraphExplorer& m_explorer;
    FramePictures& m_pictures;
    JobRunner& m_jobs;
    QStackedWidget* m_pages;
    widgets::MatrixView* m_matrix;
    widgets::ArcView* m_arcs;
    widgets::TakeGraphView* m_takes;
    QWidget* m_filters;
    QHBoxLayout* m_tools;
    QLabel* m_costLabel;
    QDoubleSpinBox* m_largestCost;
    QLabel* m_lengthLabel;
    QSpinBox* m_shortest;
    QSpinBox* m_longest;
    QLabel* m_kept;
    QToolButton* m_takeFilter;
    QPointer<Job> m_job;
    std::optional<widgets::MatrixFilter> m_shown; ///< what the picture was made for
    std::shared_ptr<const CostOverview> m_overview;
    std::shared_ptr<const widgets::MatrixPyramid> m_pyramid;
    widgets::ScalarRange m_range;
    bool m_arcsAreOld = true;
    bool m_takesAreOld = true;
    bool m_countsMotion = false; ///< the overview counts the motion graph's transitions
    double m_fps = 25;
};

/// "rad" or "m": in what a character's costs are.
QString costUnit(const GraphExplorer& explorer);
QString costUnit(PoseMetric metric);

} // namespace quadrille
