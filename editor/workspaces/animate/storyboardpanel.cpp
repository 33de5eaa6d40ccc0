// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/storyboardpanel.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/verticalscroll.h"
#include "editor/language/menutext.h"
#include "editor/language/retranslate.h"
#include "editor/pictures/framepictures.h"
#include "editor/workspaces/animate/actionform.h"
#include "editor/workspaces/animate/animationtracks.h"
#include "editor/workspaces/animate/constraintedits.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/labellist.h"
#include "widgets/storyboard/storyboard.h"
#include "widgets/theme/theme.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <algorithm>

namespace quadrille {

using widgets::Storyboard;
using widgets::StoryCard;
using widgets::Theme;

namespace {

constexpr int labelsWidth = 140;
constexpr int formWidth = 240;
/// Without cards the panel may be as low as this, and has then no room for its lists.
constexpr int oneLine = 28;
constexpr int severalLines = 4 * oneLine;

} // namespace

StoryboardPanel::StoryboardPanel(CurrentAnimation& animation, FramePictures& pictures, QWidget* parent)
    : QWidget(parent)
    , m_animation(animation)
    , m_pictures(pictures)
    , m_labels(new LabelList(animation))
    , m_board(new Storyboard)
    , m_form(new ActionForm(animation.context().document, animation.context().media))
    , m_values(verticalScroll(m_form))
    , m_addLabel(new QPushButton)
{
    setObjectName(QStringLiteral("storyboardPanel"));
    auto* addTakes = new QPushButton;
    addTakes->setObjectName(QStringLiteral("addFirstAction"));
    const QAction* addAction = animation.context().actions.action(QStringLiteral("animate.addAction"));
    connect(addTakes, &QPushButton::clicked, addAction, &QAction::trigger);
    connect(addAction, &QAction::changed, addTakes,
            [addAction, addTakes] { addTakes->setEnabled(addAction->isEnabled()); });
    addTakes->setEnabled(addAction->isEnabled());
    m_board->addEmptyAction(addTakes);
    m_addLabel->setObjectName(QStringLiteral("addFirstLabel"));
    m_addLabel->setMenu(new QMenu(m_addLabel));
    connect(m_addLabel->menu(), &QMenu::aboutToShow, this, &StoryboardPanel::fillLabelMenu);
    const auto enableLabels = [this] { m_addLabel->setEnabled(!m_labels->labels().isEmpty()); };
    connect(m_labels->model(), &QAbstractItemModel::modelReset, this, enableLabels);
    enableLabels();
    m_board->addEmptyAction(m_addLabel);
    m_labels->setFixedWidth(labelsWidth);
    m_values->setFixedWidth(formWidth);
    m_labels->setMinimumHeight(oneLine);
    m_values->setMinimumHeight(oneLine);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(1);
    row->addWidget(m_labels);
    row->addWidget(m_board, 1);
    row->addWidget(m_values);
    connectBoard();
    connect(m_labels, &LabelList::labelChosen, this,
            [this](const QString& label) { add({{.label = label}}); });
    connect(m_form, &ActionForm::edited, this,
            [this](const ActionEntry& action, const QString& text, const QString& property, EditPhase phase) {
                const auto card = static_cast<std::size_t>(m_board->current());
                std::vector<ActionEntry> all = actions();
                if (m_board->current() < 0 || card >= all.size())
                    return;
                all[card] = action;
                m_animation.edit(
                    text, property + QString::number(card),
                    [&](AnimationEntry& entry) { setActions(entry, std::move(all)); }, phase);
            });
    connect(&animation, &CurrentAnimation::changed, this, &StoryboardPanel::refresh);
    connect(&animation, &CurrentAnimation::resultChanged, this, &StoryboardPanel::refresh);
    connect(&pictures, &FramePictures::drawn, this, &StoryboardPanel::refresh);
    connect(&Theme::instance(), &Theme::changed, this, &StoryboardPanel::refresh);
    retranslates(this, [this, addTakes] {
        m_addLabel->setText(tr("Add a label"));
        addTakes->setText(tr("Add takes"));
        addTakes->setToolTip(tr("Those that are selected, as one action each"));
        m_board->setEmptyText(tr("What happens one after the other: drag takes or labels here. The joins are "
                                 "found for them."));
        refresh();
    });
}

void StoryboardPanel::connectBoard()
{
    connect(m_board, &Storyboard::currentChanged, this, &StoryboardPanel::showAction);
    connect(m_board, &Storyboard::framesDropped, this, &StoryboardPanel::insert);
    connect(m_board, &Storyboard::moveRequested, this, &StoryboardPanel::move);
    connect(m_board, &Storyboard::copyRequested, this, &StoryboardPanel::copy);
    connect(m_board, &Storyboard::deletionRequested, this, &StoryboardPanel::remove);
    connect(m_board, &Storyboard::activated, m_form, &ActionForm::edit);
    connect(m_board, &Storyboard::menuRequested, this, &StoryboardPanel::showMenu);
}

std::vector<ActionEntry> StoryboardPanel::actions() const
{
    const AnimationEntry* entry = m_animation.entry();
    return entry == nullptr ? std::vector<ActionEntry>() : actionsOf(*entry);
}

/// The frame that stands for an action: a third into it, as for a take.
std::optional<NamedFrame> StoryboardPanel::poseOf(const FrameChoice& frames) const
{
    const auto third = [](FrameRange range) { return FrameIndex(range.first.value + range.count() / 3); };
    if (!frames.label.empty()) {
        for (const SequenceEntry& sequence : m_animation.context().document.project().sequences)
            for (const LabelSpan& span : sequence.labels)
                if (span.label == frames.label)
                    return NamedFrame{sequence.name, third(span.frames)};
        return std::nullopt;
    }
    const MeshSequence* sequence =
        m_animation.context().media.sequence(QString::fromStdString(frames.sequence));
    if (sequence == nullptr)
        return std::nullopt;
    return NamedFrame{frames.sequence, third(frames.range.value_or(FrameRange::all(sequence->frameCount())))};
}

StoryCard StoryboardPanel::cardOf(const ActionEntry& action, const std::optional<FrameRange>& obtained) const
{
    const EditorContext& context = m_animation.context();
    const FrameChoice& frames = action.frames;
    const QLocale locale;
    const auto pose = poseOf(frames);
    StoryCard card;
    card.title = QString::fromStdString(frames.label.empty() ? frames.sequence : frames.label);
    if (!frames.label.empty()) {
        card.subtitle = pose ? tr("label") : tr("no such label");
        card.isFaulty = !pose;
        card.color = Theme::color(widgets::ColorRole::Demanded);
    } else {
        card.isFaulty = context.document.sequence(card.title) == nullptr;
        card.subtitle = card.isFaulty ? tr("no such take")
                        : frames.range
                            ? tr("frames %1–%2").arg(frames.range->first.value).arg(frames.range->last.value)
                            : tr("all frames");
        card.color = Theme::color(widgets::ColorRole::Original);
    }
    if (action.duration)
        card.badge = tr("%1 s").arg(locale.toString(*action.duration));
    else if (action.repeat > 1)
        card.badge = tr("× %1").arg(action.repeat);
    if (pose)
        card.picture = m_pictures.picture(QString::fromStdString(pose->sequence), pose->frame);
    card.tip = choiceText(frames);
    const double fps = context.document.project().settings.fps;
    if (obtained)
        card.tip += QLatin1Char('\n') +
                    tr("Performed from %1 s to %2 s")
                        .arg(locale.toString(static_cast<double>(obtained->first.value) / fps, 'f', 2),
                             locale.toString(static_cast<double>(obtained->last.value + 1) / fps, 'f', 2));
    return card;
}

void StoryboardPanel::refresh()
{
    const std::vector<ActionEntry> all = actions();
    const auto obtained = obtainedRanges(all, m_animation.result().get());
    std::vector<StoryCard> cards;
    for (std::size_t i = 0; i < all.size(); ++i)
        cards.push_back(cardOf(all[i], obtained[i]));
    if (cards != m_board->cards())
        m_board->setCards(std::move(cards));
    showAction();
    fit();
}

/// Lists that would be cut in the one line of an empty storyboard are not there.
void StoryboardPanel::fit()
{
    const bool isEmpty = m_board->cards().empty();
    m_values->setVisible(!isEmpty);
    m_labels->setVisible(!isEmpty || height() >= severalLines);
}

void StoryboardPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fit();
}

