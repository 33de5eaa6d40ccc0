// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QStringList>

class QComboBox;

namespace quadrille {

struct Project;

/// Fills a box with what can be exported, "SECTION/NAME" as data: takes, animations and other clips, each
/// kind under its heading where there are several. Where several clips go out together, it has the first
/// only. The box is emptied first. \param planned  the clips that go out.
void listClips(QComboBox& box, const Project& project, const QStringList& planned);
/// The name in "sequences/NAME" or "animations/NAME".
QString nameOfClip(const QString& clip);

} // namespace quadrille
