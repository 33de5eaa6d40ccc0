// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QString>

class QWidget;

namespace quadrille {

/// A place in the manual.
struct HelpTopic
{
    QString page = QStringLiteral("index"); ///< file name without ending, e.g. "importing"
    /// A heading of the English page, in any language; empty: the beginning of the page.
    QString heading;

    bool operator==(const HelpTopic&) const = default;
};

/// What the manual says about a widget: that of the nearest widget above it that the table of topics names;
/// the contents without any. \param widget  null: the contents.
HelpTopic helpTopicOf(const QWidget* widget);

/// What F1 is about: what is under the mouse in a window, else what has the focus there.
HelpTopic helpTopicIn(const QWidget& window);

/// All topics of the table.
QList<HelpTopic> helpTopics();

} // namespace quadrille
