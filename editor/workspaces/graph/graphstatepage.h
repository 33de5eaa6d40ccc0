// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/jobs/job.h"

#include <QPointer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace quadrille {

struct EditorContext;

/// Stands where the map comes: says what is missing, on its way or went wrong, and offers the button that
/// helps.
class GraphStatePage : public QWidget
{
    Q_OBJECT

public:
    explicit GraphStatePage(EditorContext& context, QWidget* parent = nullptr);

    /// Follows the graph of a character.
    void show(const QString& character);
    using QWidget::show;

private:
    void refresh();
    void showProgress();
    void act();
    std::int64_t frameCount() const;
    QString memoryText() const;

    EditorContext& m_context;
    QString m_character;
    QLabel* m_title;
    QLabel* m_text;
    QLabel* m_memory;
    QProgressBar* m_progress;
    QPushButton* m_button;
    QPointer<Job> m_job;
};

} // namespace quadrille
