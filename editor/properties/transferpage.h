// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldform.h"
#include "editor/properties/entrypage.h"

namespace quadrille {

/// A transfer: what is performed, by whom, and how.
class TransferPage : public EntryPage
{
    Q_OBJECT

public:
    explicit TransferPage(EditorContext& context);

    void show(const QString& name) override;
    using QWidget::show;

private:
    QString character() const override;
    void setCharacter(const QString& character) override;
    void retranslate() override;

    QLabel* m_pairs = nullptr;
    SettingForm* m_form;
    FieldForm<TransferEntry> m_fields;
};

} // namespace quadrille
