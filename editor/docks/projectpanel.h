// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/changeevent.h"

#include <QWidget>

class QMenu;
class QModelIndex;
class QTreeView;

namespace quadrille {

class ProjectTreeModel;
struct EditorContext;

/// Content of the Project dock: everything in the project with its state; selecting here selects everywhere.
class ProjectPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ProjectPanel(EditorContext& context, QWidget* parent = nullptr);

private:
    void makeActions();
    void updateActions();
    void takeSelection();
    void showSelection();
    void removeSelected();
    void duplicateSelected();
    void activate(const QModelIndex& index);
    /// Hides the section of what cannot be read while there is nothing in it.
    void hideEmpty();
    void showMenu(const QPoint& position);
    void fillSectionMenu(QMenu& menu, const QModelIndex& section);
    void fillEntryMenu(QMenu& menu, const EntryRef& entry);
    /// Names of the selected entries of the section that is selected.
    QStringList selectedNames(Section section) const;

    EditorContext& m_context;
    ProjectTreeModel* m_model;
    QTreeView* m_tree;
    bool m_isFollowing = false; ///< the tree is taking a selection over
};

} // namespace quadrille
