// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/appearance/texturecomparison.h"

#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/fields/actionbutton.h"
#include "editor/fields/sliderfield.h"
#include "editor/language/retranslate.h"
#include "editor/pictures/uvedges.h"
#include "widgets/controls/comparedview.h"
#include "widgets/controls/legendbar.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <array>
#include <utility>

namespace quadrille {

namespace {

constexpr int comparisonGap = 4;
constexpr int legendHeight = 240; // pixels
constexpr std::array modeIds{"appearance.first",    "appearance.second",     "appearance.difference",
                             "appearance.absolute", "appearance.sideBySide", "appearance.swipe"};

bool isDifference(TextureMode mode)
{
    return mode == TextureMode::Difference || mode == TextureMode::AbsoluteDifference;
}

} // namespace

TextureComparison::TextureComparison(ShownTexture& shown, QWidget* parent)
    : QWidget(parent)
    , m_shown(shown)
    , m_making(nullptr, 1)
    , m_view(new widgets::ComparedView)
    , m_right(new widgets::ComparedView)
    , m_legend(new widgets::LegendBar)
    , m_content(new QComboBox)
    , m_mode(new QComboBox)
    , m_edges(nullptr)
    , m_fit(nullptr)
    , m_usedLabel(new QLabel)
    , m_used(new SliderField("appearanceUsed", "appearanceUsedNumber"))
    , m_quality(new QLabel)
    , m_note(new QLabel)
{
    makeActions();
    arrangeWidgets();
    connectParts();
    retranslates(this, [this] { retranslate(); });
}

TextureComparison::~TextureComparison() = default;

void TextureComparison::makeActions()
{
    ActionRegistry& actions = m_shown.appearance().context().actions;
    const auto group = [] { return tr("Appearance"); };
    const auto add = [&](TextureMode mode, ActionRegistry::Text text) {
        actions.add({QLatin1String(modeIds.at(static_cast<std::size_t>(mode))),
                     group,
                     std::move(text),
                     {},
                     "texture",
                     {}},
                    [this, mode] { m_shown.setMode(mode); });
    };
    add(TextureMode::First, [] { return tr("&Original"); });
    add(TextureMode::Second, [] { return tr("&Made by the model"); });
    add(TextureMode::Difference, [] { return tr("&Difference"); });
    add(TextureMode::AbsoluteDifference, [] { return tr("Difference, &absolute"); });
    add(TextureMode::SideBySide, [] { return tr("&Side by side"); });
    add(TextureMode::Swipe, [] { return tr("S&wipe"); });
    actions.addToggle({"appearance.edges",
                       group,
                       [] { return tr("&UV edges"); },
                       [] { return tr("Draw the edges of the mesh over its texture"); },
                       "wire",
                       {}},
                      false, [this](bool) { refreshEdges(); });
    actions.add({"appearance.fit",
                 group,
                 [] { return tr("&Fit the texture"); },
                 [] { return tr("Fit the texture into its view"); },
                 "frameall",
                 {}},
                [this] { m_view->fit(); });
}

void TextureComparison::arrangeWidgets()
{
    setObjectName(QStringLiteral("textureComparison"));
    m_view->setObjectName(QStringLiteral("appearanceTexture"));
    m_right->setObjectName(QStringLiteral("appearanceTextureRight"));
    m_legend->setObjectName(QStringLiteral("appearanceLegend"));
    m_legend->setMaximumHeight(legendHeight);
    m_content->setObjectName(QStringLiteral("appearanceContent"));
    m_mode->setObjectName(QStringLiteral("appearanceMode"));
    m_quality->setObjectName(QStringLiteral("appearanceQuality"));
    m_note->setObjectName(QStringLiteral("appearanceNote"));
    m_content->addItems({{}, {}, {}, {}});
    m_mode->addItems({{}, {}, {}, {}, {}, {}});
    for (QComboBox* box : {m_content, m_mode}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(14); // what is chosen mostly is not cut
    }
    ActionRegistry& actions = m_shown.appearance().context().actions;
    m_edges = makeActionButton(actions.action("appearance.edges"));
    m_fit = makeActionButton(actions.action("appearance.fit"));
    for (QLabel* label : {m_quality, m_note})
        label->setWordWrap(true);
    m_quality->setFont(widgets::Theme::tabularFont(font()));
    m_note->setForegroundRole(QPalette::PlaceholderText);

    auto* tools = new QHBoxLayout;
    tools->setContentsMargins(comparisonGap, comparisonGap, comparisonGap, comparisonGap);
    tools->setSpacing(comparisonGap);
    tools->addWidget(m_content, 1);
    tools->addWidget(m_mode, 1);
    tools->addWidget(m_edges);
    tools->addWidget(m_fit);
    auto* views = new QHBoxLayout;
    views->setSpacing(1);
    views->addWidget(m_view, 1);
    views->addWidget(m_right, 1);
    views->addWidget(m_legend, 0, Qt::AlignVCenter);
    auto* used = new QHBoxLayout;
    used->setContentsMargins(2 * comparisonGap, comparisonGap, comparisonGap, 0);
    used->addWidget(m_usedLabel);
    used->addWidget(m_used, 1);
    auto* facts = new QVBoxLayout;
    facts->setContentsMargins(2 * comparisonGap, 0, comparisonGap, comparisonGap);
    facts->setSpacing(0);
    facts->addWidget(m_quality);
    facts->addWidget(m_note);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(tools);
    column->addLayout(views, 1);
    column->addLayout(used);
    column->addLayout(facts);
}

void TextureComparison::connectParts()
{
    connect(&m_shown, &ShownTexture::changed, this, &TextureComparison::refresh);
    connect(m_content, &QComboBox::activated, this,
            [this](int index) { m_shown.setContent(static_cast<TextureContent>(index)); });
    connect(m_mode, &QComboBox::activated, this,
            [this](int index) { m_shown.setMode(static_cast<TextureMode>(index)); });
    connect(m_used, &SliderField::edited, this, [this](int components) { m_shown.setUsed(components); });
    connect(m_view, &widgets::TextureView::viewMoved, this, [this] { m_right->showLike(*m_view); });
    connect(m_right, &widgets::TextureView::viewMoved, this, [this] { m_view->showLike(*m_right); });
}

void TextureComparison::retranslate()
{
    m_content->setAccessibleName(tr("What is compared"));
    m_content->setToolTip(tr("What is compared"));
    const std::array contents{tr("Frame"), tr("Between two frames"), tr("Completed"), tr("Component")};
    for (std::size_t i = 0; i < contents.size(); ++i)
        m_content->setItemText(static_cast<int>(i), contents.at(i));
    m_mode->setAccessibleName(tr("How it is compared"));
    m_mode->setToolTip(tr("How it is compared"));
    m_view->setAccessibleName(tr("Texture"));
    m_right->setAccessibleName(tr("Second texture"));
    m_legend->setToolTip(tr("Difference in grey levels, second texture less the first"));
    m_usedLabel->setText(tr("Components used"));
    refresh();
}

void TextureComparison::setEmptyText(const QString& text)
{
    m_view->setEmptyText(text);
}

/// What the two textures are called.
QString TextureComparison::sideText(bool isFirst) const
{
    switch (m_shown.content()) {
    case TextureContent::Between:
        return isFirst ? tr("Linear blend") : tr("Model");
    case TextureContent::Completed:
        return isFirst ? tr("Before") : tr("After");
    case TextureContent::Component:
        return isFirst ? tr("Mean − %1 σ").arg(ShownTexture::componentReach)
                       : tr("Mean + %1 σ").arg(ShownTexture::componentReach);
    case TextureContent::Frame:
        break;
    }
    return isFirst ? tr("Original") : m_shown.isEdited() ? tr("Made by hand") : tr("Reconstruction");
}

void TextureComparison::refresh()
{
    refreshTools();
    refreshEdges();
    request();
}

void TextureComparison::refreshTools()
{
    m_content->setCurrentIndex(static_cast<int>(m_shown.content()));
    const bool isComponent = m_shown.content() == TextureContent::Component;
    const std::array modes{sideText(true),
                           sideText(false),
                           isComponent ? tr("Component") : tr("Difference"),
                           isComponent ? tr("Component") : tr("Difference, absolute"),
                           tr("Side by side"),
                           tr("Swipe")};
    for (std::size_t i = 0; i < modes.size(); ++i)
        m_mode->setItemText(static_cast<int>(i), modes.at(i));
    m_mode->setCurrentIndex(static_cast<int>(m_shown.mode()));
    const int count = m_shown.componentCount();
    const bool counts = count > 0 && m_shown.content() == TextureContent::Frame;
    m_usedLabel->setVisible(counts);
    m_used->setVisible(counts);
    m_used->setMaximum(count);
    m_used->setValue(m_shown.used());
    m_used->setTexts(tr("Components used"), tr(" of %1", "components").arg(count),
                     tr("How many of the model’s components textures are made of, from the first on"));
}

void TextureComparison::refreshEdges()
{
    CurrentAppearance& appearance = m_shown.appearance();
    const MeshSequence* sequence =
        appearance.context().media.sequence(appearance.context().selection.shownSequence());
    const bool isShown = appearance.context().actions.action("appearance.edges")->isChecked() &&
                         sequence != nullptr && sequence->topology->hasUvs();
    if (isShown && m_linesOf.lock() != sequence->topology) {
        m_lines.clear();
        m_linesOf = sequence->topology;
        appearance.context().jobs.start(
            {.name = tr("Drawing UV edges"),
             .receiver = this,
             .stillStands = [this, topology = sequence->topology] { return m_linesOf.lock() == topology; },
             .background = true},
            [topology = sequence->topology](const Progress& progress) {
                return uvEdges(*topology, std::nullopt, progress);
            },
            [this](const QList<QLineF>& lines) {
                m_lines = lines;
                refreshEdges();
            });
    }
    for (widgets::ComparedView* view : {m_view, m_right}) {
        const bool hasEdges = isShown && !view->image().isNull();
        if (hasEdges && !m_lines.isSharedWith(view->uvEdges()))
            view->setUvEdges(m_lines);
        else if (!hasEdges && !view->uvEdges().isEmpty())
            view->setUvEdges({});
    }
}

/// The latest wish counts: while one pair is made, others wait and only the last of them is made.
void TextureComparison::request()
{
    m_isLate = m_job != nullptr;
    if (m_isLate)
        return;
    auto wanted = m_shown.request();
    if (!wanted) {
        take({});
        return;
    }
    m_job = m_making.start(
        {.name = {},
         .receiver = this,
         .failed =
             [this](const Error& error) {
                 take({});
                 m_note->setText(describe(error).oneLine());
                 m_note->show();
             }},
        [request = std::move(*wanted)](const Progress& progress) { return makePair(request, progress); },
        [this](ShownPair pair) { take(std::move(pair)); });
    connect(m_job, &Job::ended, this, [this] {
        m_job = nullptr;
        if (std::exchange(m_isLate, false))
            request();
    });
}

void TextureComparison::take(ShownPair pair)
{
    m_pair = std::move(pair);
    m_pair.range.title = tr("Levels", "grey levels");
    showPair();
    showQuality();
    refreshEdges();
    emit pairShown();
}

void TextureComparison::showPair()
{
    const bool hasSecond = !m_pair.second.image.isNull();
    const bool hasDifference = !m_pair.difference.image.isNull();
    const TextureMode mode = hasSecond ? m_shown.mode() : TextureMode::First;
    const bool isBeside = mode == TextureMode::SideBySide;
    const bool isSwiped = mode == TextureMode::Swipe;
    m_right->setVisible(isBeside);
    m_legend->setVisible(isDifference(mode) && hasDifference &&
                         m_shown.content() != TextureContent::Component);
    m_legend->setRange(m_pair.range);
    m_view->setSides(isSwiped ? sideText(true) : QString(), isSwiped ? sideText(false) : QString());
    if (isDifference(mode) && hasDifference)
        m_view->setPicture(m_pair.difference);
    else if (mode == TextureMode::Second || isDifference(mode))
        m_view->setPicture(m_pair.second);
    else
        m_view->setPicture(m_pair.first.image.isNull() ? m_pair.second : m_pair.first);
    const bool isPair = m_pair.first.image.size() == m_pair.second.image.size();
    m_view->setOther(isSwiped && isPair ? m_pair.second : widgets::TexturePicture());
    m_right->setPicture(isBeside ? m_pair.second : widgets::TexturePicture());
}

void TextureComparison::showQuality()
{
    const bool isMeasured = m_pair.quality && m_shown.content() != TextureContent::Component;
    m_quality->setText(isMeasured ? tr("SSIM %1 · MSE %2 grey levels²")
                                        .arg(QLocale().toString(m_pair.quality->similarity, 'f', 4),
                                             QLocale().toString(m_pair.quality->meanSquaredError, 'f', 1))
                                  : QString());
    m_quality->setVisible(isMeasured);
    const QString missing = m_pair.first.image.isNull() ? QString() : m_shown.missing();
    m_note->setText(missing);
    m_note->setVisible(!missing.isEmpty());
}

} // namespace quadrille

#include "moc_texturecomparison.cpp"
