// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/postpanel.h"

#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/fields/verticalscroll.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "model/project/results/openanimation.h"
#include "widgets/charts/curveeditor.h"

#include <QLabel>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

namespace quadrille {

PostPanel::PostPanel(CurrentAnimation& animation, QWidget* parent)
    : QWidget(parent)
    , m_animation(animation)
    , m_form(new SettingForm)
    , m_fields(*m_form, [this](const QString& text, const char* property,
                               const Edit& edit) { change(text, property, edit); })
    , m_scroll(verticalScroll(m_form))
    , m_empty(new QWidget)
    , m_emptyText(new QLabel)
{
    setObjectName(QStringLiteral("postPanel"));
    makeEmpty();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_scroll, 1);
    column->addWidget(m_empty, 1);

    addRepeats();
    addLoop();
    addRetime();
    addContacts();
    addMirror();
    addBlending();
    addSearch();
    connect(&animation, &CurrentAnimation::changed, this, &PostPanel::refresh);
    connect(&animation, &CurrentAnimation::resultChanged, this, &PostPanel::refresh);
    connect(&animation.context().document, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
        if (event.touches(Section::Variations))
            refresh();
    });
    retranslates(this, [this] { retranslate(); });
}

/// What stands here while there is no animation, with the button that makes one.
void PostPanel::makeEmpty()
{
    auto* make = new QToolButton;
    make->setObjectName(QStringLiteral("postNew"));
    make->setDefaultAction(m_animation.context().actions.action("animate.new"));
    make->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_emptyText->setObjectName(QStringLiteral("postEmpty"));
    m_emptyText->setWordWrap(true);
    m_emptyText->setAlignment(Qt::AlignCenter);
    m_emptyText->setForegroundRole(QPalette::PlaceholderText);
    auto* column = new QVBoxLayout(m_empty);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    column->addStretch(1);
    column->addWidget(m_emptyText);
    column->addWidget(make, 0, Qt::AlignHCenter);
    column->addStretch(1);
}

double PostPanel::fps() const
{
    return m_animation.context().document.project().settings.fps;
}

double PostPanel::clipSeconds() const
{
    const auto result = m_animation.result();
    return result == nullptr ? 0 : static_cast<double>(result->framesBeforeRetime) / fps();
}

void PostPanel::change(const QString& text, const char* property, const Edit& edit, EditPhase phase)
{
    if (!m_fields.isShowing() && m_animation.entry() != nullptr)
        m_animation.edit(text, QLatin1String(property), edit, phase);
}

void PostPanel::refresh()
{
    const AnimationEntry* shown = m_animation.entry();
    m_scroll->setVisible(shown != nullptr);
    m_empty->setVisible(shown == nullptr);
    if (shown == nullptr)
        return;
    m_fields.show(*shown);
    refreshCurve(*shown);
    refreshProblems(*shown);
}

/// Says beside a setting why it does nothing, or why the clip could not be made with it.
void PostPanel::refreshProblems(const AnimationEntry& entry)
{
    const auto* resultState = m_animation.context().animations.resultState(m_animation.name());
    const std::optional<Error> error = resultState == nullptr ? std::nullopt : resultState->error;
    const auto failure = [&](std::initializer_list<ErrorCode> codes) {
        const bool isOurs = error && std::ranges::find(codes, error->code()) != codes.end();
        return isOurs ? describe(*error).oneLine() : QString();
    };
    const QString missing = failure({ErrorCode::VariationMissing});
    m_form->setProblem(m_repeated, missing.isEmpty() ? problemOfRepeats(entry) : missing);
    m_form->setProblem(m_loop, failure({ErrorCode::LoopTooShort, ErrorCode::LoopCutTooShort}));
    const bool isOfSymmetryFile =
        error && !entry.post.symmetry.empty() && error->context().file == entry.post.symmetry;
    m_form->setProblem(m_mirror, isOfSymmetryFile
                                     ? describe(*error).oneLine()
                                     : failure({ErrorCode::NoSymmetry, ErrorCode::SymmetryMapWrong}));
    m_form->setProblem(m_retime, failure({ErrorCode::TimeCurveNotMonotone}));
    m_repeats->setEnabled(entry.post.steps.loop.has_value());
    m_form->setProblem(
        m_repeats, entry.post.steps.loop ? QString() : tr("Only a loop can be repeated: ask for one above."));
}

void PostPanel::retranslate()
{
    m_emptyText->setText(tr("Here an animation is looped, retimed, mirrored and blended."));
    m_fields.retranslate();
    m_curve->setAxisTitles(tr("Time in the result (s)"), tr("Moment of the clip (s)"));
    m_curve->setAccessibleName(tr("Curve of times"));
    if (m_animation.entry() == nullptr)
        return;
    m_fields.show(*m_animation.entry());
    refreshProblems(*m_animation.entry());
}

} // namespace quadrille

#include "moc_postpanel.cpp"
