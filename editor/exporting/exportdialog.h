// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/exporting/exportplan.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QToolButton;

namespace quadrille {

class AxesFields;
class PictureFields;
class TakePreview;
struct EditorContext;

namespace widgets {
class MessageStrip;
} // namespace widgets

/// How sequences and animations go out: format, place, frames, rate, axes, textures, and the look of
/// pictures. Stays open until everything is written, and shows what went wrong.
class ExportDialog : public QDialog
{
    Q_OBJECT

public:
    ExportDialog(EditorContext& context, ExportPlan plan, QWidget* parent = nullptr);

    const ExportPlan& plan() const { return m_plan; }

signals:
    /// All files of all entries are written.
    void exported(const QStringList& files);

private:
    void makeControls();
    void connectAll();
    void readControls();
    void showPlan();
    void showFacts();
    /// What the picture's fields say, as an entry holds it.
    UnknownKeys picture() const;
    void choosePlace();
    void chooseFormat();
    bool mayWriteOver();
    void start();
    void finish(const std::vector<ExportResult>& results);
    void setBusy(bool busy);
    void retranslate();
    void chooseClip();
    /// Whether all variations of an entry go out together.
    bool isDataSet() const;
    /// Frames of the first clip as the project has it; null while it is not ready.
    const MeshSequence* sequence() const;
    /// Nothing while the clip is not ready.
    std::optional<std::int64_t> framesWritten() const;

    EditorContext& m_context;
    ExportPlan m_plan;
    widgets::MessageStrip* m_strip;
    TakePreview* m_preview;
    QFormLayout* m_form;
    QComboBox* m_clip;
    QComboBox* m_format;
    QLineEdit* m_place;
    QToolButton* m_choosePlace;
    QLabel* m_files;
    QSpinBox* m_first;
    QSpinBox* m_last;
    QDoubleSpinBox* m_fps;
    AxesFields* m_axes;
    QCheckBox* m_textures;
    PictureFields* m_picture;
    QCheckBox* m_keep;
    QPushButton* m_export;
    QPushButton* m_cancel;
};

} // namespace quadrille
