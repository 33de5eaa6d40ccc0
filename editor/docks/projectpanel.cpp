// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/docks/projectpanel.h"

#include "editor/commands/animationedits.h"
#include "editor/commands/appearanceedits.h"
#include "editor/commands/brokenedits.h"
#include "editor/commands/entrynames.h"
#include "editor/commands/motionspaceedits.h"
#include "editor/commands/projectedits.h"
#include "editor/commands/projectionedits.h"
#include "editor/commands/transferedits.h"
#include "editor/commands/variationedits.h"
#include "editor/context/editorcontext.h"
#include "editor/docks/projecttreemodel.h"
#include "editor/errors/errortext.h"
#include "editor/fields/namedelegate.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/workspace.h"
#include "model/project/document/brokenentry.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QMenu>
#include <QTreeView>
#include <QUrl>
#include <QVBoxLayout>
#include <array>
#include <utility>

namespace quadrille {

namespace {

/// Of results of all kinds.
ProjectTreeModel::EntryStatus statusOf(const ResultState* result)
{
    ProjectTreeModel::EntryStatus status{.state = EntryState::Stale, .problem = {}};
    if (result == nullptr)
        return status;
    if (result->phase == ResultPhase::Ready)
        status.state = EntryState::Fresh;
    else if (result->phase == ResultPhase::Failed)
        status.state = EntryState::Failed;
    else if (result->phase == ResultPhase::Waiting || result->phase == ResultPhase::Computing)
        status.state = EntryState::Computing;
    if (result->error)
        status.problem = describe(*result->error).oneLine();
    return status;
}

ProjectTreeModel::EntryStatus statusOf(const EditorContext& context, const EntryRef& entry)
{
    if (entry.section == Section::Evaluations)
        return statusOf(context.evaluations.resultState(entry.name));
    if (entry.section == Section::Animations)
        return statusOf(context.animations.resultState(entry.name));
    if (entry.section == Section::Variations)
        return statusOf(context.variations.resultState(entry.name));
    if (entry.section == Section::MotionSpaces)
        return statusOf(context.motionSpaces.resultState(entry.name));
    if (entry.section == Section::Appearances)
        return statusOf(context.appearances.resultState(entry.name));
    if (entry.section == Section::Transfers)
        return statusOf(context.transfers.resultState(entry.name));
    if (entry.section == Section::BodyParts) {
        const QString problem = context.bodies.problemOf(entry.name);
        return {.state = problem.isEmpty() ? EntryState::Fresh : EntryState::Failed, .problem = problem};
    }
    if (entry.section == Section::Project) {
        const auto broken = findBroken(context.document.project(), entry.name.toStdString());
        if (!broken)
            return {};
        const Error error(broken->problem.code, broken->problem.context);
        return {.state = EntryState::Failed, .problem = describe(error).oneLine()};
    }
    if (entry.section == Section::Sequences && context.media.resultState(entry.name) != nullptr)
        return statusOf(context.media.resultState(entry.name));
    return {};
}

} // namespace

ProjectPanel::ProjectPanel(EditorContext& context, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_model(new ProjectTreeModel(
          context.document, [&context](const EntryRef& entry) { return statusOf(context, entry); }, this))
    , m_tree(new QTreeView)
{
    setObjectName(QStringLiteral("projectPanel"));
    m_tree->setObjectName(QStringLiteral("projectTree"));
    m_tree->setModel(m_model);
    m_tree->setHeaderHidden(true);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    m_tree->setEditTriggers(
        QAbstractItemView::NoEditTriggers); // by the action, so that its keys can be changed
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_tree);

    connect(&context.document, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
        if (event.kind == ChangeEvent::Kind::Reset)
            m_tree->expandAll();
        if (event.touches(Section::Project))
            hideEmpty();
    });
    connect(&context.media, &SequenceMedia::changed, this, [this](const QString& name) {
        m_model->updateStatus({Section::Sequences, name});
    });
    connect(&context.animations, &AnimationResults::changed, this, [this](const QString& name) {
        m_model->updateStatus({Section::Animations, name});
    });
    connect(&context.variations, &VariationResults::changed, this, [this](const QString& name) {
        m_model->updateStatus({Section::Variations, name});
    });
    connect(&context.motionSpaces, &MotionSpaceResults::changed, this, [this](const QString& name) {
        m_model->updateStatus({Section::MotionSpaces, name});
    });
    connect(&context.appearances, &AppearanceResults::changed, this, [this](const QString& name) {
        m_model->updateStatus({Section::Appearances, name});
    });
    connect(&context.transfers, &TransferResults::changed, this, [this](const QString& name) {
        m_model->updateStatus({Section::Transfers, name});
    });
    connect(&context.evaluations, &EvaluationResults::changed, this, [this](const QString& name) {
        m_model->updateStatus({Section::Evaluations, name});
    });
    connect(&context.bodies, &BodyProblems::changed, this, [this](const QString& character) {
        m_model->updateStatus({Section::BodyParts, character});
    });
    connect(m_tree->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &ProjectPanel::takeSelection);
    connect(&context.selection, &Selection::changed, this, &ProjectPanel::showSelection);
    connect(m_tree, &QTreeView::activated, this, &ProjectPanel::activate);
    connect(m_tree, &QTreeView::customContextMenuRequested, this, &ProjectPanel::showMenu);
    m_tree->setItemDelegate(new NameDelegate(
        [this](const QModelIndex& index, const QString& name) {
            return problemWithRename(m_context.document.project(), m_model->entry(index), name);
        },
        this));
    makeActions();
    hideEmpty();
    retranslates(this, [this] { m_tree->setAccessibleName(tr("Project")); });
}

