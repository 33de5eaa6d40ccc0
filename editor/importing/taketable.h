// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/importing/importplan.h"

#include <QTreeWidget>

namespace quadrille {

class JobRunner;

/// The takes of an import: wanted or not, a thumbnail, a name to edit, what each holds and what is wrong with
/// it.
class TakeTable : public QTreeWidget
{
    Q_OBJECT

public:
    explicit TakeTable(JobRunner& jobs, QWidget* parent = nullptr);

    /// Shows the takes of a plan; those that were shown before with the same source keep name and tick.
    void setPlan(const ImportPlan& plan);
    /// Shows what changed in the plan of the same takes; their pictures stay.
    void showValues(const ImportPlan& plan);
    /// The row's place in the plan; −1 without one.
    int currentTake() const { return indexOfTopLevelItem(currentItem()); }
    /// \param take  its place in the plan; so below. \pre There is one.
    bool isWanted(int take) const;
    QString nameOf(int take) const;
    void retranslate();

signals:
    /// A tick or a name is another.
    void edited();

private:
    enum Column
    {
        NameColumn,
        FramesColumn,
        RateColumn,
        MeshColumn,
        TextureColumn,
        ColumnCount,
    };

    void fill(QTreeWidgetItem& item, const PlannedTake& planned) const;
    void drawThumbnail(int take, const MeshSequence& sequence, const CoordinateSystem& axes);

    JobRunner& m_jobs;
    int m_generation = 0; ///< counts plans, so that a thumbnail that comes too late is dropped
};

} // namespace quadrille
