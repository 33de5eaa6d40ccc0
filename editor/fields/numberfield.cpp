// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/numberfield.h"

#include "model/project/document/groundpoint.h"
#include "model/project/document/lengthunit.h"
#include "widgets/viewport/ruler.h"

#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

constexpr auto usualMaximum = "usualMaximum"; // of a field, when it shows no number beyond

NumberFacts factsFor(const NumberLook& look)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return look.path == nullptr ? NumberFacts{-infinity, false, infinity, {}} : factsOf(look.path);
}

double lowestOf(const NumberLook& look)
{
    const NumberFacts facts = factsFor(look);
    const double step = facts.isAboveLeast ? std::pow(10.0, -look.decimals) : 0;
    return std::max(look.lowest, facts.least / look.scale + step);
}

class NumberField : public QDoubleSpinBox
{
public:
    explicit NumberField(const NumberLook& look)
        : m_trimsZeros(look.trimsZeros)
        , m_first(look.first != 0 ? look.first : factsFor(look).usual.value_or(0) / look.scale)
    {
    }

    QString textFromValue(double value) const override
    {
        return m_trimsZeros ? locale().toString(value, 'g', 9) : QDoubleSpinBox::textFromValue(value);
    }

    void stepBy(int steps) override
    {
        const bool isEmpty = !specialValueText().isEmpty() && value() == minimum();
        if (isEmpty && steps > 0 && m_first > minimum())
            setValue(m_first);
        else
            QDoubleSpinBox::stepBy(steps);
    }

private:
    bool m_trimsZeros;
    double m_first; ///< where steps up lead from an empty value; 0: one step further
};

} // namespace

double emptyNumber(const NumberLook& look)
{
    const double lowest = lowestOf(look);
    return lowest > 0 ? 0 : lowest - look.step;
}

bool isEmptyNumber(const NumberLook& look, double shown)
{
    return look.automatic && shown < lowestOf(look) - std::pow(10.0, -look.decimals) / 2;
}

QDoubleSpinBox* makeNumberField(const NumberLook& look)
{
    constexpr double widest = 1e7; // what there is room for without asking for it
    const double facts = factsFor(look).greatest / look.scale;
    const double greatest = std::isfinite(facts) ? facts : look.highest;
    const double lowest = look.automatic ? emptyNumber(look) : lowestOf(look);
    auto* field = new NumberField(look);
    field->setDecimals(look.decimals);
    if (greatest > widest) {
        // A seed may be long; a panel is not made wider for it.
        field->setRange(lowest, widest);
        field->setMinimumWidth(field->minimumSizeHint().width());
    }
    field->setRange(lowest, greatest);
    field->setSingleStep(look.step);
    field->setKeyboardTracking(false);
    field->setGroupSeparatorShown(true);
    field->setAlignment(Qt::AlignRight);
    field->setFocusPolicy(Qt::StrongFocus);
    return field;
}

NumberLook rateLook(const char* path, SettingForm::Text automatic)
{
    return {.path = path,
            .step = 1,
            .decimals = 6,
            .unit = [] { return QCoreApplication::translate("quadrille::FieldForm", " fps"); },
            .automatic = std::move(automatic),
            .trimsZeros = true};
}

void showInUnit(QDoubleSpinBox& field, const NumberLook& look)
{
    if (!look.metresPerUnit)
        return;
    const widgets::Ruler ruler(look.metresPerUnit());
    const double lowest = lowestOf(look);
    const double farthest = farthestPlace(ruler.metresPerUnit());
    const QSignalBlocker quiet(field);
    field.setDecimals(ruler.decimals(look.decimals));
    field.setRange(lowest < 0 ? -farthest : lowest / ruler.decade(), farthest);
    field.setSingleStep(look.step / ruler.decade());
    field.setSuffix(QLatin1Char(' ') + QString::fromStdString(unitText(ruler.metresPerUnit())));
    field.setProperty(usualMaximum, farthest);
}

double inFile(const NumberLook& look, double shown)
{
    return shown / (1 / look.scale);
}

void showNumber(QDoubleSpinBox& field, double shown)
{
    if (!field.property(usualMaximum).isValid())
        field.setProperty(usualMaximum, field.maximum());
    field.setMaximum(std::max(shown, field.property(usualMaximum).toDouble()));
    field.setValue(shown);
}

} // namespace quadrille
