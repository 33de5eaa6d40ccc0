// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/appearance/appearancebar.h"

#include "editor/commands/appearanceedits.h"
#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/fields/actionbutton.h"
#include "editor/fields/numberfield.h"
#include "editor/language/retranslate.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QToolButton>
#include <cmath>

namespace quadrille {

namespace {

constexpr int appearanceBarGap = 8;
constexpr int progressWidth = 110; // pixels
constexpr int fullProgress = 1000;
constexpr double minute = 60; // seconds

NumberLook componentsLook()
{
    return {.path = "appearance.components", .step = 5, .decimals = 0};
}

NumberLook warpsLook()
{
    constexpr double hundredth = 0.01;
    return {.path = "appearance.warp_share", .scale = hundredth, .step = 5, .decimals = 0};
}

} // namespace

AppearanceBar::AppearanceBar(CurrentAppearance& appearance, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance)
    , m_names(new QComboBox)
    , m_flow(new QComboBox)
    , m_varied(new QComboBox)
    , m_componentsLabel(new QLabel)
    , m_warpsLabel(new QLabel)
    , m_flowLabel(new QLabel)
    , m_variedLabel(new QLabel)
    , m_progress(new QProgressBar)
    , m_state(new QLabel)
{
    setObjectName(QStringLiteral("appearanceBar"));
    makeActions();
    makeFields();
    arrangeWidgets();
    connect(&appearance, &CurrentAppearance::changed, this, &AppearanceBar::refresh);
    connect(&appearance, &CurrentAppearance::resultChanged, this, &AppearanceBar::refreshState);
    retranslates(this, [this] { retranslate(); });
}

void AppearanceBar::makeActions()
{
    EditorContext& context = m_appearance.context();
    const auto group = [] { return tr("Appearance"); };
    context.actions.add({"appearance.new",
                         group,
                         [] { return tr("&New model of textures"); },
                         [] { return tr("Add a model of the character’s textures to the project"); },
                         "add",
                         {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_T)}},
                        [this] {
                            m_appearance.add();
                            m_appearance.context().actions.action("workspace.appearance")->trigger();
                        });
    context.actions.add(
        {"appearance.duplicate",
         group,
         [] { return tr("&Duplicate the model of textures"); },
         [] { return tr("Add a copy, to compute it with other settings"); },
         "copy",
         {}},
        [this, &context] {
            context.selection.select(
                {Section::Appearances, duplicateAppearance(context.document, m_appearance.name())});
        });
    context.actions.add({"appearance.build",
                         group,
                         [] { return tr("&Build"); },
                         [] { return tr("Computes Eigen textures and Eigen warps of all textures"); },
                         "refresh",
                         {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_U)}},
                        [this, &context] { context.appearances.build(m_appearance.name()); });
    context.actions.add(
        {"appearance.stop",
         group,
         [] { return tr("&Cancel building"); },
         [] { return tr("Ends the computation; flows that are done need not be computed again"); },
         "stop",
         {}},
        [this, &context] { context.appearances.stop(m_appearance.name()); });
}

void AppearanceBar::makeFields()
{
    m_components = makeNumberField(componentsLook());
    m_warps = makeNumberField(warpsLook());
    m_names->setObjectName(QStringLiteral("appearanceNames"));
    m_components->setObjectName(QStringLiteral("appearanceBarComponents"));
    m_warps->setObjectName(QStringLiteral("appearanceBarWarps"));
    m_flow->setObjectName(QStringLiteral("appearanceBarFlow"));
    m_progress->setObjectName(QStringLiteral("appearanceProgress"));
    m_state->setObjectName(QStringLiteral("appearanceState"));
    m_varied->setObjectName(QStringLiteral("appearanceBarVaried"));
    m_flow->addItems({{}, {}});
    m_varied->addItems({{}, {}});
    connect(m_names, &QComboBox::activated, this, [this] {
        m_appearance.context().selection.select({Section::Appearances, m_names->currentText()});
    });
    connect(m_components, &QDoubleSpinBox::valueChanged, this, [this](double shown) {
        edit(m_componentsLabel->text(), "appearanceComponents",
             [shown](AppearanceEntry& entry) { entry.components = std::llround(shown); });
    });
    connect(m_warps, &QDoubleSpinBox::valueChanged, this, [this](double shown) {
        edit(m_warpsLabel->text(), "appearanceWarps",
             [shown](AppearanceEntry& entry) { entry.warpShare = inFile(warpsLook(), shown); });
    });
    connect(m_flow, &QComboBox::currentIndexChanged, this, [this](int index) {
        edit(m_flowLabel->text(), "appearanceFlow",
             [index](AppearanceEntry& entry) { entry.flow = static_cast<FlowMethod>(index); });
    });
    connect(m_varied, &QComboBox::currentIndexChanged, this, [this](int index) {
        edit(m_variedLabel->text(), "appearanceVaried",
             [index](AppearanceEntry& entry) { entry.varied = static_cast<VariedTextures>(index); });
    });
}

