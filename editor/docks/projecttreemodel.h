// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectdocument.h"

#include <QAbstractItemModel>
#include <functional>
#include <vector>

namespace quadrille {

/// How up to date an entry is, as the tree marks it.
enum class EntryState
{
    Fresh,
    Stale,     ///< would be made anew by a rebuild
    Computing, ///< being opened or computed
    Failed,
};

/// The project as a tree: its sections, and their entries by name. Names can be edited in place. What cannot
/// be read of the project is the section Project, by titles.
class ProjectTreeModel : public QAbstractItemModel
{
    Q_OBJECT

public:
    enum Role
    {
        StateRole = Qt::UserRole, ///< EntryState as int; invalid for sections
        ProblemRole,              ///< QString: why an entry failed, or what is stale
    };
    struct EntryStatus
    {
        EntryState state = EntryState::Fresh;
        QString problem;
    };
    using StatusOf = std::function<EntryStatus(const EntryRef&)>;

    /// \param statusOf is asked whenever an entry is shown.
    ProjectTreeModel(ProjectDocument& document, StatusOf statusOf, QObject* parent = nullptr);

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& child) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    /// Renames the entry. \return false where it is refused; EditRefusals tells why.
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

    /// The entry of a row: of a section one without a name, of an invalid index the section Project.
    EntryRef entry(const QModelIndex& index) const;
    /// Invalid where the tree does not show it.
    QModelIndex indexOf(const EntryRef& entry) const;
    /// Says that the status of an entry is another now.
    void updateStatus(const EntryRef& entry);

private:
    static QString stateText(EntryState state);
    void rename(const ChangeEvent& event);
    void follow(const ChangeEvent& event);
    void reload(int section);
    QStringList namesOf(int section) const;

    ProjectDocument& m_document;
    StatusOf m_statusOf;
    std::vector<QStringList> m_names; ///< per section row, what is shown now
};

} // namespace quadrille
