// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/fields/settingform.h"

#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QScrollArea;

namespace quadrille {

class CurrentAnimation;

namespace widgets {
class CurveEditor;
class ElidedButton;
} // namespace widgets

/// How an animation is sought, blended and finished: loop, repeats, times, mirroring, contacts. Every value
/// is an undoable setting of the animation, and what follows from it shows at once.
class PostPanel : public QWidget
{
    Q_OBJECT

public:
    explicit PostPanel(CurrentAnimation& animation, QWidget* parent = nullptr);

private:
    using Text = SettingForm::Text;
    using Edit = std::function<void(AnimationEntry&)>;
    template <typename Value>
    struct Property
    {
        const char* name; ///< object name of the field
        Text label;
        Text tip;
        std::function<Value(const AnimationEntry&)> get;
        std::function<void(AnimationEntry&, Value)> set;
        /// Whether it means anything; its row is hidden where not. Empty: always.
        std::function<bool(const AnimationEntry&)> isShown = {};
    };
    struct NumberRange
    {
        double lowest = 0;
        double highest = 1;
        double step = 0.1;
        int decimals = 2;
        Text unit = {};      ///< with the space before it
        Text automatic = {}; ///< what an empty value is called; empty: there is always one
    };
    struct Binding
    {
        QWidget* field;
        std::function<void(const AnimationEntry&)> show;
        std::function<bool(const AnimationEntry&)> isUsual;
        std::function<bool(const AnimationEntry&)> isShown;
    };

    void makeEmpty();
    void addSearch();
    void addBlending();
    void addRepeats();
    void addLoop();
    void addContacts();
    void addMirror();
    void addRetime();
    void addCurve();
    QDoubleSpinBox* addNumber(Property<std::optional<double>> property, const NumberRange& range);
    QCheckBox* addSwitch(Property<bool> property);
    QComboBox* addChoice(Property<int> property, std::vector<Text> choices);
    void addSymmetry();

    void retranslate();
    void refresh();
    void keepResetButtonsWhole();
    void refreshProblems(const AnimationEntry& entry);
    /// Offers the variations of the animation's character.
    void refreshRepeats(const AnimationEntry& entry);
    QString problemOfRepeats(const AnimationEntry& entry) const;
    void refreshCurve(const AnimationEntry& entry);
    void chooseSymmetry();
    void change(const QString& what, const char* property, const Edit& edit,
                EditPhase phase = EditPhase::Final);
    /// How long the clip lasts before it is retimed, seconds.
    double clipSeconds() const;
    double fps() const;

    CurrentAnimation& m_animation;
    SettingForm* m_form;
    QScrollArea* m_scroll;
    QWidget* m_empty;
    QLabel* m_emptyText;
    QComboBox* m_repeated = nullptr; ///< what repeats are drawn from; data: the name of variations
    QCheckBox* m_loop = nullptr;
    QDoubleSpinBox* m_repeats = nullptr;
    QCheckBox* m_contacts = nullptr;
    QCheckBox* m_mirror = nullptr;
    widgets::ElidedButton* m_symmetry = nullptr;
    QComboBox* m_retime = nullptr;
    widgets::CurveEditor* m_curve = nullptr;
    std::vector<Binding> m_bindings;
    std::vector<std::function<void()>> m_texts; ///< of fields, in the language of now
    bool m_isShowing = false;                   ///< fields change because of the document
};

} // namespace quadrille
