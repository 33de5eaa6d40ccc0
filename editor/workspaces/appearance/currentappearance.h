// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/documents/appearanceresults.h"
#include "model/sequence/meshsequence.h"

#include <QObject>
#include <functional>

namespace quadrille {

class SceneView;
struct EditorContext;

/// The model of appearance that the Appearance workspace works on, and the captured frame that it looks at:
/// all that its panels know of the program.
class CurrentAppearance : public QObject
{
    Q_OBJECT

public:
    using Edit = std::function<void(AppearanceEntry&)>;

    /// Refers to context and view.
    CurrentAppearance(EditorContext& context, SceneView& view, QObject* parent = nullptr);

    EditorContext& context() const { return m_context; }
    SceneView& view() const { return m_view; }
    const QString& name() const;
    /// Null without any.
    const AppearanceEntry* entry() const;
    /// The character whose textures it learns; that of the sequence that is shown while there is none. Empty
    /// in a project without characters.
    QString character() const;
    /// How far it is; null without an entry.
    const AppearanceResults::State* resultState() const;
    /// The last model that was computed; null without one.
    OpenedAppearancePointer opened() const;
    /// The sequences that it learns from, or would.
    QStringList sequences() const;
    /// Whether one of them has a texture for each frame; nothing is known until all are open.
    std::optional<bool> hasTextures() const;
    /// The frame that is looked at; none while its sequence is not open.
    std::optional<NamedFrame> frame() const;
    /// The texture that was captured with a frame; an empty one where there is none.
    Texture textureOf(const NamedFrame& frame) const;
    /// The sequence of a frame; null while it is not open, or where the frame is beyond its end.
    const MeshSequence* sequenceOf(const NamedFrame& frame) const;
    /// Shows a frame, of another sequence where it is of that.
    void goTo(const NamedFrame& frame);
    /// Shows a frame as soon as its sequence is shown for another reason.
    void goToWhenShown(const NamedFrame& frame) { m_pending = frame; }

    /// Changes the entry, undoably; nothing happens without one.
    /// \param text  what the history calls it, translated. \param property  see setAppearance.
    void edit(const QString& text, const QString& property, const Edit& edit,
              EditPhase phase = EditPhase::Final);
    /// Adds a model for the character and works on it. \return its name.
    QString add();

signals:
    /// Another one is worked on, or this one has other values.
    void changed();
    /// How far it is, or the model itself, is another now.
    void resultChanged();
    /// Another frame is looked at, or its sequence is open now.
    void frameChanged();

private:
    AppearanceEntry wantedEntry() const;

    EditorContext& m_context;
    SceneView& m_view;
    std::optional<NamedFrame> m_pending; ///< to go to once its sequence is shown
};

/// A frame as users read it: "walk 12".
QString frameText(const NamedFrame& frame);

} // namespace quadrille
