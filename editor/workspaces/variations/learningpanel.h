// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/settingform.h"

#include <QWidget>
#include <functional>
#include <vector>

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace quadrille {

class CurrentVariation;
struct PartProgress;
struct VariationEntry;

namespace widgets {
class LineChart;
} // namespace widgets

/// How far the models of all parts are learned: their objective as it falls, what came out, and the settings
/// of learning and drawing.
class LearningPanel : public QWidget
{
    Q_OBJECT

public:
    explicit LearningPanel(CurrentVariation& variation, QWidget* parent = nullptr);

private:
    /// A number of the entry.
    struct Number
    {
        const char* name; ///< object name of the field
        SettingForm::Text label;
        SettingForm::Text tip;
        std::function<double(const VariationEntry&)> get;
        std::function<void(VariationEntry&, double)> set;
        double lowest = 0;
        double highest = 1;
        double step = 1;
        int decimals = 0;
    };
    struct Binding
    {
        QWidget* field;
        std::function<void(const VariationEntry&)> show;
        std::function<bool(const VariationEntry&)> isUsual;
    };

    void arrangeWidgets();
    void addLearning();
    void addDrawing();
    void addContacts();
    void addNumber(const Number& number);
    void refreshSettings();
    void refreshParts();
    void refreshChart();
    void showPart(QTreeWidgetItem& item, const PartProgress& part);

    CurrentVariation& m_variation;
    QLabel* m_state;
    QTreeWidget* m_parts;
    widgets::LineChart* m_chart;
    SettingForm* m_form;
    std::vector<Binding> m_bindings;
    bool m_isShowing = false; ///< fields change because of the document
};

} // namespace quadrille
