// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QSettings>
#include <QString>

namespace quadrille {

/// Folders outside of a project's own into which the user lets it write, on this computer; asked about once.
class OutsidePlaces
{
public:
    /// \param project  its file. \param folder  that is written into, not those below it.
    bool isAllowed(const QString& project, const QString& folder) const;
    void allow(const QString& project, const QString& folder);

private:
    static QString keyOf(const QString& project);

    QSettings m_store;
};

} // namespace quadrille
