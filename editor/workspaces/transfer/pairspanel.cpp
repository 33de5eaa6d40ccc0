// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/transfer/pairspanel.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/actionbutton.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/transfer/currenttransfer.h"
#include "editor/workspaces/transfer/pairtool.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

constexpr int pairsMargin = 8; // pixels
constexpr int partColumn = 1;
constexpr int likenessColumn = 2;
constexpr int templateColumn = 3;
constexpr int bodyColumn = 4;
constexpr int fewPairs = 15;
constexpr double unlikelyRatio = 5; ///< of the heights of two bodies

} // namespace

PairsPanel::PairsPanel(PairTool& tool, QWidget* parent)
    : QWidget(parent), m_transfer(tool.transfer()), m_list(new QTreeWidget), m_advice(new QLabel)
{
    setObjectName(QStringLiteral("pairsPanel"));
    m_list->setObjectName(QStringLiteral("pairsList"));
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setColumnCount(bodyColumn + 1);
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_list->header()->setStretchLastSection(true);
    m_list->addAction(m_transfer.context().actions.action(QStringLiteral("transfer.mirror")));
    m_list->addAction(m_transfer.context().actions.action(QStringLiteral("transfer.removePair")));
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_advice->setObjectName(QStringLiteral("pairsAdvice"));
    m_advice->setWordWrap(true);
    auto* tools = new QHBoxLayout;
    tools->setContentsMargins(pairsMargin, pairsMargin / 2, pairsMargin, 0);
    tools->setSpacing(pairsMargin / 2);
    for (const char* id :
         {"transfer.propose", "transfer.mirror", "transfer.mirrorAll", "transfer.removePair"})
        tools->addWidget(makeActionButton(m_transfer.context().actions.action(QLatin1String(id))));
    tools->addStretch(1);
    auto* notes = new QHBoxLayout;
    notes->setContentsMargins(pairsMargin, 0, pairsMargin, pairsMargin);
    notes->addWidget(m_advice);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(pairsMargin / 2);
    column->addLayout(tools);
    column->addWidget(m_list, 1);
    column->addLayout(notes);
    connect(m_list, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (!m_isShowing)
            m_transfer.select(item == nullptr ? -1 : m_list->indexOfTopLevelItem(item));
    });
    connect(&m_transfer, &CurrentTransfer::changed, this, &PairsPanel::refresh);
    connect(&m_transfer, &CurrentTransfer::resultChanged, this, &PairsPanel::refresh);
    connect(&m_transfer, &CurrentTransfer::selectionChanged, this, &PairsPanel::showSelection);
    connect(&widgets::Theme::instance(), &widgets::Theme::changed, this, &PairsPanel::refresh);
    retranslates(this, [this] { retranslate(); });
}

void PairsPanel::retranslate()
{
    m_list->setHeaderLabels({tr("Pair"), tr("Part"), tr("Likeness"), tr("Template"), tr("Body")});
    m_list->headerItem()->setToolTip(
        likenessColumn, tr("How alike the two places are once the template is laid onto the body: by "
                           "how far they are from hands, feet and head, where they lie and how they "
                           "face; below 30 % a look is worth while"));
    for (const int column : {templateColumn, bodyColumn})
        m_list->headerItem()->setToolTip(column, tr("Number of the triangle, from 0"));
    m_list->setAccessibleName(tr("Pairs of triangles"));
    refresh();
}

void PairsPanel::refresh()
{
    const QScopedValueRollback showing(m_isShowing, true);
    const std::vector<ProposedPair> pairs = m_transfer.pairs();
    const auto count = static_cast<int>(pairs.size());
    while (m_list->topLevelItemCount() > count)
        delete m_list->takeTopLevelItem(count);
    while (m_list->topLevelItemCount() < count)
        m_list->addTopLevelItem(new QTreeWidgetItem);
    const QLocale locale;
    for (int p = 0; p < count; ++p) {
        QTreeWidgetItem& item = *m_list->topLevelItem(p);
        const ProposedPair& pair = pairs[static_cast<std::size_t>(p)];
        const auto region = m_transfer.regionOf(pair.pair);
        const bool isKnown = !std::isnan(pair.quality);
        item.setText(0, locale.toString(p + 1));
        item.setText(partColumn, region ? CurrentTransfer::regionName(*region) : QStringLiteral("–"));
        item.setText(templateColumn, QString::number(pair.pair.onTemplate.value));
        item.setText(bodyColumn, QString::number(pair.pair.onTarget.value));
        //: a share
        item.setText(likenessColumn,
                     isKnown ? tr("%1 %").arg(std::lround(100 * pair.quality)) : QStringLiteral("–"));
        item.setIcon(likenessColumn, isKnown && pair.quality < doubtfulLikeness
                                         ? widgets::icons::icon(QStringLiteral("warning"))
                                         : QIcon());
        for (const int column : {0, likenessColumn, templateColumn, bodyColumn})
            item.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    m_advice->setText(advice());
    m_advice->setVisible(!m_advice->text().isEmpty());
    showSelection();
}

void PairsPanel::showSelection()
{
    const QScopedValueRollback showing(m_isShowing, true);
    QTreeWidgetItem* item = m_list->topLevelItem(m_transfer.selected());
    m_list->setCurrentItem(item);
    if (item != nullptr)
        m_list->scrollToItem(item);
}

QString PairsPanel::advice() const
{
    if (m_transfer.entry() == nullptr)
        return tr("Pairs of triangles say which places of two bodies move alike.");
    const auto count = static_cast<int>(m_transfer.pairs().size());
    const TransferPreviewPointer preview = m_transfer.preview();
    if (count == 0 && preview != nullptr && !preview->posed && !preview->failure)
        return tr("Pairs are sought…");
    if (count == 0)
        return preview != nullptr
                   ? tr("Click on a place of the template, then on the same place of the body. Some pairs on "
                        "each part that turns will do: from about 15 on.")
                   : QString();
    QStringList texts;
    const double ratio = preview != nullptr ? preview->sizeRatio : 1;
    if (ratio > unlikelyRatio || ratio < 1 / unlikelyRatio)
        texts +=
            tr("The body is %1 times as tall as the template: its file may be in another unit, which the "
               "properties of its take can name.")
                .arg(QLocale().toString(ratio, 'g', 3));
    if (m_transfer.arePairsProposed())
        texts += tr("%n pair(s) were proposed. What you change makes them the project’s.", nullptr, count);
    else if (count < fewPairs)
        texts += tr("%n pair(s): from about 15 on all parts turn as they should.", nullptr, count);
    QStringList missing;
    for (const BodyRegion region : m_transfer.regionsWithout())
        missing += CurrentTransfer::regionName(region);
    if (!missing.isEmpty())
        texts += tr("Without a pair: %1. How they turn is guessed from what is beside them.")
                     .arg(missing.join(QStringLiteral(", ")));
    return texts.join(QLatin1Char(' '));
}

} // namespace quadrille

#include "moc_pairspanel.cpp"
