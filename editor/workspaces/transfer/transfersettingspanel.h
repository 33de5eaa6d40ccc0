// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldform.h"
#include "editor/fields/settingform.h"
#include "model/project/document/transferentry.h"

namespace quadrille {

class CurrentTransfer;

/// How a transfer is made.
class TransferSettingsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit TransferSettingsPanel(CurrentTransfer& transfer, QWidget* parent = nullptr);

private:
    void refresh();
    /// The pose that is shown becomes the reference.
    void takeReference();

    CurrentTransfer& m_transfer;
    SettingForm* m_form;
    FieldForm<TransferEntry> m_fields;
};

} // namespace quadrille
