// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QFrame>

class QBoxLayout;
class QLabel;
class QPushButton;

namespace quadrille::widgets {

/// A message beside what it is about: a sign, a sentence, a remedy, and maybe a button that helps. Hidden
/// while there is nothing to say.
class MessageStrip : public QFrame
{
    Q_OBJECT

public:
    enum class Kind
    {
        Info,
        Warning,
        Error
    };

    explicit MessageStrip(QWidget* parent = nullptr);

    /// \param remedy may be empty.
    void show(Kind kind, const QString& sentence, const QString& remedy = {});
    /// Hides it; the text of the button stays.
    void clear();
    bool isEmpty() const { return m_sentence.isEmpty(); }
    Kind kind() const { return m_kind; }
    /// Sentence and remedy, as they are shown.
    QString text() const;
    /// A button that helps; an empty text takes it away.
    void setAction(const QString& text);

signals:
    /// The button was pressed.
    void actionTriggered();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void refresh();
    /// The button stands below the text where it would leave it few words a line.
    void arrange();

    Kind m_kind = Kind::Info;
    QString m_sentence;
    QString m_remedy;
    QLabel* m_sign;
    QLabel* m_text;
    QPushButton* m_action;
    QBoxLayout* m_content; ///< text and button
};

} // namespace quadrille::widgets
