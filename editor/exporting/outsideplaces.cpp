// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/exporting/outsideplaces.h"

#include <QCryptographicHash>

namespace quadrille {

QString OutsidePlaces::keyOf(const QString& project)
{
    // A path has slashes, which settings take for groups.
    const QByteArray name = QCryptographicHash::hash(project.toUtf8(), QCryptographicHash::Sha1).toHex();
    return QStringLiteral("outsidePlaces/") + QString::fromLatin1(name);
}

bool OutsidePlaces::isAllowed(const QString& project, const QString& folder) const
{
    return m_store.value(keyOf(project)).toStringList().contains(folder);
}

void OutsidePlaces::allow(const QString& project, const QString& folder)
{
    QStringList folders = m_store.value(keyOf(project)).toStringList();
    if (folders.contains(folder))
        return;
    m_store.setValue(keyOf(project), folders << folder);
}

} // namespace quadrille
