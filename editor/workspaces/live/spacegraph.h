// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/graph/takegraphview.h"

#include <QImage>
#include <functional>

namespace quadrille {

class LiveSession;
struct EditorContext;

/// The motion spaces that can be played as a graph, with the transitions that were made. A click on a space
/// wants it. It is edited there, too: takes that are dropped onto a space are added to it, those that are
/// dropped beside all become another one, and the right button offers what can be done with a space.
class SpaceGraph : public widgets::TakeGraphView
{
    Q_OBJECT

public:
    /// A picture of a motion space; null until there is one.
    using Picture = std::function<QImage(const QString& space)>;

    /// Refers to context and session.
    SpaceGraph(EditorContext& context, LiveSession& session, Picture picture, QWidget* parent = nullptr);

    /// There are other pictures.
    void showPictures();

protected:
    bool event(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void refresh();
    void retranslate();
    QString nameOf(int space) const;
    /// Selects a space in the project.
    void select(int space);
    void showMenu(int from, int to, const QPoint& place);
    /// Goes to the last of the transitions from one space to another.
    void goToLast(int from, int to);

    EditorContext& m_context;
    LiveSession& m_session;
    Picture m_picture;
};

} // namespace quadrille