void StoryboardPanel::fillLabelMenu()
{
    QMenu* menu = m_addLabel->menu();
    menu->clear();
    for (const QString& label : m_labels->labels())
        connect(menu->addAction(menuText(label)), &QAction::triggered, this,
                [this, label] { add({{.label = label}}); });
}

void StoryboardPanel::showAction()
{
    const std::vector<ActionEntry> all = actions();
    const int card = m_board->current();
    const bool isChosen = card >= 0 && card < static_cast<int>(all.size());
    m_form->show(isChosen ? std::optional(all[static_cast<std::size_t>(card)]) : std::nullopt);
}

void StoryboardPanel::set(std::vector<ActionEntry> actions, const QString& text, int current)
{
    m_animation.edit(text, QStringLiteral("actions"),
                     [&](AnimationEntry& entry) { setActions(entry, std::move(actions)); });
    m_board->setCurrent(current);
    showAction();
}

void StoryboardPanel::add(const std::vector<widgets::DraggedFrames>& frames)
{
    const int current = m_board->current();
    insert(current < 0 ? static_cast<int>(actions().size()) : current + 1, frames);
}

void StoryboardPanel::insert(int before, const std::vector<widgets::DraggedFrames>& frames)
{
    if (frames.empty())
        return;
    std::vector<ActionEntry> added;
    for (const widgets::DraggedFrames& each : frames) {
        ActionEntry& action = added.emplace_back();
        action.frames.label = each.label.toStdString();
        action.frames.sequence = each.label.isEmpty() ? each.sequence.toStdString() : std::string();
    }
    std::vector<ActionEntry> all = actions();
    all.insert(all.begin() + before, added.begin(), added.end());
    set(std::move(all), tr("Add to the storyboard"), before + static_cast<int>(added.size()) - 1);
}

