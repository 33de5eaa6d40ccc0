// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What is done with variations, and how they are shown.
#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"
#include "editor/documents/variationresult.h"
#include "editor/fields/partlist.h"
#include "editor/workspaces/variations/acrossfields.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "editor/workspaces/variations/samplespanel.h"
#include "model/project/document/madeclips.h"
#include "model/project/results/projectresults.h"
#include "widgets/theme/theme.h"

#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QPixmap>
#include <QScopedValueRollback>
#include <QStackedWidget>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// Why variations were rejected, in the order of the columns; one may have several faults.
QString faultsText(const DrawnSet& set)
{
    QStringList lines;
    const auto add = [&](VariationFault fault, const QString& text) {
        if (const int count = set.faults.at(static_cast<std::size_t>(fault)); count > 0)
            lines += text.arg(count);
    };
    add(VariationFault::PoseDistance, SamplesPanel::tr("Rejected, too far from what was learned: %1"));
    add(VariationFault::FootSkate, SamplesPanel::tr("Rejected, feet slide: %1"));
    add(VariationFault::Intersections, SamplesPanel::tr("Rejected, the surface goes through itself: %1"));
    add(VariationFault::Volume, SamplesPanel::tr("Rejected, the body swells or shrinks: %1"));
    add(VariationFault::Collapse, SamplesPanel::tr("Rejected, a region of the body crumples: %1"));
    add(VariationFault::Ground, SamplesPanel::tr("Rejected, it sinks into the ground: %1"));
    return lines.join(QLatin1Char('\n'));
}

/// What there is to know of how far variations are apart; a line for each, empty where all is as it was asked
/// for.
QString spreadText(const DrawnSet& set, const TrajectoryLimits& limits)
{
    constexpr double enough = 0.8; // of what was asked for: the scale is found from some of the samples
    QString text;
    if (limits.draw == TrajectoryDraw::Smooth && set.spread < enough * limits.spread)
        text +=
            '\n' + SamplesPanel::tr("They are apart by %1, not by %2: further away the model is not sure of "
                                    "the poses, or the movement becomes restless.")
                       .arg(QLocale().toString(set.spread, 'f', 2))
                       .arg(QLocale().toString(limits.spread, 'f', 2));
    if (set.isSpreadGuess)
        text += '\n' + SamplesPanel::tr("No other take shows this movement: how far its takes are apart is a "
                                        "guess.");
    return text;
}

QIcon setSwatch(const QColor& color)
{
    constexpr int side = 12;
    QPixmap pixmap(side, side);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRoundedRect(QRectF(1, 1, side - 2, side - 2), 2, 2);
    return pixmap;
}

} // namespace

void SamplesPanel::makeActions()
{
    ActionRegistry& actions = m_variation.context().actions;
    const auto group = [] { return tr("Variations"); };
    actions.add({"variations.addSet",
                 group,
                 [] { return tr("Vary &another take"); },
                 [] { return tr("Draw variations of another take or blend, too"); },
                 "add",
                 {}},
                [this] { addSet(); });
    actions.add({"variations.removeSet",
                 group,
                 [] { return tr("Do not &vary this take"); },
                 [] { return tr("Take these variations out of the project"); },
                 "delete",
                 {}},
                [this] { removeSet(); });
    actions.add({"variations.again",
                 group,
                 [] { return tr("Draw &others"); },
                 [] { return tr("Draws as many other variations, with the next seed"); },
                 "refresh",
                 {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_D)}},
                [this] { m_seed->stepUp(); });
    actions.add({"variations.keep",
                 group,
                 [] { return tr("&Keep"); },
                 [] { return tr("Keeps the selected variations after all"); },
                 "success",
                 {}},
                [this] { discard(false); });
    actions.add({"variations.discard",
                 group,
                 [] { return tr("Dis&card"); },
                 [] { return tr("Throws the selected variations away: they are not exported"); },
                 "ban",
                 {}},
                [this] { discard(true); });
    actions.add({"variations.addSequence",
                 group,
                 [] { return tr("Add as &sequences"); },
                 [] { return tr("Adds the selected variations to the project, to work on as on takes"); },
                 "sequence",
                 {}},
                [this] { addAsSequences(); });
    actions.add({"variations.export",
                 group,
                 [] { return tr("E&xport the data set…"); },
                 [] { return tr("Writes the variations that are kept, with where they come from"); },
                 "export",
                 {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E)}},
                [this] { emit exportRequested(); });
}

void SamplesPanel::refresh()
{
    const VariationEntry* entry = m_variation.entry();
    const bool hasTakes = entry != nullptr && !entry->training.empty();
    m_pages->setCurrentIndex(hasTakes ? 1 : 0);
    {
        const QScopedValueRollback showing(m_isShowing, true);
        refreshSets();
        refreshFields();
    }
    refreshVariations();
}

