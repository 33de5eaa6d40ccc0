// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectdocument.h"

#include <optional>

namespace quadrille {

/// Why an edit cannot be taken: the first thing that is wrong with the project after it and was not before.
/// Nothing when its file can be read again.
/// Cost: that of problemsWhenSaved.
std::optional<Error> refusalOf(const Project& before, const Project& after);

/// Tells of the edits of a document that were not taken, because its file could not hold what they make.
class EditRefusals : public QObject
{
    Q_OBJECT

public:
    /// Those of a document; made when they are first asked for.
    static EditRefusals& of(ProjectDocument& document);

    /// Counts it and tells it.
    void refuse(const Error& error);
    /// How many there were so far: an edit during which it grows was not taken.
    int count() const { return m_count; }

signals:
    /// The project is as it was.
    void refused(const quadrille::Error& error);

private:
    explicit EditRefusals(QObject* parent) : QObject(parent) {}

    int m_count = 0;
};

/// Pushes a command. One that changes nothing counts as taken. \return whether it was taken.
bool wasTaken(ProjectDocument& document, std::unique_ptr<ProjectCommand> command);

} // namespace quadrille
