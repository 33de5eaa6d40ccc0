// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/movementpanel.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/rightmenu.h"
#include "editor/fields/verticalscroll.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/acrossfields.h"
#include "editor/workspaces/variations/blendlist.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "editor/workspaces/variations/takelist.h"
#include "editor/workspaces/variations/takeuse.h"
#include "editor/workspaces/view/sceneview.h"
#include "model/project/document/findentry.h"
#include "model/variation/movement.h"
#include "widgets/controls/elidedbutton.h"
#include "widgets/theme/theme.h"

#include <QHeaderView>
#include <QLocale>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>

namespace quadrille {

namespace {

constexpr int movementMargin = 12; // pixels
constexpr int takeColumn = 0;
constexpr int framesColumn = 1;
constexpr int usedColumn = 2;

bool isLearnedFrom(const VariationEntry* entry, const std::string& sequence)
{
    return entry != nullptr &&
           std::ranges::find(entry->training, sequence, &TrainingEntry::sequence) != entry->training.end();
}

/// Takes a sequence out, with what speaks of it.
void removeTake(VariationEntry& entry, const std::string& sequence)
{
    std::erase_if(entry.training, [&](const TrainingEntry& take) { return take.sequence == sequence; });
    std::erase_if(entry.blends, [&](const BlendEntry& blend) {
        return blend.from == sequence || blend.to == sequence ||
               (blend.across && (blend.across->from == sequence || blend.across->to == sequence));
    });
    std::erase_if(entry.samples, [&](const SamplesEntry& samples) {
        return samples.of == sequence || samples.to == sequence ||
               (samples.across && (samples.across->of == sequence || samples.across->to == sequence));
    });
    if (entry.reference == sequence)
        entry.reference.clear();
}

/// Without samples nothing would be seen of what is learned.
void addTake(VariationEntry& entry, const std::string& sequence)
{
    TrainingEntry take;
    take.sequence = sequence;
    entry.training.push_back(std::move(take));
    if (!entry.samples.empty())
        return;
    SamplesEntry samples;
    samples.of = sequence;
    entry.samples.push_back(std::move(samples));
}

} // namespace

MovementPanel::MovementPanel(CurrentVariation& variation, QWidget* parent)
    : QWidget(parent)
    , m_variation(variation)
    , m_hint(new QLabel)
    , m_takes(new TakeList)
    , m_form(new SettingForm)
    , m_fields(*m_form,
               [this](const QString& text, const char* property, const auto& change) {
                   m_variation.edit(text, QLatin1String(property), change);
               })
    , m_template(new widgets::ElidedButton)
    , m_blendHeading(new QLabel)
    , m_blends(new BlendList(variation))
{
    setObjectName(QStringLiteral("movementPanel"));
    m_hint->setObjectName(QStringLiteral("movementHint"));
    m_hint->setWordWrap(true);
    m_hint->setForegroundRole(QPalette::PlaceholderText);
    m_takes->setObjectName(QStringLiteral("trainingTakes"));
    addRightMenu(*m_takes);
    m_takes->setRootIsDecorated(false);
    m_takes->setUniformRowHeights(true);
    m_takes->setColumnCount(3);
    m_takes->header()->setStretchLastSection(false);
    m_takes->header()->setSectionResizeMode(takeColumn, QHeaderView::Stretch);
    m_takes->header()->setSectionResizeMode(framesColumn, QHeaderView::ResizeToContents);
    m_takes->header()->setSectionResizeMode(usedColumn, QHeaderView::ResizeToContents);
    QFont heavier = font();
    heavier.setWeight(QFont::DemiBold);
    m_blendHeading->setFont(heavier);
    addSettings();
    auto* lower = new QWidget;
    auto* lowerColumn = new QVBoxLayout(lower);
    lowerColumn->setContentsMargins(0, 0, 0, 0);
    lowerColumn->setSpacing(0);
    lowerColumn->addWidget(m_form);
    auto* blends = new QVBoxLayout;
    blends->setContentsMargins(movementMargin, 0, movementMargin, movementMargin);
    blends->setSpacing(4);
    blends->addWidget(m_blendHeading);
    blends->addWidget(m_blends);
    lowerColumn->addLayout(blends);
    lowerColumn->addStretch(1);
    QScrollArea* scroll = verticalScroll(lower);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_hint->setContentsMargins(movementMargin, 8, movementMargin, 8);
    column->addWidget(m_hint);
    column->addWidget(m_takes, 1);
    column->addWidget(scroll, 1);
    connect(m_takes, &QTreeWidget::itemChanged, this, &MovementPanel::choose);
    connect(m_takes, &TakeList::takesDropped, this, &MovementPanel::addTakes);
    connect(m_takes, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        m_variation.context().selection.selectSequences({item->text(takeColumn)});
    });
    connect(&variation, &CurrentVariation::changed, this, &MovementPanel::refresh);
    connect(&variation, &CurrentVariation::resultChanged, this, &MovementPanel::refreshTakes);
    connect(&variation.context().media, &SequenceMedia::changed, this, &MovementPanel::refreshTakes);
    retranslates(this, [this] {
        m_hint->setText(
            tr("Check the takes of one kind of movement, or drag their cards here: they are learned from."));
        m_takes->setHeaderLabels({tr("Take"), tr("Frames"), tr("Used")});
        m_takes->headerItem()->setToolTip(usedColumn,
                                          tr("The frames that are learned from: one cycle, or all"));
        m_takes->setAccessibleName(tr("Takes to learn from"));
        m_blendHeading->setText(tr("Blends"));
        m_fields.retranslate();
        refresh();
    });
}

