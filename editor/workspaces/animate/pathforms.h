// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldform.h"
#include "editor/workspaces/animate/pathtool.h"
#include "model/project/document/animationentry.h"

namespace quadrille {

/// What concerns a path as a whole.
class PathForm : public LabelForm
{
    Q_OBJECT

public:
    explicit PathForm(PathTool& tool);

    void refresh();

protected:
    void retranslate() override;

private:
    void edit(const QString& text, const char* property, const PathTool::Edit& change);
    const PathEntry& shown() const;
    QString resultText() const;

    PathTool& m_tool;
    FieldForm<PathEntry, LabelForm> m_fields;
    QLabel* m_length = nullptr;
    QLabel* m_result = nullptr;
};

/// What is asked of one span of a path.
class SpanForm : public LabelForm
{
    Q_OBJECT

public:
    explicit SpanForm(PathTool& tool);

    void showSpan(int span);
    void refresh();

protected:
    void retranslate() override;

private:
    void addFrames();
    void addEnds();
    void addTimes();
    const PathSpanEntry* span() const;
    void edit(const QString& text, const char* property, const std::function<void(PathSpanEntry&)>& edit);
    QString obtainedText() const;

    PathTool& m_tool;
    FieldForm<PathSpanEntry, LabelForm> m_fields;
    int m_span = -1;
    QLabel* m_obtained = nullptr;
};

/// Where one obstacle is.
class ObstacleForm : public LabelForm
{
    Q_OBJECT

public:
    explicit ObstacleForm(PathTool& tool);

    void showObstacle(int obstacle);

protected:
    void retranslate() override;

private:
    void addMiddle(const char* name, int axis);
    const ObstacleEntry* obstacle() const;

    PathTool& m_tool;
    FieldForm<ObstacleEntry, LabelForm> m_fields;
    int m_obstacle = -1;
};

} // namespace quadrille
