// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/pathpoints.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/numberfield.h"
#include "editor/fields/ownkeys.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/pathfields.h"
#include "editor/workspaces/animate/pathtool.h"
#include "widgets/theme/theme.h"
#include "widgets/tools/pathgeometry.h"
#include "widgets/viewport/ruler.h"

#include <QApplication>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QScopedValueRollback>
#include <QStyledItemDelegate>
#include <cmath>

namespace quadrille {

using widgets::PathPart;

namespace {

/// Shows coordinates to the millimetre, and edits them in a field with limits.
class CoordinateDelegate : public QStyledItemDelegate
{
public:
    explicit CoordinateDelegate(const PathTool& tool, QObject* parent)
        : QStyledItemDelegate(parent), m_tool(tool)
    {
    }

    QString displayText(const QVariant& value, const QLocale& locale) const override
    {
        const widgets::Ruler ruler(settingsOf(m_tool).axes.metresPerUnit);
        return locale.toString(value.toDouble(), 'f', ruler.decimals(millimetres));
    }
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                          const QModelIndex& /*index*/) const override
    {
        const NumberLook look = lengthLook(m_tool, nullptr, -1, 0.1, millimetres);
        QDoubleSpinBox* field = makeNumberField(look);
        showInUnit(*field, look);
        field->setSuffix({});
        field->setParent(parent);
        field->setFrame(false);
        return field;
    }
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override
    {
        auto* field = static_cast<QDoubleSpinBox*>(editor);
        field->interpretText();
        // The decimals that a field does not show are not lost where nothing is typed.
        const double halfStep = 0.5 * std::pow(10.0, -field->decimals());
        if (std::abs(field->value() - index.data(Qt::EditRole).toDouble()) > halfStep * (1 + 1e-9))
            model->setData(index, field->value(), Qt::EditRole);
    }

private:
    static constexpr int millimetres = 3; ///< decimals of metres
    const PathTool& m_tool;
};

} // namespace

PathPoints::PathPoints(PathTool& tool, QWidget* parent) : QTableWidget(parent), m_tool(tool)
{
    setObjectName(QStringLiteral("pathPoints"));
    setItemDelegate(new CoordinateDelegate(tool, this));
    setFont(widgets::Theme::tabularFont(font()));
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setAlternatingRowColors(false);
    setShowGrid(false);
    setTabKeyNavigation(false);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    constexpr int rowHeight = 24;
    verticalHeader()->setDefaultSectionSize(rowHeight);
    connect(this, &QTableWidget::itemChanged, this, [this](const QTableWidgetItem* item) {
        if (!m_isFilling)
            takeValue(*item);
    });
    connect(this, &QTableWidget::itemSelectionChanged, this, &PathPoints::selectRow);
    setContextMenuPolicy(Qt::CustomContextMenu);
    connect(this, &QTableWidget::customContextMenuRequested, this, &PathPoints::showMenu);
    connect(&tool.editor(), &widgets::PathEditor::selectionChanged, this, &PathPoints::refresh);
}

std::vector<int> PathPoints::axes() const
{
    const PathEntry* path = m_tool.path();
    const bool inSpace = path != nullptr && path->inSpace;
    std::vector<int> shown;
    for (int axis = 0; axis < 3; ++axis)
        if (inSpace || axis != static_cast<int>(settingsOf(m_tool).axes.up))
            shown.push_back(axis);
    return shown;
}

void PathPoints::refresh()
{
    const QScopedValueRollback filling(m_isFilling, true);
    const PathEntry* path = m_tool.path();
    const std::vector<int> columns = axes();
    const auto rows = path == nullptr ? 0 : static_cast<int>(path->points.size());
    const bool isOtherSize = rows != rowCount();
    setColumnCount(static_cast<int>(columns.size()));
    setRowCount(rows);
    QStringList titles;
    for (const int axis : columns)
        titles += tr("%1 (%2)").arg(QLatin1Char(static_cast<char>('x' + axis))).arg(unitOf(m_tool));
    setHorizontalHeaderLabels(titles);
    QStringList names;
    for (int row = 0; row < rows; ++row) {
        const auto index = static_cast<std::size_t>(row);
        const auto kind = kindOf(path->curve);
        names += widgets::isHandle(kind, index) ? tr("handle")
                                                : QString::number(widgets::anchorOf(kind, index) + 1);
        for (int column = 0; column < columnCount(); ++column) {
            if (item(row, column) == nullptr) {
                setItem(row, column, new QTableWidgetItem);
                item(row, column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            }
            item(row, column)
                ->setData(Qt::EditRole, path->points[index][columns[static_cast<std::size_t>(column)]]);
        }
    }
    setVerticalHeaderLabels(names);
    const PathPart& selected = m_tool.editor().selected();
    if (selected.kind != PathPart::Kind::Point)
        clearSelection();
    else if (currentRow() != selected.index || selectedItems().isEmpty())
        setCurrentCell(selected.index, std::max(0, currentColumn()));
    if (isOtherSize)
        updateGeometry();
}

void PathPoints::selectRow()
{
    if (m_isFilling || selectedItems().isEmpty())
        return;
    m_tool.editor().setSelected({PathPart::Kind::Point, currentRow(), 0});
}

void PathPoints::takeValue(const QTableWidgetItem& item)
{
    const double value = item.data(Qt::EditRole).toDouble();
    const int axis = axes()[static_cast<std::size_t>(item.column())];
    const auto row = static_cast<std::size_t>(item.row());
    m_tool.edit(tr("Move a point of the path"), QStringLiteral("path points"), [&](PathEntry& path) {
        std::vector<Vec3d> points = path.points;
        points[row][axis] = value;
        path = withPoints(path, std::move(points), settingsOf(m_tool).axes.metresPerUnit);
    });
}

bool PathPoints::event(QEvent* event)
{
    return takesOwnKeys(*event, {Qt::Key_Delete}) || QTableWidget::event(event);
}

void PathPoints::showMenu(const QPoint& position)
{
    QTableWidgetItem* item = itemAt(position);
    QMenu menu(this);
    menu.setObjectName(QStringLiteral("pathPointsMenu"));
    if (item != nullptr) {
        setCurrentItem(item);
        menu.addAction(tr("Edit the coordinate"), this, [&] { editItem(item); });
        menu.addAction(tr("Delete the point"), this, &PathPoints::deleteSelected);
        menu.addSeparator();
    }
    const ActionRegistry& actions = m_tool.animation().context().actions;
    for (const char* id : {"animate.path.draw", "animate.path.reverse", "animate.path.close"})
        menu.addAction(actions.action(QLatin1String(id)));
    menu.exec(viewport()->mapToGlobal(position));
}

void PathPoints::deleteSelected()
{
    QKeyEvent press(QEvent::KeyPress, Qt::Key_Delete, Qt::NoModifier);
    m_tool.editor().handle(press);
}

void PathPoints::keyPressEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_Delete || m_tool.editor().selected().kind != PathPart::Kind::Point) {
        QTableWidget::keyPressEvent(event);
        return;
    }
    deleteSelected();
}

QSize PathPoints::sizeHint() const
{
    constexpr int mostRows = 8;
    const int rows = std::clamp(rowCount(), 2, mostRows);
    return {200, horizontalHeader()->sizeHint().height() + rows * verticalHeader()->defaultSectionSize() +
                     2 * frameWidth()};
}

} // namespace quadrille

#include "moc_pathpoints.cpp"
