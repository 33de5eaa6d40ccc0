// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/relinking/relinkplan.h"

#include <QTreeWidget>

namespace quadrille {

/// What is lost, one row each: what uses it, where it was, whether it was found and where. A tick takes over
/// what was found.
class LostMediaTable : public QTreeWidget
{
    Q_OBJECT

public:
    enum Column
    {
        FileColumn,
        UsersColumn,
        StateColumn,
        OldColumn,
        NewColumn,
        ColumnCount,
    };

    explicit LostMediaTable(QWidget* parent = nullptr);

    void setPlan(const RelinkPlan& plan);
    /// The row's place in the plan; −1 without one.
    int currentMedium() const { return indexOfTopLevelItem(currentItem()); }
    void selectMedium(int medium) { setCurrentItem(topLevelItem(medium)); }
    /// \param medium  its place in the plan.
    bool isWanted(int medium) const;
    void retranslate();

    /// What is known of a medium, in a few words.
    static QString stateOf(const LostMedium& medium);
    /// The same in whole sentences.
    static QString explanationOf(const LostMedium& medium);

signals:
    /// A tick was set or taken away.
    void ticked();

private:
    static void fill(QTreeWidgetItem& item, const LostMedium& medium);
};

} // namespace quadrille
