// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QTableWidget>
#include <vector>

namespace quadrille {

class PathTool;

/// The points of a path with their coordinates, which can be typed in.
class PathPoints : public QTableWidget
{
    Q_OBJECT

public:
    explicit PathPoints(PathTool& tool, QWidget* parent = nullptr);

    void refresh();
    QSize sizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void takeValue(const QTableWidgetItem& item);
    void selectRow();
    void showMenu(const QPoint& position);
    void deleteSelected();
    std::vector<int> axes() const;

    PathTool& m_tool;
    bool m_isFilling = false;
};

} // namespace quadrille
