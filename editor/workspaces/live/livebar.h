// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QComboBox;
class QProgressBar;

namespace quadrille {

class LivePaths;
class LiveSession;
struct EditorContext;

namespace widgets {
class ElidedLabel;
} // namespace widgets

/// Plays and records, and tells which recorded performance is looked at.
class LiveBar : public QWidget
{
    Q_OBJECT

public:
    /// \pre The actions of the workspace are registered.
    LiveBar(EditorContext& context, LiveSession& session, LivePaths& paths, QWidget* parent = nullptr);

    /// How far the motion spaces are. \param share  0 … 1; nothing is under way where it is negative.
    void showProgress(double share);

private:
    void retranslate();
    void refresh();
    void refreshPaths();
    void showState();

    EditorContext& m_context;
    LiveSession& m_session;
    LivePaths& m_paths;
    QComboBox* m_names;
    QComboBox* m_path;
    QProgressBar* m_progress;
    widgets::ElidedLabel* m_state;
};

} // namespace quadrille
