// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QFont>
#include <QObject>
#include <QPalette>
#include <QString>
#include <QtGlobal>
#include <array>

namespace quadrille::widgets {

/// A colour by what it is for; the values are in resources/themes/{dark,light}.json under the same names.
enum class ColorRole
{
    Window,
    Base,
    Raised,
    Hover,
    Pressed,
    Divider, ///< between areas, decorative
    Line,    ///< outlines of controls
    Text,
    TextMuted,
    TextDisabled,
    Accent,     ///< fills
    AccentText, ///< accent as text or line
    OnAccent,
    Selection,
    OnSelection,
    ViewportTop,
    ViewportBottom,
    ViewportText,
    Grid,
    AxisX,
    AxisY,
    AxisZ,
    Clay,
    Wire,
    Original, ///< frames that were captured
    Synthetic,
    Key,
    Demanded, ///< a label that was asked for
    Error,
    ErrorText,
    Warning,
    WarningText,
    Success,
    SuccessText,
    OnMark, ///< text on the meaning colours
    Count
};

/// The colours of one theme.
class ThemeColors
{
public:
    /// Reads a table of named colours. \pre the file holds every name of ColorRole.
    static ThemeColors fromFile(const QString& path);
    QColor operator[](ColorRole role) const { return m_colors[static_cast<std::size_t>(role)]; }
    /// The name of a role in the table, e.g. "textMuted".
    static QString name(ColorRole role);

private:
    std::array<QColor, static_cast<std::size_t>(ColorRole::Count)> m_colors;
};

/// The look of the application: Fusion style, palette and a small style sheet from one table of colours.
/// There is one, made at its first use; it needs a QApplication.
class Theme : public QObject
{
    Q_OBJECT
public:
    enum class Mode
    {
        System,
        Light,
        Dark
    };

    static Theme& instance();
    /// The current colour of a role.
    static QColor color(ColorRole role) { return instance().m_colors[role]; }
    /// Colour of the n-th sequence or variation: Okabe–Ito, then Tableau 10, then over again. \param index
    /// from 0.
    static QColor categorical(int index);
    /// The application font with digits of equal width, for numbers that change.
    static QFont tabularFont(const QFont& base);
    /// Black or white, whichever reads better on a background.
    static QColor textOn(const QColor& background);
    /// Contrast ratio of two colours after WCAG, 1 … 21.
    static double contrast(const QColor& a, const QColor& b);
    /// How long an explaining movement lasts: 140 ms, or 0 where the system asks for no motion.
    static int animationMilliseconds();

    /// Puts style, palette and style sheet onto the application. Call once after constructing it.
    void install();
    Mode mode() const { return m_mode; }
    bool isDark() const { return m_dark; }
    /// Takes effect at once everywhere.
    void setMode(Mode mode);
    const ThemeColors& colors() const { return m_colors; }
    /// What the desktop asks for: settings portal, then GTK theme name, then the palette Qt started with.
    bool systemIsDark() const;

signals:
    /// The colours are new; palettes have been replaced already.
    void changed();

private:
    Theme();
    void apply();
    QPalette palette() const;
    QString styleSheet() const;
    void watchSystem();

    Mode m_mode = Mode::System;
    bool m_dark = true;
    bool m_installed = false;
    bool m_startedDark = false;
    ThemeColors m_colors;

private slots:
    void onPortalSetting(const QString& group, const QString& key);
};

/// While it lives, new widgets have no style sheet; all get it at once when it goes. Qt looks up the style of
/// all that is in a widget each time that is put into another, which takes longer than all else about a
/// window of many panels. To be used before the first window is shown: those that are there lose theirs, too.
class StyleWhenComplete
{
public:
    StyleWhenComplete();
    ~StyleWhenComplete();
    Q_DISABLE_COPY_MOVE(StyleWhenComplete)

private:
    QString m_sheet;
};

} // namespace quadrille::widgets
