// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldform.h"
#include "editor/properties/entrypage.h"

namespace quadrille {

/// A model of appearance: the textures that it is learned from, and how large it is.
class AppearancePage : public EntryPage
{
    Q_OBJECT

public:
    explicit AppearancePage(EditorContext& context);

    void show(const QString& name) override;
    using QWidget::show;

private:
    QString character() const override;
    void setCharacter(const QString& character) override;
    void retranslate() override;

    QLabel* m_sequences = nullptr;
    QLabel* m_completions = nullptr;
    SettingForm* m_form;
    FieldForm<AppearanceEntry> m_fields;
};

} // namespace quadrille
