// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/junctionpanel.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/rightmenu.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/junctioninspector.h"
#include "editor/workspaces/animate/transitionpreview.h"
#include "editor/workspaces/view/sceneview.h"
#include "widgets/controls/elidedpair.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/theme/icons.h"
#include "widgets/timeline/timelinescale.h"

#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QScopedValueRollback>
#include <QTreeWidget>
#include <array>

namespace quadrille {

namespace {

constexpr int hoverMilliseconds = 150;
constexpr int costDecimals = 3;

QString numberText(double value)
{
    return QLocale().toString(value, 'f', costDecimals);
}

QString nameOf(const JunctionEntry& junction)
{
    const auto text = [](const NamedFrame& frame) {
        return QStringLiteral("%1 %2").arg(QString::fromStdString(frame.sequence)).arg(frame.frame.value);
    };
    return widgets::pairText(text(junction.from), text(junction.to));
}

void setCost(QTreeWidgetItem& item, int column, const PricedJunction& junction)
{
    item.setText(column, numberText(junction.weight()));
    item.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    item.setFont(column, widgets::Theme::tabularFont(item.font(column)));
}

} // namespace

JunctionPanel::JunctionPanel(CurrentAnimation& animation, QWidget* parent)
    : QWidget(parent)
    , m_animation(animation)
    , m_preview(new TransitionPreview(animation.context().jobs, this))
    , m_inspector(new JunctionInspector(animation.context().jobs, this))
    , m_message(new widgets::MessageStrip)
    , m_list(new QTreeWidget)
    , m_details(new QLabel)
    , m_quality(new QLabel)
    , m_alternativesTitle(new QLabel)
    , m_alternativesList(new QTreeWidget)
    , m_decisionsTitle(new QLabel)
    , m_decisionsList(new QTreeWidget)
    , m_empty(new QLabel)
    , m_buttons(new QWidget)
{
    setObjectName(QStringLiteral("junctionPanel"));
    m_delay.setSingleShot(true);
    m_delay.setInterval(hoverMilliseconds);
    makeActions();
    makeLists();
    arrangeWidgets();
    connect(&m_delay, &QTimer::timeout, this, [this] { previewAlternative(m_hovered); });
    connect(m_inspector, &JunctionInspector::changed, this, &JunctionPanel::showQuality);
    connect(&animation, &CurrentAnimation::changed, this, &JunctionPanel::refresh);
    connect(&animation, &CurrentAnimation::resultChanged, this, &JunctionPanel::refresh);
    connect(m_message, &widgets::MessageStrip::actionTriggered, this, &JunctionPanel::releaseWalk);
    connect(&animation.view().player(), &Player::playingChanged, this, [this](bool playing) {
        if (playing || !std::exchange(m_playsAround, false))
            return;
        m_animation.view().player().setLooping(m_animation.context().settings.loopsPlayback());
        m_animation.view().updateRange();
    });
    retranslates(this, [this] { retranslate(); });
}

void JunctionPanel::makeLists()
{
    const auto prepare = [](QTreeWidget* list, const char* name, int columns, int wide) {
        list->setObjectName(QLatin1String(name));
        list->setColumnCount(columns);
        list->setRootIsDecorated(false);
        list->setUniformRowHeights(true);
        list->setAllColumnsShowFocus(true);
        list->setFrameShape(QFrame::NoFrame);
        list->setItemDelegateForColumn(wide, new widgets::PairDelegate(list));
        list->setMinimumHeight(96);
        list->header()->setStretchLastSection(false);
        for (int column = 0; column < columns; ++column)
            list->header()->setSectionResizeMode(column, column == wide ? QHeaderView::Stretch
                                                                        : QHeaderView::ResizeToContents);
    };
    prepare(m_list, "junctionList", 3, 1);
    prepare(m_alternativesList, "alternativeList", 3, 0);
    prepare(m_decisionsList, "decisionList", 2, 1);
    QList<QAction*> actions;
    for (const char* id : {"junction.play", "junction.choose", "junction.lock", "junction.lockSegment",
                           "junction.ban", "junction.banNeighbours"})
        actions += m_animation.context().actions.action(id);
    addRightMenu(*m_list, actions);
    addRightMenu(*m_alternativesList);
    addRightMenu(*m_decisionsList, {m_animation.context().actions.action("junction.forget")});
    m_alternativesList->setMouseTracking(true);
    connect(m_list, &QTreeWidget::currentItemChanged, this, [this] {
        if (!m_isRefreshing) {
            keepCurrent();
            goTo(current());
        }
        showDetails();
        refreshAlternatives();
        updateActions();
        if (!m_isRefreshing)
            emit junctionSelected(current());
    });
    connect(m_list, &QTreeWidget::itemClicked, this, [this] { playAround(current()); });
    connect(m_list, &QTreeWidget::itemActivated, this, [this] { playAround(current()); });
    connect(m_alternativesList, &QTreeWidget::itemEntered, this, [this](const QTreeWidgetItem* item) {
        m_hovered = item;
        m_delay.start();
    });
    connect(m_alternativesList, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
        m_hovered = item;
        m_delay.start();
    });
    connect(m_alternativesList, &QTreeWidget::itemActivated, this, &JunctionPanel::chooseCurrent);
    connect(m_decisionsList, &QTreeWidget::currentItemChanged, this, &JunctionPanel::updateActions);
}

