// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/draggedframes.h"

#include <QAbstractScrollArea>
#include <QColor>
#include <QImage>
#include <memory>
#include <vector>

class QLabel;

namespace quadrille::widgets {

/// One thing that happens in a storyboard.
struct StoryCard
{
    QString title;
    QString subtitle; ///< e.g. the frames that are used
    QString badge;    ///< e.g. how often; over the picture, may be empty
    QString tip;
    QImage picture; ///< square; may be null
    QColor color;   ///< of the line under the picture
    bool isFaulty = false;
    bool operator==(const StoryCard&) const = default;
};

/// What happens one after the other, as a row of cards from left to right. It changes nothing itself: drops,
/// moves and deletions are signals, and come back by setCards().
///
/// ← → Home End select, Ctrl+← → move the card, Ctrl+D duplicates it, Delete removes it, Return edits it.
/// Dragging a card moves it, with Ctrl held it makes a copy; Escape leaves it where it was. Takes and labels
/// are dropped between cards.
class Storyboard : public QAbstractScrollArea
{
    Q_OBJECT

public:
    explicit Storyboard(QWidget* parent = nullptr);
    ~Storyboard() override;

    /// The current card stays by its place; where there are fewer, the last one becomes it.
    void setCards(std::vector<StoryCard> cards);
    const std::vector<StoryCard>& cards() const { return m_cards; }
    /// −1 for none. Emits nothing.
    void setCurrent(int card);
    int current() const { return m_current; }
    /// What stands there while there are no cards: one line, cut where it does not fit.
    void setEmptyText(const QString& text);
    /// A button behind that text which helps. Taken over.
    void addEmptyAction(QWidget* action);

    /// Where a card is drawn, in the viewport's coordinates.
    QRect cardRect(int card) const;
    /// Before which card something dropped at a place would go: 0 … cards().size().
    int insertionAt(const QPoint& position) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// By the user, or because there are fewer; −1 for none.
    void currentChanged(int card);
    /// \param before the card that it is to come before, counted with the card where it was; the number of
    /// cards for the end.
    void moveRequested(int card, int before);
    void copyRequested(int card, int before);
    void deletionRequested(int card);
    /// Double click or Return: to be edited.
    void activated(int card);
    /// \param before  as insertionAt().
    void framesDropped(int before, const std::vector<quadrille::widgets::DraggedFrames>& frames);
    /// \param card −1 when there was none under the pointer.
    void menuRequested(int card, const QPoint& globalPosition);

protected:
    bool event(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    struct Drag
    {
        int card = -1;
        QPoint pressedAt;
        QPoint at;
        bool moved = false;
        bool copies = false;
    };

    int cardAt(const QPoint& position) const;
    int cardHeight(int picture) const;
    /// The side of pictures; they shrink where the storyboard is low.
    int pictureHeight() const;
    int count() const { return static_cast<int>(m_cards.size()); }
    bool isMove(int card, int before) const { return before != card && before != card + 1; }
    void choose(int card);
    void reveal(int card);
    void setInsertion(int before);
    void updateScrollBar();
    void fitEmptyText();
    void updateAccessibleText();
    void scrollNear(const QPoint& position);
    void paintCard(QPainter& painter, int card, const QRect& place) const;
    void paintPicture(QPainter& painter, const StoryCard& card, const QRect& place) const;
    void paintInsertion(QPainter& painter) const;

    std::vector<StoryCard> m_cards;
    int m_current = -1;
    int m_insertion = -1; ///< while something is held over the storyboard
    Drag m_drag;
    QWidget* m_empty;
    QLabel* m_emptyText;
    QString m_emptyWords; ///< of the text, whole
};

} // namespace quadrille::widgets
