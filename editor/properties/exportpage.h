// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/properties/propertyform.h"

class QPushButton;

namespace quadrille {

struct EditorContext;

/// An export of the project: what goes where, and a way to change and write it again.
class ExportPage : public PropertyForm
{
    Q_OBJECT

public:
    explicit ExportPage(EditorContext& context);
    void show(const QString& name) override;

protected:
    void retranslate() override;

private:
    EditorContext& m_context;
    QLabel* m_what;
    QLabel* m_file;
    QLabel* m_frames;
    QLabel* m_state;
    QPushButton* m_change;
};

} // namespace quadrille
