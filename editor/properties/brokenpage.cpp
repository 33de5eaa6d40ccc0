// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/brokenpage.h"

#include "editor/commands/brokenedits.h"
#include "editor/context/editorcontext.h"
#include "model/project/document/brokenentry.h"
#include "model/project/json/keptjson.h"

#include <QFontDatabase>
#include <QPlainTextEdit>
#include <QPushButton>

namespace quadrille {

BrokenPage::BrokenPage(EditorContext& context)
    : m_context(context), m_text(new QPlainTextEdit), m_readAgain(new QPushButton), m_remove(new QPushButton)
{
    m_problem = addFact("brokenProblem", [] { return tr("Problem"); });
    m_place = addFact("brokenPlace", [] { return tr("Place"); });
    m_text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_text->setTabChangesFocus(true);
    m_text->setMinimumHeight(200);
    addWide("brokenText", m_text);
    addWide("brokenReadAgain", m_readAgain);
    addWide("brokenRemove", m_remove);
    connect(m_readAgain, &QPushButton::clicked, this, [this] {
        m_text->setFocus(); // a sentence about it goes beside it
        setBroken(m_context.document, m_title, m_text->toPlainText());
    });
    connect(m_remove, &QPushButton::clicked, this, [this] { removeBroken(m_context.document, {m_title}); });
    retranslate();
}

void BrokenPage::show(const QString& title)
{
    const BrokenEntry entry = *findBroken(m_context.document.project(), title.toStdString());
    const ErrorText problem = describe(Error(entry.problem.code, entry.problem.context));
    m_problem->setText(problem.remedy.isEmpty()
                           ? problem.sentence
                           : tr("%1 %2", "sentence and remedy").arg(problem.sentence, problem.remedy));
    m_place->setText(problem.where);
    const QString text = QString::fromStdString(textOf(entry.json)).trimmed();
    if (m_title != title || m_shown != text)
        m_text->setPlainText(text);
    m_title = title;
    m_shown = text;
}

void BrokenPage::retranslate()
{
    m_text->setAccessibleName(tr("Text in the file"));
    m_readAgain->setText(tr("Read again"));
    m_readAgain->setToolTip(
        tr("Takes the corrected text over; until then the entry stays as it is in the file"));
    m_remove->setText(tr("Remove from the project"));
}

} // namespace quadrille

#include "moc_brokenpage.cpp"
