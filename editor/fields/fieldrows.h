// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/labelform.h"
#include "editor/fields/lens.h"
#include "editor/fields/settingform.h"

#include <QScopedValueRollback>
#include <functional>
#include <vector>

namespace quadrille {

/// What the history calls an edit of a field: “Set “LABEL””.
QString historyText(QString label);

/// The rows of a FieldForm, whatever their fields are: shows entries in them, and knows what is as usual.
/// \tparam Form  SettingForm, or one without a way back to the usual value: LabelForm, FieldBar.
template <typename Entry, typename Form = SettingForm>
class FieldRows
{
public:
    using Text = std::function<QString()>;
    using Change = std::function<void(Entry&)>;
    /// \param text  what the history calls the edit. \param property  object name of the field.
    using Edit = std::function<void(const QString& text, const char* property, const Change& change)>;

    struct Row
    {
        const char* name; ///< object name of the field
        Text label;
        Text tip;
        /// Whether it means anything; its row is hidden where not. Empty: always.
        std::function<bool(const Entry&)> isShown = {};
        Text history = {};         ///< what the history calls an edit; empty: as historyText() of the label
        QWidget* beside = nullptr; ///< of a LabelForm: a button behind the field
    };
    /// \param form  rows are added to it; outlives this. \param edit  is called when the user changes a
    /// field, with a change of the entry to be made undoably.
    FieldRows(Form& form, Edit edit) : m_form(form), m_edit(std::move(edit)) {}

    /// A field of its own kind. \param reset  brings the usual value back.
    void addOther(Row row, QWidget* field, std::function<void(const Entry&)> show,
                  std::function<bool(const Entry&)> isUsual, const std::function<void()>& reset)
    {
        if constexpr (hasReset)
            m_form.add(row.name, row.label, row.tip, field, reset);
        else
            m_form.addField(row.name, row.label, field, row.tip, row.beside);
        m_bindings.push_back({field, std::move(show), std::move(isUsual), std::move(row.isShown)});
    }
    /// The same of a form without a way back.
    void addOther(Row row, QWidget* field, std::function<void(const Entry&)> show)
    {
        static_assert(!hasReset);
        addOther(std::move(row), field, std::move(show), {}, {});
    }

    /// Puts the values of an entry into all fields; nothing is edited.
    void show(const Entry& entry)
    {
        const QScopedValueRollback showing(m_isShowing, true);
        for (const Binding& binding : m_bindings) {
            m_form.setRowVisible(binding.field, !binding.isShown || binding.isShown(entry));
            binding.show(entry);
            if constexpr (hasReset)
                m_form.setUsual(binding.field, binding.isUsual(entry));
        }
    }
    void setEnabled(bool enabled)
    {
        for (const Binding& binding : m_bindings)
            binding.field->setEnabled(enabled);
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

protected:
    template <typename Value>
    void change(const Row& row, const Lens<Entry, Value>& lens, const Value& value)
    {
        if (m_isShowing)
            return;
        m_edit(row.history ? row.history() : historyText(row.label()), row.name,
               [&](Entry& entry) { lens.set(entry, value); });
    }

    /// A row for a member of the entry.
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

    std::vector<std::function<void()>> m_texts; ///< of fields, in the language of now

private:
    static constexpr bool hasReset = std::is_base_of_v<SettingForm, Form>;

    struct Binding
    {
        QWidget* field;
        std::function<void(const Entry&)> show;
        std::function<bool(const Entry&)> isUsual;
        std::function<bool(const Entry&)> isShown;
    };

    Form& m_form;
    Edit m_edit;
    std::vector<Binding> m_bindings;
    bool m_isShowing = false;
};

} // namespace quadrille
