// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/properties/entrypage.h"

namespace quadrille {

struct AnimationEntry;

/// An animation: what is asked of it, how it is finished, and what came out.
class AnimationPage : public EntryPage
{
    Q_OBJECT

public:
    explicit AnimationPage(EditorContext& context);

    void show(const QString& name) override;
    using QWidget::show;

private:
    QString character() const override;
    void setCharacter(const QString& character) override;
    void select() override;
    QString wishes(const AnimationEntry& entry) const;
    QString finish(const AnimationEntry& entry) const;
    QString outcome() const;

    QLabel* m_wishes = nullptr;
    QLabel* m_finish = nullptr;
    QLabel* m_outcome = nullptr;
};

} // namespace quadrille
