// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>

class QMenu;

namespace quadrille {

class SceneView;
struct EditorContext;

/// The menu of the right mouse button in a view: what the menu View has for it, where the pointer is.
class ViewMenu : public QObject
{
    Q_OBJECT

public:
    ViewMenu(EditorContext& context, SceneView& view);

private:
    void show(const QPoint& globalPosition);
    void addActions(QMenu& menu, const QStringList& ids);

    EditorContext& m_context;
    SceneView& m_view;
};

} // namespace quadrille
