// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldbar.h"
#include "editor/fields/fieldform.h"
#include "model/project/document/transferentry.h"

#include <QPointer>

class QComboBox;
class QProgressBar;

namespace quadrille {

class CurrentTransfer;
class Job;

namespace widgets {
class ElidedLabel;
} // namespace widgets

/// Which transfer is worked on, what is performed by whom, and how far it is.
class TransferBar : public QWidget
{
    Q_OBJECT

public:
    explicit TransferBar(CurrentTransfer& transfer, QWidget* parent = nullptr);

private:
    void makeActions();
    void arrangeWidgets();
    void retranslate();
    void refresh();
    void refreshState();
    QString stateText() const;

    CurrentTransfer& m_transfer;
    QComboBox* m_names;
    FieldBar* m_bar;
    FieldForm<TransferEntry, FieldBar> m_fields;
    QProgressBar* m_progress;
    widgets::ElidedLabel* m_state;
    QPointer<Job> m_job; ///< whose progress is followed
};

} // namespace quadrille
