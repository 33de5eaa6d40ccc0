// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QStyledItemDelegate>
#include <functional>
#include <optional>

namespace quadrille {

class Error;

/// Edits names in a list or tree in place. A name that cannot be taken keeps its field open, with the reason
/// beside it; Esc, or a click elsewhere, leaves the name as it was.
class NameDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    /// What is wrong with a text as the name of an item, or nothing.
    using Check = std::function<std::optional<Error>(const QModelIndex&, const QString&)>;

    /// \param check  is asked when the user leaves the field or presses Return or Tab.
    explicit NameDelegate(Check check, QObject* parent = nullptr);

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    Check m_check;
    mutable QPersistentModelIndex m_edited;
};

} // namespace quadrille
