// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QCollator>
#include <QSortFilterProxyModel>

namespace quadrille {

/// The cards that are found by name or label, in the order that the user chose.
class CardOrder : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    enum class By
    {
        Project, ///< as the project lists them
        Name,
        Length, ///< shortest first
        Label,  ///< by their first label; those without come last
    };

    explicit CardOrder(QObject* parent = nullptr);

    By by() const { return m_by; }
    /// Sequences that are alike in that go by name.
    void setBy(By by);

protected:
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    By m_by = By::Project;
    QCollator m_collator; ///< "take 2" before "take 10"
};

} // namespace quadrille
