// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/properties/propertyform.h"
#include "model/project/document/animationentry.h"

class QComboBox;
class QDoubleSpinBox;
class QSpinBox;

namespace quadrille {

class PathTool;

/// What concerns a path as a whole.
class PathForm : public PropertyForm
{
    Q_OBJECT

public:
    explicit PathForm(PathTool& tool);

    void show(const QString& name = {}) override;
    using PropertyForm::setFieldVisible;

protected:
    void retranslate() override { show(); }

private:
    QString resultText() const;

    PathTool& m_tool;
    QComboBox* m_curve;
    QComboBox* m_space;
    QDoubleSpinBox* m_clearance;
    QLabel* m_length = nullptr;
    QLabel* m_result = nullptr;
};

/// What is asked of one span of a path.
class SpanForm : public PropertyForm
{
    Q_OBJECT

public:
    explicit SpanForm(PathTool& tool);

    void showSpan(int span);
    void show(const QString& name = {}) override;

protected:
    void retranslate() override { show(); }

private:
    const PathSpanEntry* span() const;
    void edit(const QString& text, const char* property, const std::function<void(PathSpanEntry&)>& edit);
    void fillFrames();
    void chooseFrames(int index);
    void chooseRange();
    QString obtainedText() const;

    PathTool& m_tool;
    int m_span = -1;
    QComboBox* m_frames;
    QWidget* m_range;
    QSpinBox* m_first;
    QSpinBox* m_last;
    QDoubleSpinBox* m_from;
    QDoubleSpinBox* m_to;
    QDoubleSpinBox* m_duration;
    QDoubleSpinBox* m_speed;
    QLabel* m_obtained = nullptr;
};

/// Where one obstacle is.
class ObstacleForm : public PropertyForm
{
    Q_OBJECT

public:
    explicit ObstacleForm(PathTool& tool);

    void showObstacle(int obstacle);
    void show(const QString& name = {}) override;

protected:
    void retranslate() override { show(); }

private:
    const ObstacleEntry* obstacle() const;
    void edit(const QString& text, const std::function<void(ObstacleEntry&)>& edit);
    void move(int axis, double to);

    PathTool& m_tool;
    int m_obstacle = -1;
    QDoubleSpinBox* m_first;
    QDoubleSpinBox* m_second;
    QDoubleSpinBox* m_radius;
};

} // namespace quadrille
