// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/evaluationtexts.h"

#include "editor/documents/evaluationnames.h"

#include <QCoreApplication>
#include <QHash>
#include <array>

namespace quadrille {

namespace {

struct TableText
{
    const char* table;
    const char* title;
    const char* sentence;
};

/// As evaluationTables.
constexpr std::array tableTexts{
    TableText{"fig4", QT_TRANSLATE_NOOP("Evaluation", "Interpolated poses"),
              QT_TRANSLATE_NOOP("Evaluation", "How interpolated poses keep the lengths of edges and the "
                                              "volume, beside blended vertices (SMCAS Fig. 4)")},
    TableText{"fig7", QT_TRANSLATE_NOOP("Evaluation", "Kinds of transitions"),
              QT_TRANSLATE_NOOP("Evaluation", "Linear and warped transitions, with windows of one length and "
                                              "of any: cost, acceleration and length (SMCAS Fig. 7)")},
    TableText{"fig9", QT_TRANSLATE_NOOP("Evaluation", "Essential graph and motion graph"),
              QT_TRANSLATE_NOOP("Evaluation", "What ways through both graphs cost, and how dense the graphs "
                                              "are, for several α (SMCAS Fig. 9)")},
    TableText{"fig11", QT_TRANSLATE_NOOP("Evaluation", "Centre of a blend, constant weights"),
              QT_TRANSLATE_NOOP("Evaluation",
                                "The way of the body’s centre while two takes are blended half and half: "
                                "without alignment, aligned once, at every step (SMCAS Fig. 11)")},
    TableText{
        "fig12", QT_TRANSLATE_NOOP("Evaluation", "Centre of a blend, moving weights"),
        QT_TRANSLATE_NOOP("Evaluation", "The same while one take goes over into the other (SMCAS Fig. 12)")},
    TableText{"table1", QT_TRANSLATE_NOOP("Evaluation", "Pose distances and joint angles"),
              QT_TRANSLATE_NOOP("Evaluation", "How well pose distances agree with the joint angles of a "
                                              "motion capture beside the takes (SMCAS Table 1)")},
    TableText{
        "table2", QT_TRANSLATE_NOOP("Evaluation", "Poses at times"),
        QT_TRANSLATE_NOOP(
            "Evaluation",
            "Random poses at random times: when each was wanted and when the walk shows it (SMCAS Table 2)")},
    TableText{"junctions", QT_TRANSLATE_NOOP("Evaluation", "What shows at transitions"),
              QT_TRANSLATE_NOOP("Evaluation", "Random transitions measured against their takes: "
                                              "accelerations, frozen frames, steps, sliding feet, volume")},
    TableText{"density", QT_TRANSLATE_NOOP("Evaluation", "What makes graphs dense"),
              QT_TRANSLATE_NOOP("Evaluation",
                                "How dense both graphs are when one thing at a time is another: "
                                "divisor of costs, longest window, takes joined, as published")},
    TableText{"walks", QT_TRANSLATE_NOOP("Evaluation", "Walks along five paths"),
              QT_TRANSLATE_NOOP("Evaluation", "How calm walks along a straight line, an S, a circle, a right "
                                              "angle and a figure of eight are, and how their feet stand")},
    TableText{"cvs-fig4", QT_TRANSLATE_NOOP("Evaluation", "Poses that models reconstruct"),
              QT_TRANSLATE_NOOP("Evaluation", "How far models of variations are from the poses that they "
                                              "learned, beside principal components (CVS Fig. 4)")},
    TableText{"cvs-fig7", QT_TRANSLATE_NOOP("Evaluation", "Blends in latent space"),
              QT_TRANSLATE_NOOP("Evaluation", "How far interpolated blends are from true ones, with and "
                                              "without learned ones between (CVS Fig. 7)")},
    TableText{"variations", QT_TRANSLATE_NOOP("Evaluation", "What shows of variations"),
              QT_TRANSLATE_NOOP("Evaluation", "Variations beside the takes that they vary: accelerations, "
                                              "sliding feet, heights, headings, lengths, what was rejected")},
    TableText{"fig17", QT_TRANSLATE_NOOP("Evaluation", "Compactness, SSIM"),
              QT_TRANSLATE_NOOP("Evaluation",
                                "How well Eigen textures and Eigen warps restore textures by their number, "
                                "beside naive principal components: structural similarity (SMCAS Fig. 17)")},
    TableText{"fig18", QT_TRANSLATE_NOOP("Evaluation", "Compactness, squared error"),
              QT_TRANSLATE_NOOP("Evaluation", "The same as mean squared error (SMCAS Fig. 18)")},
    TableText{"fig19", QT_TRANSLATE_NOOP("Evaluation", "Generalisation, SSIM"),
              QT_TRANSLATE_NOOP("Evaluation", "How well textures that were left out are restored by how many "
                                              "were learned from: structural similarity (SMCAS Fig. 19)")},
    TableText{"fig20", QT_TRANSLATE_NOOP("Evaluation", "Generalisation, squared error"),
              QT_TRANSLATE_NOOP("Evaluation", "The same as mean squared error (SMCAS Fig. 20)")},
    TableText{"fig22", QT_TRANSLATE_NOOP("Evaluation", "Eigen textures of interpolated textures"),
              QT_TRANSLATE_NOOP("Evaluation", "How near textures midway between two frames come to those "
                                              "with all Eigen textures, by their number (SMCAS Fig. 22)")},
    TableText{"appearance-interpolation", QT_TRANSLATE_NOOP("Evaluation", "Interpolated textures"),
              QT_TRANSLATE_NOOP("Evaluation", "Textures midway between two frames, by the model and blended, "
                                              "against the captured one in the middle")},
    TableText{"appearance-shape", QT_TRANSLATE_NOOP("Evaluation", "Textures learned from poses"),
              QT_TRANSLATE_NOOP("Evaluation",
                                "Textures of the poses of a take that was left out: of the nearest frame of "
                                "the others, their mean, and learned from poses")},
    TableText{
        "appearance-rates", QT_TRANSLATE_NOOP("Evaluation", "Bytes of textures"),
        QT_TRANSLATE_NOOP(
            "Evaluation",
            "What files of models, JPEG pictures and H.264 films of the textures take, and what they lose")},
    TableText{
        "transfer-error", QT_TRANSLATE_NOOP("Evaluation", "Transfers and their truth"),
        QT_TRANSLATE_NOOP("Evaluation",
                          "How far transfers are from what they ought to be, where that is known: with "
                          "quaternions and logarithms, with and without correction of the pose and stretch")},
    TableText{"ia4d-table1", QT_TRANSLATE_NOOP("Evaluation", "Hybrid blends"),
              QT_TRANSLATE_NOOP("Evaluation", "How far blends of motion spaces are from non-linear ones, and "
                                              "what they take, by the number of references (IA4D Table 1)")},
    TableText{"ia4d-fig4", QT_TRANSLATE_NOOP("Evaluation", "Hybrid blends from take to take"),
              QT_TRANSLATE_NOOP("Evaluation", "The same along the ways from take to take (IA4D Fig. 4)")},
    TableText{"ia4d-table2", QT_TRANSLATE_NOOP("Evaluation", "Transitions between motion spaces"),
              QT_TRANSLATE_NOOP("Evaluation", "What transitions cost and how long they take: found while "
                                              "spaces play, and computed before (IA4D Table 2)")},
    TableText{"ia4d-table3", QT_TRANSLATE_NOOP("Evaluation", "Interpolated distances of poses"),
              QT_TRANSLATE_NOOP("Evaluation", "How far distances that are interpolated between takes are "
                                              "from true ones (IA4D Table 3)")},
};
static_assert(tableTexts.size() == evaluationTables.size());

QString translated(const char* text)
{
    return QCoreApplication::translate("Evaluation", text);
}

const TableText* textsOf(const QString& table)
{
    for (const TableText& texts : tableTexts)
        if (table == QLatin1String(texts.table))
            return &texts;
    return nullptr;
}

} // namespace

QString evaluationTitle(const QString& name)
{
    const QString table = name.section(QLatin1Char('/'), 0, 0);
    const QString character = name.section(QLatin1Char('/'), 1);
    const TableText* texts = textsOf(table);
    QString title = texts == nullptr ? table : translated(texts->title);
    if (character.isEmpty())
        return title;
    //: an evaluation and the character that it is of
    return QCoreApplication::translate("Evaluation", "%1 · %2").arg(title, character);
}

QString evaluationSentence(const QString& name)
{
    const TableText* texts = textsOf(name.section(QLatin1Char('/'), 0, 0));
    return texts == nullptr ? QString() : translated(texts->sentence);
}

} // namespace quadrille
