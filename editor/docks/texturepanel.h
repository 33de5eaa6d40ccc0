// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/jobs/jobrunner.h"
#include "editor/playback/frameloader.h"
#include "widgets/controls/textureview.h"

#include <QWidget>
#include <memory>
#include <optional>

class QCheckBox;
class QComboBox;
class QLabel;
class QToolButton;

namespace quadrille {

class ClipScene;
class TextureField;
struct EditorContext;

namespace widgets {
class ElidedLabel;
class MessageStrip;
} // namespace widgets

/// The texture that the shown sequence wears at the frame that the viewport shows, with the edges of the mesh
/// over it. It gets its frames from the scene, reads nothing itself, and rests while it is hidden.
class TexturePanel : public QWidget
{
    Q_OBJECT

public:
    /// Refers to context and scene.
    TexturePanel(EditorContext& context, ClipScene& scene, QWidget* parent = nullptr);
    ~TexturePanel() override;

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    /// A picture and what is said about it.
    struct Shown
    {
        QImage image;
        QString file; ///< name
        QString path;
        QString facts;
    };

    void arrangeWidgets();
    void retranslate();
    void refresh();
    void refreshMaterials(const MeshSequence* sequence);
    void refreshEdges(const MeshSequence* sequence);
    void showTexture(const MeshSequence& sequence, const LoadedFrame& loaded);
    void showNothing(const QString& reason, bool offersTextures);
    void prepare(Shown shown);
    void show(const Shown& shown, widgets::TexturePicture picture);
    void showFile();
    void showNote();
    void showTools();
    QString stateText() const;
    QString missingText(const MeshSequence& sequence) const;
    /// The material whose texture is chosen; the first unless there is a texture for each.
    int material() const;

    EditorContext& m_context;
    ClipScene& m_scene;
    JobRunner m_preparing; ///< one thread for itself: long jobs must not hold playback up
    widgets::TextureView* m_view;
    QComboBox* m_materials;
    QCheckBox* m_edgesShown;
    QLabel* m_zoom;
    QToolButton* m_actualSize;
    QToolButton* m_fit;
    widgets::MessageStrip* m_note;
    TextureField* m_choice;
    QLabel* m_file;
    widgets::ElidedLabel* m_facts;
    widgets::ElidedLabel* m_pointer;

    QString m_name;        ///< of the sequence
    Shown m_wanted;        ///< what is shown or being prepared
    bool m_isLate = false; ///< m_wanted came while another one was being prepared
    Job* m_job = nullptr;
    QString m_fileName; ///< in full length

    std::weak_ptr<const Topology> m_edgesOf; ///< whose edges are known or on their way
    std::optional<int> m_edgesMaterial;
    QList<QLineF> m_edges;
};

} // namespace quadrille
