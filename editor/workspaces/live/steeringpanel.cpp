// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/live/steeringpanel.h"

#include "editor/fields/measuretext.h"
#include "editor/fields/spacemap.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/live/gamepad.h"
#include "editor/workspaces/live/livesession.h"
#include "editor/workspaces/live/spacegraph.h"
#include "widgets/controls/breakable.h"
#include "widgets/theme/theme.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>

namespace quadrille {

namespace {

constexpr int sliderSteps = 1000;
constexpr std::int64_t ticksBetweenReadouts = 10;

} // namespace

SteeringPanel::SteeringPanel(SpaceGraph& graph, LiveSession& session, const Gamepad& gamepad, QWidget* parent)
    : QWidget(parent)
    , m_session(session)
    , m_gamepad(gamepad)
    , m_map(new SpaceMap)
    , m_form(new QFormLayout)
    , m_responsive(new QCheckBox)
    , m_keys(new QLabel)
    , m_readout(new QLabel)
    , m_gamepadText(new QLabel)
{
    setObjectName(QStringLiteral("steeringPanel"));
    m_responsive->setObjectName(QStringLiteral("liveResponsive"));
    m_readout->setObjectName(QStringLiteral("liveReadout"));
    m_readout->setFont(widgets::Theme::tabularFont(m_readout->font()));
    m_keys->setObjectName(QStringLiteral("liveKeys"));
    m_gamepadText->setObjectName(QStringLiteral("liveGamepad"));
    for (QLabel* label : {m_keys, m_readout, m_gamepadText})
        label->setWordWrap(true);
    m_readout->setAlignment(Qt::AlignTop | Qt::AlignLeading);
    makeRows();
    auto* column = new QVBoxLayout(this);
    column->addWidget(&graph, 1);
    column->addWidget(m_map);
    column->addLayout(m_form);
    column->addWidget(m_responsive);
    column->addWidget(m_readout);
    column->addWidget(m_gamepadText);
    column->addWidget(m_keys);
    m_map->setEditable(true);
    connect(m_map, &SpaceMap::wanted, this, [this](const SpacePoint& parameters) {
        for (std::size_t p = 0; p < m_session.steering().parameters().size(); ++p)
            m_session.setParameter(p, parameters.at(p));
        showValues();
    });
    connect(m_responsive, &QCheckBox::toggled, &m_session, &LiveSession::setResponsive);
    connect(&m_session, &LiveSession::changed, this, [this] {
        showParameters();
        showReadout();
    });
    connect(&m_session, &LiveSession::ticked, this, [this] {
        showValues();
        // Numbers that change with every picture cannot be read.
        if (!m_session.isRunning() || m_session.state().tick % ticksBetweenReadouts == 0)
            showReadout();
    });
    connect(&m_gamepad, &Gamepad::connectedChanged, this, &SteeringPanel::showReadout);
    retranslates(this, [this] { retranslate(); });
}

void SteeringPanel::makeRows()
{
    for (std::size_t p = 0; p < SpacePoint().size(); ++p) {
        Row row{new QLabel, new QSlider(Qt::Horizontal), new QLabel};
        row.slider->setObjectName(QStringLiteral("liveParameter%1").arg(p + 1));
        row.slider->setRange(0, sliderSteps);
        row.value->setFont(widgets::Theme::tabularFont(row.value->font()));
        row.value->setMinimumWidth(row.value->fontMetrics().horizontalAdvance(QStringLiteral("−888 °/s")));
        row.value->setAlignment(Qt::AlignTrailing | Qt::AlignVCenter);
        row.name->setBuddy(row.slider);
        auto* line = new QHBoxLayout;
        line->addWidget(row.slider, 1);
        line->addWidget(row.value);
        m_form->addRow(row.name, line);
        connect(row.slider, &QSlider::valueChanged, this, [this, p](int value) {
            const SteeredParameter& steered = m_session.steering().parameters()[p];
            m_session.setParameter(
                p, std::lerp(steered.least, steered.greatest, static_cast<double>(value) / sliderSteps));
            showValues();
        });
        m_rows.push_back(row);
    }
}

void SteeringPanel::retranslate()
{
    m_responsive->setText(tr("Responsive"));
    m_responsive->setToolTip(tr("Transitions come at once, where they may be seen more; R. Else they wait "
                                "for poses that are alike."));
    showParameters();
    showReadout();
}

void SteeringPanel::showParameters()
{
    const QSignalBlocker blocker(m_responsive);
    m_responsive->setChecked(m_session.isResponsive());
    m_responsive->setEnabled(m_session.isReady());
    const std::size_t count = m_session.isReady() ? m_session.steering().parameters().size() : 0;
    m_map->setSpace(count > 0
                        ? m_session.graph()->graph->spaces[static_cast<std::size_t>(m_session.wantedSpace())]
                        : nullptr);
    m_map->setVisible(count > 0);
    for (std::size_t p = 0; p < m_rows.size(); ++p) {
        const bool isShown = p < count;
        m_form->setRowVisible(static_cast<int>(p), isShown);
        if (!isShown)
            continue;
        const auto wanted = static_cast<std::size_t>(m_session.wantedSpace());
        m_rows[p].name->setText(
            QString::fromStdString(m_session.graph()->graph->spaces[wanted]->parameters[p].name));
    }
    m_keys->setText(keysText());
    showValues();
}

/// Keys and what they steer in the space that is wanted: others have no effect.
QString SteeringPanel::keysText() const
{
    QString others = tr("1 to 9: spaces · J: jump · Space: pause", "keys");
    if (!m_session.isReady())
        return others;
    const auto keys = [](SteeringAxis axis) {
        switch (axis) {
        case SteeringAxis::Horizontal:
            return tr("A D or ← →", "keys");
        case SteeringAxis::Vertical:
            return tr("W S or ↑ ↓", "keys");
        default:
            return tr("Page ↑ ↓", "keys");
        }
    };
    const LiveSteering& steering = m_session.steering();
    QStringList lines;
    for (std::size_t p = 0; p < steering.parameters().size(); ++p)
        //: keys, and the parameter that they steer
        lines += tr("%1: %2").arg(keys(steering.axisOf(p)), m_rows[p].name->text());
    if (lines.isEmpty())
        lines += tr("Nothing steers this motion space: it is always the same.");
    lines += others;
    return widgets::breakable(lines.join(QLatin1Char('\n')));
}

void SteeringPanel::showValues()
{
    if (!m_session.isReady())
        return;
    const LiveSteering& steering = m_session.steering();
    for (std::size_t p = 0; p < steering.parameters().size(); ++p) {
        const SteeredParameter& steered = steering.parameters()[p];
        const double value = steering.values().at(p);
        const double share = (value - steered.least) / (steered.greatest - steered.least);
        const QSignalBlocker blocker(m_rows[p].slider);
        if (!m_rows[p].slider->isSliderDown())
            m_rows[p].slider->setValue(static_cast<int>(std::lround(share * sliderSteps)));
        m_rows[p].value->setText(measureText(value, steered.measure));
    }
    const LiveTrack& track = m_session.state().track;
    const bool isPlayed = static_cast<int>(track.space) == m_session.wantedSpace();
    m_map->setPlayed(isPlayed ? std::optional(track.place) : std::nullopt);
}

void SteeringPanel::showReadout()
{
    m_gamepadText->setText(m_gamepad.isConnected() ? tr("Gamepad: %1").arg(m_gamepad.name()) : QString());
    m_gamepadText->setVisible(m_gamepad.isConnected());
    if (!m_session.isReady()) {
        m_readout->clear();
        return;
    }
    const LiveState& state = m_session.state();
    const auto nameOf = [this](std::size_t space) {
        return QString::fromStdString(m_session.graph()->spaces[space]);
    };
    const auto [speed, turning] = m_session.measuredMotion();
    QStringList lines;
    lines += state.way == LiveState::Way::Leaving
                 ? tr("%1, soon %2").arg(nameOf(state.track.space), nameOf(state.target))
                 : nameOf(state.track.space);
    lines += tr("Measured: %1, %2")
                 .arg(measureText(speed, SpaceMeasure::Speed), measureText(turning, SpaceMeasure::Turning));
    if (const LiveDecision* last = m_session.lastDecision()) {
        lines += tr("Last transition: %1 s, dissimilarity %2 of 1000")
                     .arg(QLocale().toString(m_session.latencyOf(*last), 'f', 2),
                          QLocale().toString(last->choices[0].dissimilarity, 'f', 0));
    }
    lines += tr("Tick %1 ms, picture %2 ms")
                 .arg(QLocale().toString(m_session.tickMilliseconds(), 'f', 2),
                      QLocale().toString(m_pictureMilliseconds, 'f', 1));
    m_readout->setText(widgets::breakable(lines.join(QLatin1Char('\n'))));
}

} // namespace quadrille

#include "moc_steeringpanel.cpp"
