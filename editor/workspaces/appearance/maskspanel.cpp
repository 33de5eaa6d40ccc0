// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/appearance/maskspanel.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/actionbutton.h"
#include "editor/fields/ownkeys.h"
#include "editor/fields/rightmenu.h"
#include "editor/fields/verticalscroll.h"
#include "editor/language/retranslate.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QSlider>
#include <QToolButton>
#include <array>
#include <cmath>

namespace quadrille {

namespace {

constexpr int masksMargin = 12;
constexpr double sizeStep = 0.002; ///< of the brush's radius, widths of the texture
constexpr int largestSize = 100;

/// Goes through its rows by keys that belong to playing elsewhere.
class CompletionList : public QListWidget
{
public:
    /// As low as it may be: a scrolled panel whose sentences wrap is as high as all its hints.
    QSize sizeHint() const override { return {QListWidget::sizeHint().width(), minimumHeight()}; }

protected:
    bool event(QEvent* event) override
    {
        return takesOwnKeys(*event, {Qt::Key_Up, Qt::Key_Down, Qt::Key_Home, Qt::Key_End}) ||
               QListWidget::event(event);
    }
};

} // namespace

MasksPanel::MasksPanel(ShownTexture& shown, TextureComparison& comparison, QWidget* parent)
    : QWidget(parent)
    , m_shown(shown)
    , m_canvas(new MaskCanvas(shown, comparison, this))
    , m_sentence(new QLabel)
    , m_toolLabel(new QLabel)
    , m_tool(new QComboBox)
    , m_sizeLabel(new QLabel)
    , m_size(new QSlider(Qt::Horizontal))
    , m_list(new CompletionList)
    , m_state(new QLabel)
{
    setObjectName(QStringLiteral("masksPanel"));
    makeActions();
    arrangeWidgets();
    connect(&shown, &ShownTexture::changed, this, &MasksPanel::refresh);
    connect(m_canvas, &MaskCanvas::changed, this, &MasksPanel::refresh);
    connect(m_tool, &QComboBox::activated, this, [this](int index) {
        m_canvas->setTool(static_cast<MaskTool>(index));
        m_canvas->setPainting(true);
    });
    connect(m_size, &QSlider::valueChanged, this, [this](int value) {
        if (!m_isShowing)
            m_canvas->setRadius(value * sizeStep);
    });
    connect(m_list, &QListWidget::currentRowChanged, this, [this](int row) {
        const AppearanceEntry* entry = m_shown.appearance().entry();
        if (m_isShowing || row < 0 || entry == nullptr)
            return;
        const NamedFrame frame = entry->completions.at(static_cast<std::size_t>(row)).frame;
        m_shown.setContent(TextureContent::Completed);
        m_shown.appearance().goTo(frame);
    });
    retranslates(this, [this] { retranslate(); });
}

void MasksPanel::makeActions()
{
    EditorContext& context = m_shown.appearance().context();
    const auto group = [] { return tr("Appearance"); };
    context.actions.addToggle({"appearance.paint",
                               group,
                               [] { return tr("&Paint a mask"); },
                               [] { return tr("Marks what is missing of the texture, in the texture view"); },
                               "drawcurve",
                               {}},
                              false, [this](bool paints) { m_canvas->setPainting(paints); });
    context.actions.add({"appearance.addCompletion",
                         group,
                         [] { return tr("Complete this f&rame"); },
                         [] { return tr("Adds the texture of the frame to those that are completed"); },
                         "add",
                         {}},
                        [this] { m_canvas->add(); });
    context.actions.add(
        {"appearance.removeCompletion",
         group,
         [] { return tr("Do &not complete this frame"); },
         [] { return tr("Takes the texture of the frame out of those that are completed, with its mask"); },
         "delete",
         {}},
        [this] { m_canvas->remove(); });
    context.actions.add({"appearance.clearMask",
                         group,
                         [] { return tr("Clear the &mask"); },
                         [] { return tr("Takes all strokes of the mask away"); },
                         "cancel",
                         {}},
                        [this] { m_canvas->clear(); });
    context.actions.add({"appearance.complete",
                         group,
                         [] { return tr("C&omplete textures"); },
                         [] { return tr("Fills in what is masked with what the model finds likeliest"); },
                         "refresh",
                         {}},
                        [this, &context] {
                            m_canvas->setPainting(false);
                            m_shown.setContent(TextureContent::Completed);
                            m_shown.setMode(TextureMode::Swipe);
                            context.appearances.complete(m_shown.appearance().name());
                        });
}

void MasksPanel::arrangeWidgets()
{
    m_sentence->setWordWrap(true);
    m_sentence->setForegroundRole(QPalette::PlaceholderText);
    m_state->setWordWrap(true);
    m_tool->setObjectName(QStringLiteral("maskTool"));
    m_size->setObjectName(QStringLiteral("maskSize"));
    m_list->setObjectName(QStringLiteral("maskList"));
    m_state->setObjectName(QStringLiteral("maskState"));
    m_tool->addItems({{}, {}, {}});
    m_size->setRange(1, largestSize);
    m_list->setMinimumHeight(60);
    ActionRegistry& actions = m_shown.appearance().context().actions;
    addRightMenu(*m_list, {actions.action("appearance.removeCompletion")});
    const auto button = [&](const char* id) { return makeActionButton(actions.action(QLatin1String(id))); };
    QToolButton* paint = button("appearance.paint");
    QToolButton* complete = button("appearance.complete");
    for (QToolButton* each : {paint, complete})
        each->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    auto* painting = new QHBoxLayout;
    painting->addWidget(paint);
    painting->addStretch(1);
    painting->addWidget(button("appearance.clearMask"));
    auto* grid = new QGridLayout;
    grid->addWidget(m_toolLabel, 0, 0);
    grid->addWidget(m_tool, 0, 1);
    grid->addWidget(m_sizeLabel, 1, 0);
    grid->addWidget(m_size, 1, 1);
    grid->setColumnStretch(1, 1);
    auto* frames = new QHBoxLayout;
    frames->addWidget(button("appearance.addCompletion"));
    frames->addWidget(button("appearance.removeCompletion"));
    frames->addStretch(1);
    frames->addWidget(complete);
    auto* page = new QWidget;
    auto* rows = new QVBoxLayout(page);
    rows->setContentsMargins(masksMargin, masksMargin / 2, masksMargin, masksMargin);
    rows->addWidget(m_sentence);
    rows->addLayout(painting);
    rows->addLayout(grid);
    rows->addWidget(m_list, 1);
    rows->addLayout(frames);
    rows->addWidget(m_state);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(verticalScroll(page));
    m_toolLabel->setBuddy(m_tool);
    m_sizeLabel->setBuddy(m_size);
}

void MasksPanel::retranslate()
{
    m_sentence->setText(
        tr("Mark what a texture lacks; the model fills it in. Textures to be completed are not "
           "learned from."));
    m_toolLabel->setText(tr("Tool"));
    const std::array tools{tr("Brush"), tr("Eraser"), tr("Fill a chart")};
    for (std::size_t i = 0; i < tools.size(); ++i)
        m_tool->setItemText(static_cast<int>(i), tools.at(i));
    m_sizeLabel->setText(tr("Size"));
    m_tool->setToolTip(tr("What a press on the texture does while a mask is painted"));
    m_size->setToolTip(tr("Radius of the brush"));
    m_list->setAccessibleName(tr("Textures to be completed"));
    m_list->setToolTip(tr("Textures to be completed: choose one to go there"));
    refresh();
}

void MasksPanel::refresh()
{
    const QScopedValueRollback showing(m_isShowing, true);
    m_tool->setCurrentIndex(static_cast<int>(m_canvas->tool()));
    m_size->setValue(static_cast<int>(std::lround(m_canvas->radius() / sizeStep)));
    const AppearanceEntry* entry = m_shown.appearance().entry();
    const auto frame = m_shown.appearance().frame();
    QStringList texts;
    int current = -1;
    for (std::size_t i = 0; entry != nullptr && i < entry->completions.size(); ++i) {
        const CompletionEntry& each = entry->completions[i];
        texts += each.strokes.empty() && each.mask.empty() ? tr("%1, no mask yet").arg(frameText(each.frame))
                                                           : frameText(each.frame);
        if (each.frame == frame)
            current = static_cast<int>(i);
    }
    QStringList shown;
    for (int row = 0; row < m_list->count(); ++row)
        shown += m_list->item(row)->text();
    if (texts != shown) {
        m_list->clear();
        m_list->addItems(texts);
    }
    m_list->setCurrentRow(current);
    m_state->setText(stateText());
    refreshActions();
}

void MasksPanel::refreshActions()
{
    using Work = AppearanceResults::Work;
    CurrentAppearance& appearance = m_shown.appearance();
    ActionRegistry& actions = appearance.context().actions;
    const AppearanceEntry* entry = appearance.entry();
    const CompletionEntry* own = m_canvas->completion();
    const AppearanceResults::State* state = appearance.resultState();
    const bool isComputed =
        state != nullptr && (state->does(Work::Building) || state->does(Work::Completing));
    const bool isDone = state != nullptr && state->opened != nullptr && state->opened->areCompletionsFresh;
    const auto frame = appearance.frame();
    const bool hasTexture = entry != nullptr && frame && !appearance.textureOf(*frame).isEmpty();
    actions.action("appearance.paint")->setEnabled(hasTexture);
    actions.action("appearance.paint")->setChecked(m_canvas->isPainting());
    actions.action("appearance.addCompletion")->setEnabled(hasTexture && own == nullptr);
    actions.action("appearance.removeCompletion")->setEnabled(own != nullptr);
    actions.action("appearance.clearMask")
        ->setEnabled(own != nullptr && (!own->strokes.empty() || !own->mask.empty()));
    actions.action("appearance.complete")
        ->setEnabled(state != nullptr && entry != nullptr && !entry->completions.empty() && !isComputed &&
                     !isDone);
}

QString MasksPanel::stateText() const
{
    using Work = AppearanceResults::Work;
    const AppearanceEntry* entry = m_shown.appearance().entry();
    const AppearanceResults::State* state = m_shown.appearance().resultState();
    if (entry == nullptr)
        return tr("Add a model of textures first.");
    if (entry->completions.empty())
        return tr("Go to a frame, choose “Paint a mask” and mark on its texture what is missing.");
    if (state != nullptr && state->does(Work::Completing))
        return tr("Completing textures…");
    if (state != nullptr && state->opened != nullptr && state->opened->areCompletionsFresh)
        return tr("All are completed as they are masked.");
    if (state != nullptr && state->phase == ResultPhase::Ready)
        return tr("Completed anew when you ask for it.");
    return tr("Completing them builds the model first.");
}

} // namespace quadrille

#include "moc_maskspanel.cpp"
