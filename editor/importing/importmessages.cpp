// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/importing/importmessages.h"

#include "editor/commands/entrynames.h"
#include "editor/documents/projectpaths.h"
#include "editor/errors/errortext.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace quadrille {

namespace {

using Kind = widgets::MessageStrip::Kind;

struct Texts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::ImportDialog)
};

QString numberText(double number, int digits)
{
    return QLocale().toString(number, 'g', digits);
}

ImportMessage messageOf(const Error& error)
{
    const ErrorText text = describe(error);
    ImportMessage message{.kind = Kind::Error, .sentence = text.sentence, .remedy = text.remedy};
    if (!text.where.isEmpty())
        message.sentence = Texts::tr("%1 (%2)").arg(text.sentence, text.where);
    if (error.code() == ErrorCode::FormatNeedsMesh) {
        message.help = ImportMessage::Help::ChooseMesh;
        message.button = Texts::tr("Choose the mesh…");
    }
    return message;
}

/// Of the takes; that of the character is told beside its field.
std::optional<Error> problemWithNames(const ImportPlan& plan)
{
    for (const PlannedTake* planned : plan.wanted()) {
        if (auto problem = problemWithText(QString::fromStdString(planned->name)))
            return problem;
    }
    return std::nullopt;
}

ImportMessage messageOfRate(const std::vector<const PlannedTake*>& guessed)
{
    return {.kind = Kind::Warning,
            .sentence =
                Texts::tr("The rate of %n take(s) is not known.", nullptr, static_cast<int>(guessed.size())),
            .remedy = Texts::tr("Set the rate at which they were captured."),
            .help = ImportMessage::Help::ConfirmRate,
            .button = Texts::tr("%1 fps is right").arg(numberText(guessed.front()->rate.fps, 5))};
}

} // namespace

ImportMessage importMessage(const ImportPlan& plan, const PlannedTake* current)
{
    if (current == nullptr)
        return {};
    if (current->take.error)
        return messageOf(*current->take.error);
    if (const auto problem = problemWithNames(plan)) {
        ImportMessage message = messageOf(*problem);
        message.forbidsImport = true;
        return message;
    }
    const double height = plan.heightOf(current->take);
    if (height < 0.3 || height > 3.5)
        return {.kind = Kind::Warning,
                .sentence = Texts::tr("The figure would be %1 m high.").arg(numberText(height, 3)),
                .remedy = Texts::tr("Choose the unit and the up axis of the file.")};
    if (const auto guessed = plan.withUnknownRate(); !guessed.empty())
        return messageOfRate(guessed);
    return {};
}

QString importNotes(const PlannedTake& planned)
{
    QStringList notes;
    for (const Issue& issue : planned.take.issues) {
        if (issue.code != Issue::Code::FpsAssumed) // stands beside, to be set
            notes += QStringLiteral("• ") + describe(issue).oneLine();
    }
    if (!planned.take.jointAngles.empty())
        notes += QStringLiteral("• ") +
                 Texts::tr("Reference joint angles: %1").arg(toQString(planned.take.jointAngles.filename()));
    return notes.join(QLatin1Char('\n'));
}

QString rateReason(const PlannedTake& planned)
{
    if (!planned.take.sequence || planned.take.sequence->frameCount() < 2)
        return {};
    if (planned.take.hasOwnFps)
        return Texts::tr("The file says so.");
    if (planned.isRateChosen)
        return Texts::tr("As you set it.");
    if (planned.rate.beside)
        return Texts::tr("As in %1 beside it.").arg(toQString(planned.rate.beside->file.filename()));
    if (planned.rate.isOfOthers)
        return Texts::tr("As the other takes of the character.");
    if (planned.take.isSampled)
        return Texts::tr("A guess: its keys are uneven, or too few to tell a rate.");
    return Texts::tr("A guess: nothing beside the take names its rate.");
}

std::optional<Issue> rateIssue(const PlannedTake& planned)
{
    const QString reason = rateReason(planned);
    if (reason.isEmpty() || planned.take.hasOwnFps || planned.isRateChosen)
        return std::nullopt;
    const QString text = Texts::tr("%1 fps are taken for it. %2", "a rate, and a sentence with the reason")
                             .arg(numberText(planned.rate.fps, 5), reason);
    Issue issue{.severity = planned.rate.isGuess() ? Issue::Severity::Warning : Issue::Severity::Info,
                .code = Issue::Code::Other};
    issue.context = {.file = planned.take.source, .values = {{"text", text.toStdString()}}};
    return issue;
}

QString importText(const ImportPlan& plan)
{
    const auto count = static_cast<int>(plan.wanted().size());
    if (count == 0)
        return Texts::tr("Import");
    const auto guessed = plan.withUnknownRate();
    if (guessed.empty())
        return Texts::tr("Import %n take(s)", nullptr, count);
    return Texts::tr("Import %n take(s) at %1 fps", nullptr, count)
        .arg(numberText(guessed.front()->rate.fps, 5));
}

} // namespace quadrille