void MovementPanel::addSettings()
{
    m_form->addHeading([] { return tr("Alignment"); });
    m_fields.addItems({"variationReference",
                       [] { return tr("Reference"); },
                       [] { return tr("The take whose timing the others are warped to"); },
                       {},
                       [] { return tr("Change the reference"); }},
                      &VariationEntry::reference, [this](const VariationEntry& /*entry*/) {
                          auto items = takeItems(m_variation, {});
                          items.insert(items.begin(), {tr("the first take"), std::string()});
                          return items;
                      });
    m_fields.addOther(
        {"variationTemplate", [] { return tr("Template"); },
         [] { return tr("The pose that all frames are laid onto; a click takes the one that is shown"); }},
        m_template,
        [this](const VariationEntry& entry) {
            m_template->setText(entry.templatePose
                                    ? tr("%1, frame %2")
                                          .arg(QString::fromStdString(entry.templatePose->sequence))
                                          .arg(entry.templatePose->frame.value)
                                    : tr("the reference’s first frame"));
        },
        [](const VariationEntry& entry) { return !entry.templatePose; }, [this] { setTemplate({}); });
    m_fields.addSwitch({"variationCycles",
                        [] { return tr("Cut walks and runs to one cycle"); },
                        [] { return tr("So that all takes begin in the same phase"); },
                        {},
                        [] { return tr("Cut to cycles"); }},
                       &VariationEntry::cycles);
    connect(m_template, &QAbstractButton::clicked, this, &MovementPanel::takeTemplate);
}

QStringList MovementPanel::takesOfCharacter() const
{
    const ProjectDocument& document = m_variation.context().document;
    const QString character = m_variation.character();
    QStringList takes;
    for (const SequenceEntry& sequence : document.project().sequences) {
        const CharacterEntry* its = document.characterOf(sequence);
        if (its == nullptr || QString::fromStdString(its->name) == character)
            takes += QString::fromStdString(sequence.name);
    }
    return takes;
}

