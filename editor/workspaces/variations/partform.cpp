// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/partform.h"

#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/partcurvetool.h"
#include "editor/workspaces/variations/partedits.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>

namespace quadrille {

namespace {

QComboBox* choice(const char* name)
{
    auto* field = new QComboBox;
    field->setObjectName(QLatin1String(name));
    field->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    field->setMinimumContentsLength(8);
    return field;
}

QLabel* fact(const char* name)
{
    auto* label = new QLabel;
    label->setObjectName(QLatin1String(name));
    label->setFont(widgets::Theme::tabularFont(label->font()));
    return label;
}

/// Shows names with one of them chosen, also one that is not there.
void showNames(QComboBox* field, const QStringList& names, const std::string& chosen)
{
    const QString current = QString::fromStdString(chosen);
    field->clear();
    field->addItems(names);
    if (!current.isEmpty() && !names.contains(current))
        field->addItem(current);
    field->setCurrentIndex(field->findText(current));
}

} // namespace

PartForm::PartForm(PartCurveTool& tool, QWidget* parent)
    : QWidget(parent)
    , m_tool(tool)
    , m_form(new QFormLayout(this))
    , m_title(new QLabel)
    , m_parent(choice("partParent"))
    , m_curves{choice("partFirstCurve"), choice("partSecondCurve")}
    , m_points(fact("curvePoints"))
    , m_length(fact("curveLength"))
{
    setObjectName(QStringLiteral("partForm"));
    QFont bold = m_title->font();
    bold.setWeight(QFont::DemiBold);
    m_title->setFont(bold);
    m_form->setContentsMargins(12, 8, 12, 4);
    m_form->setHorizontalSpacing(12);
    m_form->setVerticalSpacing(4);
    m_form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    m_form->addRow(m_title);
    for (QWidget* field :
         std::initializer_list<QWidget*>{m_parent, m_curves[0], m_curves[1], m_points, m_length}) {
        auto* label = new QLabel;
        label->setBuddy(field);
        m_form->addRow(label, field);
    }
    connect(m_parent, &QComboBox::textActivated, this, &PartForm::setParentPart);
    for (int which = 0; which < 2; ++which)
        connect(m_curves[static_cast<std::size_t>(which)], &QComboBox::textActivated, this,
                [this, which](const QString& name) { setCurve(which, name); });
    connect(&tool, &PartCurveTool::changed, this, &PartForm::refresh);
    connect(&tool, &PartCurveTool::selectionChanged, this, &PartForm::refresh);
    retranslates(this, [this] { retranslate(); });
}

void PartForm::retranslate()
{
    const auto name = [this](QWidget* field, const QString& text, const QString& tip) {
        auto* label = static_cast<QLabel*>(m_form->labelForField(field));
        label->setText(text);
        label->setToolTip(tip);
        field->setToolTip(tip);
        field->setAccessibleName(text);
    };
    name(m_parent, tr("Hangs on"), tr("The part of the body that it is joined to"));
    name(m_curves[0], tr("First curve"), tr("One of the curves that bound what it shares with its parent"));
    name(m_curves[1], tr("Second curve"), tr("The other curve that bounds what it shares with its parent"));
    name(m_points, tr("Points"), tr("That lead the curve; the vertices between them follow the surface"));
    name(m_length, tr("Length"), tr("Around the limb, over the edges of the mesh"));
    refresh();
}

void PartForm::refresh()
{
    const BodyPartsEntry& body = m_tool.body();
    const PartSelection& selected = m_tool.selected();
    const PartEntry* part =
        selected.kind == PartSelection::Kind::Part ? findPart(body, selected.name) : nullptr;
    const PartCurveEntry* curve =
        selected.kind == PartSelection::Kind::Curve ? findCurve(body, selected.name) : nullptr;
    const bool isRoot = part != nullptr && part->part.parent.empty();
    const auto show = [this](QWidget* field, bool shown) {
        field->setVisible(shown);
        m_form->labelForField(field)->setVisible(shown);
    };
    show(m_parent, part != nullptr && !isRoot);
    show(m_curves[0], part != nullptr && !isRoot);
    show(m_curves[1], part != nullptr && !isRoot);
    show(m_points, curve != nullptr);
    show(m_length, curve != nullptr);
    setVisible(part != nullptr || curve != nullptr);
    m_title->setText(isRoot ? tr("%1: all other parts hang on it").arg(QString::fromStdString(selected.name))
                            : QString::fromStdString(selected.name));
    if (part != nullptr) {
        QStringList parents;
        QStringList curves;
        for (const PartEntry& other : body.parts)
            if (other.part.name != part->part.name)
                parents += QString::fromStdString(other.part.name);
        for (const PartCurveEntry& other : body.curves)
            curves += QString::fromStdString(other.curve.name);
        showNames(m_parent, parents, part->part.parent);
        for (std::size_t which = 0; which < 2; ++which)
            showNames(m_curves[which], curves,
                      which < part->part.curves.size() ? part->part.curves[which] : std::string());
    }
    if (curve != nullptr) {
        m_points->setText(QLocale().toString(static_cast<qulonglong>(curve->points.size())));
        const double metres = m_tool.lengthOfCurve(curve->curve.name);
        m_length->setText(metres > 0 ? tr("%1 cm").arg(QLocale().toString(metres * 100, 'f', 1))
                                     : QStringLiteral("–"));
    }
}

void PartForm::setParentPart(const QString& name)
{
    m_tool.edit(tr("Hang a part on another"), QStringLiteral("parent"), [&](BodyPartsEntry& body) {
        if (PartEntry* part = findPart(body, m_tool.selected().name))
            part->part.parent = name.toStdString();
    });
}

void PartForm::setCurve(int which, const QString& name)
{
    m_tool.edit(tr("Choose a curve of a part"), QStringLiteral("curves of a part"),
                [&](BodyPartsEntry& body) {
                    PartEntry* part = findPart(body, m_tool.selected().name);
                    if (part == nullptr)
                        return;
                    part->part.curves.resize(2);
                    part->part.curves[static_cast<std::size_t>(which)] = name.toStdString();
                    std::erase(part->part.curves, std::string());
                });
}

} // namespace quadrille
