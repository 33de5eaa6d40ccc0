// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/alternativeslist.h"

#include "editor/fields/rightmenu.h"
#include "editor/language/retranslate.h"
#include "editor/pictures/framepictures.h"
#include "editor/workspaces/graph/framenames.h"
#include "editor/workspaces/graph/graphexplorer.h"
#include "editor/workspaces/graph/transitionspeeds.h"
#include "model/graph/alternatives.h"
#include "widgets/graph/chartscale.h"
#include "widgets/theme/theme.h"

#include <QHeaderView>
#include <QLocale>
#include <QPainter>
#include <algorithm>

namespace quadrille {

namespace {

using widgets::chartNumber;

constexpr int smallestTable = 180; // pixels
constexpr int pictureSide = 32;    // pixels
constexpr int pictureWidth = 22;   // of its middle: figures stand
constexpr int pictureGap = 2;      //
constexpr int mostListed = 10;
constexpr int mostSought = 60; // of which some may be of takes that are not looked at

} // namespace

QString speedText(bool isMeasured, const std::optional<double>& speed)
{
    if (!isMeasured)
        return QStringLiteral("…");
    return speed ? QLocale().toString(*speed, 'f', 2) : QStringLiteral("–");
}

AlternativesList::AlternativesList(GraphExplorer& explorer, TransitionSpeeds& speeds, FramePictures& pictures,
                                   QWidget* parent)
    : QTreeWidget(parent), m_explorer(explorer), m_speeds(speeds), m_pictures(pictures)
{
    setObjectName(QStringLiteral("transitionAlternatives"));
    addRightMenu(*this);
    setColumnCount(ColumnCount);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setIconSize({2 * pictureWidth + pictureGap, pictureSide});
    setMinimumHeight(smallestTable);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    header()->setMinimumSectionSize(32);
    connect(this, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item) { choose(item); });
    connect(this, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) { choose(item); });
    connect(&explorer, &GraphExplorer::filterChanged, this, &AlternativesList::refresh);
    connect(&speeds, &TransitionSpeeds::changed, this, &AlternativesList::showSpeeds);
    connect(&pictures, &FramePictures::drawn, this, &AlternativesList::showPictures);
    retranslates(this, [this] { retranslate(); });
}

void AlternativesList::choose(QTreeWidgetItem* item)
{
    const auto row = static_cast<std::size_t>(indexOfTopLevelItem(item));
    if (row < m_listed.size() && m_listed[row] != m_pair)
        emit chosen(m_listed[row]);
}

void AlternativesList::show(const std::optional<FramePair>& pair)
{
    m_pair = pair;
    if (!pair || std::ranges::find(m_listed, *pair) == m_listed.end())
        m_ends.reset();
    refresh();
}

void AlternativesList::showBest(int from, int to)
{
    m_ends.emplace(from, to);
    refresh();
}

std::vector<FramePair> AlternativesList::sought() const
{
    const TransitionCosts& costs = m_explorer.character()->graph.costs();
    const double alpha = m_explorer.alpha();
    if (m_ends)
        return bestTransitions(costs, alpha, m_ends->first, m_ends->second, {.most = mostListed});
    if (!m_pair)
        return {};
    return alternatives(costs, alpha, *m_pair,
                        {.most = m_explorer.filter().isEmpty() ? mostListed : mostSought});
}

void AlternativesList::refresh()
{
    clear();
    m_listed.clear();
    if (!m_explorer.character())
        return;
    const CharacterGraph& graph = m_explorer.character()->graph;
    const TransitionCosts& costs = graph.costs();
    const TakeFilter& filter = m_explorer.filter();
    for (const FramePair& pair : sought()) {
        if (static_cast<int>(m_listed.size()) < mostListed &&
            (m_ends || filter.passes(graph.layout().sequenceOf(pair.source),
                                     graph.layout().sequenceOf(pair.destination))))
            m_listed.push_back(pair);
    }
    for (const FramePair& pair : m_listed) {
        auto* item = new QTreeWidgetItem(this);
        // In two lines, which leave the numbers room.
        item->setText(Both,
                      pairName(m_explorer, pair).replace(QStringLiteral(" › "), QStringLiteral("\n› ")));
        item->setToolTip(Both, pairName(m_explorer, pair));
        item->setText(Weight, chartNumber(costs.weight(pair.source, pair.destination, m_explorer.alpha())));
        item->setText(Frames, QLocale().toString(costs.length()(pair.source, pair.destination)));
        for (int column = Weight; column < ColumnCount; ++column) {
            item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
            item->setFont(column, widgets::Theme::tabularFont(font()));
        }
    }
    showPictures();
    showSpeeds();
    std::vector<FramePair> asked = m_listed;
    if (m_pair && costs.hasTransition(m_pair->source, m_pair->destination))
        asked.insert(asked.begin(), *m_pair);
    m_speeds.ask(std::move(asked));
}

void AlternativesList::showPictures()
{
    if (!m_explorer.character())
        return;
    for (std::size_t row = 0; row < m_listed.size(); ++row) {
        const double ratio = devicePixelRatioF();
        QPixmap both(iconSize() * ratio);
        both.setDevicePixelRatio(ratio);
        both.fill(Qt::transparent);
        QPainter painter(&both);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        int left = 0;
        for (const NodeIndex frame : {m_listed[row].source, m_listed[row].destination}) {
            const NamedFrame named = m_explorer.character()->graph.nameOf(frame);
            const QImage picture = m_pictures.picture(QString::fromStdString(named.sequence), named.frame);
            if (!picture.isNull())
                painter.drawImage(QRect(left, 0, pictureWidth, pictureSide), picture,
                                  QRect(picture.width() * (pictureSide - pictureWidth) / (2 * pictureSide), 0,
                                        picture.width() * pictureWidth / pictureSide, picture.height()));
            left += pictureWidth + pictureGap;
        }
        painter.end();
        topLevelItem(static_cast<int>(row))->setIcon(Both, both);
    }
}

void AlternativesList::showSpeeds()
{
    for (std::size_t row = 0; row < m_listed.size(); ++row) {
        const TransitionSpeeds::Speeds* speeds = m_speeds.of(m_listed[row]);
        QTreeWidgetItem* item = topLevelItem(static_cast<int>(row));
        const bool isMeasured = speeds != nullptr;
        item->setText(Slide, speedText(isMeasured, isMeasured ? speeds->slide : std::nullopt));
        item->setText(Jump, speedText(isMeasured, isMeasured ? speeds->jump : std::nullopt));
    }
}

void AlternativesList::retranslate()
{
    setHeaderLabels({tr("Transition"), tr("Weight"), tr("Slide", "of feet, a speed"),
                     tr("Jump", "of the speed"), tr("Frames")});
    const auto setTip = [this](Column column, const QString& tip) {
        headerItem()->setToolTip(column, tip);
        headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    };
    setTip(Weight, tr("Deformation and duration together"));
    setTip(Frames, tr("How many frames it lasts"));
    setTip(Slide, tr("How fast standing feet slide meanwhile, in metres a second"));
    setTip(Jump,
           tr("How much the body’s velocity over the ground changes from before to behind it, in metres a "
              "second"));
    refresh();
}

} // namespace quadrille

#include "moc_alternativeslist.cpp"
