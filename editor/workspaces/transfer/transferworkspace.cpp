// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/transfer/transferworkspace.h"

#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/transfer/currenttransfer.h"
#include "editor/workspaces/transfer/pairspanel.h"
#include "editor/workspaces/transfer/pairtool.h"
#include "editor/workspaces/transfer/transferbar.h"
#include "editor/workspaces/transfer/transferchart.h"
#include "editor/workspaces/transfer/transfersettingspanel.h"
#include "model/project/document/findentry.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/theme/theme.h"

#include <QAction>
#include <QFileDialog>
#include <QVBoxLayout>

namespace quadrille {

TransferWorkspace::TransferWorkspace(EditorContext& context, QWidget* parent)
    : Workspace(parent)
    , m_context(context)
    , m_view(new SceneView(context, source(), QStringLiteral("transfer")))
    , m_transfer(new CurrentTransfer(context, *m_view, this))
    , m_tool(new PairTool(*m_transfer, this))
{
    setObjectName(QStringLiteral("transferWorkspace"));
    makeActions();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(new TransferBar(*m_transfer));
    column->addWidget(m_view, 1);
    makePanels();
    connect(m_transfer, &CurrentTransfer::changed, this, &TransferWorkspace::follow);
    connect(m_transfer, &CurrentTransfer::resultChanged, this, &TransferWorkspace::followResult);
    connect(m_transfer, &CurrentTransfer::showsReferenceChanged, this, [this] {
        m_view->show({}); // what is shown anew is framed anew
        followResult();
    });
    connect(m_view, &SceneView::sceneChanged, this, [this] {
        m_view->timeline().setFrameCount(static_cast<int>(scene().frameCount()));
        m_tool->refresh();
    });
    connect(&m_view->message(), &widgets::MessageStrip::actionTriggered, this, [this] {
        if (m_help.isEmpty())
            m_context.transfers.retry(m_transfer->name());
        else
            m_context.actions.action(m_help)->trigger();
    });
    retranslates(this, [this] { showState(); });
}

QString TransferWorkspace::templateName()
{
    return tr("Template");
}

QString TransferWorkspace::targetName()
{
    return tr("Body");
}

ClipScene::Source TransferWorkspace::source()
{
    return {.clip = [this](const QString& name, bool) { return clip(name); },
            .upAxis = [this] { return m_context.media.upAxis(); },
            .color = [](const QString& /*name*/) { return widgets::Theme::color(widgets::ColorRole::Clay); },
            .section = Section::Transfers};
}

/// While an older preview is all that there is, it is shown.
const MeshSequence* TransferWorkspace::clip(const QString& name)
{
    const TransferPreviewPointer preview = m_transfer->preview();
    if (preview == nullptr)
        return nullptr;
    const bool isTemplate = name == templateName();
    MeshSequence& shown = m_clips[isTemplate ? 0 : 1];
    const bool isPosed = preview->posed.has_value();
    if (isTemplate)
        shown = m_transfer->showsReference() ? preview->reference : preview->performed;
    else if (m_transfer->showsReference() || !isPosed)
        shown = preview->rest;
    else
        shown = m_transfer->result() ? m_transfer->result()->sequence : *preview->posed;
    return &shown;
}

void TransferWorkspace::makeActions()
{
    const auto group = [] { return tr("Transfer"); };
    ActionRegistry& actions = m_context.actions;
    actions.add({"transfer.new",
                 group,
                 [] { return tr("&New transfer"); },
                 [] { return tr("Lets another body perform the take that is selected"); },
                 "add",
                 {}},
                [this] { m_transfer->add(); });
    actions.add(
        {"transfer.addSequence",
         group,
         [] { return tr("&Add as a take"); },
         [] { return tr("Adds the transferred clip to the takes: for graphs, animations, variations"); },
         "sequence",
         {}},
        [this] { addSequence(); });
    actions.add({"transfer.export",
                 group,
                 [] { return tr("E&xport the clip…"); },
                 [] { return tr("Writes the transferred clip into files"); },
                 "export",
                 {}},
                [this] { emit exportRequested(shownClip()); });
    actions.add({"projection.new",
                 group,
                 [] { return tr("New 3D &video…"); },
                 [] {
                     return tr("Projects pictures of calibrated cameras onto the clip: its textures then are "
                               "what they saw");
                 },
                 "camera",
                 {}},
                [this] { addProjection(); });
    QAction* reference =
        actions.addToggle({"transfer.reference",
                           group,
                           [] { return tr("Show &reference poses"); },
                           [] { return tr("Shows both bodies as they stand, instead of what they perform"); },
                           "character",
                           {}},
                          false, [this](bool shows) { m_transfer->setShowsReference(shows); });
    connect(m_transfer, &CurrentTransfer::showsReferenceChanged, reference,
            [this, reference] { reference->setChecked(m_transfer->showsReference()); });
}

void TransferWorkspace::addProjection()
{
    const QString file =
        QFileDialog::getOpenFileName(window(), tr("Choose a table of cameras"), {}, tr("Cameras (*.json)"));
    if (!file.isEmpty())
        m_transfer->addProjection(file);
}

void TransferWorkspace::makePanels()
{
    m_panels.push_back({"pairsDock", [] { return tr("Pairs"); }, new PairsPanel(*m_tool)});
    m_panels.push_back(
        {"transferSettingsDock", [] { return tr("Settings"); }, new TransferSettingsPanel(*m_transfer)});
    Panel chart{"transferChartDock", [] { return tr("Report"); }, new TransferChart(*m_transfer)};
    chart.isLower = true;
    m_panels.push_back(std::move(chart));
}

void TransferWorkspace::addSequence()
{
    SequenceEntry sequence;
    sequence.name = m_transfer->name().toStdString();
    sequence.source = "clip:transfers/" + m_transfer->name().toStdString();
    const Project& project = m_context.document.project();
    if (const SequenceEntry* target = findSequence(project, m_transfer->entry()->target.sequence))
        sequence.character = target->character;
    std::vector<SequenceEntry> added;
    added.push_back(std::move(sequence));
    addSequences(m_context.document, std::move(added));
}

QString TransferWorkspace::shownClip() const
{
    return m_transfer->entry() == nullptr ? QString() : QStringLiteral("transfers/") + m_transfer->name();
}

std::optional<NamedFrame> TransferWorkspace::shownPose()
{
    const TransferEntry* entry = m_transfer->entry();
    const std::string prefix = "sequences/";
    if (entry == nullptr || !entry->clip.starts_with(prefix))
        return std::nullopt;
    return NamedFrame{entry->clip.substr(prefix.size()), FrameIndex(player().frame().value)};
}

void TransferWorkspace::setActive(bool active)
{
    m_isActive = active;
    m_tool->setActive(active);
    follow();
}

QJsonObject TransferWorkspace::look() const
{
    return {{"entry", m_transfer->name()}, {"reference", m_transfer->showsReference()}};
}

void TransferWorkspace::setLook(const QJsonObject& look)
{
    const QString entry = look["entry"].toString();
    if (findTransfer(m_context.document.project(), entry.toStdString()) != nullptr)
        m_context.selection.select({Section::Transfers, entry});
    m_transfer->setShowsReference(look["reference"].toBool());
}

/// Transfers are computed only while somebody looks.
void TransferWorkspace::follow()
{
    if (!m_isActive)
        return;
    m_context.transfers.want(m_transfer->entry() == nullptr ? QStringList()
                                                            : QStringList{m_transfer->name()});
    followResult();
}

void TransferWorkspace::followResult()
{
    if (!m_isActive)
        return;
    const QStringList names = m_transfer->entry() == nullptr || m_transfer->preview() == nullptr
                                  ? QStringList()
                                  : QStringList{templateName(), targetName()};
    if (scene().shown() != names)
        m_view->show(names);
    for (const QString& name : names)
        scene().update(name);
    for (const char* id : {"transfer.addSequence", "transfer.export"})
        m_context.actions.action(QLatin1String(id))->setEnabled(m_transfer->entry() != nullptr);
    m_tool->refresh();
    showState();
}

/// Says what is missing or went wrong, and offers what helps.
void TransferWorkspace::showState()
{
    using Kind = widgets::MessageStrip::Kind;
    const Project& project = m_context.document.project();
    widgets::MessageStrip& message = m_view->message();
    const TransferResults::State* state = m_transfer->state();
    m_help.clear();
    viewport().setNotice(
        project.sequences.empty()
            ? tr("Import takes first, and a scan of somebody else: the scan can perform the takes.")
            : QString());
    if (!project.sequences.empty() && m_transfer->entry() == nullptr) {
        m_help = QStringLiteral("transfer.new");
        message.show(Kind::Info,
                     tr("Here another body performs a take: a scan of anybody, or any creature with knees "
                        "and elbows."),
                     tr("Import a scan, then pair triangles of both bodies, or have pairs proposed."));
        message.setAction(tr("New transfer"));
    } else if (state != nullptr && state->phase == ResultPhase::Failed && state->error) {
        const ErrorText text = describe(*state->error);
        message.show(Kind::Error, text.placed(), text.remedy);
        message.setAction(tr("Try again"));
    } else {
        message.clear();
    }
}

} // namespace quadrille

#include "moc_transferworkspace.cpp"
