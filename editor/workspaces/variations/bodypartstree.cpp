// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/bodypartstree.h"

#include "editor/errors/errortext.h"
#include "editor/fields/ownkeys.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/partedits.h"
#include "widgets/theme/icons.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <map>

namespace quadrille {

using widgets::ColorRole;
using widgets::Theme;

namespace {

enum PartsColumn
{
    NameColumn,
    VerticesColumn,
    StateColumn
};

constexpr int kindRole = Qt::UserRole;
constexpr int nameRole = Qt::UserRole + 1;

QIcon swatch(const QColor& color, double pixelRatio)
{
    constexpr int side = 16;
    QPixmap picture(QSize(side, side) * pixelRatio);
    picture.setDevicePixelRatio(pixelRatio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(Theme::color(ColorRole::Line), 1.0));
    painter.setBrush(color);
    painter.drawRoundedRect(QRectF(2.5, 2.5, side - 5, side - 5), 2.0, 2.0);
    return QIcon(picture);
}

PartSelection whatIs(const QTreeWidgetItem* item)
{
    if (item == nullptr)
        return {};
    return {static_cast<PartSelection::Kind>(item->data(NameColumn, kindRole).toInt()),
            item->data(NameColumn, nameRole).toString().toStdString()};
}

QString whatIsWrong(const PartProblem* problem)
{
    if (problem == nullptr)
        return {};
    const ErrorText text = describe(problem->error);
    return text.remedy.isEmpty() ? text.sentence : text.sentence + QLatin1Char(' ') + text.remedy;
}

} // namespace

BodyPartsTree::BodyPartsTree(PartCurveTool& tool, QWidget* parent) : QTreeWidget(parent), m_tool(tool)
{
    setObjectName(QStringLiteral("bodyPartsTree"));
    setColumnCount(3);
    setUniformRowHeights(true);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    setAllColumnsShowFocus(true);
    setFrameShape(QFrame::NoFrame);
    setFont(Theme::tabularFont(font()));
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
    header()->setSectionResizeMode(VerticesColumn, QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(StateColumn, QHeaderView::ResizeToContents);
    header()->setMinimumSectionSize(28);
    connect(&tool, &PartCurveTool::changed, this, &BodyPartsTree::fill);
    connect(&tool, &PartCurveTool::selectionChanged, this, &BodyPartsTree::showSelection);
    connect(this, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (!m_isFilling)
            m_tool.select(whatIs(item));
    });
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
        if (!m_isFilling)
            rename(item);
    });
    retranslates(this, [this] { retranslate(); });
}

PartSelection BodyPartsTree::current() const
{
    return whatIs(currentItem());
}

void BodyPartsTree::retranslate()
{
    setAccessibleName(tr("Parts and curves"));
    setToolTip(tr("Parts of the body, each with the two curves that bound what it shares with its parent"));
    setHeaderLabels({tr("Part"), tr("Vertices"), QString()});
    headerItem()->setToolTip(StateColumn, tr("Whether something is wrong"));
    fill();
}

void BodyPartsTree::setUp(QTreeWidgetItem* item, const PartSelection& what, const QIcon& icon,
                          std::size_t vertices, const QString& why) const
{
    const QString name = QString::fromStdString(what.name);
    item->setData(NameColumn, kindRole, static_cast<int>(what.kind));
    item->setData(NameColumn, nameRole, name);
    item->setText(NameColumn, name);
    item->setIcon(NameColumn, icon);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    item->setText(VerticesColumn,
                  vertices > 0 ? QLocale().toString(static_cast<qulonglong>(vertices)) : QStringLiteral("–"));
    item->setTextAlignment(VerticesColumn, Qt::AlignRight | Qt::AlignVCenter);
    if (why.isEmpty())
        return;
    item->setIcon(StateColumn, widgets::icons::icon(QStringLiteral("error"), ColorRole::ErrorText));
    item->setForeground(NameColumn, Theme::color(ColorRole::ErrorText));
    for (const int column : {NameColumn, VerticesColumn, StateColumn})
        item->setToolTip(column, why);
    item->setData(NameColumn, Qt::AccessibleDescriptionRole, why);
}

void BodyPartsTree::addCurve(QTreeWidgetItem* under, const std::string& name)
{
    const PartCurveEntry* entry = findCurve(m_tool.body(), name);
    if (entry == nullptr)
        return;
    auto* item = under != nullptr ? new QTreeWidgetItem(under) : new QTreeWidgetItem(this);
    setUp(item, {PartSelection::Kind::Curve, name},
          widgets::icons::icon(QStringLiteral("drawcurve"), ColorRole::TextMuted),
          entry->curve.vertices.size(), whatIsWrong(m_tool.cut().problemOfCurve(name)));
}

void BodyPartsTree::fill()
{
    if (state() == QAbstractItemView::EditingState)
        return; // the name that is typed would be lost
    m_isFilling = true;
    clear();
    std::map<std::string, QTreeWidgetItem*> items;
    const auto add = [&](const PartDescription& part, QTreeWidgetItem* under) {
        auto* item = under != nullptr ? new QTreeWidgetItem(under) : new QTreeWidgetItem(this);
        const BodyPart* cut = m_tool.cut().part(part.name);
        setUp(item, {PartSelection::Kind::Part, part.name},
              swatch(partColor(m_tool.body(), part.name), devicePixelRatioF()),
              cut != nullptr ? cut->vertices.size() : 0, whatIsWrong(m_tool.cut().problemOfPart(part.name)));
        items[part.name] = item;
        for (const std::string& curve : part.curves)
            addCurve(item, curve);
    };
    // Parents first; what hangs on nothing that is there stands at the top.
    std::vector<PartDescription> left = partsOf(m_tool.body());
    for (bool isAdding = true; isAdding && !left.empty();) {
        isAdding = false;
        for (auto part = left.begin(); part != left.end();) {
            const auto parent = items.find(part->parent);
            if (!part->parent.empty() && parent == items.end()) {
                ++part;
                continue;
            }
            add(*part, part->parent.empty() ? nullptr : parent->second);
            part = left.erase(part);
            isAdding = true;
        }
    }
    for (const PartDescription& part : left)
        add(part, nullptr);
    for (const std::string& curve : m_tool.looseCurves())
        addCurve(nullptr, curve);
    expandAll();
    m_isFilling = false;
    showSelection();
}

void BodyPartsTree::showSelection()
{
    m_isFilling = true;
    QTreeWidgetItem* selected = nullptr;
    for (QTreeWidgetItemIterator item(this); *item != nullptr; ++item)
        if (whatIs(*item) == m_tool.selected())
            selected = *item;
    setCurrentItem(selected);
    m_isFilling = false;
}

void BodyPartsTree::rename(QTreeWidgetItem* item)
{
    const PartSelection what = whatIs(item);
    const QString wanted = item->text(NameColumn);
    // The tree is filled anew meanwhile, which the view that told of the change must not see.
    QMetaObject::invokeMethod(
        this,
        [this, what, wanted] {
            m_tool.rename(what, wanted);
            fill();
        },
        Qt::QueuedConnection);
}

bool BodyPartsTree::event(QEvent* event)
{
    return takesOwnKeys(*event, {Qt::Key_Delete, Qt::Key_F2}) || QTreeWidget::event(event);
}

void BodyPartsTree::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Delete && currentItem() != nullptr)
        m_tool.removeSelected();
    else
        QTreeWidget::keyPressEvent(event);
}

} // namespace quadrille

#include "moc_bodypartstree.cpp"
