// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/variations/partcurvetool.h"

#include <QTreeWidget>

namespace quadrille {

/// The parts of the body as a tree, each with its curves, and the curves that bound none; how many vertices
/// they have, and what is wrong with them. F2 or a double click renames, Delete removes.
class BodyPartsTree : public QTreeWidget
{
    Q_OBJECT

public:
    explicit BodyPartsTree(PartCurveTool& tool, QWidget* parent = nullptr);

    /// What is under the cursor.
    PartSelection current() const;

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void retranslate();
    void fill();
    void showSelection();
    void addCurve(QTreeWidgetItem* under, const std::string& name);
    /// \param why  what is wrong; empty when nothing is.
    void setUp(QTreeWidgetItem* item, const PartSelection& what, const QIcon& icon, std::size_t vertices,
               const QString& why) const;
    void rename(QTreeWidgetItem* item);

    PartCurveTool& m_tool;
    bool m_isFilling = false;
};

} // namespace quadrille
