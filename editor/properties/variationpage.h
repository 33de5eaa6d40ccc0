// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/properties/entrypage.h"

namespace quadrille {

/// Variations: the takes that they are learned from, and what is drawn of them.
class VariationPage : public EntryPage
{
    Q_OBJECT

public:
    explicit VariationPage(EditorContext& context);

    void show(const QString& name) override;
    using QWidget::show;

private:
    QString character() const override;
    void setCharacter(const QString& character) override;
    QLabel* m_takes = nullptr;
    QLabel* m_samples = nullptr;
};

} // namespace quadrille
