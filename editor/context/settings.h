// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/theme/theme.h"
#include "widgets/viewport/mousegestures.h"

#include <QKeySequence>
#include <QObject>
#include <QSettings>
#include <QStringList>

namespace quadrille {

/// What the user prefers, on this computer, in every project. Kept in the usual place of the desktop.
class Settings : public QObject
{
    Q_OBJECT

public:
    static constexpr int maximalRecent = 12;

    explicit Settings(QObject* parent = nullptr);

    widgets::Theme::Mode theme() const;
    void setTheme(widgets::Theme::Mode mode);
    /// Code such as "fr"; empty follows the system.
    QString language() const;
    void setLanguage(const QString& code);
    /// Seconds between two autosaves; 0 switches them off. Never above 10, which it is unless set.
    int autosaveSeconds() const;
    void setAutosaveSeconds(int seconds);
    /// Megabytes that the undo history may take. 64 unless set.
    int historyMegabytes() const;
    void setHistoryMegabytes(int megabytes);
    bool loopsPlayback() const;
    void setLoopsPlayback(bool loops);
    /// A place in CardOrder::By.
    int cardOrder() const;
    void setCardOrder(int order);
    /// Which drags of the mouse move the camera of views.
    widgets::MousePreset mousePreset() const;
    void setMousePreset(widgets::MousePreset preset);
    /// How curves are drawn on bodies.
    struct CurveDrawing
    {
        bool snaps = true;        ///< points jump to creases
        double snapRadius = 0.02; ///< how far they jump, metres
        double overlap = 0.075;   ///< between the two curves of a part, metres over the surface
    };
    CurveDrawing curveDrawing() const;
    void setCurveDrawing(const CurveDrawing& drawing);

    /// Project files, last used first.
    QStringList recentProjects() const;
    void addRecentProject(const QString& file);
    void removeRecentProject(const QString& file);

    /// The user's shortcuts of an action; its own when the user has not changed them.
    QList<QKeySequence> shortcuts(const QString& action, const QList<QKeySequence>& own) const;
    /// \param own the action's own shortcuts: equal ones are not stored.
    void setShortcuts(const QString& action, const QList<QKeySequence>& shortcuts,
                      const QList<QKeySequence>& own);

signals:
    /// One of the values above the shortcuts is another now.
    void changed();
    void recentProjectsChanged();

private:
    void set(const QString& key, const QVariant& value);

    QSettings m_store;
};

} // namespace quadrille
