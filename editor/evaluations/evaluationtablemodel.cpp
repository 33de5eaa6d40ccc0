// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/evaluations/evaluationtablemodel.h"

#include "editor/documents/evaluationtexts.h"
#include "editor/evaluations/evaluationcharts.h"
#include "model/project/store/dataitem.h"
#include "widgets/theme/theme.h"

#include <QLocale>

namespace quadrille {

namespace {

const DataTable& tableIn(const DataItem& item)
{
    return std::get<DataTable>(item.content);
}

/// A cell as it sorts: a number or a text.
QVariant cellOf(const DataArray& column, std::size_t row)
{
    return std::visit(
        [row](const auto& values) -> QVariant {
            using Value = typename std::decay_t<decltype(values)>::value_type;
            if constexpr (std::is_same_v<Value, std::string>)
                return QString::fromStdString(values[row]);
            else if constexpr (std::is_floating_point_v<Value>)
                return static_cast<double>(values[row]);
            else
                return static_cast<qlonglong>(values[row]);
        },
        column.values);
}

bool isTextColumn(const DataArray& column)
{
    return std::holds_alternative<TextColumn>(column.values);
}

/// A unit, where it is a word in the user's language.
QString unitWord(const QString& unit)
{
    return unit == QLatin1String("frame") ? evaluationWord(QStringLiteral("frames")) : unit;
}

QString shownText(const QVariant& cell)
{
    if (cell.typeId() == QMetaType::QString)
        return evaluationWord(cell.toString());
    return cell.typeId() == QMetaType::Double ? evaluationNumber(cell.toDouble())
                                              : QLocale().toString(cell.toLongLong());
}

} // namespace

void EvaluationTableModel::show(std::vector<DataItem> tables)
{
    beginResetModel();
    m_tables = std::move(tables);
    m_rows.clear();
    for (std::size_t table = 0; table < m_tables.size(); ++table) {
        const auto& columns = tableIn(m_tables[table]).columns;
        const std::size_t rows = columns.empty() ? 0 : valueCount(columns.front().values);
        for (std::size_t row = 0; row < rows; ++row)
            m_rows.emplace_back(table, row);
    }
    endResetModel();
}

QString EvaluationTableModel::csv() const
{
    QString text;
    for (const DataItem& item : m_tables)
        text += QString::fromStdString(dataAsCsv(item));
    return text;
}

void EvaluationTableModel::retranslate()
{
    beginResetModel();
    endResetModel();
}

int EvaluationTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int EvaluationTableModel::columnCount(const QModelIndex& parent) const
{
    if (parent.isValid() || m_tables.empty())
        return 0;
    return static_cast<int>(tableIn(m_tables.front()).columns.size()) + (namesCharacter() ? 1 : 0);
}

const DataArray& EvaluationTableModel::columnOf(int column) const
{
    const int own = column - (namesCharacter() ? 1 : 0);
    return tableIn(m_tables.front()).columns[static_cast<std::size_t>(own)];
}

QVariant EvaluationTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const auto [table, row] = m_rows[static_cast<std::size_t>(index.row())];
    QVariant cell;
    if (namesCharacter() && index.column() == 0) {
        cell = QString::fromStdString(m_tables[table].character);
    } else {
        const int own = index.column() - (namesCharacter() ? 1 : 0);
        cell = cellOf(tableIn(m_tables[table]).columns[static_cast<std::size_t>(own)], row);
    }
    switch (role) {
    case Qt::DisplayRole:
        return shownText(cell);
    case SortRole:
        return cell;
    case Qt::TextAlignmentRole:
        return QVariant(cell.typeId() == QMetaType::QString ? Qt::AlignLeft | Qt::AlignVCenter
                                                            : Qt::AlignRight | Qt::AlignVCenter);
    case Qt::FontRole:
        return widgets::Theme::tabularFont({});
    default:
        return {};
    }
}

QVariant EvaluationTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section >= columnCount())
        return {};
    const bool isCharacter = namesCharacter() && section == 0;
    const QString name =
        isCharacter ? QStringLiteral("character") : QString::fromStdString(columnOf(section).name);
    const QString unit = isCharacter ? QString() : QString::fromStdString(columnOf(section).unit);
    switch (role) {
    case Qt::DisplayRole: {
        const QString title = capitalized(evaluationWord(name));
        //: a column of a table, then its unit
        return unit.isEmpty() ? title : tr("%1 (%2)").arg(title, unitWord(unit));
    }
    case Qt::ToolTipRole:
        return name; // as data files call it
    case Qt::TextAlignmentRole:
        return QVariant((isCharacter || isTextColumn(columnOf(section)) ? Qt::AlignLeft : Qt::AlignRight) |
                        Qt::AlignVCenter);
    default:
        return {};
    }
}

} // namespace quadrille

#include "moc_evaluationtablemodel.cpp"
