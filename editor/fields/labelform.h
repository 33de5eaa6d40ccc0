// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QLabel>
#include <QWidget>
#include <functional>
#include <vector>

class QFormLayout;

namespace quadrille {

/// Labels left, fields right, facts that are only read. Texts are functions, so that they follow the
/// language.
class LabelForm : public QWidget
{
    Q_OBJECT

public:
    using Text = std::function<QString()>;

    explicit LabelForm(QWidget* parent = nullptr);

    /// The form owns the field.
    /// \param label  empty: the field says itself what it is, and is as wide as the form.
    /// \param tip what the property does, in one sentence. \param beside  stands behind the field.
    void addField(const char* objectName, Text label, QWidget* field, Text tip, QWidget* beside = nullptr);
    /// A value that is only read.
    QLabel* addFact(const char* objectName, Text label);
    /// A field without label, as wide as the form, which owns it.
    void addWide(const char* objectName, QWidget* field);
    /// \pre The field was added.
    void setRowVisible(const QWidget* field, bool visible);

protected:
    /// Called after the language changed.
    virtual void retranslate() {}
    void changeEvent(QEvent* event) override;

private:
    struct Row
    {
        QLabel* label; ///< null where the field says itself what it is
        QWidget* field;
        QWidget* whole; ///< the field, with what stands beside it
        Text text;
        Text tip;
    };
    void retranslateRows();

    QFormLayout* m_form;
    std::vector<Row> m_rows;
};

} // namespace quadrille
