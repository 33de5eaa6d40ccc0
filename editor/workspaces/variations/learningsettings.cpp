// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/learningsettings.h"

#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/currentvariation.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QScopedValueRollback>

namespace quadrille {

namespace {

constexpr double inPercent = 100;
constexpr double million = 1e6;
constexpr double leastBand = 0.01; // between the rates of acceptance that are sought

} // namespace

LearningSettings::LearningSettings(CurrentVariation& variation, QWidget* parent)
    : QScrollArea(parent), m_variation(variation), m_form(new SettingForm)
{
    setObjectName(QStringLiteral("learningSettings"));
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    addLearning();
    addDrawing();
    addStop();
    addChain();
    addLimits();
    setWidget(m_form);
    connect(&variation, &CurrentVariation::changed, this, &LearningSettings::refresh);
    retranslates(this, [this] {
        setAccessibleName(tr("Settings"));
        refresh();
    });
}

void LearningSettings::addNumber(const Number& number)
{
    auto* field = new QDoubleSpinBox;
    field->setDecimals(number.decimals);
    field->setRange(number.lowest, number.highest);
    field->setSingleStep(number.step);
    field->setKeyboardTracking(false);
    field->setGroupSeparatorShown(true);
    field->setAlignment(Qt::AlignRight);
    field->setFocusPolicy(Qt::StrongFocus);
    const auto set = [this, number](double value) {
        if (m_isShowing || m_variation.entry() == nullptr)
            return;
        m_variation.edit(tr("Set “%1”").arg(number.label()), QLatin1String(number.name),
                         [&](VariationEntry& entry) { number.set(entry, value); });
    };
    connect(field, &QDoubleSpinBox::valueChanged, this, set);
    m_form->add(number.name, number.label, number.tip, field,
                [set, get = number.get] { set(get(VariationEntry())); });
    m_bindings.push_back(
        {field,
         [field, number, get = number.get](const VariationEntry& entry) {
             field->setSuffix(number.unit ? QLatin1Char(' ') + number.unit() : QString());
             if (number.lowestIs)
                 field->setSpecialValueText(number.lowestIs());
             field->setValue(get(entry));
         },
         [get = number.get](const VariationEntry& entry) { return get(entry) == get(VariationEntry()); }});
}

void LearningSettings::addLearning()
{
    m_form->addHeading([] { return tr("Learning"); });
    addNumber(
        {"learnDimensions", [] { return tr("Dimensions"); },
         [] { return tr("Of the latent space: more follow the takes closer and vary less; 1 to 10"); },
         [](const VariationEntry& entry) { return entry.learning.dimensions; },
         [](VariationEntry& entry, double value) { entry.learning.dimensions = static_cast<int>(value); }, 1,
         10});
    addNumber({"learnShare", [] { return tr("Displacement"); },
               [] {
                   return tr("How much the way over the ground counts against the pose: its variance in mean "
                             "variances of a coordinate");
               },
               [](const VariationEntry& entry) { return entry.displacementShare; },
               [](VariationEntry& entry, double value) { entry.displacementShare = value; }, 0.01, 1000, 1, 2,
               [] { return tr("variances"); }});
}

void LearningSettings::addDrawing()
{
    m_form->addHeading([] { return tr("Drawing"); });
    addPoses();
    addContacts();
}

void LearningSettings::addStop()
{
    m_form->addFold("learnAdvanced", [] { return tr("Advanced: learning"); });
    addNumber(
        {"learnRestarts", [] { return tr("Restarts"); },
         [] { return tr("Starts beyond the first, from disturbed principal components; the best counts"); },
         [](const VariationEntry& entry) { return entry.learning.restarts; },
         [](VariationEntry& entry, double value) { entry.learning.restarts = static_cast<int>(value); }, 0,
         50});
    addNumber(
        {"learnSeed", [] { return tr("Seed"); },
         [] { return tr("Of the restarts: the same seed learns the same"); },
         [](const VariationEntry& entry) { return static_cast<double>(entry.learning.seed); },
         [](VariationEntry& entry, double value) { entry.learning.seed = static_cast<std::uint64_t>(value); },
         0, 999'999});
    addNumber({"learnTolerance", [] { return tr("Tolerance"); },
               [] {
                   return tr("Learning stops where the objective fell by less than this share of itself, in "
                             "parts per million, over the window");
               },
               [](const VariationEntry& entry) { return entry.learning.tolerance * million; },
               [](VariationEntry& entry, double value) { entry.learning.tolerance = value / million; }, 0.001,
               10'000, 0.5, 3, [] { return tr("ppm"); }});
    addNumber({"learnWindow", [] { return tr("Window"); },
               [] { return tr("Over how many iterations the fall of the objective is looked at"); },
               [](const VariationEntry& entry) { return entry.learning.window; },
               [](VariationEntry& entry, double value) { entry.learning.window = static_cast<int>(value); },
               1, 1'000'000, 5, 0, [] { return tr("iterations"); }});
    addNumber({"learnIterations", [] { return tr("At most"); },
               [] { return tr("Iterations of one start; the panel says where these were not enough"); },
               [](const VariationEntry& entry) { return entry.learning.greatestIterations; },
               [](VariationEntry& entry, double value) {
                   entry.learning.greatestIterations = static_cast<int>(value);
               },
               1, 1'000'000, 1000, 0, [] { return tr("iterations"); }});
}

void LearningSettings::addChain()
{
    m_form->addFold("drawAdvanced", [] { return tr("Advanced: drawing"); });
    addNumber(
        {"chainSteps", [] { return tr("Leapfrog steps"); },
         [] { return tr("At most, of each proposal of Hybrid Monte Carlo: more wander further"); },
         [](const VariationEntry& entry) { return entry.chain.leapfrogSteps; },
         [](VariationEntry& entry, double value) { entry.chain.leapfrogSteps = static_cast<int>(value); }, 1,
         1000});
    addNumber({"chainBurnIn", [] { return tr("Burn-in"); },
               [] { return tr("Proposals before the first variation, while the step size is tuned"); },
               [](const VariationEntry& entry) { return entry.chain.burnIn; },
               [](VariationEntry& entry, double value) { entry.chain.burnIn = static_cast<int>(value); }, 0,
               100'000, 10, 0, [] { return tr("proposals"); }});
    addNumber({"chainThinning", [] { return tr("Thinning"); },
               [] { return tr("Proposals from one variation to the next: more are less alike"); },
               [](const VariationEntry& entry) { return entry.chain.thinning; },
               [](VariationEntry& entry, double value) { entry.chain.thinning = static_cast<int>(value); }, 1,
               10'000, 1, 0, [] { return tr("proposals"); }});
    addNumber({"chainLeast", [] { return tr("Accepted, at least"); },
               [] { return tr("The step size is made smaller where fewer proposals are accepted"); },
               [](const VariationEntry& entry) { return entry.chain.leastAcceptance * inPercent; },
               [](VariationEntry& entry, double value) {
                   entry.chain.leastAcceptance =
                       std::min(value / inPercent, entry.chain.greatestAcceptance - leastBand);
               },
               1, 99, 5, 0, [] { return tr("%", "percent"); }});
    addNumber({"chainGreatest", [] { return tr("Accepted, at most"); },
               [] { return tr("The step size is made greater where more proposals are accepted"); },
               [](const VariationEntry& entry) { return entry.chain.greatestAcceptance * inPercent; },
               [](VariationEntry& entry, double value) {
                   entry.chain.greatestAcceptance =
                       std::max(value / inPercent, entry.chain.leastAcceptance + leastBand);
               },
               1, 99, 5, 0, [] { return tr("%", "percent"); }});
}

void LearningSettings::addLimits()
{
    m_form->addFold("limitsAdvanced", [] { return tr("Advanced: what is rejected"); });
    addNumber({"limitDistance", [] { return tr("Distance"); },
               [] {
                   return tr("How far the worst pose may be from the nearest one that was learned from: as "
                             "far as takes of the same movement are from each other, or in sizes of the "
                             "figure");
               },
               [](const VariationEntry& entry) { return entry.limits.poseDistance.value_or(0) * inPercent; },
               [](VariationEntry& entry, double value) {
                   entry.limits.poseDistance = value > 0 ? std::optional(value / inPercent) : std::nullopt;
               },
               0, 1000, 1, 1, [] { return tr("% of size", "percent"); },
               [] { return tr("As the takes", "the limit of the distance"); }});
    addNumber({"limitSkate", [] { return tr("Skate"); },
               [] {
                   return tr("How much faster standing feet may slide than in the take, in sizes of the "
                             "figure a second");
               },
               [](const VariationEntry& entry) { return entry.limits.skate * inPercent; },
               [](VariationEntry& entry, double value) { entry.limits.skate = value / inPercent; }, 0, 10'000,
               5, 1, [] { return tr("% of size/s", "percent"); }});
    addNumber({"limitCrossings", [] { return tr("Crossings"); },
               [] {
                   return tr("How many more triangles may go through each other than in the take, as a share "
                             "of all");
               },
               [](const VariationEntry& entry) { return entry.limits.intersections * inPercent; },
               [](VariationEntry& entry, double value) { entry.limits.intersections = value / inPercent; }, 0,
               100, 0.5, 2, [] { return tr("% of triangles", "percent"); }});
    addNumber({"limitVolume", [] { return tr("Volume"); },
               [] { return tr("How far the body’s volume may leave that of the takes"); },
               [](const VariationEntry& entry) { return entry.limits.volumeChange * inPercent; },
               [](VariationEntry& entry, double value) { entry.limits.volumeChange = value / inPercent; }, 0,
               1000, 0.5, 2, [] { return tr("%", "percent"); }});
    addNumber(
        {"limitCollapse", [] { return tr("Collapse"); },
         [] { return tr("How much of a foot, a hand or another region of the body may shrink or fold up"); },
         [](const VariationEntry& entry) { return entry.limits.collapse * inPercent; },
         [](VariationEntry& entry, double value) { entry.limits.collapse = value / inPercent; }, 0, 100, 1, 1,
         [] { return tr("% of triangles", "percent"); }});
    addNumber({"limitSink", [] { return tr("Sink"); },
               [] { return tr("How much deeper than the take the body may reach, as a share of its size"); },
               [](const VariationEntry& entry) { return entry.limits.sink * inPercent; },
               [](VariationEntry& entry, double value) { entry.limits.sink = value / inPercent; }, 0, 1000,
               0.5, 2, [] { return tr("%", "percent"); }});
}

void LearningSettings::addChoice(const Choice& choice)
{
    auto* box = new QComboBox;
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->addItems({QString(), QString()});
    const auto set = [this, choice](int index) {
        if (!m_isShowing && m_variation.entry() != nullptr)
            m_variation.edit(choice.undoText(), QString::fromUtf8(choice.name),
                             [choice, index](VariationEntry& entry) { choice.write(entry, index); });
    };
    connect(box, &QComboBox::activated, this, set);
    m_form->add(choice.name, choice.label, choice.tip, box, [set] { set(0); });
    m_bindings.push_back({box,
                          [box, choice](const VariationEntry& entry) {
                              box->setItemText(0, choice.first());
                              box->setItemText(1, choice.second());
                              box->setCurrentIndex(choice.read(entry));
                          },
                          [choice](const VariationEntry& entry) { return choice.read(entry) == 0; }});
}

void LearningSettings::addPoses()
{
    addChoice(
        {"trajectoryDraw", [] { return tr("Trajectories"); },
         [] {
             return tr("Smooth deviations from the take, as far apart as the spread says, or the "
                       "model’s own trajectories as they are drawn, which jitter");
         },
         [] { return tr("Change what variations are drawn from"); }, [] { return tr("Smooth deviations"); },
         [] { return tr("Of the model"); },
         [](const VariationEntry& entry) { return static_cast<int>(entry.extent.draw); },
         [](VariationEntry& entry, int index) { entry.extent.draw = static_cast<TrajectoryDraw>(index); }});
    addChoice({"poseDraw", [] { return tr("Poses"); },
               [] {
                   return tr("The most probable pose of each place in the latent space, or one draw for all "
                             "frames");
               },
               [] { return tr("Change how poses come about"); }, [] { return tr("Most probable"); },
               [] { return tr("One draw"); },
               [](const VariationEntry& entry) { return static_cast<int>(entry.draw); },
               [](VariationEntry& entry, int index) { entry.draw = static_cast<PoseDraw>(index); }});
}

void LearningSettings::addContacts()
{
    auto* correct = new QCheckBox;
    const auto set = [this](bool on) {
        if (!m_isShowing && m_variation.entry() != nullptr)
            m_variation.edit(tr("Change whether standing feet keep still"),
                             QStringLiteral("correctsContacts"),
                             [on](VariationEntry& entry) { entry.correctsContacts = on; });
    };
    connect(correct, &QCheckBox::toggled, this, set);
    m_form->add(
        "drawContacts", {},
        [] {
            return tr("Takes slip from feet that touch the ground in the take, before variations are judged");
        },
        correct, [set] { set(VariationEntry().correctsContacts); });
    m_bindings.push_back({correct,
                          [correct](const VariationEntry& entry) {
                              correct->setText(tr("Keep standing &feet still"));
                              correct->setChecked(entry.correctsContacts);
                          },
                          [](const VariationEntry& entry) {
                              return entry.correctsContacts == VariationEntry().correctsContacts;
                          }});
}

void LearningSettings::refresh()
{
    const QScopedValueRollback showing(m_isShowing, true);
    const VariationEntry usual;
    const VariationEntry* entry = m_variation.entry();
    m_form->setEnabled(entry != nullptr);
    const VariationEntry& shown = entry == nullptr ? usual : *entry;
    for (const Binding& binding : m_bindings) {
        binding.show(shown);
        m_form->setUsual(binding.field, binding.isUsual(shown));
    }
}

} // namespace quadrille
