// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QPointer>

namespace quadrille {

class Job;
struct EditorContext;

/// Proposes foot contacts for the sequence that is shown, in a job; what it finds replaces the contacts there
/// were, in one undo step.
class ContactProposal : public QObject
{
    Q_OBJECT

public:
    /// Registers the actions.
    explicit ContactProposal(EditorContext& context, QObject* parent = nullptr);

    /// Starts anew where it was under way. What is found is dropped where frames or range of the sequence are
    /// others by then.
    void propose();
    /// Takes all contacts of the sequence that is shown away, undoably.
    void clear();

signals:
    /// A sequence shows no feet that stand. Its contacts stay.
    void foundNothing(const QString& sequence);

private:
    void updateActions();

    EditorContext& m_context;
    QPointer<Job> m_job;
};

} // namespace quadrille
