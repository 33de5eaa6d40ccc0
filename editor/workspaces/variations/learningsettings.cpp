// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/learningsettings.h"

#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/currentvariation.h"

#include <algorithm>

namespace quadrille {

namespace {

constexpr double hundredth = 0.01;
constexpr double partsPerMillion = 1e-6;
constexpr double leastBand = 0.01; // between the rates of acceptance that are sought

} // namespace

LearningSettings::LearningSettings(CurrentVariation& variation, QWidget* parent)
    : QScrollArea(parent)
    , m_variation(variation)
    , m_form(new SettingForm)
    , m_fields(*m_form, [this](const QString& text, const char* property, const auto& change) {
        if (m_variation.entry() != nullptr)
            m_variation.edit(text, QLatin1String(property), change);
    })
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
        m_fields.retranslate();
        refresh();
    });
}

void LearningSettings::addLearning()
{
    using S = GpdmSettings;
    const auto of = [](auto member) { return at(&VariationEntry::learning, member); };
    m_form->addHeading([] { return tr("Learning"); });
    m_fields.addNumber(
        {"learnDimensions", [] { return tr("Dimensions"); },
         [] { return tr("Of the latent space: more follow the takes closer and vary less; 1 to 10"); }},
        of(&S::dimensions), {.path = "learning.dimensions", .step = 1, .decimals = 0});
    m_fields.addNumber(
        {"learnShare", [] { return tr("Displacement"); },
         [] {
             return tr("How much the way over the ground counts against the pose: its variance in "
                       "mean variances of a coordinate");
         }},
        &VariationEntry::displacementShare,
        {.path = "variation.displacement_share", .step = 1, .unit = [] { return tr(" variances"); }});
}

void LearningSettings::addDrawing()
{
    m_form->addHeading([] { return tr("Drawing"); });
    m_fields.addChoice({"trajectoryDraw", [] { return tr("Trajectories"); },
                        [] {
                            return tr(
                                "Smooth deviations from the take, as far apart as the spread says, or the "
                                "model’s own trajectories as they are drawn, which jitter");
                        }},
                       at(&VariationEntry::extent, &TrajectoryLimits::draw),
                       {[] { return tr("Smooth deviations"); }, [] { return tr("Of the model"); }});
    m_fields.addChoice(
        {"poseDraw", [] { return tr("Poses"); },
         [] {
             return tr("The most probable pose of each place in the latent space, or one draw for "
                       "all frames");
         }},
        &VariationEntry::draw, {[] { return tr("Most probable"); }, [] { return tr("One draw"); }});
    m_fields.addSwitch({"drawContacts", [] { return tr("Keep standing feet still"); },
                        [] {
                            return tr(
                                "Takes slip from feet that touch the ground in the take, before variations "
                                "are judged");
                        }},
                       &VariationEntry::correctsContacts);
}

