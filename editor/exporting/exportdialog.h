// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/exporting/exportplan.h"
#include "editor/exporting/seencamera.h"
#include "model/project/results/runexports.h"

#include <QDialog>
#include <QPointer>
#include <functional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace quadrille {

class AxesFields;
class Job;
class PictureFields;
class RangeField;
class TakePreview;
struct EditorContext;

namespace widgets {
class MessageStrip;
} // namespace widgets

/// How sequences and animations go out: format, place, frames, rate, axes, textures, and the look of
/// pictures. Asks before anything is replaced that matters to somebody. While files are written it shows how
/// far they are and keeps nobody from working; then it says where they are, or what went wrong.
class ExportDialog : public QDialog
{
    Q_OBJECT

public:
    /// What a view shows of a clip; nothing where it does not show it.
    using Seen = std::function<std::optional<SeenCamera>(const QString& name, const MeshSequence& clip)>;

    ExportDialog(EditorContext& context, ExportPlan plan, Seen seen, QWidget* parent = nullptr);

    const ExportPlan& plan() const { return m_plan; }

    /// While files are written the dialog only steps aside: it comes back if something went wrong.
    void reject() override;

signals:
    /// All files of all entries are written.
    void exported(const QStringList& files);

private:
    /// What is known before files are written.
    struct Preparation
    {
        std::vector<ExportEntry> entries;
        OutputQuestions questions;
    };

    void makeControls();
    void connectAll();
    void readControls();
    void showPlan();
    void showFacts();
    /// What the picture's fields say, as an entry holds it.
    UnknownKeys picture() const;
    void choosePlace();
    void chooseFormat();
    /// A file that is named as those of another format is of that format.
    void followEnding();
    QString folder() const;
    /// Looks what is in the way, then asks, then writes.
    void start();
    /// The export of the project that writes where an entry would; asks whether it may be replaced.
    /// \return false when nothing shall be written.
    bool mayTakePlaces();
    bool mayReplace(const OutputQuestions& questions);
    bool mayWriteOutside(const OutputQuestions& questions);
    void write(const Preparation& prepared);
    void finish(const std::vector<ExportEntry>& entries, const std::vector<ExportResult>& results);
    void keep(const std::vector<ExportEntry>& entries);
    void fail(const Error& error);
    void follow(Job* job);
    void setBusy(bool busy);
    /// The fields, the place of files excepted, are about a clip that is seen.
    void takeView();
    void warnOfTextures();
    void showInFolder();
    void retranslate();
    void chooseClip();
    /// Whether all clips are performances.
    bool isLive() const;
    /// Lists the formats that clips can have.
    void offerFormats();
    /// Whether all variations of an entry go out together.
    bool isDataSet() const;
    /// Frames of the first clip as the project has it; null while it is not ready.
    const MeshSequence* sequence() const;
    /// Of the first clip; 0 while it is not known.
    std::int64_t frameCount() const;
    /// Nothing while they are not known.
    std::optional<std::int64_t> framesWritten() const;

    EditorContext& m_context;
    ExportPlan m_plan;
    Seen m_seen;
    std::optional<SeenCamera> m_view; ///< where the picture's camera is to begin, taken in this dialog
    std::string m_ownPath;            ///< of the entry that is edited: what the user did not choose here
    std::string m_proposedPath;       ///< for a new one
    QStringList m_replaced;           ///< exports of the project whose places are taken, one for each entry
    QPointer<Job> m_job;
    QString m_folder; ///< of the files that were written last
    bool m_isDone = false;
    widgets::MessageStrip* m_strip;
    TakePreview* m_preview;
    QWidget* m_fields;
    QFormLayout* m_form;
    QComboBox* m_clip;
    QComboBox* m_format;
    QLineEdit* m_place;
    QToolButton* m_choosePlace;
    QLabel* m_files;
    RangeField* m_range;
    QDoubleSpinBox* m_fps;
    AxesFields* m_axes;
    QCheckBox* m_textures;
    PictureFields* m_picture;
    QCheckBox* m_keep;
    QProgressBar* m_progress;
    QPushButton* m_export;
    QPushButton* m_cancel;
};

} // namespace quadrille
