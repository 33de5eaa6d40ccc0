// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/docks/projecttreemodel.h"

#include "editor/commands/projectedits.h"
#include "editor/documents/evaluationtexts.h"
#include "widgets/theme/icons.h"

namespace quadrille {

namespace {

/// Marks the index of a section; entries carry their section's row.
constexpr quintptr sectionId = ~quintptr{0};

int rowOf(Section section)
{
    const SectionInfo* info = findSection(section);
    return info == nullptr ? -1 : static_cast<int>(info - sections().data());
}

const SectionInfo& sectionAt(std::size_t row)
{
    return sections()[row];
}

/// What stands for an entry.
QString titleOf(const EntryRef& entry)
{
    return entry.section == Section::Evaluations ? evaluationTitle(entry.name) : entry.name;
}

/// In the colour of texts once it is up to date; what is yet to be made is faint, what is being made
/// coloured.
QIcon iconOf(const QString& name, EntryState state)
{
    using widgets::ColorRole;
    switch (state) {
    case EntryState::Fresh:
        return widgets::icons::icon(name);
    case EntryState::Stale:
        return widgets::icons::icon(name, ColorRole::TextMuted);
    case EntryState::Computing:
        return widgets::icons::icon(QStringLiteral("refresh"), ColorRole::AccentText);
    case EntryState::Failed:
        return widgets::icons::icon(QStringLiteral("error"), ColorRole::Error);
    }
    return {};
}

} // namespace

ProjectTreeModel::ProjectTreeModel(ProjectDocument& document, StatusOf statusOf, QObject* parent)
    : QAbstractItemModel(parent), m_document(document), m_statusOf(std::move(statusOf))
{
    for (int i = 0; i < static_cast<int>(sections().size()); ++i)
        m_names.push_back(namesOf(i));
    connect(&document, &ProjectDocument::renamed, this, &ProjectTreeModel::rename);
    connect(&document, &ProjectDocument::changed, this, &ProjectTreeModel::follow);
}

QModelIndex ProjectTreeModel::index(int row, int column, const QModelIndex& parent) const
{
    if (!hasIndex(row, column, parent))
        return {};
    return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) : sectionId);
}

QModelIndex ProjectTreeModel::parent(const QModelIndex& child) const
{
    if (!child.isValid() || child.internalId() == sectionId)
        return {};
    return createIndex(static_cast<int>(child.internalId()), 0, sectionId);
}

int ProjectTreeModel::rowCount(const QModelIndex& parent) const
{
    if (!parent.isValid())
        return static_cast<int>(sections().size());
    if (parent.internalId() == sectionId && parent.column() == 0)
        return static_cast<int>(m_names[static_cast<std::size_t>(parent.row())].size());
    return 0;
}

int ProjectTreeModel::columnCount(const QModelIndex& /*parent*/) const
{
    return 1;
}

EntryRef ProjectTreeModel::entry(const QModelIndex& index) const
{
    if (!index.isValid())
        return {};
    if (index.internalId() == sectionId)
        return {sectionAt(static_cast<std::size_t>(index.row())).section, {}};
    const auto section = static_cast<std::size_t>(index.internalId());
    return {sectionAt(section).section, m_names[section].value(index.row())};
}

QModelIndex ProjectTreeModel::indexOf(const EntryRef& entry) const
{
    const int section = rowOf(entry.section);
    if (section < 0)
        return {};
    if (entry.name.isEmpty())
        return index(section, 0);
    const auto row = m_names[static_cast<std::size_t>(section)].indexOf(entry.name);
    return row < 0 ? QModelIndex() : index(static_cast<int>(row), 0, index(section, 0));
}

