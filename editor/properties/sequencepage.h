// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldform.h"
#include "editor/properties/propertyform.h"
#include "model/project/document/project.h"

class QComboBox;
class QLineEdit;
class QPushButton;

namespace quadrille {

class AxesFields;
class RangeField;
class TextureField;
struct EditorContext;

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
    void addSource();
    void editSource(const std::function<void(SequenceEntry&)>& change);
    void chooseJointAngles();

    EditorContext& m_context;
    QString m_name;
    QLineEdit* m_nameField;
    QLabel* m_source;
    QComboBox* m_character;
    QLabel* m_length;
    RangeField* m_range;
    FieldForm<SequenceEntry, LabelForm> m_fields;
    AxesFields* m_axes;
    TextureField* m_texture;
    QPushButton* m_jointAngles;
    QLabel* m_marks;
    QLabel* m_notes;
};

} // namespace quadrille
