// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/language/pseudolanguage.h"

#include <QRegularExpression>

namespace quadrille {

namespace {

QChar accented(QChar letter)
{
    static const QString plain = QStringLiteral("aeiouyAEIOUYcnsCNS");
    static const QString changed = QStringLiteral("àéîöüýÀÉÎÖÜÝçñšÇÑŠ");
    const auto place = plain.indexOf(letter);
    return place < 0 ? letter : changed[place];
}

/// Texts that Qt reads as data rather than shows.
bool isData(const char* context, const QString& text)
{
    return qstrcmp(context, "QGuiApplication") == 0 && text == QLatin1String("QT_LAYOUT_DIRECTION");
}

} // namespace

QString pseudoLanguage()
{
    return QStringLiteral("x-pseudo");
}

QString pseudoTranslated(const QString& text)
{
    if (text.trimmed().isEmpty())
        return text;
    static const QRegularExpression kept(
        QStringLiteral(R"(%L?\d+|%L?n|\{\w+\}|&\w+;|&.|<[^<>]+>|\([^()]*\*[^()]*\))"));
    QString result = QStringLiteral("[");
    qsizetype at = 0;
    qsizetype letters = 0;
    auto addAccented = [&](qsizetype end) {
        for (; at < end; ++at) {
            result += accented(text[at]);
            ++letters;
        }
    };
    auto matches = kept.globalMatch(text);
    while (matches.hasNext()) {
        const QRegularExpressionMatch match = matches.next();
        addAccented(match.capturedStart());
        result += match.captured();
        at = match.capturedEnd();
    }
    addAccented(text.size());
    return result + QString((2 * letters + 4) / 5, QLatin1Char('~')) + QLatin1Char(']');
}

QString PseudoTranslator::translate(const char* context, const char* source, const char* /*disambiguation*/,
                                    int /*count*/) const
{
    const QString text = QString::fromUtf8(source);
    return isData(context, text) ? QString() : pseudoTranslated(text);
}

} // namespace quadrille

#include "moc_pseudolanguage.cpp"
