// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/playbackbar.h"

#include "widgets/controls/elidedlabel.h"
#include "widgets/theme/icons.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>
#include <QToolButton>
#include <algorithm>

namespace quadrille::widgets {

namespace {

/// The greatest number of as many digits: another one of them as the greatest frame leaves the field as wide,
/// so that a sequence that grows with each picture does not lay the window out anew with each.
int roomFor(int lastFrame)
{
    int greatest = 9;
    while (greatest < lastFrame)
        greatest = 10 * greatest + 9;
    return greatest;
}

} // namespace

PlaybackBar::PlaybackBar(QWidget* parent)
    : QWidget(parent)
    , m_first(addButton("first"))
    , m_previous(addButton("stepback"))
    , m_play(addButton("play"))
    , m_next(addButton("step"))
    , m_last(addButton("last"))
    , m_loop(addButton("loop"))
    , m_frame(new QSpinBox(this))
    , m_time(new ElidedLabel(this))
    , m_reached(new QLabel(this))
{
    setObjectName(QStringLiteral("playbackBar"));
    m_frame->setObjectName(QStringLiteral("frameField"));
    m_frame->setKeyboardTracking(false);
    m_frame->setAlignment(Qt::AlignRight);
    m_frame->setButtonSymbols(QAbstractSpinBox::NoButtons);
    m_time->setObjectName(QStringLiteral("timeLabel"));
    m_reached->setObjectName(QStringLiteral("fpsLabel"));
    m_loop->setCheckable(true);
    m_loop->setChecked(true);
    const QFont digits = Theme::tabularFont(font());
    for (QWidget* number :
         {static_cast<QWidget*>(m_frame), static_cast<QWidget*>(m_time), static_cast<QWidget*>(m_reached)})
        number->setFont(digits);

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 4, 8, 4);
    row->setSpacing(4);
    for (QToolButton* button : {m_first, m_previous, m_play, m_next, m_last})
        row->addWidget(button);
    row->addSpacing(8);
    row->addWidget(m_loop);
    row->addSpacing(12);
    row->addWidget(m_frame);
    // What does not fit is not shown at all: a bar is never wider for its numbers.
    row->addWidget(m_time, 1);
    row->addWidget(m_reached);

    connect(m_first, &QToolButton::clicked, this, &PlaybackBar::firstRequested);
    connect(m_previous, &QToolButton::clicked, this, [this] { emit stepRequested(-1); });
    connect(m_play, &QToolButton::clicked, this, &PlaybackBar::playToggled);
    connect(m_next, &QToolButton::clicked, this, [this] { emit stepRequested(1); });
    connect(m_last, &QToolButton::clicked, this, &PlaybackBar::lastRequested);
    connect(m_loop, &QToolButton::toggled, this, &PlaybackBar::loopToggled);
    connect(m_frame, &QSpinBox::valueChanged, this, &PlaybackBar::enter);
    setFrameCount(0);
    retranslate();
}