void MovementPanel::refreshTakes()
{
    const QScopedValueRollback showing(m_isShowing, true);
    const VariationEntry* entry = m_variation.entry();
    const QStringList takes = takesOfCharacter();
    while (m_takes->topLevelItemCount() > takes.size())
        delete m_takes->takeTopLevelItem(m_takes->topLevelItemCount() - 1);
    while (m_takes->topLevelItemCount() < takes.size())
        new QTreeWidgetItem(m_takes);
    for (int row = 0; row < takes.size(); ++row) {
        QTreeWidgetItem* item = m_takes->topLevelItem(row);
        const MeshSequence* sequence = m_variation.context().media.sequence(takes[row]);
        const bool isChosen = isLearnedFrom(entry, takes[row].toStdString());
        item->setText(takeColumn, takes[row]);
        item->setToolTip(takeColumn, takes[row]);
        item->setCheckState(takeColumn, isChosen ? Qt::Checked : Qt::Unchecked);
        item->setText(framesColumn, sequence == nullptr
                                        ? QStringLiteral("…")
                                        : QLocale().toString(static_cast<qlonglong>(sequence->frameCount())));
        for (const int number : {framesColumn, usedColumn}) {
            item->setTextAlignment(number, Qt::AlignRight | Qt::AlignVCenter);
            item->setFont(number, widgets::Theme::tabularFont(font()));
        }
        showUse(*item);
    }
}

/// Known once the takes are aligned.
void MovementPanel::showUse(QTreeWidgetItem& item)
{
    const auto movement = m_variation.movement();
    const std::string name = item.text(takeColumn).toStdString();
    QString used;
    QString why;
    for (std::size_t i = 0; movement != nullptr && i < movement->capturedCount(); ++i) {
        if (movement->take(i).name != name || item.checkState(takeColumn) != Qt::Checked)
            continue;
        used = usedText(movement->take(i).warp.frames);
        why = useText(movement->alignment.reports[i].use);
    }
    item.setText(usedColumn, used);
    item.setToolTip(usedColumn, why);
}

void MovementPanel::refresh()
{
    refreshTakes();
    const VariationEntry* entry = m_variation.entry();
    m_form->setEnabled(entry != nullptr);
    m_fields.show(entry == nullptr ? VariationEntry() : *entry);
}

void MovementPanel::choose(QTreeWidgetItem* item)
{
    if (m_isShowing)
        return;
    const std::string name = item->text(takeColumn).toStdString();
    const bool isChosen = item->checkState(takeColumn) == Qt::Checked;
    if (isChosen == isLearnedFrom(m_variation.entry(), name))
        return;
    m_variation.edit(isChosen ? tr("Learn from “%1”").arg(item->text(takeColumn))
                              : tr("Do not learn from “%1”").arg(item->text(takeColumn)),
                     QStringLiteral("training"), [&](VariationEntry& entry) {
                         if (isChosen)
                             addTake(entry, name);
                         else
                             removeTake(entry, name);
                     });
}

/// Those of this character that are not learned from yet, in one step.
void MovementPanel::addTakes(const QStringList& takes)
{
    const QStringList own = takesOfCharacter();
    QStringList added;
    for (const QString& take : takes) {
        if (own.contains(take) && !isLearnedFrom(m_variation.entry(), take.toStdString()))
            added += take;
    }
    if (added.isEmpty()) {
        const auto isOther = [&own](const QString& take) { return !own.contains(take); };
        if (const auto other = std::ranges::find_if(takes, isOther); other != takes.end())
            QToolTip::showText(QCursor::pos(), tr("“%1” is of another character.").arg(*other), m_takes);
        return;
    }
    m_variation.edit(added.size() == 1 ? tr("Learn from “%1”").arg(added.front())
                                       : tr("Learn from %n takes", nullptr, static_cast<int>(added.size())),
                     QStringLiteral("training"), [&](VariationEntry& entry) {
                         for (const QString& take : added)
                             addTake(entry, take.toStdString());
                     });
}

void MovementPanel::takeTemplate()
{
    const QString shown = m_variation.view().scene().shown().value(0);
    if (!isLearnedFrom(m_variation.entry(), shown.toStdString()))
        return;
    setTemplate(NamedFrame{shown.toStdString(), m_variation.view().player().frame()});
}

void MovementPanel::setTemplate(const std::optional<NamedFrame>& pose)
{
    m_variation.edit(tr("Change the template"), QStringLiteral("variationTemplate"),
                     [&](VariationEntry& entry) { entry.templatePose = pose; });
}

} // namespace quadrille

#include "moc_movementpanel.cpp"
