// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldrows.h"
#include "editor/fields/numberfield.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QIcon>
#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace quadrille {

/// As narrow as it may be, however long its texts are. The caller owns it.
QComboBox* makeChoiceField();

/// One of the texts that a field offers.
template <typename Value>
struct FieldItem
{
    QString text;
    Value value;
    QIcon icon = {};
};

/// Binds the rows of a form to the members of an entry: shows them, edits them, and knows which are as usual.
/// A member is given as a pointer to it, at(), or a Lens. The form owns the fields.
/// \tparam Form  see FieldRows.
template <typename Entry, typename Form = SettingForm>
class FieldForm : public FieldRows<Entry, Form>
{
    using Rows = FieldRows<Entry, Form>;

public:
    using Rows::Rows;
    using typename Rows::Row;
    using typename Rows::Text;

    /// A number. Of an optional one, what is below the lowest stands for none; then `look.automatic` must
    /// have a text.
    template <typename Member>
    QDoubleSpinBox* addNumber(Row row, Member member, const NumberLook& look)
    {
        const auto lens = lensOf<Entry>(member);
        using Value = decltype(lens.get(Entry()));
        QDoubleSpinBox* field = makeNumberField(look);
        QObject::connect(field, &QDoubleSpinBox::valueChanged, field, [=, this](double shown) {
            Rows::change(row, lens,
                         isEmptyNumber(look, shown) ? Value{} : toValue<Value>(inFile(look, shown)));
        });
        Rows::add(row, field, lens, [=](const Entry& entry) {
            showInUnit(*field, look);
            const std::optional<double> value = toNumber(lens.get(entry));
            showNumber(*field, value ? *value / look.scale : emptyNumber(look));
        });
        Rows::m_texts.emplace_back([field, look] {
            if (look.unit)
                field->setSuffix(look.unit());
            if (look.automatic)
                field->setSpecialValueText(look.automatic());
        });
        return field;
    }

    template <typename Member>
    QCheckBox* addSwitch(Row row, Member member)
    {
        const auto lens = lensOf<Entry>(member);
        auto* field = new QCheckBox;
        QObject::connect(field, &QCheckBox::toggled, field,
                         [=, this](bool on) { Rows::change(row, lens, on); });
        Rows::m_texts.emplace_back([field, text = row.label] { field->setText(text()); });
        Rows::add(
            row, field, lens, [=](const Entry& entry) { field->setChecked(lens.get(entry)); }, true);
        return field;
    }

    /// \param choices  in the order of their values.
    template <typename Member>
    QComboBox* addChoice(Row row, Member member, std::vector<Text> choices)
    {
        const auto lens = lensOf<Entry>(member);
        using Value = decltype(lens.get(Entry()));
        QComboBox* field = makeChoiceField();
        for (const Text& choice : choices)
            field->addItem(choice());
        QObject::connect(field, &QComboBox::currentIndexChanged, field,
                         [=, this](int index) { Rows::change(row, lens, static_cast<Value>(index)); });
        Rows::add(row, field, lens,
                  [=](const Entry& entry) { field->setCurrentIndex(static_cast<int>(lens.get(entry))); });
        Rows::m_texts.emplace_back([field, choices = std::move(choices)] {
            for (std::size_t i = 0; i < choices.size(); ++i)
                field->setItemText(static_cast<int>(i), choices[i]());
        });
        return field;
    }

    /// One of some texts, each of which stands for a value; what there is depends on the entry. Where its own
    /// value is not among them, none is chosen.
    template <typename Member, typename Items>
    QComboBox* addItems(Row row, Member member, Items items)
    {
        const auto lens = lensOf<Entry>(member);
        using Value = decltype(lens.get(Entry()));
        QComboBox* field = makeChoiceField();
        field->setMinimumContentsLength(6);
        auto values = std::make_shared<std::vector<Value>>();
        QObject::connect(field, &QComboBox::currentIndexChanged, field, [=, this](int index) {
            if (!Rows::isShowing() && index >= 0)
                Rows::change(row, lens, Value((*values)[static_cast<std::size_t>(index)]));
        });
        Rows::add(row, field, lens, [=](const Entry& entry) {
            field->clear();
            values->clear();
            for (const FieldItem<Value>& item : items(entry)) {
                field->addItem(item.icon, item.text);
                values->push_back(item.value);
            }
            const auto own = std::ranges::find(*values, lens.get(entry));
            field->setCurrentIndex(own == values->end() ? -1 : static_cast<int>(own - values->begin()));
        });
        return field;
    }
};

} // namespace quadrille
