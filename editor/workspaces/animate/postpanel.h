// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/fields/fieldform.h"

#include <QWidget>
#include <functional>

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
    using Fields = FieldForm<AnimationEntry>;

    void makeEmpty();
    void addSearch();
    void addBlending();
    void addRepeats();
    void addLoop();
    void addContacts();
    void addMirror();
    void addRetime();
    void addCurve();
    /// \param kind  as the choice has it; times begin as they are in the clip.
    void setRetimeKind(AnimationEntry& entry, int kind) const;
    void addSymmetry();

    void retranslate();
    void refresh();
    void refreshProblems(const AnimationEntry& entry);
    /// Offers the variations of the animation's character.
    void refreshRepeats(const AnimationEntry& entry);
    QString problemOfRepeats(const AnimationEntry& entry) const;
    void refreshCurve(const AnimationEntry& entry);
    void chooseSymmetry();
    void change(const QString& text, const char* property, const Edit& edit,
                EditPhase phase = EditPhase::Final);
    /// How long the clip lasts before it is retimed, seconds.
    double clipSeconds() const;
    double fps() const;

    CurrentAnimation& m_animation;
    SettingForm* m_form;
    Fields m_fields;
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
};

} // namespace quadrille
