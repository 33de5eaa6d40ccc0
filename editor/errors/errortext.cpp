// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/errors/errortext.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <iterator>

namespace quadrille {

namespace {

struct Texts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::ErrorText)
};

/// The model marks its sentences with QUADRILLE_MESSAGE; translations/lupdate.py files them under this
/// context.
QString translated(const std::string& english)
{
    return english.empty() ? QString() : QCoreApplication::translate("quadrille", english.c_str());
}

/// Values that count something, with %1 for the number, which is written as it is.
constexpr const char* countedValues[] = {QT_TRANSLATE_NOOP("quadrille", "%1 frames"),
                                         QT_TRANSLATE_NOOP("quadrille", "%1 bytes"),
                                         QT_TRANSLATE_NOOP("quadrille", "at least %1 bytes"),
                                         QT_TRANSLATE_NOOP("quadrille", "a header of %1 bytes"),
                                         QT_TRANSLATE_NOOP("quadrille", "the header says %1 frames")};

QString translatedValue(const std::string& english)
{
    static const QRegularExpression number(QStringLiteral("\\d+"));
    const QString text = QString::fromStdString(english);
    const QRegularExpressionMatch match = number.match(text);
    const std::string counted = QString(text).replace(number, QStringLiteral("%1")).toStdString();
    if (!match.hasMatch() || std::ranges::find(countedValues, counted) == std::end(countedValues))
        return translated(english);
    return translated(counted).arg(match.captured());
}

QString filled(const char* english, const ErrorContext& context)
{
    ErrorContext values;
    for (const auto& [name, value] : context.values)
        values.values.emplace_back(name, translatedValue(value).toStdString());
    return QString::fromStdString(fillMessage(translated(english).toStdString(), values));
}

QString whereOf(const ErrorContext& context)
{
    QStringList parts;
    if (!context.file.empty())
        parts += QString::fromStdString(context.file.filename().string());
    if (context.place.line && context.place.column)
        parts += Texts::tr("line %1, column %2").arg(*context.place.line).arg(*context.place.column);
    else if (context.place.line)
        parts += Texts::tr("line %1").arg(*context.place.line);
    if (context.place.byte)
        parts += Texts::tr("byte %1").arg(*context.place.byte);
    if (context.place.frame)
        parts += Texts::tr("frame %1").arg(context.place.frame->value);
    return parts.join(Texts::tr(", ", "between the parts of a place"));
}

ErrorText textOf(const ErrorMessage& message, const ErrorContext& context)
{
    return {filled(message.sentence, context), whereOf(context), filled(message.remedy, context)};
}

} // namespace

QString ErrorText::placed() const
{
    return where.isEmpty() ? sentence : Texts::tr("%1 (%2)", "sentences and place").arg(sentence, where);
}

QString ErrorText::oneLine() const
{
    const QString said =
        remedy.isEmpty() ? sentence : Texts::tr("%1 %2", "sentence and remedy").arg(sentence, remedy);
    return where.isEmpty() ? said : Texts::tr("%1 (%2)", "sentences and place").arg(said, where);
}

ErrorText describe(const Error& error)
{
    return textOf(errorMessage(error.code()), error.context());
}

ErrorText describe(const Issue& issue)
{
    return textOf(issueMessage(issue.code), issue.context);
}

} // namespace quadrille
