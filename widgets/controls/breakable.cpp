// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/controls/breakable.h"

#include <QRegularExpression>

namespace quadrille::widgets {

QString breakable(const QString& text)
{
    static const QRegularExpression joint(QStringLiteral(R"(([/\\_]|\.(?=\D))(?=\S))"));
    static const QRegularExpression longWord(QStringLiteral(R"(([^\s\x{200B}]{24})(?=[^\s\x{200B}]))"));
    QString result = text;
    result.replace(joint, QStringLiteral("\\1\u200B"));
    return result.replace(longWord, QStringLiteral("\\1\u200B"));
}

} // namespace quadrille::widgets
