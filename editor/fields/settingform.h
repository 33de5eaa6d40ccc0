// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

class QGridLayout;
class QLabel;
class QToolButton;

namespace quadrille {

/// Rows of settings under headings: label, field, a button that brings the usual value back, and a sentence
/// where something cannot be done. Texts are functions, so that they follow the language.
class SettingForm : public QWidget
{
    Q_OBJECT

public:
    using Text = std::function<QString()>;

    explicit SettingForm(QWidget* parent = nullptr);

    void addHeading(Text text);
    /// A heading that shows and hides the rows after it, up to the next heading; closed at first.
    /// \param name  object name of its button.
    void addFold(const char* name, Text text);
    /// Adds a row below the others; the form owns the field.
    /// \param name  object name of the field; its button is called the same with "Reset" behind.
    /// \param label  empty: the field says itself what it is, as a check box does.
    /// \param tip  what the setting does, in one sentence.
    void add(const char* name, Text label, Text tip, QWidget* field, std::function<void()> reset);
    /// Whether a field has its usual value: the button shows only where it has not. \pre The field was added;
    /// so for the next two.
    void setUsual(const QWidget* field, bool usual);
    /// Why a setting does nothing, or failed; empty for nothing.
    void setProblem(const QWidget* field, const QString& sentence);
    /// A row inside of a closed fold stays hidden either way.
    void setRowVisible(const QWidget* field, bool visible);

private:
    struct Row
    {
        QLabel* label;
        QWidget* field;
        QToolButton* reset;
        QLabel* problem;
        Text text;
        Text tip;
        QToolButton* fold = nullptr; ///< that shows and hides it
        bool isVisible = true;
        bool isUsual = true;
    };

    void addHeadingRow(QWidget* heading);
    static void showRow(const Row& row);
    Row& rowOf(const QWidget* field);
    void retranslate();

    QGridLayout* m_grid;
    std::vector<Row> m_rows;
    std::vector<std::pair<QLabel*, Text>> m_headings;
    std::vector<std::pair<QToolButton*, Text>> m_folds;
    QToolButton* m_fold = nullptr; ///< that rows are added to
};

} // namespace quadrille
