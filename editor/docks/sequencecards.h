// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/sequencemedia.h"

#include <QAbstractListModel>
#include <QColor>
#include <QStringList>

namespace quadrille {

class CardPictures;
struct EditorContext;

/// A label on a card: where it begins and ends, as shares of the sequence, 0 … 1.
struct CardLabel
{
    double first = 0;
    double last = 0;
    QString text;
    QColor color;
};

/// The sequences of the project as cards: name, colour, length, labels, state, and pictures of the movement,
/// which are drawn for the cards that somebody looks at.
class SequenceCards : public QAbstractListModel
{
    Q_OBJECT

public:
    enum Role
    {
        LengthRole = Qt::UserRole, ///< QString of two lines: "3.16 s · 25 fps", "79 frames"
        PicturesRole,              ///< QList<QImage>, to be shown one after the other; maybe empty
        LabelsRole,                ///< QList<CardLabel>
        StateRole,                 ///< ResultPhase of its media as int
        SearchRole,                ///< QString: name and labels
        ColorRole,                 ///< QColor: of the sequence, as in the graph of its character
        SecondsRole,               ///< double: its length; 0 until it is open
        LabelNamesRole,            ///< QStringList: its labels, each once, in the order of time
    };

    explicit SequenceCards(EditorContext& context, QObject* parent = nullptr);

    /// Empty for an invalid index.
    QString name(const QModelIndex& index) const;
    /// Invalid where there is none.
    QModelIndex indexOf(const QString& name) const;
    /// Which of a card's pictures is looked at: the frame of it is what a drag takes along.
    void setMoving(const QModelIndex& index, int phase);
    /// The frame of the sequence that the picture shows which is looked at. A third of the way where there
    /// are no pictures yet; 0 before it is open.
    FrameIndex shownFrame(const QModelIndex& index) const;
    CardPictures& pictures() const { return *m_pictures; }

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QStringList mimeTypes() const override;
    /// See widgets::DraggedFrames.
    QMimeData* mimeData(const QModelIndexList& indexes) const override;
    Qt::DropActions supportedDragActions() const override { return Qt::CopyAction; }
    /// Renames. \return false when the name is taken or empty.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

private:
    /// The place of the picture that is looked at among a card's; 0 while there are none.
    int shownPicture(const QModelIndex& index) const;
    void follow(const ChangeEvent& event);
    void changed(const QString& name);
    QString length(const QString& name) const;
    QString tip(const QString& name, const SequenceEntry& entry) const;
    QColor colorOf(const SequenceEntry& entry) const;
    QList<CardLabel> labels(const SequenceEntry& entry) const;
    const std::vector<SequenceEntry>& entries() const;

    EditorContext& m_context;
    CardPictures* m_pictures;
    QString m_moving;
    int m_phase = 0;
};

} // namespace quadrille
