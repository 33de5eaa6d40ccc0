// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/properties/propertyform.h"
#include "model/project/project.h"

#include <functional>

class QComboBox;
class QPushButton;
class QDoubleSpinBox;
class QSpinBox;

namespace quadrille {

struct EditorContext;

/// How a character's poses are compared and which transitions are sought. Each edit is undoable; the graph is
/// computed anew.
class GraphSettingsPanel : public PropertyForm
{
    Q_OBJECT

public:
    explicit GraphSettingsPanel(EditorContext& context, QWidget* parent = nullptr);

    /// Shows the settings of a character.
    void show(const QString& character) override;
    using PropertyForm::show;

private:
    void makeFields();
    void connectFields();
    void refresh();
    void edit(const QString& text, const QString& property, const std::function<void(GraphEntry&)>& change);
    void editDurations();
    void retranslate() override;

    EditorContext& m_context;
    QString m_character;
    QComboBox* m_metric;
    QDoubleSpinBox* m_stretch;
    QComboBox* m_cost;
    QComboBox* m_scale;
    QComboBox* m_length;
    QComboBox* m_smoothing;
    QDoubleSpinBox* m_contacts;
    QDoubleSpinBox* m_velocity;
    QSpinBox* m_slope;
    QDoubleSpinBox* m_shortest;
    QDoubleSpinBox* m_longest;
    QDoubleSpinBox* m_greatest;
    QPushButton* m_published;
};

} // namespace quadrille
