// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectdocument.h"

#include <QObject>
#include <QStringList>

namespace quadrille {

/// What the user has selected: one current entry, and of the sequences maybe several. Follows renames and
/// forgets what is removed.
class Selection : public QObject
{
    Q_OBJECT

public:
    explicit Selection(ProjectDocument& document, QObject* parent = nullptr);

    /// The entry whose properties are shown; Section::Project without a name when nothing is selected.
    const EntryRef& current() const { return m_current; }
    /// The selected sequences in the order of selecting; the current one is among them.
    const QStringList& sequences() const { return m_sequences; }
    /// The sequence that the viewport and the timeline show: the last one selected that still exists. Where
    /// that one goes, the first of the project; empty in a project without any. So for animations, variations
    /// and models of appearance.
    const QString& shownSequence() const { return m_shown; }
    /// The selected animations in the order of selecting; those of the last time one was selected.
    const QStringList& animations() const { return m_animations; }
    /// The animation that its workspace works on: the last one selected that still exists.
    const QString& shownAnimation() const { return m_shownAnimation; }
    /// The variations that their workspace works on: the last ones selected that still exist.
    const QString& shownVariation() const { return m_shownVariation; }
    /// The model of appearance that its workspace works on: the last one selected that still exists.
    const QString& shownAppearance() const { return m_shownAppearance; }
    const QString& shownTransfer() const { return m_shownTransfer; }

    /// A sequence or an animation becomes the only one selected of its kind. Selecting anything but sequences
    /// lets go of these. `changed` is told where the selection is another.
    void select(const EntryRef& entry);
    /// No names clear the selection.
    /// \param current one of `names`, or empty for the last.
    void selectSequences(const QStringList& names, const QString& current = {});
    /// The last of them is the current one; nothing happens without names.
    void selectAnimations(const QStringList& names);
    /// Nothing is selected then; what is shown stays.
    void clear() { select({}); }

signals:
    /// Also when an entry, be it not a selected one, has another name.
    void changed();

private:
    void rename(const ChangeEvent& event);
    void follow(const ChangeEvent& event);
    bool exists(const EntryRef& entry) const;
    void showExisting();

    ProjectDocument& m_document;
    EntryRef m_current;
    QStringList m_sequences;
    QString m_shown;
    QStringList m_animations;
    QString m_shownAnimation;
    QString m_shownVariation;
    QString m_shownAppearance;
    QString m_shownTransfer;
};

} // namespace quadrille
