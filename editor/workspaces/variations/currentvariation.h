// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/documents/variationresults.h"
#include "model/variation/timewarp.h"

#include <QColor>
#include <QObject>
#include <QSet>
#include <functional>

namespace quadrille {

class SceneView;
struct EditorContext;

/// The variations that the Variations workspace works on: all that its tools and panels know of the program.
class CurrentVariation : public QObject
{
    Q_OBJECT

public:
    using Edit = std::function<void(VariationEntry&)>;
    using SetEdit = std::function<void(SamplesEntry&)>;
    using BodyEdit = std::function<void(BodyPartsEntry&)>;

    /// Refers to context and view.
    CurrentVariation(EditorContext& context, SceneView& view, QObject* parent = nullptr);

    EditorContext& context() const { return m_context; }
    SceneView& view() const { return m_view; }
    const QString& name() const;
    /// Null without any.
    const VariationEntry* entry() const;
    /// The character that they are of; of the sequence that is shown while there are none. Empty in a project
    /// without characters.
    QString character() const;
    /// The parts of its body.
    BodyPartsEntry body() const;
    /// How far it is; null without an entry.
    const VariationResults::State* resultState() const;
    /// The aligned takes; null without any.
    std::shared_ptr<const Movement> movement() const;
    /// What is known of the parts' models. Good until `resultChanged`.
    const std::vector<PartProgress>& parts() const;
    /// What is going on or missing, in a sentence; empty where all is done.
    QString stateText() const;

    /// Which of the entry's samples are worked on. It is counted from 0; −1 without any.
    int set() const;
    void setSet(int set);
    /// Null without any.
    const SamplesEntry* samples() const;
    /// The variations of those samples. What is discarded is told as the entry has it now.
    std::vector<DrawnVariation> drawn() const;
    /// Whether the user took one of them from the view. \param inSet  number in the set, from 1; so for all
    /// that have it.
    bool isHidden(int inSet) const { return m_hidden.contains(inSet); }
    void setHidden(int inSet, bool hidden);
    /// All that is known of drawing those samples; null before they are drawn.
    const DrawnSet* drawnSet() const;
    bool isOriginalShown() const { return m_isOriginalShown; }
    void setOriginalShown(bool shown);
    /// The colour of a variation in view and lists.
    static QColor colorOf(int inSet);

    /// The frames of the take that is varied that are used; nothing of blends.
    std::optional<FrameRange> framesUsed() const;
    /// The frame of the reference that is shown now: all that varies runs on it. Nothing without a movement.
    /// It may lie between two frames.
    std::optional<double> referenceFrame() const;
    /// Shows the moment at a frame of the reference. Stops the player at the nearest frame of what is shown;
    /// nothing happens without a movement.
    void goToReference(double frame);

    /// Changes the entry, undoably; without one, a new one is made first.
    /// \param text  what the history calls it, translated. \param property  see setVariation.
    void edit(const QString& text, const QString& property, const Edit& edit,
              EditPhase phase = EditPhase::Final);
    /// Changes the samples that are worked on, undoably; without any, nothing happens.
    void editSet(const QString& text, const char* property, const SetEdit& edit,
                 EditPhase phase = EditPhase::Final);
    /// Changes the parts of the character's body, undoably. \param edit  is called at once, with a copy.
    void editBody(const QString& text, const QString& property, const BodyEdit& edit,
                  EditPhase phase = EditPhase::Final);
    /// Adds variations and works on them. \return their name.
    QString add();

signals:
    /// Others are worked on, or these have other values.
    void changed();
    /// The parts of the character's body are others, or another character's.
    void bodyChanged();
    /// How far learning or drawing is, what was drawn, or which of it is shown is another now.
    void resultChanged();
    /// A variation of the set was clicked on in the view. \param adds  to those that are selected already.
    void picked(int inSet, bool adds);

private:
    /// The timing that the clips in the view have; nothing where it is not known.
    std::optional<TakeWarp> shownWarp() const;

    EditorContext& m_context;
    SceneView& m_view;
    int m_set = 0;
    QSet<int> m_hidden; ///< of the set
    bool m_isOriginalShown = false;
};

} // namespace quadrille
