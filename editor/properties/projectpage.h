// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldform.h"
#include "editor/properties/propertyform.h"
#include "model/project/document/project.h"

namespace quadrille {

struct EditorContext;

/// The settings of the project.
class ProjectPage : public PropertyForm
{
    Q_OBJECT

public:
    explicit ProjectPage(EditorContext& context);
    void show(const QString& name) override;

protected:
    void retranslate() override;

private:
    void edit(const std::function<void(ProjectSettings&)>& change);

    EditorContext& m_context;
    FieldForm<ProjectSettings, LabelForm> m_fields;
    QLabel* m_content;
    QLabel* m_file;
};

} // namespace quadrille
