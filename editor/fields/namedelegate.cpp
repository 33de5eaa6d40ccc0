// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/namedelegate.h"

#include "editor/errors/errortext.h"
#include "widgets/controls/fieldnote.h"

#include <QKeyEvent>
#include <QLineEdit>

namespace quadrille {

namespace {

bool commits(const QEvent& event)
{
    if (event.type() != QEvent::KeyPress)
        return false;
    const int key = static_cast<const QKeyEvent&>(event).key();
    return key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Tab || key == Qt::Key_Backtab;
}

} // namespace

NameDelegate::NameDelegate(Check check, QObject* parent)
    : QStyledItemDelegate(parent), m_check(std::move(check))
{
}

QWidget* NameDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                                    const QModelIndex& index) const
{
    m_edited = index;
    return QStyledItemDelegate::createEditor(parent, option, index);
}

void NameDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const
{
    // What is being typed, or is selected to be typed over, stays when a result changes the row meanwhile.
    const auto* field = qobject_cast<QLineEdit*>(editor);
    if (field == nullptr || (!field->isModified() && field->text() != index.data(Qt::EditRole).toString()))
        QStyledItemDelegate::setEditorData(editor, index);
}

bool NameDelegate::eventFilter(QObject* watched, QEvent* event)
{
    auto* field = qobject_cast<QLineEdit*>(watched);
    const bool leaves = event->type() == QEvent::FocusOut;
    if (field == nullptr || !m_edited.isValid() || !(leaves || commits(*event)))
        return QStyledItemDelegate::eventFilter(watched, event);
    const auto problem = m_check(m_edited, field->text());
    if (!problem)
        return QStyledItemDelegate::eventFilter(watched, event);
    const ErrorText text = describe(*problem);
    if (leaves) {
        QWidget& view = *field->parentWidget();
        const QRect place = field->geometry();
        emit closeEditor(field, QAbstractItemDelegate::RevertModelCache);
        widgets::FieldNote::show(view, text.sentence, text.remedy, place);
        return false;
    }
    widgets::FieldNote::show(*field, text.sentence, text.remedy);
    return true;
}

} // namespace quadrille

#include "moc_namedelegate.cpp"