void SamplesPanel::refreshSets()
{
    QStringList names;
    if (const VariationEntry* entry = m_variation.entry()) {
        for (const SamplesEntry& set : entry->samples)
            names += tr("%1: %2", "a take or blend, and how often").arg(nameOf(set)).arg(set.count);
    }
    m_sets->fill(names);
    m_sets->showRow(m_variation.set());
}

void SamplesPanel::refreshFields()
{
    const VariationEntry* entry = m_variation.entry();
    const SamplesEntry* set = m_variation.samples();
    m_fields.show(set == nullptr ? SamplesEntry() : *set);
    m_fields.setEnabled(set != nullptr);
    m_common.show(entry == nullptr ? VariationEntry() : *entry);
    m_common.setEnabled(entry != nullptr);
}

void SamplesPanel::refreshVariations()
{
    const QScopedValueRollback showing(m_isShowing, true);
    const std::vector<DrawnVariation> drawn = m_variation.drawn();
    while (m_variations->topLevelItemCount() > static_cast<int>(drawn.size()))
        delete m_variations->takeTopLevelItem(m_variations->topLevelItemCount() - 1);
    while (m_variations->topLevelItemCount() < static_cast<int>(drawn.size()))
        new QTreeWidgetItem(m_variations);
    for (std::size_t i = 0; i < drawn.size(); ++i)
        showVariation(*m_variations->topLevelItem(static_cast<int>(i)), drawn[i]);
    const auto discarded = static_cast<int>(std::ranges::count(drawn, true, &DrawnVariation::isDiscarded));
    const auto count = static_cast<int>(drawn.size());
    const DrawnSet* set = m_variation.drawnSet();
    QString summary = m_variation.stateText();
    if (set != nullptr && summary.isEmpty())
        summary =
            tr("%n drawn, %1 rejected, %2 thrown away", nullptr, count).arg(set->rejected).arg(discarded);
    if (set != nullptr && count < m_variation.samples()->count && m_variation.stateText().isEmpty())
        summary +=
            QLatin1Char('\n') + tr("Too few were good enough: %1 were asked for. Take another seed, or "
                                   "more takes; the panel Learning says what is rejected.")
                                    .arg(m_variation.samples()->count);
    if (set != nullptr && count > 0 && m_variation.stateText().isEmpty())
        summary += spreadText(*set, m_variation.entry()->extent);
    m_summary->setText(summary);
    m_summary->setToolTip(set == nullptr ? QString() : faultsText(*set));
    updateActions();
}

void SamplesPanel::showVariation(QTreeWidgetItem& item, const DrawnVariation& drawn)
{
    item.setText(0, QLocale().toString(drawn.inSet));
    item.setIcon(0, setSwatch(CurrentVariation::colorOf(drawn.inSet)));
    item.setData(0, Qt::UserRole, drawn.inSet);
    const bool isShown = !drawn.isDiscarded && !m_variation.isHidden(drawn.inSet);
    item.setCheckState(0, isShown ? Qt::Checked : Qt::Unchecked);
    Qt::ItemFlags flags = item.flags();
    flags.setFlag(Qt::ItemIsUserCheckable, !drawn.isDiscarded);
    item.setFlags(flags);
    constexpr double centimetres = 100;
    constexpr double percent = 100;
    const VariationQuality& quality = drawn.quality;
    const QLocale locale;
    item.setText(
        1, tr("%1 cm", "a distance").arg(locale.toString(quality.meanPoseDistance * centimetres, 'f', 1)));
    item.setToolTip(1, tr("At most %1 cm from the nearest pose that was learned from")
                           .arg(locale.toString(quality.worstPoseDistance * centimetres, 'f', 1)));
    item.setText(2, quality.skate
                        ? tr("%1 cm/s", "a speed").arg(locale.toString(*quality.skate * centimetres, 'f', 1))
                        : QStringLiteral("–"));
    item.setToolTip(2, tr("The take: %1 cm/s").arg(locale.toString(quality.takeSkate * centimetres, 'f', 1)));
    item.setText(3, locale.toString(static_cast<qlonglong>(quality.intersections)));
    item.setToolTip(3, tr("The takes: %1").arg(quality.takeIntersections));
    item.setText(
        4, quality.volumeChange
               ? tr("%1 %", "share in percent").arg(locale.toString(*quality.volumeChange * percent, 'f', 1))
               : QStringLiteral("–"));
    QFont font = m_variations->font();
    font.setStrikeOut(drawn.isDiscarded);
    for (int column = 0; column < m_variations->columnCount(); ++column) {
        item.setFont(column, column == 0 ? font : widgets::Theme::tabularFont(font));
        item.setTextAlignment(column, column == 0 ? Qt::AlignLeft | Qt::AlignVCenter
                                                  : Qt::AlignRight | Qt::AlignVCenter);
        item.setForeground(column, drawn.isDiscarded ? widgets::Theme::color(widgets::ColorRole::TextDisabled)
                                                     : widgets::Theme::color(widgets::ColorRole::Text));
    }
    item.setToolTip(0, drawn.isDiscarded ? tr("Thrown away: it is not exported") : QString());
}