void AppearanceBar::arrangeWidgets()
{
    ActionRegistry& actions = m_appearance.context().actions;
    m_build = makeActionButton(actions.action("appearance.build"));
    m_stop = makeActionButton(actions.action("appearance.stop"));
    m_names->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_names->setMinimumContentsLength(10);
    m_progress->setRange(0, fullProgress);
    m_progress->setFixedWidth(progressWidth);
    m_progress->setTextVisible(false);
    m_state->setFont(widgets::Theme::tabularFont(m_state->font()));
    m_state->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(appearanceBarGap, appearanceBarGap / 2, appearanceBarGap,
                               appearanceBarGap / 2);
    column->setSpacing(appearanceBarGap / 2);
    auto* upper = new QHBoxLayout;
    upper->setSpacing(appearanceBarGap / 2);
    upper->addWidget(m_names);
    upper->addWidget(makeActionButton(actions.action("appearance.new")));
    upper->addWidget(makeActionButton(actions.action("appearance.duplicate")));
    upper->addSpacing(appearanceBarGap);
    for (QToolButton* button : {m_build, m_stop}) {
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        upper->addWidget(button);
    }
    upper->addWidget(m_progress);
    upper->addWidget(m_state, 1);
    auto* lower = new QHBoxLayout;
    lower->setSpacing(appearanceBarGap / 2);
    const auto add = [&](QLabel* label, QWidget* field) {
        label->setBuddy(field);
        lower->addWidget(label);
        lower->addWidget(field);
        lower->addSpacing(appearanceBarGap);
    };
    add(m_componentsLabel, m_components);
    add(m_warpsLabel, m_warps);
    add(m_flowLabel, m_flow);
    add(m_variedLabel, m_varied);
    lower->addStretch(1);
    column->addLayout(upper);
    column->addLayout(lower);
}

void AppearanceBar::retranslate()
{
    const QScopedValueRollback showing(m_isShowing, true);
    m_names->setAccessibleName(tr("Models of textures"));
    m_names->setToolTip(tr("The model of textures that is worked on"));
    m_names->setPlaceholderText(tr("No model"));
    m_componentsLabel->setText(tr("Components"));
    m_components->setToolTip(tr("Of Eigen textures and Eigen warps together, at most; 1 to 1000"));
    m_warpsLabel->setText(tr("Warps"));
    m_warps->setToolTip(tr("How many of the components are Eigen warps, which align textures"));
    m_warps->setSuffix(tr(" %", "percent"));
    m_flowLabel->setText(tr("Alignment"));
    m_flow->setToolTip(tr("How the way of each texel is found from texture to texture"));
    m_flow->setItemText(0, tr("TV-L1"));
    m_flow->setItemText(1, tr("Dense inverse search, quick"));
    m_variedLabel->setText(tr("Variations"));
    m_varied->setToolTip(tr("What frames of variations take their textures from: their poses, as the model "
                            "learned to vary with them, or the captured frames that they vary"));
    m_varied->setItemText(0, tr("Learned from poses"));
    m_varied->setItemText(1, tr("Of captured frames"));
    refresh();
}

