// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/properties/propertyform.h"

class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QSpinBox;
class QPushButton;

namespace quadrille {

class AxesFields;
class TextureField;
struct EditorContext;
struct SequenceEntry;

/// A sequence: where it comes from, which of its frames are used, its rate, axes, textures and marks.
class SequencePage : public PropertyForm
{
    Q_OBJECT

public:
    explicit SequencePage(EditorContext& context);
    void show(const QString& name) override;

protected:
    void retranslate() override;

private:
    void makeFields();
    void connectFields();
    void showResultState(const SequenceEntry& entry);
    void editRange();
    void editAxes();
    void chooseJointAngles();

    EditorContext& m_context;
    QString m_name;
    QLineEdit* m_nameField;
    QLabel* m_source;
    QComboBox* m_character;
    QLabel* m_length;
    QWidget* m_range;
    QSpinBox* m_first;
    QSpinBox* m_last;
    QDoubleSpinBox* m_fps;
    QComboBox* m_hasAxes;
    AxesFields* m_axes;
    TextureField* m_texture;
    QPushButton* m_jointAngles;
    QLabel* m_marks;
    QLabel* m_notes;
};

} // namespace quadrille