QVariant ProjectTreeModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const EntryRef ref = entry(index);
    if (ref.name.isEmpty()) {
        if (role != Qt::DisplayRole)
            return {};
        return titleOf(*findSection(ref.section), rowCount(index));
    }
    switch (role) {
    case Qt::DisplayRole:
        return titleOf(ref);
    case Qt::EditRole:
        return ref.name;
    case Qt::DecorationRole:
        return iconOf(QLatin1String(findSection(ref.section)->icon), m_statusOf(ref).state);
    case StateRole:
        return static_cast<int>(m_statusOf(ref).state);
    case ProblemRole:
        return m_statusOf(ref).problem;
    case Qt::ToolTipRole: {
        const EntryStatus status = m_statusOf(ref);
        const QString state = status.problem.isEmpty() ? stateText(status.state) : status.problem;
        //: an entry of the project, and its state or what is wrong with it
        return state.isEmpty() ? titleOf(ref) : tr("%1: %2").arg(titleOf(ref), state);
    }
    default:
        return {};
    }
}

QString ProjectTreeModel::stateText(EntryState state)
{
    switch (state) {
    case EntryState::Fresh:
    case EntryState::Failed:
        return {};
    case EntryState::Stale:
        return tr("not made yet, or out of date");
    case EntryState::Computing:
        return tr("being made");
    }
    return {};
}

bool ProjectTreeModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const EntryRef ref = entry(index);
    if (role != Qt::EditRole || ref.name.isEmpty())
        return false;
    return renameEntry(m_document, ref, value.toString());
}

Qt::ItemFlags ProjectTreeModel::flags(const QModelIndex& index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (index.internalId() == sectionId)
        return flags;
    flags |= Qt::ItemNeverHasChildren;
    flags.setFlag(Qt::ItemIsEditable, findSection(entry(index).section)->isRenamable);
    return flags;
}

void ProjectTreeModel::updateStatus(const EntryRef& entry)
{
    const QModelIndex found = indexOf(entry);
    if (found.isValid())
        emit dataChanged(found, found);
}

QStringList ProjectTreeModel::namesOf(int section) const
{
    return sectionAt(static_cast<std::size_t>(section)).names(m_document.project());
}

void ProjectTreeModel::reload(int section)
{
    const QModelIndex parent = index(section, 0);
    QStringList& shown = m_names[static_cast<std::size_t>(section)];
    const QStringList wanted = namesOf(section);
    for (int row = static_cast<int>(shown.size()) - 1; row >= 0; --row) {
        if (!wanted.contains(shown[row])) {
            beginRemoveRows(parent, row, row);
            shown.removeAt(row);
            endRemoveRows();
        }
    }
    for (int row = 0; row < static_cast<int>(wanted.size()); ++row) {
        if (row < shown.size() && shown[row] == wanted[row])
            continue;
        const auto before = static_cast<int>(shown.indexOf(wanted[row], row));
        if (before >= 0) {
            beginMoveRows(parent, before, before, parent, row);
            shown.move(before, row);
            endMoveRows();
        } else {
            beginInsertRows(parent, row, row);
            shown.insert(row, wanted[row]);
            endInsertRows();
        }
    }
    emit dataChanged(parent, parent);
}

/// At once, so that whoever selects the new name finds it.
void ProjectTreeModel::rename(const ChangeEvent& event)
{
    if (event.entry.section == Section::Characters)
        reload(rowOf(Section::BodyParts));
    const QModelIndex index = indexOf({event.entry.section, event.before});
    if (index.isValid()) {
        m_names[static_cast<std::size_t>(index.internalId())][index.row()] = event.entry.name;
        emit dataChanged(index, index);
    }
}

void ProjectTreeModel::follow(const ChangeEvent& event)
{
    switch (event.kind) {
    case ChangeEvent::Kind::Reset:
        beginResetModel();
        for (int i = 0; i < static_cast<int>(sections().size()); ++i)
            m_names[static_cast<std::size_t>(i)] = namesOf(i);
        endResetModel();
        break;
    case ChangeEvent::Kind::List:
        if (const int section = rowOf(event.entry.section); section >= 0)
            reload(section);
        break;
    case ChangeEvent::Kind::Renamed: // see rename
        break;
    case ChangeEvent::Kind::Entry:
        if (event.entry.section == Section::BodyParts) // one value for all characters
            reload(rowOf(Section::BodyParts));
        updateStatus(event.entry);
        break;
    case ChangeEvent::Kind::File:
        break;
    }
}

} // namespace quadrille

#include "moc_projecttreemodel.cpp"
