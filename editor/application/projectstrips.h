// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/mediawatch.h"

#include <QWidget>

namespace quadrille {

class ProjectFiles;
struct EditorContext;

namespace widgets {
class MessageStrip;
} // namespace widgets

/// What is to be said about the files of the open project, above everything else: that it cannot be saved
/// here, was changed by somebody else, or cannot be read whole; each as long as it is so.
class ProjectStrips : public QWidget
{
    Q_OBJECT

public:
    ProjectStrips(EditorContext& context, ProjectFiles& files, QWidget* parent = nullptr);

    MediaWatch& media() { return m_media; }

signals:
    /// The project shall be shown anew with its media as they are now.
    void aboutToRefresh();
    /// What cannot be read was selected and wants to be seen.
    void brokenShown();

private:
    widgets::MessageStrip* addStrip(const char* name);
    void showAccess();
    void showChanged();
    void showBroken();
    void tellBroken();
    void showMedia();
    void retranslate();

    EditorContext& m_context;
    ProjectFiles& m_files;
    MediaWatch m_media;
    QStringList m_broken;     ///< titles that the issues tell of
    bool m_isChanged = false; ///< the file, by somebody else
    widgets::MessageStrip* m_accessStrip;
    widgets::MessageStrip* m_changedStrip;
    widgets::MessageStrip* m_brokenStrip;
    widgets::MessageStrip* m_mediaStrip;
};

} // namespace quadrille
