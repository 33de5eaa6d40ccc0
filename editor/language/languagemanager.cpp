// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/language/languagemanager.h"

#include <QCoreApplication>
#include <QDir>
#include <QGuiApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <algorithm>
#include <array>

namespace quadrille {

namespace {

struct Word
{
    const char* text;
    const char* comment;
};

/// What Qt shows in dialogs of files and has in none of its own catalogues.
[[maybe_unused]] constexpr std::array<Word, 2> wordsOfQt{
    {QT_TRANSLATE_NOOP3("QAbstractFileIconProvider", "Folder", "All other platforms"),
     QT_TRANSLATE_NOOP3("QAbstractFileIconProvider", "Drive", "")}};

QString catalogueFolder()
{
    return QStringLiteral(":/translations");
}

Language languageOf(const QString& code)
{
    QString name = QLocale(code).nativeLanguageName();
    if (code == QLatin1String("en"))
        name = QStringLiteral("English"); // not "American English"
    if (!name.isEmpty())
        name[0] = name[0].toUpper();
    return {code, name};
}

bool isKnown(const QString& code)
{
    return code == pseudoLanguage() ||
           std::ranges::any_of(LanguageManager::languages(),
                               [&code](const Language& language) { return language.code == code; });
}

QString systemLanguage()
{
    for (const QString& wanted : QLocale::system().uiLanguages()) {
        QString code = wanted.section(QLatin1Char('-'), 0, 0);
        if (isKnown(code))
            return code;
    }
    return QStringLiteral("en");
}

} // namespace

LanguageManager::LanguageManager(QObject* parent) : QObject(parent) {}

LanguageManager::~LanguageManager() = default;

std::vector<Language> LanguageManager::languages()
{
    std::vector<Language> languages{languageOf(QStringLiteral("en"))};
    const QString prefix = QStringLiteral("quadrille_");
    for (const QFileInfo& file : QDir(catalogueFolder()).entryInfoList({prefix + QStringLiteral("*.qm")})) {
        const QString code = file.completeBaseName().mid(prefix.size());
        if (code != QLatin1String("en"))
            languages.push_back(languageOf(code));
    }
    return languages;
}

void LanguageManager::setLanguage(const QString& code)
{
    const QString language = isKnown(code) ? code : systemLanguage();
    if (language == m_language)
        return;
    m_language = language;
    // Regional habits (decimal comma, dates) stay the system's where it speaks the language.
    const QLocale system = QLocale::system();
    const QLocale locale = system.language() == QLocale(language).language() ? system : QLocale(language);
    QLocale::setDefault(locale);
    QCoreApplication::removeTranslator(&m_pseudo);
    if (language == pseudoLanguage())
        QCoreApplication::installTranslator(&m_pseudo);
    load(m_qt, QLibraryInfo::path(QLibraryInfo::TranslationsPath) + QStringLiteral("/qtbase_") + language);
    load(m_own, catalogueFolder() + QStringLiteral("/quadrille_") + language);
    QGuiApplication::setLayoutDirection(locale.textDirection());
    emit changed();
}

void LanguageManager::load(QTranslator& translator, const QString& file)
{
    QCoreApplication::removeTranslator(&translator);
    if (translator.load(file))
        QCoreApplication::installTranslator(&translator);
}

} // namespace quadrille

#include "moc_languagemanager.cpp"
