// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/axesfields.h"

#include "editor/language/retranslate.h"
#include "model/project/document/lengthunit.h"

#include <QComboBox>
#include <QVBoxLayout>
#include <array>

namespace quadrille {

namespace {

/// Axes and unit as other programs expect them.
struct Preset
{
    const char* program; ///< a proper name
    CoordinateSystem axes;
};
constexpr std::array presets{
    Preset{"Blender", {UpAxis::Z, 1}},
    Preset{"Maya", {UpAxis::Y, 0.01}},
    Preset{"Unity", {UpAxis::Y, 1}},
    Preset{"Unreal Engine", {UpAxis::Z, 0.01}},
};

} // namespace

QString groundAxisName(UpAxis up, int which)
{
    const int axis = which < static_cast<int>(up) ? which : which + 1;
    return QString(QLatin1Char(static_cast<char>('x' + axis)));
}

AxesFields::AxesFields(bool offersPrograms, QWidget* parent)
    : QWidget(parent), m_up(new QComboBox), m_unit(new QComboBox)
{
    m_up->setObjectName(QStringLiteral("upAxis"));
    m_unit->setObjectName(QStringLiteral("unit"));
    m_up->addItems({QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")});
    for (const LengthUnit& unit : lengthUnits())
        m_unit->addItem(QString::fromUtf8(unit.name.data(), static_cast<qsizetype>(unit.name.size())),
                        unit.metres);
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    row->addWidget(m_up, 1);
    row->addWidget(m_unit, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    if (offersPrograms) {
        m_programs = new QComboBox;
        m_programs->setObjectName(QStringLiteral("axesOfProgram"));
        m_programs->addItem(QString());
        for (const Preset& preset : presets)
            m_programs->addItem(QLatin1String(preset.program));
        m_programs->addItem(QString());
        column->addWidget(m_programs);
        connect(m_programs, &QComboBox::activated, this, &AxesFields::choosePreset);
    }
    column->addLayout(row);
    setFocusProxy(m_programs != nullptr ? m_programs : m_up);
    for (QComboBox* box : {m_up, m_unit}) {
        connect(box, &QComboBox::activated, this, [this] {
            showPreset();
            emit edited();
        });
    }
    setAxes({});
    retranslates(this, [this] { retranslate(); });
}

CoordinateSystem AxesFields::axes() const
{
    return {static_cast<UpAxis>(m_up->currentIndex()), m_unit->currentData().toDouble()};
}

void AxesFields::setAxes(const CoordinateSystem& axes)
{
    m_up->setCurrentIndex(static_cast<int>(axes.up));
    if (m_unit->findData(axes.metresPerUnit) < 0) // a unit without a name, from a project written by hand
        m_unit->addItem(tr("%1 m").arg(axes.metresPerUnit), axes.metresPerUnit);
    m_unit->setCurrentIndex(m_unit->findData(axes.metresPerUnit));
    showPreset();
}

void AxesFields::setProjectAxes(const CoordinateSystem& axes)
{
    m_projectAxes = axes;
    showPreset();
}

void AxesFields::choosePreset()
{
    const int index = m_programs->currentIndex() - 1;
    if (index < static_cast<int>(presets.size())) // the last one stands for what is set already
        setAxes(index < 0 ? m_projectAxes : presets.at(static_cast<std::size_t>(index)).axes);
    emit edited();
}

void AxesFields::showPreset()
{
    if (m_programs == nullptr)
        return;
    int index = axes() == m_projectAxes ? 0 : m_programs->count() - 1;
    for (std::size_t p = 0; index != 0 && p < presets.size(); ++p) {
        if (presets.at(p).axes == axes())
            index = static_cast<int>(p) + 1;
    }
    m_programs->setCurrentIndex(index);
}

void AxesFields::retranslate()
{
    m_up->setAccessibleName(tr("Up axis"));
    m_up->setToolTip(tr("The axis that points up"));
    m_unit->setAccessibleName(tr("Unit"));
    m_unit->setToolTip(tr("The length of one unit"));
    if (m_programs == nullptr)
        return;
    m_programs->setAccessibleName(tr("Axes"));
    m_programs->setItemText(0, tr("As the project"));
    m_programs->setItemText(m_programs->count() - 1, tr("Others"));
}

} // namespace quadrille

#include "moc_axesfields.cpp"
