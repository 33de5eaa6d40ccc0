// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/docks/projectpanel.h"

#include "editor/application/editorcontext.h"
#include "editor/docks/projecttreemodel.h"
#include "editor/errors/errortext.h"
#include "editor/language/retranslate.h"

#include <QTreeView>
#include <QVBoxLayout>

namespace quadrille {

namespace {

ProjectTreeModel::EntryStatus statusOf(const SequenceMedia& media, const EntryRef& entry)
{
    ProjectTreeModel::EntryStatus status;
    const auto* medium = entry.section == Section::Sequences ? media.medium(entry.name) : nullptr;
    if (!medium || medium->state == SequenceMedia::State::Ready)
        return status;
    status.state = medium->state == SequenceMedia::State::Failed ? EntryState::Failed : EntryState::Computing;
    if (medium->error)
        status.problem = describe(*medium->error).oneLine();
    return status;
}

} // namespace

ProjectPanel::ProjectPanel(EditorContext& context, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_model(new ProjectTreeModel(
          context.document, [&context](const EntryRef& entry) { return statusOf(context.media, entry); },
          this))
    , m_tree(new QTreeView)
{
    setObjectName(QStringLiteral("projectPanel"));
    m_tree->setObjectName(QStringLiteral("projectTree"));
    m_tree->setModel(m_model);
    m_tree->setHeaderHidden(true);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_tree);

    connect(&context.document, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
        if (event.kind == ChangeEvent::Kind::Reset)
            m_tree->expandAll();
    });
    connect(&context.media, &SequenceMedia::changed, this, [this](const QString& name) {
        m_model->updateStatus({Section::Sequences, name});
    });
    connect(m_tree->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &ProjectPanel::takeSelection);
    retranslates(this, [this] { m_tree->setAccessibleName(tr("Project")); });
}

void ProjectPanel::takeSelection()
{
    QStringList names;
    for (const QModelIndex& index : m_tree->selectionModel()->selectedIndexes()) {
        const EntryRef entry = m_model->entry(index);
        if (entry.section == Section::Sequences && !entry.name.isEmpty())
            names << entry.name;
    }
    if (!names.isEmpty())
        m_context.selection.selectSequences(names);
    else if (m_tree->currentIndex().isValid())
        m_context.selection.select(m_model->entry(m_tree->currentIndex()));
}

} // namespace quadrille