void JunctionPanel::refresh()
{
    const auto* entry = m_animation.entry();
    if (m_result != m_animation.result()) {
        m_result = m_animation.result();
        refreshJunctions();
    }
    refreshDecisions();
    m_empty->setVisible(m_junctions.empty());
    m_list->setVisible(!m_junctions.empty());
    m_details->setVisible(!m_junctions.empty());
    if (m_junctions.empty() || entry == nullptr || entry->walk)
        setChoosing(false);
    showState();
    updateActions();
}

void JunctionPanel::refreshJunctions()
{
    // The transition that was selected stays so while it is in the walk, else the one at its place; so where
    // there is no walk for a while.
    const QScopedValueRollback refreshing(m_isRefreshing, true);
    m_junctions = m_result == nullptr ? std::vector<ClipJunction>() : junctionsOf(*m_result);
    m_list->clear();
    int place = m_kept ? std::min(m_kept->place, static_cast<int>(m_junctions.size()) - 1) : -1;
    const double fps = m_animation.context().document.project().settings.fps;
    for (std::size_t i = 0; i < m_junctions.size(); ++i) {
        const ClipJunction& junction = m_junctions[i];
        auto* item = new QTreeWidgetItem(m_list);
        item->setText(0, junction.shown ? widgets::timeText(static_cast<double>(junction.shown->first) / fps)
                                        : tr("cut", "a transition that is not in the clip any more"));
        item->setText(1, nameOf(junction.transition.names));
        item->setToolTip(1, item->text(1));
        setCost(*item, 2, junction.transition);
        if (m_kept && m_kept->frames == junction.transition.frames)
            place = static_cast<int>(i);
    }
    select(place);
    showDetails();
    refreshAlternatives();
}

void JunctionPanel::keepCurrent()
{
    const ClipJunction* junction = currentJunction();
    m_kept = junction == nullptr ? std::nullopt
                                 : std::optional(KeptJunction{junction->transition.frames, current()});
}

void JunctionPanel::refreshDecisions()
{
    const AnimationEntry* entry = m_animation.entry();
    const JunctionsEntry decided = entry == nullptr ? JunctionsEntry() : entry->junctions;
    const auto icon = [](const char* name) { return widgets::icons::icon(QLatin1String(name)); };
    for (std::size_t i = 0; i < m_junctions.size(); ++i) {
        const JunctionEntry& names = m_junctions[i].transition.names;
        QTreeWidgetItem* item = m_list->topLevelItem(static_cast<int>(i));
        const bool isLocked = contains(decided.locked, names);
        const bool isChosen = contains(decided.chosen, names);
        item->setIcon(1, isLocked ? icon("lock") : isChosen ? icon("exchange") : QIcon());
        item->setToolTip(0, isLocked ? tr("Locked") : isChosen ? tr("Chosen") : QString());
    }
    const int before = m_decisionsList->indexOfTopLevelItem(m_decisionsList->currentItem());
    m_decisions.clear();
    m_decisionsList->clear();
    const auto add = [&](const std::vector<JunctionEntry>& junctions, const char* iconName,
                         const QString& decision) {
        for (const JunctionEntry& junction : junctions) {
            auto* item = new QTreeWidgetItem(m_decisionsList, {decision, nameOf(junction)});
            item->setIcon(0, icon(iconName));
            item->setToolTip(1, item->text(1));
            m_decisions.push_back(junction);
        }
    };
    add(decided.banned, "ban", tr("Banned"));
    add(decided.locked, "lock", tr("Locked"));
    add(decided.chosen, "exchange", tr("Chosen"));
    const int last = static_cast<int>(m_decisions.size()) - 1;
    if (before >= 0 && last >= 0)
        m_decisionsList->setCurrentItem(m_decisionsList->topLevelItem(std::min(before, last)));
    m_decisionsTitle->setVisible(last >= 0);
    m_decisionsList->setVisible(last >= 0);
}

void JunctionPanel::refreshAlternatives()
{
    const int junction = current();
    m_hovered = nullptr;
    m_delay.stop();
    m_alternativesList->clear();
    m_alternatives.clear();
    if (m_isChoosing && junction >= 0 && m_animation.entry() != nullptr)
        m_alternatives =
            alternativesTo(*m_result, static_cast<std::size_t>(junction), m_animation.entry()->junctions);
    for (const PricedJunction& alternative : m_alternatives) {
        auto* item = new QTreeWidgetItem(m_alternativesList);
        item->setText(0, nameOf(alternative.names));
        item->setToolTip(0, item->text(0));
        item->setText(1, QLocale().toString(alternative.length));
        item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        setCost(*item, 2, alternative);
    }
    m_alternativesTitle->setText(m_alternatives.empty() ? tr("No other transition is nearby.")
                                                        : tr("Instead of it"));
    m_alternativesTitle->setVisible(m_isChoosing);
    m_alternativesList->setVisible(!m_alternatives.empty());
    if (m_alternatives.empty())
        m_preview->end();
}

