// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/projectquestions.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <utility>
#include <vector>

namespace quadrille::questions {

namespace {

struct QuestionTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::ProjectQuestions)
};

template <typename Answer>
struct Choice
{
    Answer answer;
    const char* name; ///< of the button
    QString text;
    QMessageBox::ButtonRole role = QMessageBox::AcceptRole;
};

/// Asks a question whose buttons are the choices, the first being the default, and Cancel.
template <typename Answer>
Answer ask(QWidget* window, const char* name, const QString& sentence, const QString& remedy,
           const std::vector<Choice<Answer>>& choices, Answer fallback)
{
    QMessageBox box(QMessageBox::Warning, QStringLiteral("Quadrille"), sentence, QMessageBox::Cancel, window);
    box.setObjectName(QLatin1String(name));
    box.setInformativeText(remedy);
    std::vector<std::pair<QAbstractButton*, Answer>> buttons;
    for (const auto& choice : choices) {
        QPushButton* button = box.addButton(choice.text, choice.role);
        button->setObjectName(QLatin1String(choice.name));
        if (buttons.empty())
            box.setDefaultButton(button);
        buttons.emplace_back(button, choice.answer);
    }
    box.setEscapeButton(QMessageBox::Cancel);
    box.exec();
    for (const auto& [button, answer] : buttons) {
        if (box.clickedButton() == button)
            return answer;
    }
    return fallback;
}

} // namespace

Locked askLocked(QWidget* window, const QString& title, const QString& holder)
{
    return ask<Locked>(
        window, "projectLocked", QuestionTexts::tr("“%1” is open elsewhere: %2.").arg(title, holder),
        QuestionTexts::tr(
            "Two who save the same project write over each other's work. Taken over, it cannot be "
            "saved there any more without being asked."),
        {{Locked::OpenCopy, "lockedCopy", QuestionTexts::tr("Open a copy")},
         {Locked::ReadOnly, "lockedReadOnly", QuestionTexts::tr("Read only")},
         {Locked::TakeOver, "lockedTakeOver", QuestionTexts::tr("Take over"), QMessageBox::DestructiveRole}},
        Locked::Cancel);
}

Unwritable askUnwritable(QWidget* window, const QString& sentence, bool canTakeOver)
{
    std::vector<Choice<Unwritable>> choices{
        {Unwritable::SaveAs, "unwritableSaveAs", QuestionTexts::tr("Save as…")}};
    if (canTakeOver)
        choices.push_back({Unwritable::TakeOver, "unwritableTakeOver",
                           QuestionTexts::tr("Take over and save"), QMessageBox::DestructiveRole});
    return ask<Unwritable>(window, "projectUnwritable", sentence,
                           QuestionTexts::tr("Save it under another name to keep your edits."), choices,
                           Unwritable::Cancel);
}

Changed askChanged(QWidget* window, const QString& title)
{
    return ask<Changed>(
        window, "projectChanged",
        QuestionTexts::tr("The file of “%1” was changed by somebody else since it was opened.").arg(title),
        QuestionTexts::tr("Overwriting it loses their edits; reloading it loses yours."),
        {{Changed::SaveAs, "changedSaveAs", QuestionTexts::tr("Save as…")},
         {Changed::Overwrite, "changedOverwrite", QuestionTexts::tr("Overwrite"),
          QMessageBox::DestructiveRole},
         {Changed::Reload, "changedReload", QuestionTexts::tr("Reload"), QMessageBox::DestructiveRole}},
        Changed::Cancel);
}

bool mayReload(QWidget* window, const QString& title)
{
    return ask<bool>(window, "projectReload", QuestionTexts::tr("Reload “%1”?").arg(title),
                     QuestionTexts::tr("Your unsaved edits are lost then."),
                     {{true, "reloadAccept", QuestionTexts::tr("Reload"), QMessageBox::DestructiveRole}},
                     false);
}

bool mayOpenBackup(QWidget* window, const QString& title, const QString& problem, const QDateTime& saved)
{
    return ask<bool>(
        window, "projectBackup",
        QuestionTexts::tr("“%1” cannot be opened. %2", "project and problem").arg(title, problem),
        QuestionTexts::tr("The backup beside it, of %1, can. It takes the project's place when you save.")
            .arg(QLocale().toString(saved, QLocale::ShortFormat)),
        {{true, "backupAccept", QuestionTexts::tr("Open the backup")}}, false);
}

} // namespace quadrille::questions
