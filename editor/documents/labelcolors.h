// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QHash>
#include <QObject>
#include <string>

namespace quadrille {

class ProjectDocument;

/// The colours of a project's labels. A label keeps its colour as long as the project is open, whatever else
/// is labelled: each begins with the colour that its name stands for, in every project, and takes another
/// only where a label has that one already. All can be told apart by the colour-blind, and none is that of a
/// foot.
class LabelColors : public QObject
{
    Q_OBJECT

public:
    /// Those of a document; made at the first use, and gone with it.
    static LabelColors& of(ProjectDocument& document);

    /// A new label is given one, which may be that of another once all sixteen are taken.
    QColor color(const QString& label);
    QColor color(const std::string& label) { return color(QString::fromStdString(label)); }

    /// Of the contacts of a foot: left and right differ in hue and in lightness, others are like the left.
    static QColor contact(const std::string& foot);

signals:
    /// Another project is open: colours are given anew.
    void changed();

private:
    explicit LabelColors(ProjectDocument& document);
    void reset();

    ProjectDocument& m_document;
    QHash<QString, int> m_places; ///< in the list of colours, going round
};

} // namespace quadrille
