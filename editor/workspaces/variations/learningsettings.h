// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldform.h"
#include "model/project/document/variationentry.h"

#include <QScrollArea>

namespace quadrille {

class CurrentVariation;

/// How models are learned, how variations are drawn of them, and which of these are too bad to be kept.
class LearningSettings : public QScrollArea
{
    Q_OBJECT

public:
    explicit LearningSettings(CurrentVariation& variation, QWidget* parent = nullptr);

private:
    void addLearning();
    void addStop();
    void addDrawing();
    void addChain();
    void addLimits();
    void refresh();

    CurrentVariation& m_variation;
    SettingForm* m_form;
    FieldForm<VariationEntry> m_fields;
};

} // namespace quadrille
