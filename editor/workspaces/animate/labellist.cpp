// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/labellist.h"

#include "editor/context/editorcontext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "model/project/document/findentry.h"
#include "widgets/theme/icons.h"
#include "widgets/timeline/draggedframes.h"

#include <QMimeData>
#include <QStringListModel>
#include <set>

namespace quadrille {

namespace {

class Labels : public QStringListModel
{
public:
    using QStringListModel::QStringListModel;

    QStringList mimeTypes() const override { return {widgets::draggedFramesType()}; }
    QMimeData* mimeData(const QModelIndexList& indexes) const override
    {
        std::vector<widgets::DraggedFrames> frames;
        for (const QModelIndex& index : indexes)
            frames.push_back({.label = index.data().toString()});
        return widgets::toMimeData(frames).release();
    }
    Qt::ItemFlags flags(const QModelIndex& /*index*/) const override
    {
        return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled;
    }
    Qt::DropActions supportedDragActions() const override { return Qt::CopyAction; }
    QVariant data(const QModelIndex& index, int role) const override
    {
        if (role == Qt::DecorationRole)
            return widgets::icons::icon(QStringLiteral("label"), widgets::ColorRole::TextMuted);
        return QStringListModel::data(index, role);
    }
};

} // namespace

LabelList::LabelList(CurrentAnimation& animation, QWidget* parent)
    : QListView(parent), m_animation(animation), m_labels(new Labels(this))
{
    setObjectName(QStringLiteral("labelList"));
    setModel(m_labels);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setDragEnabled(true);
    setDragDropMode(QAbstractItemView::DragOnly);
    setFrameShape(QFrame::NoFrame);
    setUniformItemSizes(true);
    connect(this, &QListView::activated, this,
            [this](const QModelIndex& index) { emit labelChosen(index.data().toString()); });
    connect(&animation, &CurrentAnimation::changed, this, &LabelList::refresh);
    connect(&animation.context().document, &ProjectDocument::changed, this, &LabelList::refresh);
    retranslates(this, [this] {
        setAccessibleName(tr("Labels"));
        setToolTip(tr("Drag a label between the cards, or press Return: any take that has it may be played"));
    });
    refresh();
}

QStringList LabelList::labels() const
{
    return m_labels->stringList();
}

void LabelList::refresh()
{
    const ProjectDocument& document = m_animation.context().document;
    const AnimationEntry* entry = m_animation.entry();
    const QString character =
        entry == nullptr ? QString() : m_animation.context().animations.characterOf(m_animation.name());
    std::set<QString> labels;
    for (const SequenceEntry& sequence : document.project().sequences) {
        const CharacterEntry* its = document.characterOf(sequence);
        if (entry != nullptr && its != nullptr && QString::fromStdString(its->name) != character)
            continue;
        for (const LabelSpan& span : sequence.labels)
            labels.insert(QString::fromStdString(span.label));
    }
    const QStringList all(labels.begin(), labels.end());
    if (all != m_labels->stringList())
        m_labels->setStringList(all);
}

} // namespace quadrille

#include "moc_labellist.cpp"
