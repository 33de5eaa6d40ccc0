// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/changeevent.h"
#include "editor/properties/propertyform.h"

class QComboBox;
class QLineEdit;
class QPushButton;

namespace quadrille {

struct EditorContext;

/// What pages of entries that are made of a character's sequences have in common: name, character, and a
/// button to the workspace where the rest is done.
class EntryPage : public PropertyForm
{
    Q_OBJECT

public:
    void show(const QString& name) override;
    using QWidget::show;

protected:
    /// What a page is about.
    struct Subject
    {
        Section section;
        const char* name;      ///< object names begin with it
        const char* workspace; ///< the action that goes there; null without addOpen()
        Text characterTip;
    };
    EntryPage(EditorContext& context, Subject subject);

    EditorContext& context() const { return m_context; }
    const QString& entryName() const { return m_name; }
    /// The button, below all that was added by then.
    void addOpen();
    void retranslate() override;
    /// \return the character that the entry is of.
    virtual QString character() const = 0;
    virtual void setCharacter(const QString& character) = 0;
    /// Makes the entry the one that its workspace works on: by default, selects it.
    virtual void select();

private:
    EditorContext& m_context;
    Subject m_subject;
    QString m_name;
    QLineEdit* m_nameField;
    QComboBox* m_character;
    QPushButton* m_open = nullptr;
};

} // namespace quadrille
