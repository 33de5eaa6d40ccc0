// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/documents/transferresults.h"

#include <QObject>
#include <functional>
#include <optional>
#include <vector>

namespace quadrille {

class SceneView;
struct EditorContext;

/// The transfer that the Transfer workspace works on, and which of its pairs is selected: all that its panels
/// know of the program.
class CurrentTransfer : public QObject
{
    Q_OBJECT

public:
    using Edit = std::function<void(TransferEntry&)>;

    /// Refers to context and view.
    CurrentTransfer(EditorContext& context, SceneView& view, QObject* parent = nullptr);

    EditorContext& context() const { return m_context; }
    SceneView& view() const { return m_view; }
    const QString& name() const;
    /// Null without any.
    const TransferEntry* entry() const;
    /// How far it is; null without an entry.
    const TransferResults::State* state() const;
    /// The last preview of this clip on this body; null without one.
    TransferPreviewPointer preview() const;
    /// The result as the project says; null while there is none.
    TransferResultPointer result() const;
    /// Those of the entry, else what was proposed for it. Their quality is not a number where no limbs are
    /// found.
    std::vector<ProposedPair> pairs() const;
    /// The same, without their quality.
    std::vector<TrianglePair> plainPairs() const;
    bool arePairsProposed() const { return entry() != nullptr && entry()->pairs.empty(); }
    /// Where a pair is on the template; nothing where that is not known.
    std::optional<BodyRegion> regionOf(const TrianglePair& pair) const;
    /// Parts of the template without a pair, where its limbs are known.
    std::vector<BodyRegion> regionsWithout() const;

    int selected() const { return m_selected; }
    /// \param pair  −1: none.
    void select(int pair);
    /// Both bodies in their reference poses, instead of what they perform.
    bool showsReference() const { return m_showsReference; }
    void setShowsReference(bool shows);

    /// Changes the entry, undoably; nothing happens without one.
    /// \param text  what the history calls it, translated. \param property  see setTransfer.
    void edit(const QString& text, const QString& property, const Edit& edit,
              EditPhase phase = EditPhase::Final);
    /// Exchanges all pairs; proposed ones become the entry's by that.
    void setPairs(const QString& text, std::vector<TrianglePair> pairs, EditPhase phase = EditPhase::Final);
    /// One more, which is selected. \return whether the body's triangle had no pair yet.
    bool addPair(const TrianglePair& pair);
    /// \return whether the body's triangle had no other pair.
    bool movePair(int pair, int side, std::uint32_t triangle, EditPhase phase);
    void removePair(int pair);
    /// The same pair on the other side of both bodies. \return whether there is such a place, and it had no
    /// pair yet.
    bool mirrorPair(int pair);
    /// The triangle of the other body at the place of one. \param side  0: of the template.
    std::optional<std::uint32_t> counterpart(int side, std::uint32_t triangle) const;
    /// Adds a transfer of the clip that is looked at elsewhere onto the first other body. \return its name.
    QString add();

    /// Adds a projection of pictures onto the transferred clip, or without one onto the take that is
    /// selected. \param cameras  file of their table. \return its name.
    QString addProjection(const QString& cameras);

    /// In the user's words.
    static QString regionName(BodyRegion region);

signals:
    /// Another one is worked on, or this one has other values.
    void changed();
    /// Preview or result are others now.
    void resultChanged();
    void selectionChanged();
    void showsReferenceChanged();

private:
    bool hasTarget(const std::vector<TrianglePair>& pairs, TriangleIndex triangle) const;

    EditorContext& m_context;
    SceneView& m_view;
    int m_selected = -1;
    bool m_showsReference = false;
};

/// Below this likeness a pair deserves a look.
inline constexpr double doubtfulLikeness = 0.3;

} // namespace quadrille
