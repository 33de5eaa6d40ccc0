// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/importing/importmessages.h"
#include "editor/importing/importplan.h"

#include <QDialog>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QToolButton;

namespace quadrille {

class AxesFields;
class RangeField;
class TakePreview;
class TakeTable;
class TextureField;
struct EditorContext;

/// The import preview: what was found, how it will look, and what can be decided about it before anything is
/// in the project.
class ImportDialog : public QDialog
{
    Q_OBJECT

public:
    /// Opens the takes in a job. \param found  as findSources() gave it.
    ImportDialog(EditorContext& context, FoundSources found, QWidget* parent = nullptr);
    ~ImportDialog() override;

    const ImportPlan& plan() const { return m_plan; }

signals:
    /// The plan was carried out.
    void imported(const QStringList& names);

private:
    void makeControls();
    QWidget* makeSettings();
    void connectAll();
    void survey();
    void takeSurvey(std::vector<SurveyedTake> takes);
    void readControls();
    void showPlan();
    void showTake();
    void showProblems();
    void setRate(double fps);
    void triggerStrip();
    void chooseMesh();
    void setTexture(const TextureReference& texture);
    void import();
    void retranslate();
    PlannedTake* current();

    EditorContext& m_context;
    FoundSources m_found;
    ImportPlan m_plan;
    bool m_isSurveyed = false;
    ImportMessage::Help m_help = ImportMessage::Help::None; ///< what the strip's button does

    TakeTable* m_takes;
    widgets::MessageStrip* m_strip;
    QLabel* m_notes;
    TakePreview* m_preview;
    QLabel* m_height;
    QFormLayout* m_form = nullptr;
    QComboBox* m_character;
    QLineEdit* m_mesh;
    QToolButton* m_chooseMesh;
    AxesFields* m_axes;
    QDoubleSpinBox* m_fps;
    QLabel* m_rateReason;
    RangeField* m_range;
    TextureField* m_texture;
    QPushButton* m_import;
    QPushButton* m_cancel;
};

} // namespace quadrille
