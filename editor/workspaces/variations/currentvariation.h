// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"

#include <QObject>
#include <functional>

namespace quadrille {

class StageView;
struct EditorContext;

/// The variations that the Variations workspace works on: all that its tools and panels know of the program.
class CurrentVariation : public QObject
{
    Q_OBJECT

public:
    using Edit = std::function<void(VariationEntry&)>;
    using BodyEdit = std::function<void(BodyPartsEntry&)>;

    CurrentVariation(EditorContext& context, StageView& view, QObject* parent = nullptr);

    EditorContext& context() const { return m_context; }
    StageView& view() const { return m_view; }
    const QString& name() const;
    /// Null without any.
    const VariationEntry* entry() const;
    /// The character that they are of; of the sequence that is shown while there are none. Empty in a project
    /// without characters.
    QString character() const;
    /// The parts of its body.
    BodyPartsEntry body() const;
    /// Changes the entry, undoably; without one, a new one is made first.
    /// \param text  what the history calls it, translated. \param property  see setVariation.
    void edit(const QString& text, const QString& property, const Edit& edit,
              EditPhase phase = EditPhase::Final);
    /// Changes the parts of the character's body, undoably.
    void editBody(const QString& text, const QString& property, const BodyEdit& edit,
                  EditPhase phase = EditPhase::Final);
    /// Adds variations and works on them. \return their name.
    QString add();

signals:
    /// Others are worked on, or these have other values.
    void changed();
    /// The parts of the character's body are others, or another character's.
    void bodyChanged();

private:
    EditorContext& m_context;
    StageView& m_view;
};

} // namespace quadrille
