// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/sealedfile.h"

#include <QCryptographicHash>
#include <QFile>
#include <QJsonDocument>
#include <QSaveFile>
#include <optional>

namespace quadrille {

namespace {

constexpr auto formatKey = QLatin1String("format");
constexpr auto checksumKey = QLatin1String("checksum");
constexpr qint64 largestFile = qint64(4) << 20U; // bytes; usual ones have some thousands

/// Of everything but itself.
QString checksumOf(QJsonObject values)
{
    values.remove(checksumKey);
    const QByteArray compact = QJsonDocument(values).toJson(QJsonDocument::Compact);
    return QString::fromLatin1(QCryptographicHash::hash(compact, QCryptographicHash::Sha1).toHex());
}

/// Nothing when the file cannot be used.
std::optional<QJsonObject> contentsOf(QFile& file, int format)
{
    if (file.size() > largestFile)
        return std::nullopt;
    const QJsonDocument document = QJsonDocument::fromJson(file.readAll());
    if (!document.isObject())
        return std::nullopt;
    const QJsonObject values = document.object();
    if (!values.contains(formatKey))
        return QJsonObject();
    if (values[formatKey].toInt() != format || values[checksumKey].toString() != checksumOf(values))
        return std::nullopt;
    return values;
}

} // namespace

SealedContents readSealed(const QString& path, int format)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    if (const auto values = contentsOf(file, format))
        return {*values, {}};
    file.close();
    const QString aside = path + QStringLiteral(".aside");
    QFile::remove(aside);
    QFile::rename(path, aside);
    return {{}, aside};
}

bool writeSealed(const QString& path, QJsonObject values, int format)
{
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return false;
    values[formatKey] = format;
    values[checksumKey] = checksumOf(values);
    file.write(QJsonDocument(values).toJson());
    return file.commit();
}

} // namespace quadrille