void JunctionPanel::previewAlternative(const QTreeWidgetItem* item)
{
    const int place = m_alternativesList->indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(item));
    if (place >= 0 && m_animation.entry() != nullptr)
        m_preview->show(m_result->character, m_alternatives[static_cast<std::size_t>(place)].frames,
                        *m_animation.entry());
}

int JunctionPanel::current() const
{
    return m_list->indexOfTopLevelItem(m_list->currentItem());
}

const ClipJunction* JunctionPanel::currentJunction() const
{
    const int place = current();
    return place < 0 ? nullptr : &m_junctions[static_cast<std::size_t>(place)];
}

void JunctionPanel::select(int junction)
{
    m_list->setCurrentItem(m_list->topLevelItem(junction));
}

void JunctionPanel::showDetails()
{
    const ClipJunction* junction = currentJunction();
    inspectCurrent();
    if (junction == nullptr) {
        m_details->clear();
        return;
    }
    const PricedJunction& transition = junction->transition;
    const double fps = m_animation.context().document.project().settings.fps;
    const QString length = tr("%n frame(s)", "length of a transition", transition.length);
    const QString seconds = QLocale().toString(transition.length / fps, 'f', 2);
    m_details->setText(tr("%1, %2 s. Cost %3: deformation %4, duration %5.")
                           .arg(length, seconds, numberText(transition.weight()),
                                numberText(transition.deformation), numberText(transition.duration)));
}

/// Has the selected transition measured.
void JunctionPanel::inspectCurrent()
{
    const ClipJunction* junction = currentJunction();
    if (junction == nullptr || m_animation.entry() == nullptr)
        m_inspector->clear();
    else
        m_inspector->inspect(m_result->character, junction->transition.frames, *m_animation.entry());
    showQuality();
}

void JunctionPanel::showQuality()
{
    const auto& measures = m_inspector->measures();
    m_quality->setVisible(measures.has_value());
    if (!measures)
        return;
    const std::array<QString, junctionCriteria> names = {tr("jerk"), tr("stand-still"), tr("leap"),
                                                         tr("foot slip"), tr("volume")};
    QStringList parts;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const JunctionValue& value = measures->values[i];
        const QString percent =
            value.isMeasured ? tr("%1 %").arg(QLocale().toString(value.ratio * 100, 'f', 0)) : tr("–");
        // A number stays with its name where lines break.
        parts += QStringLiteral("%1 %2").arg(names[i], percent).replace(QLatin1Char(' '), QChar::Nbsp);
    }
    const QString verdict = measures->isGood() ? tr("Should not show:") : tr("May show:");
    m_quality->setText(QStringLiteral("%1 %2").arg(verdict, parts.join(QStringLiteral(", "))));
}

void JunctionPanel::showState()
{
    const AnimationEntry* entry = m_animation.entry();
    if (entry != nullptr && entry->walk) {
        m_message->show(widgets::MessageStrip::Kind::Info,
                        tr("This walk was accepted: it stays as it is, and nothing is sought."));
        m_message->setAction(tr("Seek again"));
    } else if (entry != nullptr && !entry->junctions.walk.empty()) {
        m_message->show(
            widgets::MessageStrip::Kind::Info,
            tr("Only what you decide changes, and what is next to it; the rest of the walk stays."));
        m_message->setAction(tr("Seek again"));
    } else {
        m_message->clear();
    }
}

void JunctionPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    // A dock behind others counts as shown: it tells itself when it comes to the front.
    if (const auto* dock = qobject_cast<QDockWidget*>(parentWidget()))
        connect(dock, &QDockWidget::visibilityChanged, this, &JunctionPanel::followVisibility,
                Qt::UniqueConnection);
}

void JunctionPanel::followVisibility(bool visible)
{
    if (!visible)
        setChoosing(false);
}

void JunctionPanel::retranslate()
{
    m_list->setHeaderLabels({tr("At"), tr("Transition"), tr("Cost")});
    m_list->setAccessibleName(tr("Transitions of the clip"));
    m_alternativesList->setHeaderLabels({tr("Transition"), tr("Frames"), tr("Cost")});
    m_alternativesList->setAccessibleName(tr("Transitions nearby"));
    m_alternativesList->setToolTip(tr("Point at one to see it; double-click or Return takes it"));
    m_decisionsTitle->setText(tr("Decided"));
    m_decisionsList->setHeaderLabels({tr("Decision"), tr("Transition")});
    m_decisionsList->setAccessibleName(tr("Decisions about transitions"));
    m_empty->setText(tr("The transitions of the clip come here: to be played, banned, locked or exchanged. "
                        "There is none yet."));
    m_list->setToolTip(tr("A click goes there and plays around it"));
    m_quality->setToolTip(tr("How much of what is still good is used up, measured on the frames of the "
                             "transition: what is above 100 % is likely to be seen"));
    m_result.reset();
    refresh();
}

} // namespace quadrille

#include "moc_junctionpanel.cpp"
