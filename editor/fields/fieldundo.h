// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>

namespace quadrille {

/// Undo and redo while a field has the keyboard: what is typed there and not taken yet comes first; where
/// there is nothing of it, the keys go on to the project.
class FieldUndo : public QObject
{
    Q_OBJECT

public:
    /// Watches the whole application for as long as it lives.
    explicit FieldUndo(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace quadrille
