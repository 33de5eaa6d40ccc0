// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/theme/outlinestyle.h"

#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QStyleFactory>
#include <QStyleOption>
#include <QTabBar>

namespace quadrille::widgets {

OutlineStyle::OutlineStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion")))
{
    connect(&Theme::instance(), &Theme::changed, this, [this] { m_outlined.clear(); });
}

QPalette OutlineStyle::outlined(const QPalette& palette) const
{
    constexpr qsizetype manyWidgets = 64;
    if (m_outlined.size() > manyWidgets)
        m_outlined.clear();
    auto found = m_outlined.find(palette.cacheKey());
    if (found == m_outlined.end()) {
        constexpr int fusionDarkens = 140; // percent
        QPalette changed = palette;
        changed.setColor(QPalette::Window, Theme::color(ColorRole::Line).lighter(fusionDarkens));
        changed.setColor(QPalette::Disabled, QPalette::Window,
                         Theme::color(ColorRole::Divider).lighter(fusionDarkens));
        found = m_outlined.insert(palette.cacheKey(), changed);
    }
    // One identity serves widgets that are enabled and others that are not.
    QPalette result = *found;
    result.setCurrentColorGroup(palette.currentColorGroup());
    return result;
}

void OutlineStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                 const QWidget* widget) const
{
    switch (element) {
    case PE_FrameLineEdit:
    case PE_IndicatorCheckBox:
    case PE_IndicatorItemViewItemCheck:
    case PE_IndicatorRadioButton: {
        // Items of views have options of another type, which Fusion would not take for a check box's.
        QStyleOptionButton changed;
        changed.state = option->state;
        changed.direction = option->direction;
        changed.rect = option->rect;
        changed.fontMetrics = option->fontMetrics;
        changed.styleObject = option->styleObject;
        changed.palette = outlined(option->palette);
        QProxyStyle::drawPrimitive(element, &changed, painter, widget);
        break;
    }
    default:
        QProxyStyle::drawPrimitive(element, option, painter, widget);
    }
}

void OutlineStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                      QPainter* painter, const QWidget* widget) const
{
    if (const auto* spin = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
        control == CC_SpinBox && spin) {
        QStyleOptionSpinBox changed = *spin;
        changed.palette = outlined(option->palette);
        QProxyStyle::drawComplexControl(control, &changed, painter, widget);
        return;
    }
    if (const auto* combo = qstyleoption_cast<const QStyleOptionComboBox*>(option);
        control == CC_ComboBox && combo) {
        QStyleOptionComboBox changed = *combo;
        changed.palette = outlined(option->palette);
        QProxyStyle::drawComplexControl(control, &changed, painter, widget);
        return;
    }
    QProxyStyle::drawComplexControl(control, option, painter, widget);
}

void OutlineStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                               const QWidget* widget) const
{
    const auto* combo = qstyleoption_cast<const QStyleOptionComboBox*>(option);
    if (element != CE_ComboBoxLabel || combo == nullptr) {
        QProxyStyle::drawControl(element, option, painter, widget);
        return;
    }
    constexpr int textMargin = 2; // at both ends together, as Fusion leaves it
    QStyleOptionComboBox changed = *combo;
    const QRect field = subControlRect(CC_ComboBox, combo, SC_ComboBoxEditField, widget);
    const int icon = combo->currentIcon.isNull() ? 0 : combo->iconSize.width() + 4;
    changed.currentText =
        combo->fontMetrics.elidedText(combo->currentText, Qt::ElideRight, field.width() - icon - textMargin);
    QProxyStyle::drawControl(element, &changed, painter, widget);
}

int OutlineStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const
{
    constexpr int narrowSpace = 10; // around the words of a tab; Fusion leaves 24
    constexpr int moreWidth =
        24; // of the button for tools without room; with Fusion's 12 its sign is cut off
    if (metric == PM_TabBarTabHSpace && qobject_cast<const QTabBar*>(widget) != nullptr)
        return narrowSpace;
    return metric == PM_ToolBarExtensionExtent ? moreWidth : QProxyStyle::pixelMetric(metric, option, widget);
}

QIcon OutlineStyle::standardIcon(StandardPixmap icon, const QStyleOption* option, const QWidget* widget) const
{
    return icon == SP_ToolBarHorizontalExtensionButton ? icons::icon(QStringLiteral("more"))
                                                       : QProxyStyle::standardIcon(icon, option, widget);
}

int OutlineStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                            QStyleHintReturn* result) const
{
    return hint == SH_DialogButtonBox_ButtonsHaveIcons ? 0
                                                       : QProxyStyle::styleHint(hint, option, widget, result);
}

} // namespace quadrille::widgets

#include "moc_outlinestyle.cpp"
