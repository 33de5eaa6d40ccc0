// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/properties/propertyform.h"

class QComboBox;
class QLineEdit;
class QPushButton;

namespace quadrille {

struct AnimationEntry;
struct EditorContext;

/// What is asked of an animation, in short, and what came out. Its workspace edits it.
class AnimationPage : public PropertyForm
{
    Q_OBJECT

public:
    explicit AnimationPage(EditorContext& context);

    void show(const QString& name) override;
    using QWidget::show;

private:
    void retranslate() override;
    QString wishes(const AnimationEntry& entry) const;
    QString finish(const AnimationEntry& entry) const;
    QString outcome() const;

    EditorContext& m_context;
    QString m_name;
    QLineEdit* m_nameField;
    QComboBox* m_character;
    QLabel* m_wishes = nullptr;
    QLabel* m_finish = nullptr;
    QLabel* m_outcome = nullptr;
    QPushButton* m_open;
};

} // namespace quadrille
