// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/standardkeys.h"

namespace quadrille {

namespace {

QList<QKeySequence> ownKeys(QKeySequence::StandardKey key)
{
    switch (key) {
    case QKeySequence::New:
        return {QKeySequence(Qt::CTRL | Qt::Key_N)};
    case QKeySequence::Open:
        return {QKeySequence(Qt::CTRL | Qt::Key_O)};
    case QKeySequence::Close:
        return {QKeySequence(Qt::CTRL | Qt::Key_W)};
    case QKeySequence::Save:
        return {QKeySequence(Qt::CTRL | Qt::Key_S)};
    case QKeySequence::SaveAs:
        return {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)};
    case QKeySequence::Quit:
        return {QKeySequence(Qt::CTRL | Qt::Key_Q)};
    case QKeySequence::Undo:
        return {QKeySequence(Qt::CTRL | Qt::Key_Z)};
    case QKeySequence::Redo:
        return {QKeySequence(Qt::CTRL | Qt::Key_Y), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z)};
    case QKeySequence::Delete:
        return {QKeySequence(Qt::Key_Delete)};
    case QKeySequence::Preferences:
        return {QKeySequence(Qt::CTRL | Qt::Key_Comma)};
    case QKeySequence::ZoomIn: // with the key of the equals sign it needs no Shift
        return {QKeySequence(Qt::CTRL | Qt::Key_Plus), QKeySequence(Qt::CTRL | Qt::Key_Equal)};
    case QKeySequence::ZoomOut:
        return {QKeySequence(Qt::CTRL | Qt::Key_Minus)};
    case QKeySequence::FullScreen:
        return {QKeySequence(Qt::Key_F11)};
    case QKeySequence::HelpContents:
        return {QKeySequence(Qt::Key_F1)};
    default:
        return {};
    }
}

} // namespace

QList<QKeySequence> standardKeys(QKeySequence::StandardKey key)
{
    QList<QKeySequence> keys = ownKeys(key);
    if (const QKeySequence desktop(key); !desktop.isEmpty() && !keys.contains(desktop))
        keys += desktop;
    return keys;
}

} // namespace quadrille
