// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QLineEdit>

namespace quadrille::widgets {

/// A field that lies over what it names while it is edited, and goes by itself. Return, Tab and a press or a
/// turn of the wheel anywhere else take what was typed, Escape leaves everything as it was. No key reaches
/// the widget below, nor a shortcut that is a single key.
class InPlaceEdit : public QLineEdit
{
    Q_OBJECT

public:
    /// Lies over a part of `below`, which gets the keyboard back.
    InPlaceEdit(const QString& text, QWidget& below);
    /// Shows the field, as wide as a name needs, with all of its text selected.
    void begin(const QRect& place);

signals:
    /// At most once: another text that is not blank, without blanks around it.
    void accepted(const QString& text);
    /// Once, at the end and after `accepted`. \param leaves  by Escape: nothing is wanted.
    void ended(bool leaves);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void finish(bool accepts);

    QString m_before;
    bool m_isDone = false;
};

} // namespace quadrille::widgets
