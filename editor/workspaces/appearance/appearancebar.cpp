// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/appearance/appearancebar.h"

#include "editor/commands/appearanceedits.h"
#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/fields/actionbutton.h"
#include "editor/fields/appearancefields.h"
#include "editor/fields/namebox.h"
#include "editor/language/retranslate.h"
#include "widgets/controls/elidedlabel.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QSignalBlocker>
#include <QToolButton>
#include <cmath>

namespace quadrille {

namespace {

constexpr int appearanceBarGap = 8;
constexpr int progressWidth = 110; // pixels
constexpr int fullProgress = 1000;
constexpr double minute = 60; // seconds

} // namespace

AppearanceBar::AppearanceBar(CurrentAppearance& appearance, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance)
    , m_names(new QComboBox)
    , m_bar(new FieldBar)
    , m_fields(*m_bar,
               [this](const QString& text, const char* property, const auto& change) {
                   m_appearance.edit(text, QLatin1String(property), change);
               })
    , m_progress(new QProgressBar)
    , m_state(new widgets::ElidedLabel)
{
    setObjectName(QStringLiteral("appearanceBar"));
    makeActions();
    addAppearanceFields(m_fields, {.components = "appearanceBarComponents",
                                   .warps = "appearanceBarWarps",
                                   .flow = "appearanceBarFlow",
                                   .varied = "appearanceBarVaried"});
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
         [] { return tr("&Cancel"); },
         [] { return tr("Ends the computation; flows that are done need not be computed again"); },
         "stop",
         {}},
        [this, &context] { context.appearances.stop(m_appearance.name()); });
}

void AppearanceBar::arrangeWidgets()
{
    ActionRegistry& actions = m_appearance.context().actions;
    m_build = makeActionButton(actions.action("appearance.build"));
    m_stop = makeActionButton(actions.action("appearance.stop"));
    m_names->setObjectName(QStringLiteral("appearanceNames"));
    m_progress->setObjectName(QStringLiteral("appearanceProgress"));
    m_state->setObjectName(QStringLiteral("appearanceState"));
    connect(m_names, &QComboBox::activated, this, [this] {
        m_appearance.context().selection.select({Section::Appearances, m_names->currentText()});
    });
    fitToNames(*m_names);
    m_progress->setRange(0, fullProgress);
    m_progress->setFixedWidth(progressWidth);
    m_progress->setTextVisible(false);
    m_state->setFont(widgets::Theme::tabularFont(m_state->font()));
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
    column->addLayout(upper);
    column->addWidget(m_bar);
}

void AppearanceBar::retranslate()
{
    m_names->setAccessibleName(tr("Models of textures"));
    m_names->setToolTip(tr("The model of textures that is worked on"));
    m_names->setPlaceholderText(tr("No model"));
    m_fields.retranslate();
    refresh();
}

void AppearanceBar::refresh()
{
    const QSignalBlocker blocker(m_names);
    m_names->clear();
    for (const AppearanceEntry& each : m_appearance.context().document.project().appearances)
        m_names->addItem(QString::fromStdString(each.name));
    m_names->setCurrentIndex(m_names->findText(m_appearance.name()));
    m_names->setEnabled(m_names->count() > 0);
    const AppearanceEntry* entry = m_appearance.entry();
    m_bar->setVisible(entry != nullptr);
    if (entry != nullptr)
        m_fields.show(*entry);
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
    case ResultPhase::Ready: {
        const AppearanceModel& model = state->opened->decoder->model();
        const QString learned =
            tr("Ready: %n texture(s) learned", nullptr, static_cast<int>(model.frames.size()));
        const auto count = static_cast<int>(model.textures.count + model.warps.count);
        return count < m_appearance.entry()->components
                   ? tr("%1; they have no more than %n component(s)", nullptr, count).arg(learned)
                   : learned;
    }
    case ResultPhase::Failed:
        return state->error ? tr("Failed: %1").arg(describe(*state->error).oneLine())
                            : tr("It did not work.");
    default:
        return state->hasModel() ? tr("Out of date: of other settings or textures. Build it again.")
                                 : tr("Not built yet");
    }
}

} // namespace quadrille

#include "moc_appearancebar.cpp"
