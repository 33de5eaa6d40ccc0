// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/relinking/relinkplan.h"

#include <QDialog>
#include <QPointer>

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QToolButton;

namespace quadrille {

class Error;
class Job;
class LostMediaTable;
struct EditorContext;

namespace widgets {
class MessageStrip;
} // namespace widgets

/// Finds media that moved: lists what is lost, searches a folder or takes files that are chosen by hand, and
/// changes nothing before the user says so; then everything in one edit.
class RelinkDialog : public QDialog
{
    Q_OBJECT

public:
    /// \param folder where to search first.
    RelinkDialog(EditorContext& context, const QString& folder, QWidget* parent = nullptr);
    ~RelinkDialog() override;

    const RelinkPlan& plan() const { return m_plan; }
    /// The folder that stands in the field.
    QString folder() const;

signals:
    /// The paths were changed.
    void relinked(int media);

private:
    void makeControls();
    void connectAll();
    void survey();
    void takeSurvey(RelinkPlan plan);
    void chooseFolder();
    void search();
    void takeFound(const std::vector<FoundMedium>& found);
    void chooseByHand();
    void takeChoice(std::size_t medium, const ChosenMedium& choice);
    void follow(Job* job);
    void finish();
    void fail(const Error& error);
    void showPlan();
    void showButtons();
    void showMedium();
    void apply();
    void retranslate();
    bool isBusy() const { return !m_job.isNull(); }

    EditorContext& m_context;
    RelinkPlan m_plan;
    bool m_isSurveyed = false;
    bool m_hasSearched = false; ///< the folder that stands in the field
    QPointer<Job> m_job;
    QPointer<QWidget> m_focus; ///< that had the keyboard when the job began

    QLabel* m_summary;
    QLabel* m_folderLabel;
    QLineEdit* m_folder;
    QToolButton* m_chooseFolder;
    QPushButton* m_search;
    QProgressBar* m_progress;
    QStackedWidget* m_pages;
    LostMediaTable* m_table;
    QLabel* m_empty;
    QLabel* m_note;
    widgets::MessageStrip* m_strip;
    QPushButton* m_byHand;
    QPushButton* m_cancel;
    QPushButton* m_apply;
};

} // namespace quadrille
