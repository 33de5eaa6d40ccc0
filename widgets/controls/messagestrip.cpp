// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/controls/messagestrip.h"

#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QBoxLayout>
#include <QEvent>
#include <QLabel>
#include <QPushButton>

namespace quadrille::widgets {

namespace {

struct Look
{
    const char* icon;
    ColorRole sign;
    const char* name; ///< for assistive tools
};

Look lookOf(MessageStrip::Kind kind)
{
    switch (kind) {
    case MessageStrip::Kind::Error:
        return {"error", ColorRole::Error, QT_TRANSLATE_NOOP("quadrille::widgets::MessageStrip", "Error")};
    case MessageStrip::Kind::Warning:
        return {"warning", ColorRole::Warning,
                QT_TRANSLATE_NOOP("quadrille::widgets::MessageStrip", "Warning")};
    case MessageStrip::Kind::Info:
        break;
    }
    return {"info", ColorRole::Accent, QT_TRANSLATE_NOOP("quadrille::widgets::MessageStrip", "Note")};
}

} // namespace

MessageStrip::MessageStrip(QWidget* parent)
    : QFrame(parent)
    , m_sign(new QLabel)
    , m_text(new QLabel)
    , m_action(new QPushButton)
    , m_content(new QBoxLayout(QBoxLayout::LeftToRight))
{
    setObjectName(QStringLiteral("messageStrip"));
    setAutoFillBackground(true);
    m_text->setObjectName(QStringLiteral("messageStripText"));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_action->setObjectName(QStringLiteral("messageStripAction"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 8, 12, 8);
    row->setSpacing(8);
    row->addWidget(m_sign, 0, Qt::AlignTop);
    m_content->setSpacing(8);
    m_content->addWidget(m_text, 1);
    m_content->addWidget(m_action, 0, Qt::AlignTop | Qt::AlignLeft);
    row->addLayout(m_content, 1);
    m_action->hide();
    hide();
    connect(m_action, &QPushButton::clicked, this, &MessageStrip::actionTriggered);
    connect(&Theme::instance(), &Theme::changed, this, &MessageStrip::refresh);
    refresh();
}

void MessageStrip::show(Kind kind, const QString& sentence, const QString& remedy)
{
    m_kind = kind;
    m_sentence = sentence;
    m_remedy = remedy;
    refresh();
    setVisible(!isEmpty());
}

void MessageStrip::clear()
{
    show(Kind::Info, {});
}

QString MessageStrip::text() const
{
    return m_text->text();
}

void MessageStrip::setAction(const QString& text)
{
    m_action->setText(text);
    m_action->setVisible(!text.isEmpty());
    arrange();
}

void MessageStrip::arrange()
{
    const bool isNarrow = m_action->sizeHint().width() > width() / 3;
    m_content->setDirection(isNarrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void MessageStrip::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    arrange();
}

void MessageStrip::refresh()
{
    const Look look = lookOf(m_kind);
    const QColor sign = Theme::color(look.sign);
    m_sign->setPixmap(icons::pixmap(QLatin1String(look.icon), 16, sign, devicePixelRatioF()));
    m_text->setText(m_remedy.isEmpty() ? m_sentence : m_sentence + QLatin1Char('\n') + m_remedy);
    setAccessibleName(tr(look.name));
    setAccessibleDescription(m_text->text());
    QPalette colors = palette();
    const QColor base = Theme::color(ColorRole::Window);
    constexpr float share = 0.12F; // of the sign's colour
    const auto mixed = [&](float a, float b) { return a + share * (b - a); };
    colors.setColor(QPalette::Window,
                    QColor::fromRgbF(mixed(base.redF(), sign.redF()), mixed(base.greenF(), sign.greenF()),
                                     mixed(base.blueF(), sign.blueF())));
    if (colors != palette())
        setPalette(colors);
}

void MessageStrip::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        refresh();
    QFrame::changeEvent(event);
}

} // namespace quadrille::widgets

#include "moc_messagestrip.cpp"
