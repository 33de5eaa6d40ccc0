// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QListView>

class QStringListModel;

namespace quadrille {

class CurrentAnimation;

/// The labels that the sequences of the animation's character have, to be dragged into its storyboard. Return
/// and double clicks choose one.
class LabelList : public QListView
{
    Q_OBJECT

public:
    explicit LabelList(CurrentAnimation& animation, QWidget* parent = nullptr);

    QStringList labels() const;

signals:
    void labelChosen(const QString& label);

private:
    void refresh();

    CurrentAnimation& m_animation;
    QStringListModel* m_labels;
};

} // namespace quadrille
