// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/partform.h"

#include "editor/workspaces/variations/partcurvetool.h"
#include "editor/workspaces/variations/partedits.h"
#include "widgets/theme/theme.h"

#include <QLocale>
#include <algorithm>

namespace quadrille {

namespace {

using NameItems = std::vector<FieldItem<std::string>>;

void addName(NameItems& items, const std::string& name)
{
    items.push_back({QString::fromStdString(name), name});
}

/// Adds a name that is chosen, also one of something that is not there.
void addChosen(NameItems& items, const std::string& name)
{
    if (!name.empty() && std::ranges::find(items, name, &FieldItem<std::string>::value) == items.end())
        addName(items, name);
}

/// One of the two curves that bound what a part shares with its parent; empty where there is none.
Lens<PartEntry, std::string> curveOf(std::size_t which)
{
    return {[which](const PartEntry& entry) {
                const std::vector<std::string>& curves = entry.part.curves;
                return which < curves.size() ? curves[which] : std::string();
            },
            [which](PartEntry& entry, std::string name) {
                entry.part.curves.resize(2);
                entry.part.curves[which] = std::move(name);
                std::erase(entry.part.curves, std::string());
            }};
}

bool hangsOnAnother(const PartEntry& entry)
{
    return !entry.part.parent.empty();
}

} // namespace

PartForm::PartForm(PartCurveTool& tool, QWidget* parent)
    : LabelForm(parent)
    , m_tool(tool)
    , m_title(new QLabel)
    , m_fields(*this,
               [this](const QString& text, const char* property, const auto& change) {
                   m_tool.edit(text, QLatin1String(property), [&](BodyPartsEntry& body) {
                       if (PartEntry* part = findPart(body, m_tool.selected().name))
                           change(*part);
                   });
               })
    , m_points(new QLabel)
    , m_length(new QLabel)
{
    setObjectName(QStringLiteral("partForm"));
    QFont bold = m_title->font();
    bold.setWeight(QFont::DemiBold);
    m_title->setFont(bold);
    addWide("partTitle", m_title);
    addParent();
    addCurve(0, {.name = "partFirstCurve",
                 .label = [] { return tr("First curve"); },
                 .tip = [] { return tr("One of the curves that bound what it shares with its parent"); }});
    addCurve(1, {.name = "partSecondCurve",
                 .label = [] { return tr("Second curve"); },
                 .tip = [] { return tr("The other curve that bounds what it shares with its parent"); }});
    addField(
        "curvePoints", [] { return tr("Points"); }, m_points,
        [] { return tr("That lead the curve; the vertices between them follow the surface"); });
    addField(
        "curveLength", [] { return tr("Length"); }, m_length,
        [] { return tr("Around the limb, over the edges of the mesh"); });
    for (QLabel* fact : {m_points, m_length})
        fact->setFont(widgets::Theme::tabularFont(fact->font()));
    connect(&tool, &PartCurveTool::changed, this, &PartForm::refresh);
    connect(&tool, &PartCurveTool::selectionChanged, this, &PartForm::refresh);
    refresh();
}

void PartForm::addParent()
{
    m_fields.addItems({.name = "partParent",
                       .label = [] { return tr("Hangs on"); },
                       .tip = [] { return tr("The part of the body that it is joined to"); },
                       .isShown = hangsOnAnother,
                       .history = [] { return tr("Hang a part on another"); }},
                      at(&PartEntry::part, &PartDescription::parent), [this](const PartEntry& entry) {
                          NameItems items;
                          for (const PartEntry& other : m_tool.body().parts) {
                              if (other.part.name != entry.part.name)
                                  addName(items, other.part.name);
                          }
                          addChosen(items, entry.part.parent);
                          return items;
                      });
}

void PartForm::addCurve(std::size_t which, FieldRows<PartEntry, LabelForm>::Row row)
{
    row.isShown = hangsOnAnother;
    row.history = [] { return tr("Choose a curve of a part"); };
    const Lens<PartEntry, std::string> lens = curveOf(which);
    m_fields.addItems(std::move(row), lens, [this, lens](const PartEntry& entry) {
        NameItems items;
        for (const PartCurveEntry& other : m_tool.body().curves)
            addName(items, other.curve.name);
        addChosen(items, lens.get(entry));
        return items;
    });
}

void PartForm::retranslate()
{
    m_fields.retranslate();
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
    const QString name = QString::fromStdString(selected.name);
    m_title->setText(
        part != nullptr && !hangsOnAnother(*part) ? tr("%1: all other parts hang on it").arg(name) : name);
    m_fields.show(part != nullptr ? *part : PartEntry());
    showCurve(curve);
    setVisible(part != nullptr || curve != nullptr);
}

void PartForm::showCurve(const PartCurveEntry* curve)
{
    setRowVisible(m_points, curve != nullptr);
    setRowVisible(m_length, curve != nullptr);
    if (curve == nullptr)
        return;
    m_points->setText(QLocale().toString(static_cast<qulonglong>(curve->points.size())));
    const double metres = m_tool.lengthOfCurve(curve->curve.name);
    m_length->setText(metres > 0 ? tr("%1 cm").arg(QLocale().toString(metres * 100, 'f', 1))
                                 : QStringLiteral("–"));
}

} // namespace quadrille

#include "moc_partform.cpp"
