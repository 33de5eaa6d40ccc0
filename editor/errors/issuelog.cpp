// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/errors/issuelog.h"

#include <QLocale>
#include <algorithm>
#include <utility>

namespace quadrille {

IssueLog::IssueLog(QObject* parent) : QAbstractTableModel(parent) {}

IssueLog::Severity IssueLog::severityOf(const Entry& entry)
{
    const auto* issue = std::get_if<Issue>(&entry.what);
    if (!issue)
        return Severity::Error;
    return issue->severity == Issue::Severity::Warning ? Severity::Warning : Severity::Info;
}

ErrorText IssueLog::textOf(const Entry& entry)
{
    return std::visit([](const auto& what) { return describe(what); }, entry.what);
}

void IssueLog::add(const Error& error, const QString& subject, std::function<void()> jump)
{
    if (error.code() != ErrorCode::Cancelled)
        add(Entry{error, subject, std::move(jump)});
}

void IssueLog::add(const Issue& issue, const QString& subject, std::function<void()> jump)
{
    add(Entry{issue, subject, std::move(jump)});
}

void IssueLog::add(Entry entry)
{
    entry.last = QDateTime::currentDateTime();
    const QString said = textOf(entry).oneLine();
    const auto same = std::ranges::find_if(m_entries, [&](const Entry& known) {
        return known.subject == entry.subject && textOf(known).oneLine() == said;
    });
    const Severity severity = severityOf(entry);
    if (same != m_entries.end()) {
        ++same->repeats;
        same->last = entry.last;
        same->jump = std::move(entry.jump);
        const int row = static_cast<int>(same - m_entries.begin());
        emit dataChanged(index(row, 0), index(row, ColumnCount - 1));
    } else {
        const int row = rowCount();
        beginInsertRows({}, row, row);
        m_entries.push_back(std::move(entry));
        endInsertRows();
    }
    emit added(severity);
}

void IssueLog::clear(const QString& subject)
{
    for (int row = rowCount() - 1; row >= 0; --row) {
        const auto entry = m_entries.begin() + row;
        if (entry->subject != subject)
            continue;
        beginRemoveRows({}, row, row);
        m_entries.erase(entry);
        endRemoveRows();
    }
}

void IssueLog::clear()
{
    beginResetModel();
    m_entries.clear();
    endResetModel();
}

void IssueLog::jump(const QModelIndex& index) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return;
    const auto jump = m_entries[static_cast<std::size_t>(index.row())].jump; // may clear the log
    if (jump)
        jump();
}

int IssueLog::count(Severity severity) const
{
    return static_cast<int>(std::ranges::count_if(
        m_entries, [severity](const Entry& entry) { return severityOf(entry) == severity; }));
}

int IssueLog::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_entries.size());
}

int IssueLog::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant IssueLog::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Entry& entry = m_entries[static_cast<std::size_t>(index.row())];
    switch (role) {
    case SeverityRole:
        return QVariant::fromValue(severityOf(entry));
    case CanJumpRole:
        return static_cast<bool>(entry.jump);
    case Qt::ToolTipRole:
        return textOf(entry).oneLine() + QLatin1Char('\n') +
               QLocale().toString(entry.last, QLocale::ShortFormat);
    case Qt::TextAlignmentRole:
        return index.column() == CountColumn ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    case Qt::DisplayRole:
        break;
    default:
        return {};
    }
    switch (index.column()) {
    case MessageColumn: {
        const ErrorText text = textOf(entry);
        return ErrorText{text.sentence, {}, text.remedy}.oneLine();
    }
    case SubjectColumn:
        return entry.subject;
    case PlaceColumn:
        return textOf(entry).where;
    case CountColumn:
        return entry.repeats > 1 ? QVariant(entry.repeats) : QVariant();
    default:
        return {};
    }
}

QVariant IssueLog::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case MessageColumn:
        return tr("Message");
    case SubjectColumn:
        return tr("Concerns");
    case PlaceColumn:
        return tr("Place");
    case CountColumn:
        return tr("Times");
    default:
        return {};
    }
}

void IssueLog::retranslate()
{
    emit headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    if (!m_entries.empty())
        emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

} // namespace quadrille

#include "moc_issuelog.cpp"
