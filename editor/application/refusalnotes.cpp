// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/refusalnotes.h"

#include "editor/documents/editcheck.h"
#include "editor/errors/errortext.h"
#include "widgets/controls/fieldnote.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>

namespace quadrille {

namespace {

/// The field that a widget is or is part of; null where it is none.
QWidget* fieldOf(QWidget* widget)
{
    if (widget == nullptr || !widget->isVisible())
        return nullptr;
    if (auto* spinBox = qobject_cast<QAbstractSpinBox*>(widget->parentWidget()))
        return spinBox;
    if (auto* comboBox = qobject_cast<QComboBox*>(widget->parentWidget()))
        return comboBox;
    const bool isField =
        qobject_cast<QLineEdit*>(widget) != nullptr || qobject_cast<QAbstractSpinBox*>(widget) != nullptr ||
        qobject_cast<QComboBox*>(widget) != nullptr || qobject_cast<QPlainTextEdit*>(widget) != nullptr ||
        qobject_cast<QTextEdit*>(widget) != nullptr;
    return isField ? widget : nullptr;
}

} // namespace

RefusalNotes::RefusalNotes(ProjectDocument& document, QObject* parent) : QObject(parent), m_document(document)
{
    connect(&EditRefusals::of(document), &EditRefusals::refused, this, &RefusalNotes::tell);
    qApp->installEventFilter(this);
}

bool RefusalNotes::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::FocusOut)
        m_left = qobject_cast<QWidget*>(watched);
    else if (event->type() == QEvent::FocusIn)
        m_left.clear();
    return QObject::eventFilter(watched, event);
}

void RefusalNotes::tell(const Error& error)
{
    const ErrorText text = describe(error);
    QWidget* field = fieldOf(m_left ? m_left.data() : QApplication::focusWidget());
    if (field != nullptr) {
        widgets::FieldNote::show(*field, text.placed(), text.remedy);
        return;
    }
    emit told(text.oneLine());
    // What was dragged goes back; not at once, for whoever was dragging is still at it.
    QMetaObject::invokeMethod(this, &RefusalNotes::showAgain, Qt::QueuedConnection);
}

void RefusalNotes::showAgain()
{
    emit m_document.changed(ChangeEvent::list(Section::Graphs));
    for (const SectionInfo& section : sections())
        emit m_document.changed(ChangeEvent::list(section.section));
}

} // namespace quadrille

#include "moc_refusalnotes.cpp"
