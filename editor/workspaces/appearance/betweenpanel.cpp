// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/appearance/betweenpanel.h"

#include "editor/fields/sliderfield.h"
#include "editor/fields/verticalscroll.h"
#include "editor/language/retranslate.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <cmath>

namespace quadrille {

namespace {

constexpr int betweenMargin = 12;
constexpr double hundred = 100;

} // namespace

BetweenPanel::BetweenPanel(ShownTexture& shown, QWidget* parent)
    : QWidget(parent)
    , m_shown(shown)
    , m_sentence(new QLabel)
    , m_ends{End{new QLabel, new QLabel, new QPushButton, new QPushButton},
             End{new QLabel, new QLabel, new QPushButton, new QPushButton}}
    , m_weightLabel(new QLabel)
    , m_weight(new SliderField("betweenWeight", "betweenPercent"))
    , m_note(new QLabel)
{
    setObjectName(QStringLiteral("betweenPanel"));
    arrangeWidgets();
    for (std::size_t end = 0; end < m_ends.size(); ++end) {
        connect(m_ends.at(end).take, &QPushButton::clicked, this, [this, end] {
            const auto frame = m_shown.appearance().frame();
            if (m_shown.mode() != TextureMode::SideBySide)
                m_shown.setMode(TextureMode::Swipe);
            m_shown.setBetween(end == 0 ? frame : m_shown.from(), end == 1 ? frame : m_shown.to());
        });
        connect(m_ends.at(end).show, &QPushButton::clicked, this, [this, end] {
            if (frameOf(end))
                m_shown.appearance().goTo(NamedFrame(*frameOf(end)));
        });
    }
    connect(m_weight, &SliderField::edited, this,
            [this](int percent) { m_shown.setWeight(percent / hundred); });
    connect(&shown, &ShownTexture::changed, this, &BetweenPanel::refresh);
    retranslates(this, [this] { retranslate(); });
}

const std::optional<NamedFrame>& BetweenPanel::frameOf(std::size_t end) const
{
    return end == 0 ? m_shown.from() : m_shown.to();
}

void BetweenPanel::arrangeWidgets()
{
    const std::array names{QStringLiteral("betweenFrom"), QStringLiteral("betweenTo")};
    auto* grid = new QGridLayout;
    for (std::size_t i = 0; i < m_ends.size(); ++i) {
        End& end = m_ends.at(i);
        end.frame->setObjectName(names.at(i) + QStringLiteral("Frame"));
        end.take->setObjectName(names.at(i) + QStringLiteral("Take"));
        end.show->setObjectName(names.at(i) + QStringLiteral("Show"));
        const int row = static_cast<int>(i);
        grid->addWidget(end.label, row, 0);
        grid->addWidget(end.frame, row, 1);
        grid->addWidget(end.take, row, 2);
        grid->addWidget(end.show, row, 3);
    }
    grid->addWidget(m_weightLabel, 2, 0);
    grid->addWidget(m_weight, 2, 1, 1, 3);
    grid->setColumnStretch(1, 1);
    m_note->setObjectName(QStringLiteral("betweenNote"));
    m_weightLabel->setBuddy(m_weight);
    for (QLabel* label : {m_sentence, m_note}) {
        label->setWordWrap(true);
        label->setForegroundRole(QPalette::PlaceholderText);
    }
    auto* page = new QWidget;
    auto* rows = new QVBoxLayout(page);
    rows->setContentsMargins(betweenMargin, betweenMargin / 2, betweenMargin, betweenMargin);
    rows->addWidget(m_sentence);
    rows->addLayout(grid);
    rows->addWidget(m_note);
    rows->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(verticalScroll(page));
}

void BetweenPanel::retranslate()
{
    m_sentence->setText(tr("The texture between two captured frames: a linear blend shows both, one through "
                           "the other; the model moves the one to the other."));
    m_ends[0].label->setText(tr("From"));
    m_ends[1].label->setText(tr("To"));
    for (const End& end : m_ends) {
        end.take->setText(tr("This frame"));
        end.take->setToolTip(tr("Take the frame that is shown"));
        end.take->setAccessibleName(tr("%1: this frame").arg(end.label->text()));
        end.show->setText(tr("Show"));
        end.show->setToolTip(tr("Go to that frame"));
        end.show->setAccessibleName(tr("%1: show").arg(end.label->text()));
    }
    m_weightLabel->setText(tr("Weight"));
    m_weight->setTexts(tr("Weight"), tr(" %", "percent"), tr("How far from the first frame to the second"));
    refresh();
}

void BetweenPanel::refresh()
{
    const bool hasFrame = m_shown.appearance().frame().has_value();
    for (std::size_t i = 0; i < m_ends.size(); ++i) {
        const End& end = m_ends.at(i);
        end.frame->setText(frameOf(i) ? frameText(*frameOf(i)) : tr("none yet"));
        end.take->setEnabled(hasFrame);
        end.show->setEnabled(frameOf(i).has_value());
    }
    const bool hasBoth = m_shown.from() && m_shown.to();
    m_weight->setEnabled(hasBoth);
    m_weight->setValue(static_cast<int>(std::lround(hundred * m_shown.weight())));
    m_note->setText(m_shown.content() == TextureContent::Between ? m_shown.missing() : QString());
}

} // namespace quadrille

#include "moc_betweenpanel.cpp"
