// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/properties/propertyform.h"

class QPlainTextEdit;
class QPushButton;

namespace quadrille {

struct EditorContext;

/// An entry that cannot be read: what is wrong, and its text, to be corrected.
class BrokenPage : public PropertyForm
{
    Q_OBJECT

public:
    explicit BrokenPage(EditorContext& context);

    void show(const QString& title) override;
    using QWidget::show;

protected:
    void retranslate() override;

private:
    EditorContext& m_context;
    QString m_title;
    QString m_shown; ///< the text as it stands in the project
    QLabel* m_problem;
    QLabel* m_place;
    QPlainTextEdit* m_text;
    QPushButton* m_readAgain;
    QPushButton* m_remove;
};

} // namespace quadrille