void SamplesPanel::updateActions()
{
    ActionRegistry& actions = m_variation.context().actions;
    const auto chosen = selected();
    const auto isDiscarded = [](const DrawnVariation& drawn) { return drawn.isDiscarded; };
    const VariationEntry* entry = m_variation.entry();
    const bool hasSet = m_variation.samples() != nullptr;
    actions.action("variations.addSet")->setEnabled(entry != nullptr && !entry->training.empty());
    actions.action("variations.removeSet")->setEnabled(hasSet);
    actions.action("variations.again")->setEnabled(hasSet);
    actions.action("variations.keep")->setEnabled(std::ranges::any_of(chosen, isDiscarded));
    actions.action("variations.discard")->setEnabled(!std::ranges::all_of(chosen, isDiscarded));
    actions.action("variations.addSequence")->setEnabled(!chosen.empty());
    actions.action("variations.export")->setEnabled(!m_variation.drawn().empty());
}

void SamplesPanel::addSet()
{
    m_variation.edit(tr("Vary another take"), QStringLiteral("samples"), [](VariationEntry& entry) {
        // The first take that nothing is drawn of yet.
        const auto isNew = [&entry](const TrainingEntry& take) {
            return std::ranges::find(entry.samples, take.sequence, &SamplesEntry::of) == entry.samples.end();
        };
        const auto found = std::ranges::find_if(entry.training, isNew);
        SamplesEntry set;
        set.of = found == entry.training.end() ? entry.training.front().sequence : found->sequence;
        entry.samples.push_back(std::move(set));
    });
    m_variation.setSet(static_cast<int>(m_variation.entry()->samples.size()) - 1);
}

void SamplesPanel::removeSet()
{
    if (m_variation.samples() == nullptr)
        return;
    m_variation.edit(tr("Do not vary a take"), QStringLiteral("samples"), [this](VariationEntry& entry) {
        entry.samples.erase(entry.samples.begin() + m_variation.set());
    });
}

std::vector<DrawnVariation> SamplesPanel::selected() const
{
    const std::vector<DrawnVariation> drawn = m_variation.drawn();
    std::vector<DrawnVariation> chosen;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (m_variations->topLevelItem(static_cast<int>(i))->isSelected())
            chosen.push_back(drawn[i]);
    }
    return chosen;
}

void SamplesPanel::discard(bool discards)
{
    const std::vector<DrawnVariation> chosen = selected();
    const auto count = static_cast<int>(chosen.size());
    m_variation.editSet(discards ? tr("Throw %n variation(s) away", nullptr, count)
                                 : tr("Keep %n variation(s)", nullptr, count),
                        "discarded", [&](SamplesEntry& set) {
                            for (const DrawnVariation& drawn : chosen) {
                                std::erase(set.discarded, drawn.inSet);
                                if (discards)
                                    set.discarded.push_back(drawn.inSet);
                            }
                            std::ranges::sort(set.discarded);
                        });
}

void SamplesPanel::addAsSequences()
{
    std::vector<SequenceEntry> sequences;
    std::vector<std::string> clips;
    for (const DrawnVariation& drawn : selected()) {
        clips.push_back(variationClip(m_variation.name().toStdString(), drawn.number));
        SequenceEntry sequence;
        //: a take or blend, and the number of a variation
        sequence.name =
            tr("%1, variation %2").arg(nameOf(*m_variation.samples())).arg(drawn.inSet).toStdString();
        sequence.source = "clip:" + clips.back();
        if (m_variation.context().document.project().characters.size() > 1)
            sequence.character = m_variation.character().toStdString();
        sequences.push_back(std::move(sequence));
    }
    addSequences(m_variation.context().document, std::move(sequences));
    makeClips(std::move(clips));
}

/// Brings the results that sequences show up to date.
void SamplesPanel::makeClips(std::vector<std::string> clips)
{
    EditorContext& context = m_variation.context();
    const auto count = static_cast<int>(clips.size());
    const bool isStopped = m_variation.resultState() != nullptr && m_variation.resultState()->isStopped;
    const JobSettings settings{.name = isStopped
                                           ? tr("Learning to the end, making %n clip(s)", nullptr, count)
                                           : tr("Making %n clip(s)", nullptr, count),
                               .receiver = this};
    context.jobs.start(
        settings,
        [working = context.document.working(), clips = std::move(clips)](const Progress& progress) {
            ProjectResults(working).get(clips, progress);
        },
        [&context] {
            context.media.refresh();
            context.variations.readStopped();
        });
}

bool SamplesPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    QAction* action = nullptr;
    if (key == Qt::Key_Delete)
        action = m_variation.context().actions.action(QStringLiteral("variations.discard"));
    else if (key == Qt::Key_Insert)
        action = m_variation.context().actions.action(QStringLiteral("variations.keep"));
    if (action == nullptr)
        return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::KeyPress)
        action->trigger();
    event->accept();
    return true;
}

} // namespace quadrille
