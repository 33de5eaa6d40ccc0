// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/welcome/welcometile.h"

#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>

namespace quadrille {

namespace {

using widgets::ColorRole;
using widgets::Theme;

constexpr int tileMargin = 12;
constexpr int tileGap = 12;
constexpr int tileSignSize = 32;
constexpr int barHeight = 4;
constexpr int narrowest = 168;
constexpr int usualWidth = 260;
constexpr double tileCorner = 6;

constexpr int textFlags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;

} // namespace

WelcomeTile::WelcomeTile(const QString& icon, QWidget* parent) : QAbstractButton(parent), m_icon(icon)
{
    setFocusPolicy(Qt::StrongFocus);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void WelcomeTile::setTexts(const QString& name, const QString& sentence)
{
    setText(name);
    setAccessibleName(name);
    setAccessibleDescription(sentence);
    m_sentence = sentence;
    updateGeometry();
    update();
}

void WelcomeTile::showProgress(double fraction, const QString& sentence)
{
    m_fraction = std::clamp(fraction, 0.0, 1.0);
    m_progressSentence = sentence;
    setAccessibleDescription(sentence);
    update();
}

void WelcomeTile::endProgress()
{
    m_fraction = -1;
    setAccessibleDescription(m_sentence);
    update();
}

QFont WelcomeTile::nameFont() const
{
    QFont heavier = font();
    heavier.setWeight(QFont::DemiBold);
    return heavier;
}

QRect WelcomeTile::textRect(int width) const
{
    const int left = tileMargin + tileSignSize + tileGap;
    return {left, tileMargin, std::max(width - left - tileMargin, 1), 1};
}

int WelcomeTile::heightForWidth(int width) const
{
    constexpr int plenty = 10000;
    const QRect text = textRect(width).adjusted(0, 0, 0, plenty);
    const int name = QFontMetrics(nameFont()).boundingRect(text, textFlags, this->text()).height();
    const int sentence = fontMetrics().boundingRect(text, textFlags, m_sentence).height();
    return std::max(name + 2 + sentence, tileSignSize) + 2 * tileMargin + barHeight;
}

QSize WelcomeTile::sizeHint() const
{
    return {usualWidth, heightForWidth(usualWidth)};
}

QSize WelcomeTile::minimumSizeHint() const
{
    return {narrowest, heightForWidth(usualWidth)};
}

void WelcomeTile::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    const ColorRole surface = !isEnabled()                 ? ColorRole::Window
                              : isDown()                   ? ColorRole::Pressed
                              : underMouse() || hasFocus() ? ColorRole::Hover
                                                           : ColorRole::Raised;
    painter.setBrush(Theme::color(surface));
    painter.setPen(Theme::color(hasFocus() ? ColorRole::AccentText : ColorRole::Divider));
    painter.drawRoundedRect(frame, tileCorner, tileCorner);
    painter.drawPixmap(
        QRect(tileMargin, tileMargin, tileSignSize, tileSignSize),
        widgets::icons::pixmap(m_icon, tileSignSize,
                               Theme::color(isEnabled() ? ColorRole::AccentText : ColorRole::TextDisabled),
                               devicePixelRatioF()));
    QRect text = textRect(width());
    text.setBottom(height() - tileMargin);
    painter.setFont(nameFont());
    painter.setPen(Theme::color(isEnabled() ? ColorRole::Text : ColorRole::TextDisabled));
    QRect used;
    painter.drawText(text, textFlags, this->text(), &used);
    painter.setFont(font());
    painter.setPen(Theme::color(isEnabled() ? ColorRole::TextMuted : ColorRole::TextDisabled));
    text.setTop(used.bottom() + 3);
    painter.drawText(text, textFlags, sentence());
    if (isInProgress())
        paintProgress(painter);
}

void WelcomeTile::paintProgress(QPainter& painter) const
{
    const QRectF whole(tileMargin, height() - barHeight - tileMargin / 2.0, width() - 2 * tileMargin,
                       barHeight);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Theme::color(ColorRole::Divider));
    painter.drawRoundedRect(whole, barHeight / 2.0, barHeight / 2.0);
    QRectF done = whole;
    done.setWidth(std::max(whole.width() * m_fraction, static_cast<double>(barHeight)));
    painter.setBrush(Theme::color(ColorRole::Accent));
    painter.drawRoundedRect(done, barHeight / 2.0, barHeight / 2.0);
}

void WelcomeTile::enterEvent(QEnterEvent* event)
{
    QAbstractButton::enterEvent(event);
    update();
}

void WelcomeTile::leaveEvent(QEvent* event)
{
    QAbstractButton::leaveEvent(event);
    update();
}

void WelcomeTile::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::FontChange || event->type() == QEvent::EnabledChange) {
        updateGeometry();
        update();
    }
    QAbstractButton::changeEvent(event);
}

} // namespace quadrille

#include "moc_welcometile.cpp"
