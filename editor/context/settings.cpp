// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/context/settings.h"

#include <QFileInfo>
#include <algorithm>
#include <array>

namespace quadrille {

namespace {

using widgets::Theme;

constexpr auto themeKey = "theme";
constexpr auto languageKey = "language";
constexpr auto autosaveKey = "autosaveSeconds";
constexpr auto historyKey = "historyMegabytes";
constexpr auto loopKey = "loopPlayback";
constexpr auto cardOrderKey = "cardOrder";
constexpr auto mouseKey = "mousePreset";
/// As they are stored, in the order of widgets::MousePreset.
constexpr std::array mousePresets{"quadrille", "blender", "maya", "paraview"};
constexpr auto snapsKey = "curves/snaps";
constexpr auto snapRadiusKey = "curves/snapRadius";
constexpr auto overlapKey = "curves/overlap";
constexpr auto recentKey = "recentProjects";

QString shortcutKey(const QString& action)
{
    return QStringLiteral("shortcuts/") + action;
}

} // namespace

Settings::Settings(QObject* parent) : QObject(parent) {}

void Settings::set(const QString& key, const QVariant& value)
{
    if (m_store.value(key) == value)
        return;
    m_store.setValue(key, value);
    emit changed();
}

Theme::Mode Settings::theme() const
{
    const QString name = m_store.value(themeKey).toString();
    if (name == QLatin1String("light"))
        return Theme::Mode::Light;
    if (name == QLatin1String("dark"))
        return Theme::Mode::Dark;
    return Theme::Mode::System;
}

void Settings::setTheme(Theme::Mode mode)
{
    switch (mode) {
    case Theme::Mode::System:
        return set(themeKey, QStringLiteral("system"));
    case Theme::Mode::Light:
        return set(themeKey, QStringLiteral("light"));
    case Theme::Mode::Dark:
        return set(themeKey, QStringLiteral("dark"));
    }
}

QString Settings::language() const
{
    return m_store.value(languageKey).toString();
}

void Settings::setLanguage(const QString& code)
{
    set(languageKey, code);
}

int Settings::autosaveSeconds() const
{
    // Edits older than this are never without a copy, unless there shall be none at all.
    constexpr int longest = 10;
    return std::clamp(m_store.value(autosaveKey, longest).toInt(), 0, longest);
}

void Settings::setAutosaveSeconds(int seconds)
{
    set(autosaveKey, seconds);
}

int Settings::historyMegabytes() const
{
    return m_store.value(historyKey, 64).toInt();
}

void Settings::setHistoryMegabytes(int megabytes)
{
    set(historyKey, megabytes);
}

bool Settings::loopsPlayback() const
{
    return m_store.value(loopKey, true).toBool();
}

void Settings::setLoopsPlayback(bool loops)
{
    set(loopKey, loops);
}

int Settings::cardOrder() const
{
    return m_store.value(cardOrderKey, 0).toInt();
}

void Settings::setCardOrder(int order)
{
    set(cardOrderKey, order);
}

widgets::MousePreset Settings::mousePreset() const
{
    const QString name = m_store.value(mouseKey).toString();
    const auto* found =
        std::ranges::find_if(mousePresets, [&name](const char* each) { return name == QLatin1String(each); });
    return found == mousePresets.end() ? widgets::MousePreset::Quadrille
                                       : static_cast<widgets::MousePreset>(found - mousePresets.begin());
}

void Settings::setMousePreset(widgets::MousePreset preset)
{
    set(mouseKey, QString::fromLatin1(mousePresets.at(static_cast<std::size_t>(preset))));
}

Settings::CurveDrawing Settings::curveDrawing() const
{
    const CurveDrawing usual;
    return {.snaps = m_store.value(snapsKey, usual.snaps).toBool(),
            .snapRadius = m_store.value(snapRadiusKey, usual.snapRadius).toDouble(),
            .overlap = m_store.value(overlapKey, usual.overlap).toDouble()};
}

void Settings::setCurveDrawing(const CurveDrawing& drawing)
{
    set(snapsKey, drawing.snaps);
    set(snapRadiusKey, drawing.snapRadius);
    set(overlapKey, drawing.overlap);
}

QStringList Settings::recentProjects() const
{
    return m_store.value(recentKey).toStringList();
}

void Settings::addRecentProject(const QString& file)
{
    QStringList recent = recentProjects();
    recent.removeAll(file);
    recent.prepend(file);
    while (recent.size() > maximalRecent)
        recent.removeLast();
    m_store.setValue(recentKey, recent);
    emit recentProjectsChanged();
}

void Settings::removeRecentProject(const QString& file)
{
    QStringList recent = recentProjects();
    recent.removeAll(file);
    m_store.setValue(recentKey, recent);
    emit recentProjectsChanged();
}

QList<QKeySequence> Settings::shortcuts(const QString& action, const QList<QKeySequence>& own) const
{
    const QVariant stored = m_store.value(shortcutKey(action));
    if (!stored.isValid())
        return own;
    return QKeySequence::listFromString(stored.toString(), QKeySequence::PortableText);
}

void Settings::setShortcuts(const QString& action, const QList<QKeySequence>& shortcuts,
                            const QList<QKeySequence>& own)
{
    if (shortcuts == own)
        m_store.remove(shortcutKey(action));
    else
        m_store.setValue(shortcutKey(action),
                         QKeySequence::listToString(shortcuts, QKeySequence::PortableText));
}

} // namespace quadrille

#include "moc_settings.cpp"
