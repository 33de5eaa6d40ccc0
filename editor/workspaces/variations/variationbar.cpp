// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/variationbar.h"

#include "editor/commands/variationedits.h"
#include "editor/context/editorcontext.h"
#include "editor/fields/actionbutton.h"
#include "editor/fields/namebox.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/currentvariation.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

namespace quadrille {

namespace {

constexpr int barGap = 8;

} // namespace

VariationBar::VariationBar(CurrentVariation& variation, QWidget* parent)
    : QWidget(parent)
    , m_variation(variation)
    , m_names(new QComboBox)
    , m_learn(nullptr)
    , m_stop(nullptr)
    , m_state(new QLabel)
{
    setObjectName(QStringLiteral("variationBar"));
    m_names->setObjectName(QStringLiteral("variationNames"));
    fitToNames(*m_names);
    m_state->setObjectName(QStringLiteral("variationState"));
    m_state->setFont(widgets::Theme::tabularFont(m_state->font()));
    makeActions();
    ActionRegistry& actions = variation.context().actions;
    m_learn = makeActionButton(actions.action("variations.learn"));
    m_stop = makeActionButton(actions.action("variations.stop"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(barGap, barGap / 2, barGap, barGap / 2);
    row->setSpacing(barGap / 2);
    row->addWidget(m_names);
    row->addWidget(makeActionButton(actions.action("variations.new")));
    row->addWidget(makeActionButton(actions.action("variations.duplicate")));
    row->addSpacing(barGap);
    for (QToolButton* button : {m_learn, m_stop}) {
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        row->addWidget(button);
    }
    row->addWidget(m_state, 1);
    connect(m_names, &QComboBox::activated, this, [this] {
        m_variation.context().selection.select({Section::Variations, m_names->currentText()});
    });
    connect(&variation, &CurrentVariation::changed, this, &VariationBar::refresh);
    connect(&variation, &CurrentVariation::resultChanged, this, &VariationBar::refreshState);
    retranslates(this, [this] {
        m_names->setAccessibleName(tr("Variations"));
        m_names->setToolTip(tr("The variations that are worked on"));
        m_names->setPlaceholderText(tr("No variations"));
        refresh();
    });
}

void VariationBar::makeActions()
{
    EditorContext& context = m_variation.context();
    const auto group = [] { return tr("Variations"); };
    context.actions.add({"variations.new",
                         group,
                         [] { return tr("&New variations"); },
                         [] { return tr("Add variations of a movement to the project"); },
                         "add",
                         {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_V)}},
                        [this] {
                            m_variation.add();
                            m_variation.context().actions.action("workspace.variations")->trigger();
                        });
    context.actions.add({"variations.learn",
                         group,
                         [] { return tr("&Learn"); },
                         [] { return tr("Learns a model of each part of the body from the checked takes"); },
                         "refresh",
                         {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Return)}},
                        [this, &context] { context.variations.learn(m_variation.name()); });
    context.actions.add({"variations.stop",
                         group,
                         [] { return tr("Stop lear&ning"); },
                         [] { return tr("Ends learning and keeps the best so far"); },
                         "stop",
                         {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Backspace)}},
                        [this, &context] { context.variations.stop(m_variation.name()); });
    context.actions.add(
        {"variations.duplicate",
         group,
         [] { return tr("&Duplicate the variations"); },
         [] { return tr("Add a copy, to learn from other takes or in another way"); },
         "copy",
         {}},
        [this, &context] {
            context.selection.select(
                {Section::Variations, duplicateVariation(context.document, m_variation.name())});
        });
}

void VariationBar::refresh()
{
    const QSignalBlocker blocker(m_names);
    m_names->clear();
    for (const VariationEntry& entry : m_variation.context().document.project().variations)
        m_names->addItem(QString::fromStdString(entry.name));
    m_names->setCurrentIndex(m_names->findText(m_variation.name()));
    m_names->setEnabled(m_names->count() > 0);
    m_variation.context().actions.action("variations.duplicate")->setEnabled(m_variation.entry() != nullptr);
    refreshState();
}

void VariationBar::refreshState()
{
    using Work = VariationResults::Work;
    const VariationResults::State* result = m_variation.resultState();
    const bool isLearning = result != nullptr && result->does(Work::Learning);
    ActionRegistry& actions = m_variation.context().actions;
    actions.action("variations.learn")
        ->setEnabled(result != nullptr && !m_variation.entry()->training.empty() && !isLearning &&
                     !result->does(Work::Opening));
    actions.action("variations.stop")->setEnabled(isLearning);
    m_learn->setVisible(!isLearning);
    m_stop->setVisible(isLearning);
    m_state->setText(m_variation.stateText());
}

} // namespace quadrille

#include "moc_variationbar.cpp"
