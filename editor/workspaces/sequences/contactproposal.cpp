// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/sequences/contactproposal.h"

#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"
#include "model/sequence/contacts.h"

namespace quadrille {

ContactProposal::ContactProposal(EditorContext& context, QObject* parent)
    : QObject(parent), m_context(context)
{
    const auto edit = [] { return tr("Edit"); };
    context.actions.add({"edit.proposeContacts",
                         edit,
                         [] { return tr("&Propose foot contacts"); },
                         [] { return tr("Finds the frames in which the feet stand on the ground"); },
                         "contact",
                         {Qt::SHIFT | Qt::Key_C}},
                        [this] { propose(); });
    context.actions.add(
        {"edit.clearContacts", edit, [] { return tr("&Clear foot contacts"); }, {}, "delete", {}},
        [this] { clear(); });
    connect(&context.document, &ProjectDocument::changed, this, &ContactProposal::updateActions);
    connect(&context.selection, &Selection::changed, this, &ContactProposal::updateActions);
    connect(&context.media, &SequenceMedia::changed, this, &ContactProposal::updateActions);
    updateActions();
}

void ContactProposal::updateActions()
{
    const QString& name = m_context.selection.shownSequence();
    const SequenceEntry* entry = m_context.document.sequence(name);
    m_context.actions.action(QStringLiteral("edit.proposeContacts"))
        ->setEnabled(m_context.media.sequence(name) != nullptr);
    m_context.actions.action(QStringLiteral("edit.clearContacts"))
        ->setEnabled(entry != nullptr && !entry->contacts.empty());
}

void ContactProposal::propose()
{
    const QString name = m_context.selection.shownSequence();
    const MeshSequence* sequence = m_context.media.sequence(name);
    if (sequence == nullptr)
        return;
    if (m_job)
        m_job->cancel();
    // What is found counts the frames of the range as it is now.
    const auto stillStands = [this, name, source = sequence->source, range = sequence->range] {
        const MeshSequence* now = m_context.media.sequence(name);
        return now != nullptr && now->source == source && now->range == range;
    };
    m_job = m_context.jobs.start(
        {.name = tr("Finding foot contacts of “%1”").arg(name), .receiver = this, .stillStands = stillStands},
        [sequence = *sequence, up = m_context.media.upAxis()](const Progress& progress) {
            return detectContacts(sequence, {.up = up}, progress);
        },
        [this, name](std::vector<ContactSpan> contacts) {
            if (contacts.empty())
                emit foundNothing(name);
            else
                setSequenceContacts(m_context.document, name, std::move(contacts));
        });
}

void ContactProposal::clear()
{
    const QString& name = m_context.selection.shownSequence();
    if (m_context.document.sequence(name) != nullptr)
        setSequenceContacts(m_context.document, name, {});
}

} // namespace quadrille

#include "moc_contactproposal.cpp"
