// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/welcome/welcomepage.h"

#include "editor/fields/verticalscroll.h"
#include "editor/language/retranslate.h"
#include "editor/welcome/recentprojects.h"
#include "editor/welcome/welcometile.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/theme/icons.h"

#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QScrollArea>
#include <QVBoxLayout>

namespace quadrille {

namespace {

constexpr int widest = 900;
constexpr int pageMargin = 16;
constexpr int pageGap = 12;
constexpr int logoSize = 48;

} // namespace

WelcomePage::WelcomePage(Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_title(new QLabel)
    , m_lead(new QLabel)
    , m_notices(new QVBoxLayout)
    , m_missing(new widgets::MessageStrip)
    , m_recent(new RecentProjects(settings))
{
    setObjectName(QStringLiteral("welcomePage"));
    QFont heading = font();
    heading.setPointSizeF(heading.pointSizeF() * 1.8);
    heading.setWeight(QFont::DemiBold);
    m_title->setFont(heading);
    m_lead->setWordWrap(true);
    m_lead->setForegroundRole(QPalette::PlaceholderText);
    auto* logo = new QLabel;
    logo->setPixmap(widgets::icons::application().pixmap(logoSize));
    auto* top = new QGridLayout;
    top->setHorizontalSpacing(pageGap);
    top->setVerticalSpacing(0);
    top->setColumnStretch(1, 1);
    top->addWidget(logo, 0, 0, 2, 1);
    top->addWidget(m_title, 0, 1);
    top->addWidget(m_lead, 1, 1);

    auto* content = new QWidget;
    content->setMaximumWidth(widest);
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(pageMargin, pageMargin, pageMargin, pageMargin);
    column->setSpacing(pageGap);
    column->addLayout(top);
    m_notices->setSpacing(pageGap / 2);
    column->addLayout(m_notices);
    auto* tiles = new QGridLayout;
    tiles->setSpacing(pageGap);
    m_ownTitle = addHeading(*column, QStringLiteral("welcomeOwn"));
    addOwnTiles(*tiles);
    column->addLayout(tiles);
    auto* sampleTiles = new QGridLayout;
    sampleTiles->setSpacing(pageGap);
    m_sampleTitle = addHeading(*column, QStringLiteral("welcomeSample"));
    addSampleTiles(*sampleTiles);
    column->addLayout(sampleTiles);
    m_recentTitle = addHeading(*column, QStringLiteral("welcomeRecent"));
    column->addWidget(m_missing);
    column->addWidget(m_recent);
    column->addStretch(1);

    auto* centred = new QWidget;
    auto* row = new QHBoxLayout(centred);
    row->setContentsMargins(0, 0, 0, 0);
    row->addStretch(1);
    row->addWidget(content, 1000);
    row->addStretch(1);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(verticalScroll(centred));

    connect(m_recent, &RecentProjects::projectRequested, this, &WelcomePage::projectRequested);
    connect(m_recent, &RecentProjects::missingRequested, this, &WelcomePage::offerToForget);
    connect(m_recent, &RecentProjects::refreshed, this, &WelcomePage::showRecent);
    connect(m_missing, &widgets::MessageStrip::actionTriggered, this, [this] {
        m_missing->clear();
        m_recent->forget(m_missingFile);
    });
    showRecent();
    retranslates(this, [this] { retranslate(); });
}

QLabel* WelcomePage::addHeading(QVBoxLayout& column, const QString& name)
{
    auto* label = new QLabel;
    label->setObjectName(name);
    QFont heavier = font();
    heavier.setWeight(QFont::DemiBold);
    label->setFont(heavier);
    label->setContentsMargins(0, pageGap / 2, 0, 0);
    column.addWidget(label);
    return label;
}

void WelcomePage::addOwnTiles(QGridLayout& tiles)
{
    struct Own
    {
        const char* action;
        const char* icon;
    };
    constexpr std::array<Own, 3> own{
        {{"file.import", "import"}, {"file.importFolder", "folder"}, {"file.open", "open"}}};
    for (std::size_t i = 0; i < own.size(); ++i) {
        m_own[i] = new WelcomeTile(QLatin1String(own[i].icon));
        m_own[i]->setObjectName(QStringLiteral("welcome.") + QLatin1String(own[i].action));
        connect(m_own[i], &QAbstractButton::clicked, this,
                [this, id = QString::fromLatin1(own[i].action)] { emit actionRequested(id); });
        tiles.addWidget(m_own[i], 0, static_cast<int>(i));
    }
}

void WelcomePage::addSampleTiles(QGridLayout& tiles)
{
    struct Sample
    {
        SampleGoal goal;
        const char* name;
        const char* icon;
    };
    constexpr std::array<Sample, 3> samples{{{SampleGoal::Play, "welcome.play", "play"},
                                             {SampleGoal::Transitions, "welcome.transitions", "arcs"},
                                             {SampleGoal::Path, "welcome.path", "path"}}};
    for (std::size_t i = 0; i < samples.size(); ++i) {
        m_sample[i] = new WelcomeTile(QLatin1String(samples[i].icon));
        m_sample[i]->setObjectName(QLatin1String(samples[i].name));
        connect(m_sample[i], &QAbstractButton::clicked, this,
                [this, goal = samples[i].goal] { askSample(goal); });
        tiles.addWidget(m_sample[i], 0, static_cast<int>(i));
    }
}

/// A second click on the tile that is at work takes the first one back.
void WelcomePage::askSample(SampleGoal goal)
{
    if (m_sample.at(static_cast<std::size_t>(goal))->isInProgress())
        emit sampleCancelled();
    else
        emit sampleRequested(goal);
}

void WelcomePage::addNotice(QWidget* row)
{
    m_notices->addWidget(row);
}

void WelcomePage::showSampleProgress(SampleGoal goal, double fraction)
{
    const QString percent = QLocale().toString(static_cast<int>(100 * fraction));
    for (std::size_t i = 0; i < m_sample.size(); ++i) {
        const bool isAtWork = i == static_cast<std::size_t>(goal);
        m_sample[i]->setEnabled(isAtWork);
        if (isAtWork)
            m_sample[i]->showProgress(fraction,
                                      tr("Making the character: %1 %. Click again to cancel.").arg(percent));
    }
}

void WelcomePage::endSampleProgress()
{
    for (WelcomeTile* tile : m_sample) {
        tile->setEnabled(true);
        tile->endProgress();
    }
}

void WelcomePage::showRecent()
{
    const bool hasRecent = m_recent->count() > 0;
    m_recentTitle->setVisible(hasRecent);
    m_recent->setVisible(hasRecent);
}

void WelcomePage::offerToForget(const QString& file)
{
    m_missingFile = file;
    m_missing->show(widgets::MessageStrip::Kind::Warning, tr("%1 is not there any more.").arg(file),
                    tr("Open it from where it is now, or take it out of this list."));
    m_missing->setAction(tr("Remove from this list"));
}

void WelcomePage::showEvent(QShowEvent* event)
{
    m_missing->clear();
    m_recent->refresh(); // pictures may be new
    QWidget::showEvent(event);
}

void WelcomePage::retranslate()
{
    m_title->setText(QStringLiteral("Quadrille"));
    m_lead->setText(tr("New performances from captured ones. Drop files or folders anywhere in this window, "
                       "or begin here."));
    m_ownTitle->setText(tr("Your own"));
    m_sampleTitle->setText(tr("Try it with the sample character"));
    m_recentTitle->setText(tr("Recent projects"));
    m_own[0]->setTexts(tr("Open your takes…"),
                       tr("Mesh sequences as files: OBJ, PLY, PC2, MDD, GLB, FBX and more."));
    m_own[1]->setTexts(tr("Open a folder of takes…"), tr("Everything in it, with the mesh that it shares."));
    m_own[2]->setTexts(tr("Open a project…"), tr("What you saved before, as you left it."));
    m_sample[0]->setTexts(tr("Play a take"), tr("Look at a captured walk from all sides."));
    m_sample[1]->setTexts(tr("See transitions"), tr("Where every frame goes over into every other."));
    m_sample[2]->setTexts(tr("Draw a path"), tr("A new performance that follows a line; change the line."));
}

} // namespace quadrille

#include "moc_welcomepage.cpp"
