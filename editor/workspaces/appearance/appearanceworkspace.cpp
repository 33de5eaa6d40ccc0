// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/appearance/appearanceworkspace.h"

#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/appearance/appearancebar.h"
#include "editor/workspaces/appearance/betweenpanel.h"
#include "editor/workspaces/appearance/coefficientspanel.h"
#include "editor/workspaces/appearance/componentspanel.h"
#include "editor/workspaces/appearance/currentappearance.h"
#include "editor/workspaces/appearance/maskspanel.h"
#include "editor/workspaces/appearance/qualitypanel.h"
#include "editor/workspaces/appearance/showntexture.h"
#include "editor/workspaces/appearance/texturecomparison.h"
#include "widgets/controls/messagestrip.h"

#include <QAction>
#include <QVBoxLayout>
#include <algorithm>

namespace quadrille {

AppearanceWorkspace::AppearanceWorkspace(EditorContext& context, QWidget* parent)
    : Workspace(parent)
    , m_context(context)
    , m_view(new SceneView(context, source(), QStringLiteral("appearance")))
    , m_appearance(new CurrentAppearance(context, *m_view, this))
    , m_shown(new ShownTexture(*m_appearance, this))
    , m_comparison(new TextureComparison(*m_shown))
{
    setObjectName(QStringLiteral("appearanceWorkspace"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(new AppearanceBar(*m_appearance));
    column->addWidget(m_view, 1);
    m_view->addBeside(m_comparison);
    makePanels();
    connect(m_appearance, &CurrentAppearance::changed, this, &AppearanceWorkspace::follow);
    connect(m_appearance, &CurrentAppearance::resultChanged, this, &AppearanceWorkspace::showState);
    connect(m_shown, &ShownTexture::dressChanged, this, &AppearanceWorkspace::followTake);
    connect(&context.media, &SequenceMedia::changed, this, [this](const QString& name) {
        scene().update(name);
        showState();
    });
    connect(m_view, &SceneView::sceneChanged, this,
            [this] { m_view->timeline().setFrameCount(static_cast<int>(scene().frameCount())); });
    connect(&m_view->message(), &widgets::MessageStrip::actionTriggered, this, [this] {
        if (m_help != nullptr)
            m_context.actions.action(QLatin1String(m_help))->trigger();
    });
    retranslates(this, [this] { showState(); });
}

ClipScene::Source AppearanceWorkspace::source()
{
    return {.clip = [this](const QString& name, bool) -> const MeshSequence* {
                const MeshSequence* take = m_context.media.sequence(name);
                if (take == nullptr)
                    return nullptr;
                m_dressed = m_shown->dressed(*take);
                return &m_dressed;
            },
            .upAxis = [this] { return m_context.media.upAxis(); }};
}

void AppearanceWorkspace::makePanels()
{
    m_panels.push_back(
        {"coefficientsDock", [] { return tr("Coefficients"); }, new CoefficientsPanel(*m_shown)});
    m_panels.push_back({"componentsDock", [] { return tr("Components"); }, new ComponentsPanel(*m_shown)});
    m_panels.push_back({"masksDock", [] { return tr("Masks"); }, new MasksPanel(*m_shown, *m_comparison)});
    m_panels.push_back({"betweenDock", [] { return tr("Between"); }, new BetweenPanel(*m_shown)});
    Panel quality{"qualityDock", [] { return tr("Quality"); }, new QualityPanel(*m_shown)};
    quality.isLower = true;
    m_panels.push_back(std::move(quality));
}

std::optional<NamedFrame> AppearanceWorkspace::shownPose()
{
    return m_appearance->frame();
}

void AppearanceWorkspace::setActive(bool active)
{
    m_isActive = active;
    follow();
}

QJsonObject AppearanceWorkspace::look() const
{
    QJsonObject look = m_shown->toJson();
    look["entry"] = m_appearance->name();
    if (const auto frame = m_appearance->frame()) {
        look["sequence"] = QString::fromStdString(frame->sequence);
        look["frame"] = qint64{frame->frame.value};
    }
    return look;
}

void AppearanceWorkspace::setLook(const QJsonObject& look)
{
    const QString entry = look["entry"].toString();
    if (findAppearance(m_context.document.project(), entry.toStdString()) != nullptr)
        m_context.selection.select({Section::Appearances, entry});
    m_shown->fromJson(look);
    if (look.contains("sequence"))
        m_appearance->goToWhenShown({look["sequence"].toString().toStdString(),
                                     FrameIndex(std::max<qint64>(0, look["frame"].toInteger()))});
}

/// Models are read only while somebody looks.
void AppearanceWorkspace::follow()
{
    if (!m_isActive)
        return;
    m_context.appearances.want(m_appearance->name().isEmpty() ? QStringList()
                                                              : QStringList{m_appearance->name()});
    const QString& take = m_context.selection.shownSequence();
    const QStringList names = take.isEmpty() ? QStringList() : QStringList{take};
    if (scene().shown() != names)
        m_view->show(names);
    showState();
}

void AppearanceWorkspace::followTake()
{
    // The pose between two frames stands elsewhere than the take: that is no reason to look from elsewhere.
    if (m_shown->content() == TextureContent::Between && m_appearance->frame())
        scene().keepCamera();
    for (const QString& name : QStringList(scene().shown()))
        scene().update(name);
}

/// Says what is missing or went wrong, and offers what helps.
void AppearanceWorkspace::showState()
{
    using Kind = widgets::MessageStrip::Kind;
    const Project& project = m_context.document.project();
    const QString& take = m_context.selection.shownSequence();
    const auto* opening = m_context.media.resultState(take);
    QString notice;
    if (project.sequences.empty())
        notice = tr("Import sequences first: their textures are what is modelled.");
    else if (opening != nullptr && opening->phase == ResultPhase::Failed && scene().isEmpty())
        notice = tr("“%1” cannot be shown.").arg(take);
    viewport().setNotice(notice);
    widgets::MessageStrip& message = m_view->message();
    const AppearanceResults::State* state = m_appearance->resultState();
    m_help = nullptr;
    m_comparison->setEmptyText(tr("The texture of the frame that is shown stands here."));
    if (!project.sequences.empty() && m_appearance->hasTextures() == false) {
        const QString who = m_appearance->character();
        message.show(Kind::Info,
                     who.isEmpty() ? tr("No take has a texture for each frame, so there is nothing to model.")
                                   : tr("No take of “%1” has a texture for each frame, so there is nothing "
                                        "to model.")
                                         .arg(who),
                     tr("Select a take and choose a folder of textures in its properties: one picture for "
                        "each of its frames."));
        message.setAction({});
    } else if (!project.sequences.empty() && m_appearance->entry() == nullptr) {
        m_help = "appearance.new";
        message.show(
            Kind::Info,
            tr("Eigen textures and warps make sharp textures between captured frames, and fill in what is "
               "missing."));
        message.setAction(tr("New model"));
    } else if (state != nullptr && state->phase == ResultPhase::Failed && state->error) {
        const ErrorText text = describe(*state->error);
        m_help = "appearance.build";
        message.show(Kind::Error, text.placed(), text.remedy);
        message.setAction(tr("Try again"));
    } else if (state != nullptr && state->phase == ResultPhase::Stale && !state->hasModel()) {
        m_help = "appearance.build";
        message.show(Kind::Info, tr("“%1” is not built yet.").arg(m_appearance->name()),
                     tr("It takes some seconds for each texture; you can go on working meanwhile."));
        message.setAction(tr("Build"));
    } else {
        message.clear();
    }
}

} // namespace quadrille

#include "moc_appearanceworkspace.cpp"
