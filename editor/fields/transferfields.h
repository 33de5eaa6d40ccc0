// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldform.h"
#include "model/project/document/transferentry.h"

#include <QCoreApplication>
#include <functional>

namespace quadrille {

struct Project;

struct TransferTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::TransferFields)
};

/// Object names of what a transfer is of, and of how it is made.
struct TransferNames
{
    const char* clip;
    const char* target;
    const char* reference;
    const char* field;
    const char* scale;
    const char* poses;
    const char* stretch;
    const char* surroundings;
    const char* contacts;
    const char* truth;
};

/// What can be performed: takes, animations and other transfers of a project.
std::vector<FieldItem<std::string>> clipItems(const Project& project, const TransferEntry& transfer);
/// What can perform it: all takes.
std::vector<FieldItem<std::string>> targetItems(const Project& project);
/// The template's poses that can be named: where its takes begin, and the one that is.
std::vector<FieldItem<std::optional<NamedFrame>>> referenceItems(const Project& project,
                                                                 const TransferEntry& transfer);
/// What it ought to be: takes of the body that performs it.
std::vector<FieldItem<std::string>> truthItems(const Project& project, const TransferEntry& transfer);
/// Pairs of triangles mean nothing on other meshes: these are lost with the character; so is what another
/// clip or body ought to show.
void setClip(TransferEntry& transfer, const std::string& clip, const Project& project);
void setTarget(TransferEntry& transfer, const std::string& sequence, const Project& project);

/// What is performed, and by whom. \param project  that of now.
template <typename Form>
void addTransferSubjects(FieldForm<TransferEntry, Form>& fields, const TransferNames& names,
                         const std::function<const Project&()>& project)
{
    auto clip = lensOf<TransferEntry>(&TransferEntry::clip);
    clip.set = [project](TransferEntry& entry, const std::string& name) { setClip(entry, name, project()); };
    fields.addItems(
        {names.clip, [] { return TransferTexts::tr("Clip"); },
         [] { return TransferTexts::tr("What is performed: a take, an animation or another transfer"); }},
        clip, [project](const TransferEntry& entry) { return clipItems(project(), entry); });
    Lens<TransferEntry, std::string> target;
    target.get = [](const TransferEntry& entry) { return entry.target.sequence; };
    target.set = [project](TransferEntry& entry, const std::string& name) {
        setTarget(entry, name, project());
    };
    fields.addItems({names.target, [] { return TransferTexts::tr("Performed by"); },
                     [] {
                         return TransferTexts::tr(
                             "The body that performs it: a scan or a take of another character, in "
                             "its first frame");
                     }},
                    target, [project](const TransferEntry& /*entry*/) { return targetItems(project()); });
}

/// How it is made.
template <typename Form>
void addTransferSettings(FieldForm<TransferEntry, Form>& fields, const TransferNames& names,
                         const std::function<const Project&()>& project)
{
    fields.addItems({names.reference, [] { return TransferTexts::tr("Reference pose"); },
                     [] {
                         return TransferTexts::tr(
                             "The pose of the template that the body's is like; the nearer it is, "
                             "the better the result");
                     }},
                    &TransferEntry::reference,
                    [project](const TransferEntry& entry) { return referenceItems(project(), entry); });
    fields.addChoice(
        {names.field, [] { return TransferTexts::tr("Rotations"); },
         [] {
             return TransferTexts::tr("What of the rotations of paired triangles is spread over the body: "
                                      "logarithms turn evenly where a part turns far");
         }},
        &TransferEntry::field,
        {[] { return TransferTexts::tr("Quaternions"); }, [] { return TransferTexts::tr("Logarithms"); }});
    fields.addNumber({names.scale, [] { return TransferTexts::tr("Scale of the way"); },
                      [] {
                          return TransferTexts::tr(
                              "Of the way over the ground and of heights above it; by itself what "
                              "the steps of the body ask for");
                      }},
                     &TransferEntry::scale,
                     {.path = "transfer.scale",
                      .step = 0.05,
                      .automatic = [] { return TransferTexts::tr("by itself"); },
                      .first = 1});
    fields.addSwitch({names.poses, [] { return TransferTexts::tr("Correct the pose"); },
                      [] {
                          return TransferTexts::tr(
                              "Limbs that the body holds otherwise than the template does in the "
                              "reference pose are brought there first: the arms of a scan in A- or "
                              "T-pose");
                      }},
                     &TransferEntry::correctsPose);
    fields.addSwitch({names.stretch, [] { return TransferTexts::tr("Carry stretch"); },
                      [] {
                          return TransferTexts::tr(
                              "How the skin of the template stretches and is pressed together about "
                              "each pair is carried as well, so that bends keep their volume; else "
                              "rotations only");
                      }},
                     &TransferEntry::carriesStretch);
    fields.addSwitch({names.surroundings, [] { return TransferTexts::tr("Hold surroundings"); },
                      [] {
                          return TransferTexts::tr(
                              "Each pair stands for what lies about it, some 8 cm on a grown-up, so that "
                              "bends stay where they are however fine the body is; else for single "
                              "triangles");
                      }},
                     &TransferEntry::marksSurroundings);
    fields.addSwitch(
        {names.contacts, [] { return TransferTexts::tr("Correct contacts"); },
         [] { return TransferTexts::tr("Feet that stand in the clip stand still in the result as well"); }},
        &TransferEntry::correctsContacts);
    fields.addItems({names.truth, [] { return TransferTexts::tr("Truth"); },
                     [] {
                         return TransferTexts::tr(
                             "A take of the body that shows what the result ought to be, for the "
                             "evaluation of transfers; the result does not depend on it");
                     }},
                    &TransferEntry::truth,
                    [project](const TransferEntry& entry) { return truthItems(project(), entry); });
}

} // namespace quadrille