void ProjectPanel::makeActions()
{
    ActionRegistry& actions = m_context.actions;
    const auto edit = [] { return tr("Edit"); };
    QAction* rename = actions.add({"edit.rename",
                                   edit,
                                   [] { return tr("Re&name"); },
                                   [] { return tr("Give the selected entry of the project another name"); },
                                   "label",
                                   {Qt::Key_F2}},
                                  [this] {
                                      Workspace::showPanel(this);
                                      m_tree->edit(m_tree->currentIndex());
                                  });
    QAction* duplicate = actions.add(
        {"edit.duplicate",
         edit,
         [] { return tr("&Duplicate"); },
         [] { return tr("Add a copy of the selected sequence, animation or variations, to change it"); },
         "copy",
         {QKeySequence(Qt::CTRL | Qt::Key_D)}},
        [this] { duplicateSelected(); });
    QAction* remove = actions.add({"edit.remove",
                                   edit,
                                   [] { return tr("&Remove from the project"); },
                                   [] { return tr("Take the selected entries out; their files stay"); },
                                   "delete",
                                   {QKeySequence::Delete}},
                                  [this] { removeSelected(); });
    actions.add(
        {"motionSpaces.new",
         [] { return tr("Variations"); },
         [] { return tr("New &motion space"); },
         [] { return tr("Make the selected takes one movement that is steered, such as by its speed"); },
         "add",
         {}},
        [this] {
            const QString name =
                addMotionSpace(m_context.document, tr("motion space"), m_context.selection.sequences());
            m_context.selection.select({Section::MotionSpaces, name});
            m_context.actions.action("edit.properties")->trigger();
        });
    // Keys that mean something else in a text or on the timeline.
    for (QAction* action : {rename, duplicate, remove}) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        m_tree->addAction(action);
    }
    updateActions();
}

void ProjectPanel::updateActions()
{
    const EntryRef& current = m_context.selection.current();
    const SectionInfo* section = current.name.isEmpty() ? nullptr : findSection(current.section);
    m_context.actions.action("edit.rename")->setEnabled(section != nullptr && section->isRenamable);
    m_context.actions.action("edit.remove")->setEnabled(section != nullptr && section->removal != nullptr);
    m_context.actions.action("edit.duplicate")->setEnabled(section != nullptr && section->isDuplicable);
}

QStringList ProjectPanel::selectedNames(Section section) const
{
    QStringList names;
    for (const QModelIndex& index : m_tree->selectionModel()->selectedIndexes()) {
        const EntryRef entry = m_model->entry(index);
        if (entry.section == section && !entry.name.isEmpty())
            names << entry.name;
    }
    return names;
}

void ProjectPanel::takeSelection()
{
    if (m_isFollowing)
        return;
    const QStringList names = selectedNames(Section::Sequences);
    const QStringList animations = selectedNames(Section::Animations);
    if (!names.isEmpty())
        m_context.selection.selectSequences(names);
    else if (!animations.isEmpty())
        m_context.selection.selectAnimations(animations);
    else if (m_tree->currentIndex().isValid())
        m_context.selection.select(m_model->entry(m_tree->currentIndex()));
}

void ProjectPanel::showSelection()
{
    updateActions();
    const EntryRef& current = m_context.selection.current();
    QStringList names = current.section == Section::Animations ? m_context.selection.animations()
                                                               : m_context.selection.sequences();
    if (names.isEmpty())
        names = {current.name};
    QItemSelection selection;
    for (const QString& name : names) {
        if (const QModelIndex index = m_model->indexOf({current.section, name}); index.isValid())
            selection.select(index, index);
    }
    m_isFollowing = true;
    m_tree->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
    if (const QModelIndex index = m_model->indexOf(current); index.isValid())
        m_tree->selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
    m_isFollowing = false;
}

void ProjectPanel::removeSelected()
{
    const EntryRef current = m_context.selection.current();
    QStringList names = selectedNames(current.section);
    if (names.isEmpty())
        names = {current.name};
    if (current.section == Section::Project)
        removeBroken(m_context.document, names);
    else
        removeEntries(m_context.document, current.section, names);
}

