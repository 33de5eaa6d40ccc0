// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldform.h"
#include "model/project/document/project.h"

#include <functional>

class QPushButton;

namespace quadrille {

struct EditorContext;

/// How a character's poses are compared and which transitions are sought. Each edit is undoable; the graph is
/// computed anew.
class GraphSettingsPanel : public SettingForm
{
    Q_OBJECT

public:
    explicit GraphSettingsPanel(EditorContext& context, QWidget* parent = nullptr);

    /// Shows the settings of a character.
    void showCharacter(const QString& character);

private:
    void addDistances();
    void addCosts();
    void addWindows();
    void addPublished();
    void refresh();
    void edit(const QString& text, const char* property, const std::function<void(GraphEntry&)>& change);

    EditorContext& m_context;
    QString m_character;
    FieldForm<GraphEntry> m_fields;
    QDoubleSpinBox* m_greatest = nullptr;
    QPushButton* m_published;
};

} // namespace quadrille
