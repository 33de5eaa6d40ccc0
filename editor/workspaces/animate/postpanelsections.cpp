// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The settings that the panel shows.
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/postpanel.h"
#include "model/synthesis/finishing/monotonecurve.h"
#include "model/synthesis/walks/constraints.h"
#include "widgets/charts/curveeditor.h"
#include "widgets/controls/elidedbutton.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <algorithm>
#include <numbers>

namespace quadrille {

namespace {

constexpr double hundredth = 0.01;
constexpr double degree = std::numbers::pi / 180;

enum class RetimeKind
{
    None,
    Factor,
    Duration,
    Curve
};

RetimeKind retimeKindOf(const AnimationEntry& entry)
{
    const auto& retime = entry.post.steps.retime;
    return retime ? static_cast<RetimeKind>(1 + retime->time.index()) : RetimeKind::None;
}

bool isKind(const AnimationEntry& entry, RetimeKind kind)
{
    return retimeKindOf(entry) == kind;
}

QList<QPointF> toPoints(const RetimeSettings::Curve& curve)
{
    QList<QPointF> points;
    for (const RetimePoint& point : curve)
        points += QPointF(point.output.value - curve.front().output.value, point.clip.value);
    return points;
}

RetimeSettings::Curve toCurve(const QList<QPointF>& points)
{
    RetimeSettings::Curve curve;
    for (const QPointF& point : points)
        curve.push_back({Seconds{point.x()}, Seconds{point.y()}});
    return curve;
}

using Steps = PostProcessing;

/// Of the steps of an animation.
template <typename Member>
auto step(Member member)
{
    return at(&AnimationEntry::post, &PostProcessingEntry::steps, member);
}

/// A switch for a step that has settings of its own: on with the usual ones.
template <typename Settings>
Lens<AnimationEntry, bool> presenceOf(std::optional<Settings> Steps::*settings)
{
    return {[=](const AnimationEntry& entry) { return (entry.post.steps.*settings).has_value(); },
            [=](AnimationEntry& entry, bool on) {
                entry.post.steps.*settings = on ? std::optional(Settings()) : std::nullopt;
            }};
}

QString percentText()
{
    return QCoreApplication::translate("quadrille::PostPanel", " %", "unit of a number");
}

QString secondsText()
{
    return QCoreApplication::translate("quadrille::PostPanel", " s", "unit of a number");
}

} // namespace

void PostPanel::addLoop()
{
    const auto hasLoop = [](const AnimationEntry& entry) { return entry.post.steps.loop.has_value(); };
    const auto of = [](auto member) { return lensInside<AnimationEntry>(step(&Steps::loop), member); };
    NumberLook cut{.path = "loop.cut_start", .unit = secondsText, .automatic = [] { return tr("a third"); }};
    auto loop = presenceOf(&Steps::loop);
    loop.set = [set = loop.set](AnimationEntry& entry, bool on) {
        set(entry, on);
        if (!on)
            entry.post.steps.repeats = 1;
    };
    m_form->addHeading([] { return tr("Loop"); });
    m_loop = m_fields.addSwitch(
        {"postLoop", [] { return tr("Close to a seamless loop"); },
         [] { return tr("Cuts both ends where they fit best and blends one into the other"); }},
        loop);
    m_fields.addNumber({"postCutStart", [] { return tr("Cut at the start"); },
                        [] { return tr("How far from the first frame the loop may begin"); }, hasLoop},
                       of(&LoopSettings::cutStart), cut);
    cut.path = "loop.cut_end";
    m_fields.addNumber({"postCutEnd", [] { return tr("Cut at the end"); },
                        [] { return tr("How far from the last frame the loop may end"); }, hasLoop},
                       of(&LoopSettings::cutEnd), cut);
    m_fields.addSwitch(
        {"postInPlace", [] { return tr("Stay in place"); },
         [] { return tr("Takes the way over the ground out, so that each round begins where it began"); },
         hasLoop},
        of(&LoopSettings::inPlace));
    m_repeats = m_fields.addNumber(
        {"postRepeats", [] { return tr("Repeats"); }, [] { return tr("How often the loop plays"); }},
        step(&Steps::repeats), {.path = "post.repeats", .step = 1, .decimals = 0, .unit = [] {
                                    return tr(" ×", "how many times");
                                }});
}

void PostPanel::addRetime()
{
    const auto hasKind = [](RetimeKind kind) {
        return [kind](const AnimationEntry& entry) { return isKind(entry, kind); };
    };
    m_form->addHeading([] { return tr("Time"); });
    m_retime = m_fields.addChoice(
        {"postRetime", [] { return tr("Retime"); },
         [] { return tr("Plays the clip faster or slower, as a whole or from moment to moment"); }},
        Lens<AnimationEntry, RetimeKind>{
            retimeKindOf,
            [this](AnimationEntry& entry, RetimeKind kind) { setRetimeKind(entry, static_cast<int>(kind)); }},
        {[] { return tr("Not at all"); }, [] { return tr("By a factor"); },
         [] { return tr("To a duration"); }, [] { return tr("By a curve"); }});
    m_fields.addNumber(
        {"postFactor", [] { return tr("Factor"); },
         [] { return tr("Times as long as the clip: 2 is half as fast"); }, hasKind(RetimeKind::Factor)},
        Lens<AnimationEntry, double>{
            [](const AnimationEntry& entry) {
                return isKind(entry, RetimeKind::Factor)
                           ? std::get<RetimeFactor>(entry.post.steps.retime->time).value
                           : 1.0;
            },
            [](AnimationEntry& entry, double value) { entry.post.steps.retime->time = RetimeFactor{value}; }},
        {.path = "retime.factor",
         .step = 0.05,
         .unit = [] { return tr(" ×", "how many times"); },
         .lowest = 0.05,
         .highest = 1000});
    m_fields.addNumber(
        {"postDuration", [] { return tr("Duration"); }, [] { return tr("How long the result lasts"); },
         hasKind(RetimeKind::Duration)},
        Lens<AnimationEntry, double>{
            [this](const AnimationEntry& entry) {
                return isKind(entry, RetimeKind::Duration)
                           ? std::get<Seconds>(entry.post.steps.retime->time).value
                           : clipSeconds();
            },
            [](AnimationEntry& entry, double value) { entry.post.steps.retime->time = Seconds{value}; }},
        {.unit = secondsText, .lowest = 0.01, .highest = 3600});
    addCurve();
    m_fields.addSwitch({"postRootSpeed", [] { return tr("Keep the speed over the ground"); },
                        [] {
                            return tr(
                                "The figure goes as fast as in the clip, and its feet slide; otherwise its "
                                "way slows with its poses");
                        },
                        [](const AnimationEntry& entry) { return entry.post.steps.retime.has_value(); }},
                       lensInside<AnimationEntry>(step(&Steps::retime), &RetimeSettings::keepsRootSpeed));
}

void PostPanel::setRetimeKind(AnimationEntry& entry, int kind) const
{
    auto& retime = entry.post.steps.retime;
    if (kind == static_cast<int>(RetimeKind::None)) {
        retime.reset();
        return;
    }
    if (!retime)
        retime.emplace();
    const Seconds length{std::max(clipSeconds(), 1 / fps())};
    if (kind == static_cast<int>(RetimeKind::Factor))
        retime->time = RetimeFactor();
    else if (kind == static_cast<int>(RetimeKind::Duration))
        retime->time = length;
    else
        retime->time = RetimeSettings::Curve{{Seconds{0}, Seconds{0}}, {length, length}};
}

void PostPanel::addCurve()
{
    m_curve = new widgets::CurveEditor;
    m_curve->setInterpolation([](const QList<QPointF>& points) -> widgets::CurveEditor::Curve {
        std::vector<Vec2d> places;
        for (const QPointF& point : points)
            places.emplace_back(point.x(), point.y());
        return MonotoneCurve(std::move(places));
    });
    const auto setCurve = [this](const QList<QPointF>& points, bool committed) {
        change(
            tr("Curve of times"), "postCurve",
            [&](AnimationEntry& entry) { entry.post.steps.retime->time = toCurve(points); },
            committed ? EditPhase::Final : EditPhase::Dragging);
    };
    connect(m_curve, &widgets::CurveEditor::edited, this, setCurve);
    m_form->add(
        "postCurve", {},
        [] { return tr("Drag points; double-click adds one, Del removes it; Page Up and Down choose one"); },
        m_curve,
        [this, setCurve] {
            const double length = std::max(clipSeconds(), 1 / fps());
            setCurve({{0, 0}, {length, length}}, true);
        });
}

void PostPanel::refreshCurve(const AnimationEntry& entry)
{
    const bool isShown = isKind(entry, RetimeKind::Curve);
    m_form->setRowVisible(m_curve, isShown);
    if (!isShown)
        return;
    const QList<QPointF> points = toPoints(std::get<RetimeSettings::Curve>(entry.post.steps.retime->time));
    if (points.size() < 2)
        return;
    const double length = clipSeconds();
    m_curve->setFps(fps());
    m_curve->setLength(length > 0 ? length : points.back().y());
    m_curve->setPoints(points);
    m_form->setUsual(m_curve, points.size() == 2 && points[0] == QPointF(0, 0) &&
                                  points[1] == QPointF(length, length));
}

void PostPanel::addContacts()
{
    using S = ContactCorrectionSettings;
    const auto addPart = [this](const char* name, Text label, Text tip, double S::*member,
                                const NumberLook& look) {
        m_fields.addNumber(
            {name, std::move(label), std::move(tip),
             [](const AnimationEntry& entry) { return entry.post.steps.contacts.has_value(); }},
            lensInside<AnimationEntry>(step(&Steps::contacts), member), look);
    };
    m_form->addHeading([] { return tr("Feet"); });
    m_contacts = m_fields.addSwitch({"postContacts", [] { return tr("Keep standing feet still"); },
                                     [] { return tr("Takes slip from feet while they touch the ground"); }},
                                    presenceOf(&Steps::contacts));
    addPart(
        "postStrength", [] { return tr("Strength"); },
        [] { return tr("Share of the slip that is taken out"); }, &S::strength,
        {.path = "contact_correction.strength",
         .scale = hundredth,
         .step = 5,
         .decimals = 0,
         .unit = percentText});
    addPart(
        "postEase", [] { return tr("Ease"); },
        [] { return tr("How long before a contact it sets in, and how long after it dies away"); },
        &S::easeSeconds,
        {.path = "contact_correction.ease", .step = 0.05, .unit = secondsText, .highest = 5});
    addPart(
        "postShift", [] { return tr("Greatest shift"); },
        [] {
            return tr(
                "How far a foot is moved at most, of the height of the figure; the rest of the slip stays");
        },
        &S::greatestShift,
        {.path = "contact_correction.greatest_shift",
         .scale = hundredth,
         .step = 1,
         .decimals = 1,
         .unit = percentText,
         .highest = 100});
    addPart(
        "postTurn", [] { return tr("Greatest turn"); },
        [] { return tr("How far a foot is turned about the vertical at most"); }, &S::greatestTurn,
        {.path = "contact_correction.greatest_turn",
         .scale = degree,
         .step = 1,
         .decimals = 1,
         .unit = [] { return tr("°", "unit of a number"); },
         .highest = 180});
    addPart(
        "postLift", [] { return tr("Greatest lift"); },
        [] { return tr("How far a foot is lifted or lowered at most, of the height of the figure"); },
        &S::greatestLift,
        {.path = "contact_correction.greatest_lift",
         .scale = hundredth,
         .step = 0.5,
         .decimals = 1,
         .unit = percentText,
         .highest = 100});
}

void PostPanel::addMirror()
{
    m_form->addHeading([] { return tr("Mirror"); });
    m_mirror =
        m_fields.addSwitch({"postMirror", [] { return tr("Exchange left and right"); },
                            [] { return tr("Needs the symmetry of the mesh: found, or read from a file"); }},
                           step(&Steps::mirror));
    addSymmetry();
}

void PostPanel::addSymmetry()
{
    m_symmetry = new widgets::ElidedButton;
    m_symmetry->setMenu(new QMenu(m_symmetry));
    const auto forget = [this] {
        change(tr("Symmetry"), "postSymmetry", [](AnimationEntry& entry) { entry.post.symmetry.clear(); });
    };
    connect(m_symmetry->menu(), &QMenu::aboutToShow, this, [this, forget] {
        m_symmetry->menu()->clear();
        m_symmetry->menu()->addAction(tr("Choose a file…"), this, &PostPanel::chooseSymmetry);
        m_symmetry->menu()->addAction(tr("Find it in the mesh"), this, forget);
    });
    const auto showFile = [this](const AnimationEntry& entry) {
        const QString file = QString::fromStdString(entry.post.symmetry);
        m_symmetry->setText(file.isEmpty() ? tr("Found in the mesh") : QFileInfo(file).fileName());
    };
    m_fields.addOther(
        {"postSymmetry", [] { return tr("Symmetry"); },
         [] { return tr("A file that names, for each vertex, the one opposite to it"); },
         [](const AnimationEntry& entry) { return entry.post.steps.mirror; }},
        m_symmetry, showFile, [](const AnimationEntry& entry) { return entry.post.symmetry.empty(); },
        forget);
}

void PostPanel::chooseSymmetry()
{
    const QString file = QFileDialog::getOpenFileName(this, tr("Choose a symmetry"), {},
                                                      tr("Symmetries (*.npy *.txt *.csv);;All files (*)"));
    if (!file.isEmpty())
        change(tr("Symmetry"), "postSymmetry",
               [&](AnimationEntry& entry) { entry.post.symmetry = file.toStdString(); });
}

} // namespace quadrille
