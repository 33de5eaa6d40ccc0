// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "model/project/document/animationentry.h"

#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace quadrille {

class SequenceMedia;
class ProjectDocument;

namespace widgets {
class RangeStrip;
}

/// Which frames an action plays, how often, and for how long. It changes nothing itself.
class ActionForm : public QWidget
{
    Q_OBJECT

public:
    /// Refers to document and media.
    ActionForm(ProjectDocument& document, SequenceMedia& media, QWidget* parent = nullptr);

    /// Shows an action; nothing can be edited without one. Emits nothing.
    void show(const std::optional<ActionEntry>& action);
    using QWidget::show;
    /// Gives the keyboard to the first field.
    void edit();

signals:
    /// The user edited it.
    /// \param text what the history calls the edit. \param property tells what is edited. \param action  as
    /// it is to be.
    void edited(const quadrille::ActionEntry& action, const QString& text, const QString& property,
                quadrille::EditPhase phase);

private:
    void addRow(QLabel* label, QWidget* field);
    void connectFields();
    void retranslate();
    void showRange();
    void setRange(int first, int last, EditPhase phase);
    void change(const QString& text, const QString& property, EditPhase phase = EditPhase::Final);

    ProjectDocument& m_document;
    SequenceMedia& m_media;
    std::optional<ActionEntry> m_action;
    QFormLayout* m_form;
    QLabel* m_title;
    QLabel* m_framesLabel;
    QWidget* m_frames;
    QSpinBox* m_first;
    QSpinBox* m_last;
    widgets::RangeStrip* m_strip;
    QLabel* m_repeatLabel;
    QSpinBox* m_repeat;
    QCheckBox* m_hasDuration;
    QDoubleSpinBox* m_duration;
    QLabel* m_shareLabel;
    QSpinBox* m_share;
    bool m_isShowing = false;
};

} // namespace quadrille
