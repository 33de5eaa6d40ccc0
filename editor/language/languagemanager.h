// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/language/pseudolanguage.h"

#include <QObject>
#include <QString>
#include <QTranslator>
#include <vector>

namespace quadrille {

struct Language
{
    QString code; ///< "fr"; "en" for the language of the sources
    QString name; ///< as its speakers write it: "Français"
};

/// The language of the interface: our catalogue and Qt's own, exchanged while the program runs. Widgets hear
/// of it as QEvent::LanguageChange (see retranslate.h).
class LanguageManager : public QObject
{
    Q_OBJECT
public:
    explicit LanguageManager(QObject* parent = nullptr);
    ~LanguageManager() override;

    /// English and every catalogue that the program was built with.
    static std::vector<Language> languages();

    /// \param code of one of the languages; empty or unknown: what the system asks for, else English.
    ///             The pseudo-language is known, though not among languages().
    void setLanguage(const QString& code);
    /// The code of the language that is shown.
    const QString& language() const { return m_language; }

signals:
    void changed();

private:
    void load(QTranslator& translator, const QString& file);

    QString m_language;
    QTranslator m_own;
    QTranslator m_qt;
    PseudoTranslator m_pseudo;
};

} // namespace quadrille
