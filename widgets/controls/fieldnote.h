// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/controls/messagestrip.h"

#include <QPointer>
#include <QTimer>

namespace quadrille::widgets {

/// A sentence beside a field that could not take what was typed into it. It goes when the field is edited or
/// hidden, when another note comes, and some seconds after the keyboard left the field.
class FieldNote : public MessageStrip
{
    Q_OBJECT

public:
    /// Puts a note below a field, or above where there is no room. Its window owns the note.
    /// \param place of the field that it belongs to; all of it by default.
    static void show(QWidget& field, const QString& sentence, const QString& remedy = {},
                     const QRect& place = {});
    /// Takes the note of a window away.
    static void clear(const QWidget& window);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    FieldNote(QWidget& field, const QRect& place);
    void placeIt();

    QPointer<QWidget> m_field;
    QRect m_place;
    QTimer m_lingering;
};

} // namespace quadrille::widgets
