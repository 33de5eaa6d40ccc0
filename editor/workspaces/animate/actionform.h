// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/fields/fieldform.h"
#include "model/project/document/animationentry.h"

namespace quadrille {

class ProjectDocument;
class RangeField;
class SequenceMedia;

namespace widgets {
class RangeStrip;
}

/// Which frames an action plays, how often, and for how long. It changes nothing itself.
class ActionForm : public LabelForm
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

protected:
    void retranslate() override;

private:
    void addFrames();
    void addPlaying();
    void showFrames(const ActionEntry& action);
    void setRange(const std::optional<FrameRange>& range, EditPhase phase);

    ProjectDocument& m_document;
    SequenceMedia& m_media;
    std::optional<ActionEntry> m_action;
    FieldForm<ActionEntry, LabelForm> m_fields;
    QLabel* m_title;
    RangeField* m_range;
    widgets::RangeStrip* m_strip;
    QDoubleSpinBox* m_repeat = nullptr;
    QDoubleSpinBox* m_share = nullptr;
};

} // namespace quadrille