QToolButton* PlaybackBar::addButton(const char* name)
{
    auto* button = new QToolButton(this);
    button->setObjectName(QLatin1String(name));
    button->setIcon(icons::icon(QLatin1String(name)));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

void PlaybackBar::setFrameCount(int frames)
{
    m_frames = frames;
    const QSignalBlocker quiet(m_frame);
    if (m_frame->value() >= frames)
        m_frame->setValue(std::max(0, frames - 1));
    setRoom(frames - 1);
    setEnabled(frames > 0);
    showTime();
}

void PlaybackBar::setFps(double fps)
{
    m_fps = fps;
    showTime();
}

void PlaybackBar::setCurrentFrame(int frame)
{
    const QSignalBlocker quiet(m_frame);
    // The playhead may stand behind the last frame that plays.
    setRoom(std::max(m_frames - 1, frame));
    m_frame->setValue(frame);
    showTime();
}

void PlaybackBar::setRoom(int lastFrame)
{
    if (const int room = roomFor(lastFrame); room != m_frame->maximum())
        m_frame->setMaximum(room);
}

void PlaybackBar::enter(int frame)
{
    const int last = std::max(0, m_frames - 1);
    if (frame > last)
        setCurrentFrame(last);
    emit frameEntered(std::min(frame, last));
}

void PlaybackBar::setPlaying(bool playing)
{
    m_playing = playing;
    m_play->setIcon(icons::icon(playing ? QStringLiteral("pause") : QStringLiteral("play")));
    if (!playing)
        m_fpsReached = 0;
    retranslate();
}

void PlaybackBar::setLooping(bool looping)
{
    const QSignalBlocker quiet(m_loop);
    m_loop->setChecked(looping);
}

void PlaybackBar::setLoopActions(const QList<QAction*>& actions)
{
    m_loop->addActions(actions);
    m_loop->setPopupMode(QToolButton::MenuButtonPopup);
}

void PlaybackBar::setFpsReached(double fps)
{
    m_fpsReached = fps;
    showTime();
}

void PlaybackBar::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void PlaybackBar::retranslate()
{
    const auto name = [](QToolButton* button, const QString& text) {
        button->setToolTip(text);
        button->setAccessibleName(text);
    };
    name(m_first, tr("First frame (Home)"));
    name(m_previous, tr("Previous frame (←)"));
    name(m_play, m_playing ? tr("Pause (Space)") : tr("Play (Space)"));
    name(m_next, tr("Next frame (→)"));
    name(m_last, tr("Last frame (End)"));
    name(m_loop, tr("Start over at the end"));
    m_frame->setToolTip(tr("Current frame, counted from 0"));
    m_frame->setAccessibleName(tr("Current frame"));
    m_reached->setToolTip(tr("Frames a second that are reached, and that the sequence has"));
    showTime();
}

void PlaybackBar::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    showTime();
}

/// As much of time and rate as there is room for: the rate gives way first, then the last frame, then the
/// end. The longest that they come to while it plays decides, so that nothing comes and goes.
void PlaybackBar::showTime()
{
    const auto seconds = [this](int frame) { return locale().toString(frame / m_fps, 'f', 2); };
    const int lastFrame = std::max(0, m_frames - 1);
    const QString now = seconds(m_frame->value());
    const QString end = seconds(std::max(lastFrame, m_frame->value()));
    const auto whole = [&](const QString& at) {
        return tr("of %1 · %2 / %3 s").arg(locale().toString(lastFrame), at, seconds(lastFrame));
    };
    const auto shorter = [&](const QString& at) { return tr("%1 / %2 s").arg(at, seconds(lastFrame)); };
    const auto shortest = [](const QString& at) { return tr("%1 s").arg(at); };
    const auto playing = [this](double reached) {
        return tr("%1 of %2 fps").arg(locale().toString(reached, 'f', 1), locale().toString(m_fps, 'g', 5));
    };
    const QFontMetrics metrics = m_time->fontMetrics();
    const int room = contentsRect().right() - layout()->contentsMargins().right() - m_time->x();
    const auto left = [&](const QString& time) { return room - metrics.horizontalAdvance(time); };
    const bool isWhole = left(whole(end)) >= 0;
    m_time->setMinimumWidth(metrics.horizontalAdvance(shortest(end)));
    m_time->setText(isWhole ? whole(now) : left(shorter(end)) >= 0 ? shorter(now) : shortest(now));
    m_time->setToolTip(isWhole ? QString() : whole(now));
    m_reached->setText(m_fpsReached > 0 ? playing(m_fpsReached)
                                        : tr("%1 fps").arg(locale().toString(m_fps, 'g', 5)));
    m_reached->setVisible(left(whole(end)) >=
                          layout()->spacing() + metrics.horizontalAdvance(playing(m_fps)));
    // The text changes while it plays: a wider one must not wait for the next layout to be seen whole.
    m_reached->setMinimumWidth(m_reached->sizeHint().width());
}

} // namespace quadrille::widgets

#include "moc_playbackbar.cpp"