void StoryboardPanel::move(int card, int before)
{
    std::vector<ActionEntry> all = actions();
    const auto moved = all.begin() + card;
    if (before > card)
        std::rotate(moved, moved + 1, all.begin() + before);
    else
        std::rotate(all.begin() + before, moved, moved + 1);
    set(std::move(all), tr("Move in the storyboard"), before > card ? before - 1 : before);
}

void StoryboardPanel::copy(int card, int before)
{
    std::vector<ActionEntry> all = actions();
    const ActionEntry copied = all[static_cast<std::size_t>(card)];
    all.insert(all.begin() + before, copied);
    set(std::move(all), tr("Duplicate in the storyboard"), before);
}

void StoryboardPanel::remove(int card)
{
    std::vector<ActionEntry> all = actions();
    all.erase(all.begin() + card);
    const int next = std::min(card, static_cast<int>(all.size()) - 1);
    set(std::move(all), tr("Remove from the storyboard"), next);
}

void StoryboardPanel::goTo(int card)
{
    const auto obtained = obtainedRanges(actions(), m_animation.result().get());
    if (card >= 0 && card < static_cast<int>(obtained.size()) && obtained[static_cast<std::size_t>(card)])
        emit actionChosen(*obtained[static_cast<std::size_t>(card)]);
}

void StoryboardPanel::showMenu(int card, const QPoint& position)
{
    QMenu menu(m_board);
    menu.setObjectName(QStringLiteral("storyboardMenu"));
    if (card >= 0) {
        menu.addAction(tr("Go to where it is performed"), this, [&] { goTo(card); });
        menu.addAction(tr("Edit"), m_form, &ActionForm::edit);
        menu.addAction(tr("Duplicate"), this, [&] { copy(card, card + 1); });
        menu.addAction(tr("Remove"), this, [&] { remove(card); });
        menu.addSeparator();
    }
    menu.addAction(m_animation.context().actions.action(QStringLiteral("animate.addAction")));
    menu.exec(position);
}

} // namespace quadrille

#include "moc_storyboardpanel.cpp"
