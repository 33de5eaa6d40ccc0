// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QPointer>

class QWidget;

namespace quadrille {

class Error;
class ProjectDocument;

/// Says why an edit was not taken: beside the field that it was typed into, which keeps what was typed, else
/// by `told`.
class RefusalNotes : public QObject
{
    Q_OBJECT

public:
    explicit RefusalNotes(ProjectDocument& document, QObject* parent = nullptr);

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// An edit that was no field's was refused, in the user's words.
    void told(const QString& message);

private:
    void tell(const Error& error);
    void showAgain();

    ProjectDocument& m_document;
    QPointer<QWidget> m_left; ///< what the keyboard is just leaving; fields commit then
};

} // namespace quadrille
