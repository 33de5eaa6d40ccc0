// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldform.h"
#include "editor/properties/entrypage.h"

#include <functional>

class QComboBox;
class QToolButton;

namespace quadrille {

class PartList;
class RangeField;
class SpaceMap;

/// A motion space: its takes, what steers it, and how well its blends come out once it is computed. The take
/// and the parameter that are current in their lists have their fields below them.
class MotionSpacePage : public EntryPage
{
    Q_OBJECT

public:
    explicit MotionSpacePage(EditorContext& context);

    void show(const QString& name) override;
    using QWidget::show;

private:
    using Change = std::function<void(MotionSpaceEntry&)>;

    QString character() const override;
    void setCharacter(const QString& character) override;
    void retranslate() override;

    void addTakes();
    void addParameters();
    void addSettings();
    const MotionSpaceEntry& entry() const;
    void edit(const QString& text, const char* property, const Change& change);
    /// The current take's number; nothing where there is none.
    std::optional<std::size_t> take() const;
    std::optional<std::size_t> parameter() const;
    void addTake(const QString& sequence);
    void removeTake(std::size_t index);
    void removeParameter(std::size_t index);
    void showLists();
    void showCurrent();
    void showState();
    QString takeText(std::size_t index) const;
    QString parameterText(std::size_t index) const;

    QLabel* m_state = nullptr;
    SpaceMap* m_map;
    PartList* m_takes;
    QComboBox* m_newTake;
    QToolButton* m_removeTake;
    SettingForm* m_takeForm;
    FieldForm<SpaceTakeEntry> m_takeFields;
    RangeField* m_range;
    PartList* m_parameters;
    QToolButton* m_addParameter;
    QToolButton* m_removeParameter;
    SettingForm* m_parameterForm;
    FieldForm<SpaceParameterEntry> m_parameterFields;
    SettingForm* m_form;
    FieldForm<MotionSpaceEntry> m_fields;
};

} // namespace quadrille