void ProjectPanel::duplicateSelected()
{
    const EntryRef current = m_context.selection.current();
    if (current.section == Section::Animations)
        m_context.selection.selectAnimations({duplicateAnimation(m_context.document, current.name)});
    else if (current.section == Section::Variations)
        m_context.selection.select(
            {Section::Variations, duplicateVariation(m_context.document, current.name)});
    else if (current.section == Section::MotionSpaces)
        m_context.selection.select(
            {Section::MotionSpaces, duplicateMotionSpace(m_context.document, current.name)});
    else if (current.section == Section::Appearances)
        m_context.selection.select(
            {Section::Appearances, duplicateAppearance(m_context.document, current.name)});
    else if (current.section == Section::Projections)
        m_context.selection.select(
            {Section::Projections, duplicateProjection(m_context.document, current.name)});
    else if (current.section == Section::Transfers)
        m_context.selection.select({Section::Transfers, duplicateTransfer(m_context.document, current.name)});
    else
        m_context.selection.selectSequences({duplicateSequence(m_context.document, current.name)});
}

void ProjectPanel::activate(const QModelIndex& index)
{
    const EntryRef entry = m_model->entry(index);
    const auto* resultState =
        entry.section == Section::Sequences ? m_context.media.resultState(entry.name) : nullptr;
    if (resultState != nullptr && resultState->phase == ResultPhase::Failed)
        m_context.media.retry(entry.name);
    else if (const SectionInfo* section = findSection(entry.section);
             !entry.name.isEmpty() && section->opening != nullptr)
        m_context.actions.action(QLatin1String(section->opening))->trigger();
    else if (entry.section == Section::Evaluations && m_model->rowCount(index) == 0)
        m_context.actions.action("evaluations.add")->trigger();
    // Its workspace has no panel for it.
    if (entry.section == Section::MotionSpaces && !entry.name.isEmpty())
        m_context.actions.action("edit.properties")->trigger();
}

void ProjectPanel::hideEmpty()
{
    const int row = m_model->indexOf({Section::Project, {}}).row();
    const bool isEmpty = brokenEntries(m_context.document.project()).empty();
    m_tree->setRowHidden(row, {}, isEmpty);
    if (!isEmpty)
        m_tree->expand(m_model->index(row, 0));
}

void ProjectPanel::showMenu(const QPoint& position)
{
    const QModelIndex index = m_tree->indexAt(position);
    QMenu menu(m_tree);
    menu.setObjectName(QStringLiteral("projectMenu"));
    if (!index.isValid() || m_model->entry(index).name.isEmpty())
        fillSectionMenu(menu, index);
    else
        fillEntryMenu(menu, m_model->entry(index));
    if (!menu.isEmpty())
        menu.exec(m_tree->viewport()->mapToGlobal(position));
}

/// What can be added: to a section, or beside all of them.
void ProjectPanel::fillSectionMenu(QMenu& menu, const QModelIndex& section)
{
    for (const SectionInfo& info : sections()) {
        if (section.isValid() && m_model->entry(section).section != info.section)
            continue;
        for (const char* action : info.additions)
            menu.addAction(m_context.actions.action(QLatin1String(action)));
    }
    menu.addSeparator();
    menu.addAction(tr("Unfold all"), m_tree, &QTreeView::expandAll);
    menu.addAction(tr("Fold all"), m_tree, &QTreeView::collapseAll);
}

void ProjectPanel::fillEntryMenu(QMenu& menu, const EntryRef& entry)
{
    for (const char* id :
         {"edit.rename", "edit.duplicate", "edit.remove", "edit.properties", "file.export"}) {
        if (QAction* action = m_context.actions.action(QLatin1String(id)); action->isEnabled())
            menu.addAction(action);
    }
    if (entry.section == Section::Sequences)
        menu.addAction(m_context.actions.action("edit.labelTakes"));
    if (entry.section == Section::Evaluations) {
        for (const char* id : {"evaluations.show", "evaluations.compute", "evaluations.stop"}) {
            if (QAction* action = m_context.actions.action(QLatin1String(id)); action->isEnabled())
                menu.addAction(action);
        }
    }
    const auto* resultState =
        entry.section == Section::Sequences ? m_context.media.resultState(entry.name) : nullptr;
    if (resultState != nullptr && resultState->phase == ResultPhase::Failed) {
        menu.addAction(tr("Try again"), m_tree, [this, name = entry.name] { m_context.media.retry(name); });
        menu.addAction(m_context.actions.action("file.findMissing"));
    }
    if (const SequenceEntry* sequence = m_context.document.sequence(entry.name);
        sequence != nullptr && entry.section == Section::Sequences) {
        const QString folder = QFileInfo(QString::fromStdString(sequence->source)).absolutePath();
        menu.addAction(tr("Show in its folder"), m_tree,
                       [folder] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); });
    }
}

} // namespace quadrille

#include "moc_projectpanel.cpp"
