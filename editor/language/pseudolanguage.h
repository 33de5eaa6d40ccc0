// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QTranslator>

namespace quadrille {

/// Code of a language that nobody speaks; it shows which texts cannot be translated and which have no room to
/// grow.
QString pseudoLanguage();

/// A text as the pseudo-language says it: in brackets, with accents, two fifths longer. Placeholders,
/// mnemonics, markup and patterns of file names stay. A blank text stays as it is.
QString pseudoTranslated(const QString& text);

/// Translates every text of the program and of Qt into the pseudo-language.
class PseudoTranslator : public QTranslator
{
    Q_OBJECT
public:
    using QTranslator::QTranslator;
    bool isEmpty() const override { return false; }
    QString translate(const char* context, const char* source, const char* disambiguation,
                      int count) const override;
};

} // namespace quadrille
