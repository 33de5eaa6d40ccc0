// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldform.h"
#include "editor/properties/entrypage.h"

namespace quadrille {

/// A performance that was steered live: what was recorded, and how it is played again.
class LivePage : public EntryPage
{
    Q_OBJECT

public:
    explicit LivePage(EditorContext& context);

    void show(const QString& name) override;
    using QWidget::show;

private:
    QString character() const override;
    void setCharacter(const QString& character) override;
    void retranslate() override;

    void addBeginning();
    void addPlaying();
    const LiveEntry& entry() const;

    QLabel* m_spaces = nullptr;
    QLabel* m_length = nullptr;
    SettingForm* m_form;
    FieldForm<LiveEntry> m_fields;
};

} // namespace quadrille
