// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/motionspacepage.h"

#include "editor/commands/motionspaceedits.h"
#include "editor/context/editorcontext.h"
#include "editor/fields/partlist.h"
#include "editor/fields/rangefield.h"
#include "editor/fields/spacemap.h"
#include "model/project/document/findentry.h"
#include "widgets/theme/icons.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QLocale>
#include <QToolButton>
#include <algorithm>

namespace quadrille {

namespace {

constexpr int linesOfState = 4;

QToolButton* iconButton(const char* icon)
{
    auto* button = new QToolButton;
    button->setIcon(widgets::icons::icon(QLatin1String(icon)));
    button->setAutoRaise(true);
    return button;
}

/// \param last  begins at the end of the row, which the first widget leaves free or fills.
QWidget* inRow(QWidget* first, QWidget* last, bool fills)
{
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(first, fills ? 1 : 0);
    if (!fills)
        layout->addStretch(1);
    layout->addWidget(last);
    return row;
}

/// The values of a place, as “1.2; 0.4”.
QString placeText(const std::vector<double>& place)
{
    QStringList values;
    for (const double value : place)
        values += QLocale().toString(value, 'g', 6);
    return values.join(QStringLiteral("; "));
}

/// Nothing where a part of the text is no number.
std::optional<std::vector<double>> placeOfText(const QString& text)
{
    std::vector<double> place;
    for (const QString& part : text.split(QLatin1Char(';'), Qt::SkipEmptyParts)) {
        bool isNumber = false;
        place.push_back(QLocale().toDouble(part.trimmed(), &isNumber));
        if (!isNumber)
            return std::nullopt;
    }
    return place;
}

} // namespace

MotionSpacePage::MotionSpacePage(EditorContext& context)
    : EntryPage(
          context,
          {.section = Section::MotionSpaces,
           .name = "motionSpace",
           .workspace = nullptr,
           .characterTip = [] { return tr("Whose movement it is; takes are chosen anew with another one"); }})
    , m_map(new SpaceMap)
    , m_takes(new PartList(QStringLiteral("motionSpaceTakes")))
    , m_newTake(makeChoiceField())
    , m_removeTake(iconButton("delete"))
    , m_takeForm(new SettingForm)
    , m_takeFields(*m_takeForm,
                   [this](const QString& text, const char* property, const auto& change) {
                       if (const auto index = take())
                           edit(text, property,
                                [&](MotionSpaceEntry& after) { change(after.takes[*index]); });
                   })
    , m_range(new RangeField("motionSpaceRange"))
    , m_parameters(new PartList(QStringLiteral("motionSpaceParameters")))
    , m_addParameter(iconButton("add"))
    , m_removeParameter(iconButton("delete"))
    , m_parameterForm(new SettingForm)
    , m_parameterFields(*m_parameterForm,
                        [this](const QString& text, const char* property, const auto& change) {
                            if (const auto index = parameter())
                                edit(text, property, [&](MotionSpaceEntry& after) {
                                    const SpaceMeasure before = after.parameters[*index].measure;
                                    change(after.parameters[*index]);
                                    followMeasure(after, *index, before);
                                });
                        })
    , m_form(new SettingForm)
    , m_fields(*m_form, [this](const QString& text, const char* property, const auto& change) {
        edit(text, property, change);
    })
{
    m_state = addFact("motionSpaceState", [] { return tr("State"); });
    m_state->setWordWrap(true);
    // As high while it is computed as afterwards, or what is below would move under the pointer.
    m_state->setAlignment(Qt::AlignTop | Qt::AlignLeading);
    m_state->setMinimumHeight(linesOfState * m_state->fontMetrics().lineSpacing());
    addWide("motionSpaceMap", m_map);
    addTakes();
    addParameters();
    addSettings();
    connect(&context.motionSpaces, &MotionSpaceResults::changed, this, [this](const QString& name) {
        if (name != entryName() ||
            findMotionSpace(EntryPage::context().document.project(), name.toStdString()) == nullptr)
            return;
        showState();
        showLists();
    });
    retranslate();
}

void MotionSpacePage::addTakes()
{
    m_newTake->setObjectName(QStringLiteral("motionSpaceNewTake"));
    m_removeTake->setObjectName(QStringLiteral("motionSpaceRemoveTake"));
    addField(
        "motionSpaceTakes", [] { return tr("Takes"); }, m_takes,
        [] { return tr("What the space is made of, and where each take lies on its axes"); });
    addWide("motionSpaceTakeButtons", inRow(m_newTake, m_removeTake, true));
    connect(m_newTake, &QComboBox::activated, this, [this](int index) {
        if (index >= 0)
            addTake(m_newTake->itemText(index));
    });
    connect(m_removeTake, &QToolButton::clicked, this, [this] {
        if (const auto index = take())
            removeTake(*index);
    });
    connect(m_takes, &PartList::deletionRequested, this,
            [this](int row) { removeTake(static_cast<std::size_t>(row)); });
    connect(m_takes, &QListWidget::currentRowChanged, this, &MotionSpacePage::showCurrent);
    const auto setRange = [this](std::optional<FrameRange> range) {
        if (const auto index = take())
            edit(tr("Set the frames of a take"), "motionSpaceRange",
                 [&](MotionSpaceEntry& after) { after.takes[*index].range = range; });
    };
    connect(m_range, &RangeField::edited, this, [=, this] { setRange(m_range->range()); });
    m_takeFields.addOther(
        {"motionSpaceRange", [] { return tr("Frames"); },
         [] { return tr("Exactly these; all of them, or the cycle that is found in them"); }},
        m_range,
        [this](const SpaceTakeEntry& shown) {
            const MeshSequence* sequence = context().media.sequence(QString::fromStdString(shown.sequence));
            m_range->setRange(shown.range, sequence == nullptr ? 0 : sequence->frameCount());
        },
        [](const SpaceTakeEntry& shown) { return !shown.range; }, [=] { setRange(std::nullopt); });
    m_takeFields.addSwitch({"motionSpaceMirrored", [] { return tr("Mirrored"); },
                            [] { return tr("Left and right are exchanged"); }},
                           &SpaceTakeEntry::isMirrored);
    m_takeFields.addSwitch({"motionSpaceReversed", [] { return tr("Reversed"); },
                            [] { return tr("It is played from its last frame to its first"); }},
                           &SpaceTakeEntry::isReversed);
    m_takeFields.addNumber(
        {"motionSpaceSpeed", [] { return tr("Played at"); }, [] { return tr("1 is as it was captured"); }},
        &SpaceTakeEntry::speed, {.path = "space_take.speed", .step = 0.1, .decimals = 2});
    auto* place = new QLineEdit;
    const auto setPlace = [this](const std::vector<double>& values) {
        if (const auto index = take())
            edit(tr("Set the place of a take"), "motionSpacePlace",
                 [&](MotionSpaceEntry& after) { after.takes[*index].place = values; });
    };
    connect(place, &QLineEdit::editingFinished, this, [=, this] {
        const auto index = take();
        const auto values = placeOfText(place->text());
        if (index && values)
            setPlace(*values);
        showCurrent();
    });
    m_takeFields.addOther(
        {"motionSpacePlace", [] { return tr("Place"); },
         [] { return tr("A value of each parameter, with ; between them; measured where it is empty"); }},
        place, [place](const SpaceTakeEntry& shown) { place->setText(placeText(shown.place)); },
        [](const SpaceTakeEntry& shown) { return shown.place.empty(); }, [=] { setPlace({}); });
    addWide("motionSpaceTake", m_takeForm);
}

void MotionSpacePage::addParameters()
{
    m_addParameter->setObjectName(QStringLiteral("motionSpaceAddParameter"));
    m_removeParameter->setObjectName(QStringLiteral("motionSpaceRemoveParameter"));
    addField(
        "motionSpaceParameters", [] { return tr("Steered by"); }, m_parameters,
        [] { return tr("What its takes differ in: one to three parameters"); });
    addWide("motionSpaceParameterButtons", inRow(m_addParameter, m_removeParameter, false));
    connect(m_addParameter, &QToolButton::clicked, this, [this] {
        edit(tr("Add a parameter"), "motionSpaceAddParameter",
             [](MotionSpaceEntry& after) { addParameter(after); });
    });
    connect(m_removeParameter, &QToolButton::clicked, this, [this] {
        if (const auto index = parameter())
            removeParameter(*index);
    });
    connect(m_parameters, &PartList::deletionRequested, this,
            [this](int row) { removeParameter(static_cast<std::size_t>(row)); });
    connect(m_parameters, &QListWidget::currentRowChanged, this, &MotionSpacePage::showCurrent);
    auto* name = new QLineEdit;
    connect(name, &QLineEdit::editingFinished, this, [=, this] {
        const auto index = parameter();
        const std::string text = name->text().trimmed().toStdString();
        if (index && !text.empty() && text != entry().parameters[*index].name)
            edit(tr("Name a parameter"), "motionSpaceParameterName",
                 [&](MotionSpaceEntry& after) { after.parameters[*index].name = text; });
        showCurrent();
    });
    m_parameterFields.addOther(
        {"motionSpaceParameterName", [] { return tr("Name"); }, [] { return tr("Unique in the space"); }},
        name, [name](const SpaceParameterEntry& shown) { name->setText(QString::fromStdString(shown.name)); },
        [](const SpaceParameterEntry& /*shown*/) { return true; }, [] {});
    m_parameterFields.addChoice(
        {"motionSpaceMeasure", [] { return tr("Measure"); },
         [] { return tr("What is measured of each take, and of the blends between them"); }},
        &SpaceParameterEntry::measure,
        {[] { return tr("Speed"); }, [] { return tr("Turning to the left"); },
         [] { return tr("Height of a jump"); }, [] { return tr("Length of a jump"); },
         [] { return tr("Height of a vertex"); }, [] { return tr("Forward way of a vertex"); },
         [] { return tr("Way of a vertex to the left"); }, [] { return tr("By hand"); }});
    m_parameterFields.addNumber(
        {"motionSpaceVertex", [] { return tr("Vertex"); }, [] { return tr("Of the mesh, from 0"); },
         [](const SpaceParameterEntry& shown) { return isOfVertex(shown.measure) || shown.vertex; }},
        &SpaceParameterEntry::vertex,
        {.path = "space_parameter.vertex",
         .step = 1,
         .decimals = 0,
         .automatic = [] { return tr("none"); },
         .highest = 1e7});
    addWide("motionSpaceParameter", m_parameterForm);
}

void MotionSpacePage::addSettings()
{
    m_fields.addItems({"motionSpaceReference", [] { return tr("Reference"); },
                       [] { return tr("The take whose frames are those of the space"); }},
                      &MotionSpaceEntry::reference, [](const MotionSpaceEntry& shown) {
                          std::vector<FieldItem<std::string>> items{{tr("the first"), std::string()}};
                          for (const SpaceTakeEntry& take : shown.takes) {
                              const auto isIt = [&](const auto& item) { return item.value == take.sequence; };
                              if (std::ranges::none_of(items, isIt))
                                  items.push_back({QString::fromStdString(take.sequence), take.sequence});
                          }
                          return items;
                      });
    m_fields.addSwitch(
        {"motionSpaceCycles", [] { return tr("Find cycles"); },
         [] { return tr("Takes of walking and running are cut to one cycle, which repeats"); }},
        &MotionSpaceEntry::cycles);
    m_fields.addNumber(
        {"motionSpaceTolerance", [] { return tr("Tolerance"); },
         [] { return tr("By how much blends may miss the non-linear ones at most"); }},
        &MotionSpaceEntry::tolerance,
        {.path = "motion_space.tolerance", .scale = 0.001, .step = 1, .decimals = 2, .unit = [] {
             return tr(" mm");
         }});
    m_fields.addNumber(
        {"motionSpaceMostReferences", [] { return tr("References at most"); },
         [] { return tr("Non-linear blends that are stored to keep the tolerance; 0 for linear blends"); }},
        &MotionSpaceEntry::mostReferences,
        {.path = "motion_space.most_references", .step = 1, .decimals = 0});
    addWide("motionSpaceSettings", m_form);
}

const MotionSpaceEntry& MotionSpacePage::entry() const
{
    return *findMotionSpace(context().document.project(), entryName().toStdString());
}

QString MotionSpacePage::character() const
{
    return QString::fromStdString(characterNameOf(context().document.project(), entry()));
}

void MotionSpacePage::setCharacter(const QString& character)
{
    edit(tr("Change the character of “%1”").arg(entryName()), "motionSpaceCharacter",
         [&](MotionSpaceEntry& after) {
             after.character = character.toStdString();
             after.takes.clear();
             after.reference.clear();
         });
}

void MotionSpacePage::edit(const QString& text, const char* property, const Change& change)
{
    MotionSpaceEntry after = entry();
    change(after);
    setMotionSpace(context().document, entryName(), text, QLatin1String(property), std::move(after));
}

std::optional<std::size_t> MotionSpacePage::take() const
{
    const int row = m_takes->currentRow();
    return row >= 0 && row < static_cast<int>(entry().takes.size())
               ? std::optional(static_cast<std::size_t>(row))
               : std::nullopt;
}

std::optional<std::size_t> MotionSpacePage::parameter() const
{
    const int row = m_parameters->currentRow();
    return row >= 0 && row < static_cast<int>(entry().parameters.size())
               ? std::optional(static_cast<std::size_t>(row))
               : std::nullopt;
}

void MotionSpacePage::addTake(const QString& sequence)
{
    quadrille::addTakes(context().document, entryName(), {sequence});
    m_takes->setCurrentRow(static_cast<int>(entry().takes.size()) - 1);
}

void MotionSpacePage::removeTake(std::size_t index)
{
    const std::string sequence = entry().takes[index].sequence;
    edit(tr("Remove the take “%1”").arg(QString::fromStdString(sequence)), "motionSpaceRemoveTake",
         [&](MotionSpaceEntry& after) {
             after.takes.erase(after.takes.begin() + static_cast<std::ptrdiff_t>(index));
             if (std::ranges::find(after.takes, after.reference, &SpaceTakeEntry::sequence) ==
                 after.takes.end())
                 after.reference.clear();
         });
}

/// Its value goes out of the places by hand, too.
void MotionSpacePage::removeParameter(std::size_t index)
{
    edit(tr("Remove a parameter"), "motionSpaceRemoveParameter", [&](MotionSpaceEntry& after) {
        const auto at = static_cast<std::ptrdiff_t>(index);
        for (SpaceTakeEntry& take : after.takes) {
            if (take.place.size() == after.parameters.size())
                take.place.erase(take.place.begin() + at);
        }
        after.parameters.erase(after.parameters.begin() + at);
    });
}

void MotionSpacePage::retranslate()
{
    EntryPage::retranslate();
    m_takeFields.retranslate();
    m_parameterFields.retranslate();
    m_fields.retranslate();
    m_newTake->setPlaceholderText(tr("Add a take"));
    m_newTake->setAccessibleName(tr("Add a take"));
    m_removeTake->setToolTip(tr("Remove the take"));
    m_removeTake->setAccessibleName(tr("Remove the take"));
    m_addParameter->setToolTip(tr("Add a parameter"));
    m_addParameter->setAccessibleName(tr("Add a parameter"));
    m_removeParameter->setToolTip(tr("Remove the parameter"));
    m_removeParameter->setAccessibleName(tr("Remove the parameter"));
}

void MotionSpacePage::show(const QString& name)
{
    EntryPage::show(name);
    m_newTake->clear();
    m_newTake->addItems(sequencesFor(context().document.project(), entry()));
    m_newTake->setCurrentIndex(-1);
    m_newTake->setEnabled(m_newTake->count() > 0 && entry().takes.size() < WeightSpace::mostTakes);
    m_fields.show(entry());
    showLists();
    showCurrent();
    context().motionSpaces.want({name});
    showState();
}

void MotionSpacePage::showCurrent()
{
    const auto ownTake = take();
    const auto ownParameter = parameter();
    m_takeForm->setVisible(ownTake.has_value());
    m_removeTake->setEnabled(ownTake.has_value());
    m_parameterForm->setVisible(ownParameter.has_value());
    m_removeParameter->setEnabled(ownParameter.has_value());
    if (ownTake)
        m_takeFields.show(entry().takes[*ownTake]);
    if (ownParameter)
        m_parameterFields.show(entry().parameters[*ownParameter]);
}

} // namespace quadrille

#include "moc_motionspacepage.cpp"
