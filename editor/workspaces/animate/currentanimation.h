// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/documents/animationresults.h"

#include <QObject>
#include <functional>

namespace quadrille {

class SceneView;
struct EditorContext;

/// The animation that the Animate workspace works on: all that its tools and panels know of the program.
class CurrentAnimation : public QObject
{
    Q_OBJECT

public:
    using Edit = std::function<void(AnimationEntry&)>;

    /// Refers to context and view.
    CurrentAnimation(EditorContext& context, SceneView& view, QObject* parent = nullptr);

    EditorContext& context() const { return m_context; }
    SceneView& view() const { return m_view; }
    /// Empty without one.
    const QString& name() const;
    /// Null without an animation.
    const AnimationEntry* entry() const;
    /// Idle without one.
    ResultPhase phase() const;
    /// What is shown now; null without one. It may be of the entry as it was before the last edits.
    std::shared_ptr<const AnimationResult> result() const;
    /// The opened graph of its character; null where there is none yet. Without an animation it is that of
    /// the first character.
    std::shared_ptr<const OpenedCharacter> character() const;
    /// Changes the animation, undoably; without one, a new one is made first.
    /// \param text  what the history calls it, translated. \param property  see setAnimation. \param edit  is
    /// called at once, with a copy.
    void edit(const QString& text, const QString& property, const Edit& edit,
              EditPhase phase = EditPhase::Final);
    /// Adds an animation and works on it. \return its name.
    QString add();

signals:
    /// Another animation is worked on, or this one has other values.
    void changed();
    /// State or result of the animation are others now, or its graph is.
    void resultChanged();

private:
    EditorContext& m_context;
    SceneView& m_view;
};

} // namespace quadrille
