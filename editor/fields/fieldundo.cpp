// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/fieldundo.h"

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QTextEdit>
#include <optional>

namespace quadrille {

namespace {

/// What a field could take back of what is typed.
struct Typing
{
    bool canUndo = false;
    bool canRedo = false;
};

Typing typingIn(const QLineEdit& edit)
{
    return {edit.isUndoAvailable() && edit.isModified(), edit.isRedoAvailable()};
}

/// Whether a number reads otherwise than its value: it is typed and not taken yet.
template <typename Box>
bool isPending(const Box& box)
{
    if (!box.specialValueText().isEmpty() && box.text() == box.specialValueText())
        return false;
    bool isNumber = false;
    const double typed = box.locale().toDouble(box.cleanText(), &isNumber);
    return !isNumber || typed != static_cast<double>(box.value());
}

Typing typingIn(const QAbstractSpinBox& field)
{
    const auto* edit = field.findChild<QLineEdit*>();
    const auto* whole = qobject_cast<const QSpinBox*>(&field);
    const auto* real = qobject_cast<const QDoubleSpinBox*>(&field);
    const bool pending = (whole != nullptr && isPending(*whole)) || (real != nullptr && isPending(*real));
    return pending && edit != nullptr ? typingIn(*edit) : Typing{};
}

/// Nothing for what is no field.
std::optional<Typing> typingIn(const QObject* object)
{
    if (const auto* edit = qobject_cast<const QLineEdit*>(object))
        return typingIn(*edit);
    if (const auto* field = qobject_cast<const QAbstractSpinBox*>(object))
        return typingIn(*field);
    if (const auto* box = qobject_cast<const QComboBox*>(object); box != nullptr && box->isEditable())
        return typingIn(*box->lineEdit());
    const QTextDocument* document = nullptr;
    if (const auto* text = qobject_cast<const QTextEdit*>(object))
        document = text->document();
    else if (const auto* plain = qobject_cast<const QPlainTextEdit*>(object))
        document = plain->document();
    if (document == nullptr)
        return std::nullopt;
    return Typing{document->isUndoAvailable(), document->isRedoAvailable()};
}

} // namespace

FieldUndo::FieldUndo(QObject* parent) : QObject(parent)
{
    qApp->installEventFilter(this);
}

bool FieldUndo::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::ShortcutOverride)
        return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool undoes = key->matches(QKeySequence::Undo);
    if (!undoes && !key->matches(QKeySequence::Redo))
        return false;
    const std::optional<Typing> typing = typingIn(watched);
    if (!typing || (undoes ? typing->canUndo : typing->canRedo))
        return false;
    // Fields claim these keys even where they have nothing to do with them.
    event->ignore();
    return true;
}

} // namespace quadrille

#include "moc_fieldundo.cpp"