void LearningSettings::addStop()
{
    using S = GpdmSettings;
    const auto of = [](auto member) { return at(&VariationEntry::learning, member); };
    const auto iterations = [] { return tr(" iterations"); };
    m_form->addFold("learnAdvanced", [] { return tr("Advanced: learning"); });
    m_fields.addNumber({"learnRestarts", [] { return tr("Restarts"); },
                        [] {
                            return tr(
                                "Starts beyond the first, from disturbed principal components; the best "
                                "counts");
                        }},
                       of(&S::restarts), {.path = "learning.restarts", .step = 1, .decimals = 0});
    m_fields.addNumber({"learnSeed", [] { return tr("Seed"); },
                        [] { return tr("Of the restarts: the same seed learns the same"); }},
                       of(&S::seed), {.path = "learning.seed", .step = 1, .decimals = 0});
    m_fields.addNumber({"learnTolerance", [] { return tr("Tolerance"); },
                        [] {
                            return tr(
                                "Learning stops where the objective fell by less than this share of itself, "
                                "in parts per million, over the window");
                        }},
                       of(&S::tolerance),
                       {.path = "learning.tolerance",
                        .scale = partsPerMillion,
                        .step = 0.5,
                        .decimals = 3,
                        .unit = [] { return tr(" ppm"); },
                        .highest = 10'000});
    m_fields.addNumber({"learnWindow", [] { return tr("Window"); },
                        [] { return tr("Over how many iterations the fall of the objective is looked at"); }},
                       of(&S::window),
                       {.path = "learning.window", .step = 5, .decimals = 0, .unit = iterations});
    m_fields.addNumber(
        {"learnIterations", [] { return tr("At most"); },
         [] { return tr("Iterations of one start; the panel says where these were not enough"); }},
        of(&S::greatestIterations),
        {.path = "learning.iterations", .step = 1000, .decimals = 0, .unit = iterations});
}

void LearningSettings::addChain()
{
    using S = HmcSettings;
    const auto of = [](auto member) { return at(&VariationEntry::chain, member); };
    const auto proposals = [] { return tr(" proposals"); };
    m_form->addFold("drawAdvanced", [] { return tr("Advanced: drawing"); });
    m_fields.addNumber(
        {"chainSteps", [] { return tr("Leapfrog steps"); },
         [] { return tr("At most, of each proposal of Hybrid Monte Carlo: more wander further"); }},
        of(&S::leapfrogSteps), {.path = "sampling.leapfrog_steps", .step = 1, .decimals = 0});
    m_fields.addNumber(
        {"chainBurnIn", [] { return tr("Burn-in"); },
         [] { return tr("Proposals before the first variation, while the step size is tuned"); }},
        of(&S::burnIn), {.path = "sampling.burn_in", .step = 10, .decimals = 0, .unit = proposals});
    m_fields.addNumber({"chainThinning", [] { return tr("Thinning"); },
                        [] { return tr("Proposals from one variation to the next: more are less alike"); }},
                       of(&S::thinning),
                       {.path = "sampling.thinning", .step = 1, .decimals = 0, .unit = proposals});
    // Each moves the other where it has to.
    auto least = lensOf<VariationEntry>(of(&S::leastAcceptance));
    least.set = [](VariationEntry& entry, double share) {
        entry.chain.leastAcceptance = std::min(share, entry.chain.greatestAcceptance - leastBand);
    };
    auto greatest = lensOf<VariationEntry>(of(&S::greatestAcceptance));
    greatest.set = [](VariationEntry& entry, double share) {
        entry.chain.greatestAcceptance = std::max(share, entry.chain.leastAcceptance + leastBand);
    };
    const NumberLook share{.scale = hundredth,
                           .step = 5,
                           .decimals = 0,
                           .unit = [] { return tr(" %", "percent"); },
                           .lowest = 1,
                           .highest = 99};
    m_fields.addNumber(
        {"chainLeast", [] { return tr("Accepted, at least"); },
         [] { return tr("The step size is made smaller where fewer proposals are accepted"); }},
        least, share);
    m_fields.addNumber({"chainGreatest", [] { return tr("Accepted, at most"); },
                        [] { return tr("The step size is made greater where more proposals are accepted"); }},
                       greatest, share);
}

void LearningSettings::addLimits()
{
    using S = VariationLimits;
    const auto addShare = [this](const char* name, SettingForm::Text label, SettingForm::Text tip,
                                 auto member, NumberLook look) {
        look.scale = hundredth;
        m_fields.addNumber({name, std::move(label), std::move(tip)}, at(&VariationEntry::limits, member),
                           look);
    };
    const auto ofTriangles = [] { return tr(" % of triangles", "percent"); };
    m_form->addFold("limitsAdvanced", [] { return tr("Advanced: what is rejected"); });
    addShare(
        "limitDistance", [] { return tr("Distance"); },
        [] {
            return tr("How far the worst pose may be from the nearest one that was learned from: as far as "
                      "takes of "
                      "the same movement are from each other, or in sizes of the figure");
        },
        &S::poseDistance,
        {.step = 1,
         .decimals = 1,
         .unit = [] { return tr(" % of size", "percent"); },
         .automatic = [] { return tr("As the takes", "the limit of the distance"); },
         .lowest = 0.1});
    addShare(
        "limitSkate", [] { return tr("Skate"); },
        [] {
            return tr(
                "How much faster standing feet may slide than in the take, in sizes of the figure a second");
        },
        &S::skate,
        {.path = "variation_limits.skate",
         .step = 5,
         .decimals = 1,
         .unit = [] { return tr(" % of size/s", "percent"); },
         .highest = 10'000});
    addShare(
        "limitCrossings", [] { return tr("Crossings"); },
        [] {
            return tr(
                "How many more triangles may go through each other than in the take, as a share of all");
        },
        &S::intersections,
        {.path = "variation_limits.intersections", .step = 0.5, .unit = ofTriangles, .highest = 100});
    addShare(
        "limitVolume", [] { return tr("Volume"); },
        [] { return tr("How far the body’s volume may leave that of the takes"); }, &S::volumeChange,
        {.path = "variation_limits.volume_change", .step = 0.5, .unit = [] { return tr(" %", "percent"); }});
    addShare(
        "limitCollapse", [] { return tr("Collapse"); },
        [] { return tr("How much of a foot, a hand or another region of the body may shrink or fold up"); },
        &S::collapse,
        {.path = "variation_limits.collapse", .step = 1, .decimals = 1, .unit = ofTriangles, .highest = 100});
    addShare(
        "limitSink", [] { return tr("Sink"); },
        [] { return tr("How much deeper than the take the body may reach, as a share of its size"); },
        &S::sink, {.path = "variation_limits.sink", .step = 0.5, .unit = [] { return tr(" %", "percent"); }});
}

void LearningSettings::refresh()
{
    const VariationEntry* entry = m_variation.entry();
    m_form->setEnabled(entry != nullptr);
    m_fields.show(entry == nullptr ? VariationEntry() : *entry);
}

} // namespace quadrille

#include "moc_learningsettings.cpp"
