// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/context/actionregistry.h"
#include "editor/context/settings.h"
#include "editor/documents/animationresults.h"
#include "editor/documents/appearanceresults.h"
#include "editor/documents/bodyproblems.h"
#include "editor/documents/evaluationresults.h"
#include "editor/documents/graphresults.h"
#include "editor/documents/livegraphresults.h"
#include "editor/documents/motionspaceresults.h"
#include "editor/documents/projectdocument.h"
#include "editor/documents/selection.h"
#include "editor/documents/sequencemedia.h"
#include "editor/documents/transferresults.h"
#include "editor/documents/variationresults.h"
#include "editor/errors/issuelog.h"
#include "editor/jobs/jobrunner.h"
#include "editor/language/languagemanager.h"

namespace quadrille {

/// What everything in a window works on. Panels, dialogs and workspaces take it by reference and talk to each
/// other through it alone. Members are made in this order and destroyed in the opposite one: later ones refer
/// to earlier ones.
struct EditorContext
{
    EditorContext()
        : actions(settings)
        , selection(document)
        , media(document, jobs)
        , graphs(document, jobs)
        , animations(document, graphs, jobs)
        , variations(document, jobs)
        , motionSpaces(document, jobs)
        , evaluations(document, jobs)
        , liveGraphs(document, jobs)
        , appearances(document, jobs)
        , transfers(document, jobs)
    {
        // Clips have the textures of a model; those of animations follow their graph.
        QObject::connect(&appearances, &AppearanceResults::texturesMade, &media, &SequenceMedia::refresh);
        QObject::connect(&appearances, &AppearanceResults::texturesMade, &graphs, &GraphResults::reopen);
        QObject::connect(&appearances, &AppearanceResults::texturesMade, &variations,
                         &VariationResults::reopen);
        QObject::connect(&transfers, &TransferResults::computed, &media, &SequenceMedia::refresh);
        // Transfers are made of clips.
        QObject::connect(&animations, &AnimationResults::changed, &transfers, [this](const QString& name) {
            const AnimationResults::State* state = animations.resultState(name);
            if (state != nullptr && state->phase == ResultPhase::Ready)
                transfers.refresh();
        });
        languages.setLanguage(settings.language());
    }

    Settings settings;
    LanguageManager languages;
    ActionRegistry actions;
    IssueLog issues;
    JobRunner jobs;
    ProjectDocument document;
    Selection selection;
    SequenceMedia media;
    GraphResults graphs;
    AnimationResults animations;
    VariationResults variations;
    MotionSpaceResults motionSpaces;
    EvaluationResults evaluations;
    LiveGraphResults liveGraphs;
    AppearanceResults appearances;
    TransferResults transfers;
    BodyProblems bodies;
};

} // namespace quadrille
