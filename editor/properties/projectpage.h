// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/properties/propertyform.h"

class QDoubleSpinBox;
class QSpinBox;

namespace quadrille {

class AxesFields;
struct EditorContext;
struct ProjectSettings;

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
    QDoubleSpinBox* m_fps;
    AxesFields* m_axes;
    QSpinBox* m_cache;
    QLabel* m_content;
    QLabel* m_file;
};

} // namespace quadrille
