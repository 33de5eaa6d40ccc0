// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/errors/errortext.h"

#include <QAbstractTableModel>
#include <QDateTime>
#include <functional>
#include <variant>
#include <vector>

namespace quadrille {

/// What went wrong and is worth keeping: errors that did not stop anything and findings of imports. Repeats
/// are counted. Kept as data and put into words when shown, so that it follows the language.
class IssueLog : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum class Severity
    {
        Info,
        Warning,
        Error,
    };
    Q_ENUM(Severity)
    enum Column
    {
        MessageColumn,
        SubjectColumn,
        PlaceColumn,
        CountColumn,
        ColumnCount,
    };
    enum Role
    {
        SeverityRole = Qt::UserRole,
        CanJumpRole, ///< bool: there is a culprit to go to
    };

    explicit IssueLog(QObject* parent = nullptr);

    /// That something was cancelled is not kept.
    /// \param subject what it is about, e.g. the name of a sequence. \param jump shows the culprit; may be
    /// empty.
    void add(const Error& error, const QString& subject = {}, std::function<void()> jump = {});
    void add(const Issue& issue, const QString& subject = {}, std::function<void()> jump = {});
    /// Forgets what is known of a subject: it was reloaded, renamed or removed.
    void clear(const QString& subject);
    void clear();
    /// Shows the culprit of a row. Nothing happens where it has none.
    void jump(const QModelIndex& index) const;
    /// How many rows have it; repeats do not count. Cost: linear.
    int count(Severity severity) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// Puts everything into words again.
    void retranslate();

signals:
    /// Something new came, or was said again.
    void added(quadrille::IssueLog::Severity severity);

private:
    struct Entry
    {
        std::variant<Error, Issue> what;
        QString subject;
        std::function<void()> jump;
        int repeats = 1;
        QDateTime last;
    };
    static Severity severityOf(const Entry& entry);
    static ErrorText textOf(const Entry& entry);
    void add(Entry entry);

    std::vector<Entry> m_entries; ///< in the order they came
};

} // namespace quadrille
