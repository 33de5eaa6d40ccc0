// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldform.h"
#include "editor/properties/propertyform.h"
#include "model/project/document/projectionentry.h"

#include <QPointer>

class QLineEdit;
class QPushButton;

namespace quadrille {

class Job;
struct EditorContext;

/// A clip whose textures come from pictures of calibrated cameras: what is seen, by which cameras, and how
/// its textures are made.
class ProjectionPage : public PropertyForm
{
    Q_OBJECT

public:
    explicit ProjectionPage(EditorContext& context);

    void show(const QString& name) override;
    using QWidget::show;

private:
    void edit(const QString& text, const char* property, const std::function<void(ProjectionEntry&)>& change);
    void addFields();
    void chooseCameras();
    void compute();
    void addSequence();
    void retranslate() override;

    EditorContext& m_context;
    QString m_name;
    QLineEdit* m_nameField;
    QPushButton* m_cameras;
    QPushButton* m_compute;
    QPushButton* m_add;
    SettingForm* m_form;
    FieldForm<ProjectionEntry> m_fields;
    QPointer<Job> m_job;
};

} // namespace quadrille
