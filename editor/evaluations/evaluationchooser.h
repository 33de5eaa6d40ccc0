// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QLabel;
class QListWidget;
class QPushButton;

namespace quadrille {

struct EditorContext;

/// The evaluations that there are, with a sentence on each, to add some to the project. Those that it has
/// already, or that there is nothing for, say so.
class EvaluationChooser : public QWidget
{
    Q_OBJECT

public:
    explicit EvaluationChooser(EditorContext& context, QWidget* parent = nullptr);

    /// Puts the keyboard into the list.
    void begin();

signals:
    /// One was added. \param name  see evaluationName().
    void added(const QString& name);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void refresh();
    void add();
    QString hindrance(const QString& table) const;

    EditorContext& m_context;
    QLabel* m_heading;
    QListWidget* m_list;
    QPushButton* m_add;
};

} // namespace quadrille
