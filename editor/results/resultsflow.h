// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/store/resultplaces.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <filesystem>

class QWidget;

namespace quadrille {

struct EditorContext;

namespace widgets {
class MessageStrip;
} // namespace widgets

/// Where the results of the open project go: lets the user choose a folder, says so when they go elsewhere
/// because they cannot be stored where they belong, and stores those that are in memory only as soon as that
/// is possible. Looks every few seconds, beside the interface: folders on a network may be slow.
class ResultsFlow : public QObject
{
    Q_OBJECT

public:
    /// \param window what dialogs belong to.
    ResultsFlow(EditorContext& context, QWidget* window);
    ~ResultsFlow() override;

    /// Says that results are not where they should be; hidden while they are. For the window to place, which
    /// owns it.
    widgets::MessageStrip* strip() const { return m_strip; }

private:
    struct Seen
    {
        std::filesystem::path project;
        ResultPlaces places;
        int unstored = 0; ///< results that are in memory only
    };
    static Seen lookAt(const std::filesystem::path& project);
    void followFile();
    void look();
    void take(const Seen& seen);
    void showStrip();
    void ask();

    EditorContext& m_context;
    QWidget* m_window;
    widgets::MessageStrip* m_strip;
    Seen m_seen;
    QTimer m_timer; ///< folders become writable, and cease to be, without a word
    bool m_isLooking = false;
    QThreadPool m_looker;
};

} // namespace quadrille
