// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/relinking/relinkplan.h"

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <set>

class QWidget;

namespace quadrille {

class Job;
struct EditorContext;

namespace widgets {
class MessageStrip;
} // namespace widgets

/// Notices media that are not where the open project says, offers to find them, and notes the contents of
/// those that are there so that they can be found.
class RelinkFlow : public QObject
{
    Q_OBJECT

public:
    /// \param window what dialogs belong to.
    RelinkFlow(EditorContext& context, QWidget* window);

    /// Says how many files are missing; hidden while there are none. For the window to place, which owns it.
    widgets::MessageStrip* strip() const { return m_strip; }
    /// Notes the contents of the project's media beside it, in the background; when it was saved.
    void noteContents();

signals:
    /// \param media  how many have another path.
    void relinked(int media);

private:
    void look();
    void takeMissing(const std::vector<MediaUse>& missing);
    void showStrip();
    void ask();

    EditorContext& m_context;
    QWidget* m_window;
    widgets::MessageStrip* m_strip;
    QTimer m_timer; ///< several changes are looked at once
    QPointer<Job> m_looking;
    QPointer<Job> m_noting;
    std::set<std::string> m_missing; ///< paths
    QString m_folder;                ///< searched last
};

} // namespace quadrille
