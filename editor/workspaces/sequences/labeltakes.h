// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>
#include <QStringList>

class QComboBox;
class QDialogButtonBox;
class QTableWidget;

namespace quadrille {

class ProjectDocument;
class SequenceMedia;

/// What a take is most likely about: its name without numbers and underscores, "walk" for "walk_1".
QString proposedLabel(const QString& take);

/// Gives takes a label each over all their frames, in one undo step. The labels are proposed from the names;
/// they can be changed one by one, or all at once.
class LabelTakes : public QDialog
{
    Q_OBJECT

public:
    /// \param takes  those that are not open yet cannot be labelled, and say so.
    LabelTakes(ProjectDocument& document, const SequenceMedia& media, const QStringList& takes,
               QWidget* parent);

    void accept() override;

private:
    void fill(const QStringList& takes);
    void labelAll(const QString& label);
    void updateButton();

    ProjectDocument& m_document;
    const SequenceMedia& m_media;
    QComboBox* m_all;
    QTableWidget* m_table;
    QDialogButtonBox* m_buttons;
};

} // namespace quadrille
