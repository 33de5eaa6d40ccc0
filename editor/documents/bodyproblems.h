// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QHash>
#include <QObject>
#include <QString>

namespace quadrille {

/// What is wrong with the curves and parts of characters' bodies, as far as somebody has cut them.
class BodyProblems : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// One sentence, translated; empty where nothing is known to be wrong.
    QString problemOf(const QString& character) const { return m_problems.value(character); }
    /// \param problem  empty when nothing is wrong any more. `changed` is told where it is another one.
    void set(const QString& character, const QString& problem);

signals:
    void changed(const QString& character);

private:
    QHash<QString, QString> m_problems;
};

} // namespace quadrille
