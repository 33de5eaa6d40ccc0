// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

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
    void takeSelection();

    EditorContext& m_context;
    ProjectTreeModel* m_model;
    QTreeView* m_tree;
};

} // namespace quadrille
