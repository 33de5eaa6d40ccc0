// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QLabel>
#include <QWidget>
#include <functional>
#include <vector>

class QFormLayout;
class QLineEdit;

namespace quadrille {

/// A page of properties: labels left, fields right, facts that are only read. Texts are functions, so that
/// they follow the language.
class PropertyForm : public QWidget
{
    Q_OBJECT

public:
    using Text = std::function<QString()>;

    explicit PropertyForm(QWidget* parent = nullptr);

    /// Shows the entry of a name; the page reads its values anew.
    virtual void show(const QString& name) = 0;

protected:
    /// The page owns the field.
    /// \param tip what the property does, in one sentence.
    void addField(const char* objectName, Text label, QWidget* field, Text tip);
    /// A value that is only read.
    QLabel* addFact(const char* objectName, Text label);
    /// A field without label, as wide as the page, which owns it.
    void addWide(const char* objectName, QWidget* field);
    void setFieldVisible(QWidget* field, bool visible);
    /// Shows the name of an entry; what is being typed stays while the entry keeps its name.
    static void showName(QLineEdit& field, const QString& name);
    /// Called after the language changed.
    virtual void retranslate() {}

private:
    struct Row
    {
        QLabel* label;
        QWidget* field;
        Text text;
        Text tip;
    };
    void retranslateRows();

    QFormLayout* m_form;
    std::vector<Row> m_rows;

protected:
    void changeEvent(QEvent* event) override;
};

} // namespace quadrille
