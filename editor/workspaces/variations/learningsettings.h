// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/settingform.h"

#include <QScrollArea>
#include <functional>
#include <vector>

namespace quadrille {

class CurrentVariation;
struct VariationEntry;

/// How models are learned, how variations are drawn of them, and which of these are too bad to be kept.
class LearningSettings : public QScrollArea
{
    Q_OBJECT

public:
    explicit LearningSettings(CurrentVariation& variation, QWidget* parent = nullptr);

private:
    using Get = std::function<double(const VariationEntry&)>;
    using Set = std::function<void(VariationEntry&, double)>;
    /// A number of the entry.
    struct Number
    {
        const char* name; ///< object name of the field
        SettingForm::Text label;
        SettingForm::Text tip;
        Get get;
        Set set;
        double lowest = 0;
        double highest = 1;
        double step = 1;
        int decimals = 0;
        SettingForm::Text unit = {};     ///< behind the number; none where it is a count
        SettingForm::Text lowestIs = {}; ///< shown in place of the lowest number
    };
    /// One of two.
    struct Choice
    {
        const char* name; ///< object name of the field
        SettingForm::Text label;
        SettingForm::Text tip;
        std::function<QString()> undoText;
        std::function<QString()> first;
        std::function<QString()> second;
        std::function<int(const VariationEntry&)> read; ///< 0 or 1
        std::function<void(VariationEntry&, int)> write;
    };
    struct Binding
    {
        QWidget* field;
        std::function<void(const VariationEntry&)> show;
        std::function<bool(const VariationEntry&)> isUsual;
    };

    void addLearning();
    void addStop();
    void addDrawing();
    void addChain();
    void addLimits();
    void addNumber(const Number& number);
    void addChoice(const Choice& choice);
    void addPoses();
    void addContacts();
    void refresh();

    CurrentVariation& m_variation;
    SettingForm* m_form;
    std::vector<Binding> m_bindings;
    bool m_isShowing = false; ///< fields change because of the document
};

} // namespace quadrille
