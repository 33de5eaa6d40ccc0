// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/transfer/transferbar.h"

#include "editor/commands/transferedits.h"
#include "editor/context/editorcontext.h"
#include "editor/fields/actionbutton.h"
#include "editor/fields/namebox.h"
#include "editor/fields/transferfields.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/transfer/currenttransfer.h"
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

constexpr int transferBarGap = 8;          // pixels
constexpr int transferProgressWidth = 110; // pixels
constexpr int transferFullProgress = 1000;

} // namespace

TransferBar::TransferBar(CurrentTransfer& transfer, QWidget* parent)
    : QWidget(parent)
    , m_transfer(transfer)
    , m_names(new QComboBox)
    , m_bar(new FieldBar)
    , m_fields(*m_bar, [this](const QString& text, const char* property,
                              const auto& change) { m_transfer.edit(text, QLatin1String(property), change); })
    , m_progress(new QProgressBar)
    , m_state(new widgets::ElidedLabel)
{
    setObjectName(QStringLiteral("transferBar"));
    makeActions();
    addTransferSubjects(m_fields, {.clip = "transferBarClip", .target = "transferBarTarget"},
                        [&transfer]() -> const Project& { return transfer.context().document.project(); });
    arrangeWidgets();
    connect(&transfer, &CurrentTransfer::changed, this, &TransferBar::refresh);
    connect(&transfer, &CurrentTransfer::resultChanged, this, &TransferBar::refreshState);
    retranslates(this, [this] { retranslate(); });
}

void TransferBar::makeActions()
{
    EditorContext& context = m_transfer.context();
    context.actions.add({"transfer.duplicate",
                         [] { return tr("Transfer"); },
                         [] { return tr("&Duplicate the transfer"); },
                         [] { return tr("Adds a copy, for another body or another clip"); },
                         "copy",
                         {}},
                        [this, &context] {
                            context.selection.select(
                                {Section::Transfers, duplicateTransfer(context.document, m_transfer.name())});
                        });
}

void TransferBar::arrangeWidgets()
{
    ActionRegistry& actions = m_transfer.context().actions;
    m_names->setObjectName(QStringLiteral("transferNames"));
    m_progress->setObjectName(QStringLiteral("transferProgress"));
    m_state->setObjectName(QStringLiteral("transferState"));
    connect(m_names, &QComboBox::activated, this, [this] {
        m_transfer.context().selection.select({Section::Transfers, m_names->currentText()});
    });
    fitToNames(*m_names);
    m_progress->setRange(0, transferFullProgress);
    m_progress->setFixedWidth(transferProgressWidth);
    m_progress->setTextVisible(false);
    m_state->setFont(widgets::Theme::tabularFont(m_state->font()));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(transferBarGap, transferBarGap / 2, transferBarGap, transferBarGap / 2);
    column->setSpacing(transferBarGap / 2);
    auto* upper = new QHBoxLayout;
    upper->setSpacing(transferBarGap / 2);
    upper->addWidget(m_names);
    for (const char* id : {"transfer.new", "transfer.duplicate"})
        upper->addWidget(makeActionButton(actions.action(QLatin1String(id))));
    upper->addSpacing(transferBarGap);
    for (const char* id : {"transfer.reference", "transfer.addSequence", "transfer.export"})
        upper->addWidget(makeActionButton(actions.action(QLatin1String(id))));
    upper->addSpacing(transferBarGap);
    upper->addWidget(m_progress);
    upper->addWidget(m_state, 1);
    column->addLayout(upper);
    column->addWidget(m_bar);
}

void TransferBar::retranslate()
{
    m_names->setAccessibleName(tr("Transfers"));
    m_names->setToolTip(tr("The transfer that is worked on"));
    m_names->setPlaceholderText(tr("No transfer"));
    m_fields.retranslate();
    refresh();
}

void TransferBar::refresh()
{
    const QSignalBlocker blocker(m_names);
    m_names->clear();
    const Project& project = m_transfer.context().document.project();
    for (const TransferEntry& each : project.transfers)
        m_names->addItem(QString::fromStdString(each.name));
    m_names->setCurrentIndex(m_names->findText(m_transfer.name()));
    m_names->setEnabled(m_names->count() > 0);
    const TransferEntry* entry = m_transfer.entry();
    m_bar->setVisible(entry != nullptr);
    if (entry != nullptr)
        m_fields.show(*entry);
    ActionRegistry& actions = m_transfer.context().actions;
    actions.action(QStringLiteral("transfer.duplicate"))->setEnabled(entry != nullptr);
    actions.action(QStringLiteral("transfer.new"))->setEnabled(!project.sequences.empty());
    actions.action(QStringLiteral("transfer.reference"))->setEnabled(entry != nullptr);
    refreshState();
}

void TransferBar::refreshState()
{
    const TransferResults::State* state = m_transfer.state();
    const bool isComputed = state != nullptr && state->phase == ResultPhase::Computing;
    Job* job = isComputed ? state->job.data() : nullptr;
    if (m_job != job) {
        if (m_job)
            m_job->disconnect(this);
        m_job = job;
        const auto show = [this] {
            if (m_job)
                m_progress->setValue(static_cast<int>(std::lround(m_job->fraction() * transferFullProgress)));
        };
        if (m_job)
            connect(m_job, &Job::changed, this, show);
    }
    m_progress->setVisible(isComputed);
    m_state->setText(stateText());
    m_state->setToolTip(m_state->text());
}

QString TransferBar::stateText() const
{
    const TransferResults::State* state = m_transfer.state();
    if (m_transfer.entry() == nullptr || state == nullptr)
        return {};
    const bool isPosed = m_transfer.preview() != nullptr && m_transfer.preview()->posed;
    switch (state->phase) {
    case ResultPhase::Computing:
        return isPosed ? tr("Preview; the clip is computed…") : tr("Computing…");
    case ResultPhase::Ready:
        return m_transfer.result() == nullptr
                   ? QString()
                   : tr("Ready: %n frame(s)", nullptr,
                        static_cast<int>(m_transfer.result()->sequence.frameCount()));
    case ResultPhase::Failed:
        return tr("It did not work.");
    default:
        return isPosed ? tr("Preview") : tr("Not computed");
    }
}

} // namespace quadrille

#include "moc_transferbar.cpp"
