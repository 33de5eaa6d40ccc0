// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/lens.h"
#include "editor/fields/numberfield.h"
#include "editor/fields/settingform.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QScopedValueRollback>
#include <functional>
#include <optional>
#include <vector>

namespace quadrille {

/// Binds the rows of a form to the members of an entry: shows them, edits them, and knows which are as usual.
template <typename Entry>
class FieldForm
{
public:
    using Text = SettingForm::Text;
    using Change = std::function<void(Entry&)>;
    /// \param what  the label of the field. \param property  its object name.
    using Edit = std::function<void(const QString& what, const char* property, const Change& change)>;

    struct Row
    {
        const char* name; ///< object name of the field
        Text label;
        Text tip;
        /// Whether it means anything; its row is hidden where not. Empty: always.
        std::function<bool(const Entry&)> isShown = {};
    };

    /// \param form  rows are added to it; outlives this. \param edit  is called when the user changes a
    /// field, with a change of the entry to be made undoably.
    FieldForm(SettingForm& form, Edit edit) : m_form(form), m_edit(std::move(edit)) {}

    /// A row for a number. Of an optional one, what is below the lowest stands for none; then
    /// `look.automatic` must have a text. The form owns the field; so for those that follow.
    template <typename Value>
    QDoubleSpinBox* addNumber(Row row, Lens<Entry, Value> lens, const NumberLook& look)
    {
        QDoubleSpinBox* field = makeNumberField(look);
        const double empty = emptyNumber(look);
        QObject::connect(field, &QDoubleSpinBox::valueChanged, field, [=, this](double shown) {
            change(row, lens, isEmptyNumber(look, shown) ? Value{} : toValue<Value>(inFile(look, shown)));
        });
        add(row, field, lens, [=](const Entry& entry) {
            const std::optional<double> value = toNumber(lens.get(entry));
            showNumber(*field, value ? *value / look.scale : empty);
        });
        m_texts.emplace_back([field, look] {
            if (look.unit)
                field->setSuffix(look.unit());
            if (look.automatic)
                field->setSpecialValueText(look.automatic());
        });
        return field;
    }

    QCheckBox* addSwitch(Row row, Lens<Entry, bool> lens)
    {
        auto* field = new QCheckBox;
        QObject::connect(field, &QCheckBox::toggled, field, [=, this](bool on) { change(row, lens, on); });
        m_texts.emplace_back([field, text = row.label] { field->setText(text()); });
        add(
            row, field, lens, [=](const Entry& entry) { field->setChecked(lens.get(entry)); }, true);
        return field;
    }

    /// \param choices  in the order of their values.
    template <typename Value>
    QComboBox* addChoice(Row row, Lens<Entry, Value> lens, std::vector<Text> choices)
    {
        auto* field = new QComboBox;
        field->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        field->setFocusPolicy(Qt::StrongFocus);
        for (const Text& choice : choices)
            field->addItem(choice());
        QObject::connect(field, &QComboBox::currentIndexChanged, field,
                         [=, this](int index) { change(row, lens, static_cast<Value>(index)); });
        add(row, field, lens,
            [=](const Entry& entry) { field->setCurrentIndex(static_cast<int>(lens.get(entry))); });
        m_texts.emplace_back([field, choices = std::move(choices)] {
            for (std::size_t i = 0; i < choices.size(); ++i)
                field->setItemText(static_cast<int>(i), choices[i]());
        });
        return field;
    }

    template <typename Member>
    QDoubleSpinBox* addNumber(Row row, Member member, const NumberLook& look)
    {
        return addNumber(std::move(row), lensOf<Entry>(member), look);
    }
    template <typename Member>
    QCheckBox* addSwitch(Row row, Member member)
    {
        return addSwitch(std::move(row), lensOf<Entry>(member));
    }
    template <typename Member>
    QComboBox* addChoice(Row row, Member member, std::vector<Text> choices)
    {
        return addChoice(std::move(row), lensOf<Entry>(member), std::move(choices));
    }

    /// A field of its own kind. \param reset  brings the usual value back.
    void addOther(Row row, QWidget* field, std::function<void(const Entry&)> show,
                  std::function<bool(const Entry&)> isUsual, const std::function<void()>& reset)
    {
        m_form.add(row.name, row.label, row.tip, field, reset);
        m_bindings.push_back({field, std::move(show), std::move(isUsual), std::move(row.isShown)});
    }

    /// Puts the values of an entry into all fields; nothing is edited.
    void show(const Entry& entry)
    {
        const QScopedValueRollback showing(m_isShowing, true);
        for (const Binding& binding : m_bindings) {
            m_form.setRowVisible(binding.field, !binding.isShown || binding.isShown(entry));
            binding.show(entry);
            m_form.setUsual(binding.field, binding.isUsual(entry));
        }
    }
    /// Whether fields change because of show(); nothing is edited then.
    bool isShowing() const { return m_isShowing; }

    /// For retranslates(): texts inside of fields; those of rows follow by themselves.
    void retranslate()
    {
        const QScopedValueRollback showing(m_isShowing, true);
        for (const auto& set : m_texts)
            set();
    }

private:
    struct Binding
    {
        QWidget* field;
        std::function<void(const Entry&)> show;
        std::function<bool(const Entry&)> isUsual;
        std::function<bool(const Entry&)> isShown;
    };

    template <typename Value>
    static std::optional<double> toNumber(const Value& value)
    {
        if constexpr (!IsOptional<Value>::value)
            return static_cast<double>(bare(value));
        else
            return value ? std::optional(static_cast<double>(bare(*value))) : std::nullopt;
    }
    template <typename Value>
    static Value toValue(double number)
    {
        using Number = typename Plain<Value>::Type;
        return Number{static_cast<decltype(bare(Number()))>(number)};
    }

    template <typename Value>
    void change(const Row& row, const Lens<Entry, Value>& lens, const Value& value)
    {
        if (m_isShowing)
            return;
        QString what = row.label();
        m_edit(what.remove(QLatin1Char('&')), row.name, [&](Entry& entry) { lens.set(entry, value); });
    }

    /// \param saysItself  the field has its label, as a check box does.
    template <typename Value>
    void add(const Row& row, QWidget* field, const Lens<Entry, Value>& lens,
             std::function<void(const Entry&)> show, bool saysItself = false)
    {
        Row shown = row;
        if (saysItself)
            shown.label = {};
        addOther(
            std::move(shown), field, std::move(show),
            [lens](const Entry& entry) { return lens.get(entry) == lens.get(Entry()); },
            [this, row, lens] { change(row, lens, lens.get(Entry())); });
    }

    SettingForm& m_form;
    Edit m_edit;
    std::vector<Binding> m_bindings;
    std::vector<std::function<void()>> m_texts; ///< of fields, in the language of now
    bool m_isShowing = false;
};

} // namespace quadrille