void AppearanceBar::edit(const QString& what, const char* property, const CurrentAppearance::Edit& edit)
{
    if (!m_isShowing)
        m_appearance.edit(tr("Set “%1”").arg(what), QLatin1String(property), edit);
}

void AppearanceBar::refresh()
{
    const QScopedValueRollback showing(m_isShowing, true);
    const QSignalBlocker blocker(m_names);
    m_names->clear();
    for (const AppearanceEntry& each : m_appearance.context().document.project().appearances)
        m_names->addItem(QString::fromStdString(each.name));
    m_names->setCurrentIndex(m_names->findText(m_appearance.name()));
    m_names->setEnabled(m_names->count() > 0);
    const AppearanceEntry* entry = m_appearance.entry();
    for (QWidget* field :
         std::initializer_list<QWidget*>{m_components, m_warps, m_flow, m_varied, m_componentsLabel,
                                         m_warpsLabel, m_flowLabel, m_variedLabel})
        field->setVisible(entry != nullptr);
    if (entry != nullptr) {
        showNumber(*m_components, static_cast<double>(entry->components));
        showNumber(*m_warps, entry->warpShare / warpsLook().scale);
        m_flow->setCurrentIndex(static_cast<int>(entry->flow));
        m_varied->setCurrentIndex(static_cast<int>(entry->varied));
    }
    m_appearance.context().actions.action("appearance.duplicate")->setEnabled(entry != nullptr);
    refreshState();
}

void AppearanceBar::refreshState()
{
    using Work = AppearanceResults::Work;
    const AppearanceResults::State* state = m_appearance.resultState();
    const bool isComputed =
        state != nullptr && (state->does(Work::Building) || state->does(Work::Completing));
    ActionRegistry& actions = m_appearance.context().actions;
    const bool isFresh = state != nullptr && state->phase == ResultPhase::Ready;
    actions.action("appearance.build")
        ->setEnabled(m_appearance.entry() != nullptr && state != nullptr && !isComputed && !isFresh &&
                     m_appearance.hasTextures().value_or(true));
    actions.action("appearance.stop")->setEnabled(isComputed);
    m_build->setVisible(m_appearance.entry() != nullptr && !isComputed);
    m_stop->setVisible(isComputed);
    m_progress->setVisible(isComputed);
    Job* job = isComputed ? state->job.data() : nullptr;
    if (m_job != job) {
        if (m_job)
            m_job->disconnect(this);
        m_job = job;
        if (m_job)
            connect(m_job, &Job::changed, this, &AppearanceBar::showProgress);
    }
    showProgress();
}

void AppearanceBar::showProgress()
{
    if (m_job)
        m_progress->setValue(static_cast<int>(std::lround(m_job->fraction() * fullProgress)));
    const QString text = stateText();
    m_state->setText(text);
    m_state->setToolTip(text);
}

QString AppearanceBar::stateText() const
{
    using Work = AppearanceResults::Work;
    const AppearanceResults::State* state = m_appearance.resultState();
    if (m_appearance.entry() == nullptr || state == nullptr)
        return {};
    switch (state->phase) {
    case ResultPhase::Computing: {
        if (state->does(Work::Looking))
            return {};
        QString what =
            state->does(Work::Completing) ? tr("Completing textures…") : tr("Computing the model…");
        const auto left = m_job ? m_job->timeLeft() : std::nullopt;
        if (!left)
            return what;
        const auto seconds = static_cast<int>(std::ceil(left->value));
        return seconds < static_cast<int>(minute)
                   ? tr("%1 %n second(s) left", nullptr, seconds).arg(what)
                   : tr("%1 %n minute(s) left", nullptr, static_cast<int>(std::ceil(left->value / minute)))
                         .arg(what);
    }
    case ResultPhase::Ready:
        return tr("Ready: %n texture(s) learned", nullptr,
                  static_cast<int>(state->opened->decoder->model().frames.size()));
    case ResultPhase::Failed:
        return state->error ? tr("Failed: %1").arg(describe(*state->error).oneLine())
                            : tr("It did not work.");
    default:
        return state->hasModel() ? tr("Out of date: the model is of other settings or textures")
                                 : tr("Not built yet");
    }
}

} // namespace quadrille
