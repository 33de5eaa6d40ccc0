// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/application/recoveries.h"

#include <QWidget>

class QVBoxLayout;

namespace quadrille {

/// A row for each work that a crash left unsaved, for the welcome page; nothing where there is none.
class RecoveryNotice : public QWidget
{
    Q_OBJECT

public:
    explicit RecoveryNotice(QWidget* parent = nullptr);

    /// Looks again what there is. It is done when the row is shown, too.
    void refresh();

signals:
    void recoverRequested(const quadrille::Recovery& recovery);

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeRow(const Recovery& recovery);

    QVBoxLayout* m_rows;
};

} // namespace quadrille
