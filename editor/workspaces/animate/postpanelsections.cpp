// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The settings that the panel shows.
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/postpanel.h"
#include "model/synthesis/constraints.h"
#include "model/synthesis/monotonecurve.h"
#include "widgets/charts/curveeditor.h"
#include "widgets/controls/elidedbutton.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <algorithm>
#include <numbers>

namespace quadrille {

namespace {

constexpr double degree = std::numbers::pi / 180;

enum class RetimeKind
{
    None,
    Factor,
    Duration,
    Curve
};

RetimeKind kindOf(const AnimationEntry& entry)
{
    const auto& retime = entry.post.steps.retime;
    return retime ? static_cast<RetimeKind>(1 + retime->time.index()) : RetimeKind::None;
}

bool isKind(const AnimationEntry& entry, RetimeKind kind)
{
    return kindOf(entry) == kind;
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

std::optional<double> secondsOf(const std::optional<Seconds>& seconds)
{
    return seconds ? std::optional(seconds->value) : std::nullopt;
}

std::optional<Seconds> toSeconds(const std::optional<double>& value)
{
    return value ? std::optional(Seconds{*value}) : std::nullopt;
}

/// The loop's settings, the usual ones where there is no loop.
LoopSettings loopOf(const AnimationEntry& entry)
{
    return entry.post.steps.loop.value_or(LoopSettings());
}

ContactCorrectionSettings contactsOf(const AnimationEntry& entry)
{
    return entry.post.steps.contacts.value_or(ContactCorrectionSettings());
}

} // namespace

void PostPanel::addLoop()
{
    const auto seconds = [] { return tr(" s", "unit of a number"); };
    const auto hasLoop = [](const AnimationEntry& entry) { return entry.post.steps.loop.has_value(); };
    const NumberRange cut{
        .highest = 1000, .step = 0.1, .unit = seconds, .automatic = [] { return tr("a third"); }};
    m_form->addHeading([] { return tr("Loop"); });
    m_loop = addSwitch({"postLoop", [] { return tr("&Close to a seamless loop"); },
                        [] { return tr("Cuts both ends where they fit best and blends one into the other"); },
                        hasLoop,
                        [](AnimationEntry& entry, bool on) {
                            PostProcessing& steps = entry.post.steps;
                            steps.loop = on ? std::optional(LoopSettings()) : std::nullopt;
                            if (!on)
                                steps.repeats = 1;
                        }});
    addNumber({"postCutStart", [] { return tr("Cut at the start"); },
               [] { return tr("How far from the first frame the loop may begin"); },
               [](const AnimationEntry& entry) { return secondsOf(loopOf(entry).cutStart); },
               [](AnimationEntry& entry, std::optional<double> value) {
                   entry.post.steps.loop->cutStart = toSeconds(value);
               },
               hasLoop},
              cut);
    addNumber({"postCutEnd", [] { return tr("Cut at the end"); },
               [] { return tr("How far from the last frame the loop may end"); },
               [](const AnimationEntry& entry) { return secondsOf(loopOf(entry).cutEnd); },
               [](AnimationEntry& entry, std::optional<double> value) {
                   entry.post.steps.loop->cutEnd = toSeconds(value);
               },
               hasLoop},
              cut);
    addSwitch(
        {"postInPlace", [] { return tr("Stay in &place"); },
         [] { return tr("Takes the way over the ground out, so that each round begins where it began"); },
         [](const AnimationEntry& entry) { return loopOf(entry).inPlace; },
         [](AnimationEntry& entry, bool on) { entry.post.steps.loop->inPlace = on; }, hasLoop});
    m_repeats = addNumber(
        {"postRepeats", [] { return tr("Repeats"); }, [] { return tr("How often the loop plays"); },
         [](const AnimationEntry& entry) { return std::optional<double>(entry.post.steps.repeats); },
         [](AnimationEntry& entry, std::optional<double> value) {
             entry.post.steps.repeats = static_cast<int>(value.value_or(1));
         }},
        {.lowest = 1, .highest = 1000, .step = 1, .decimals = 0, .unit = [] {
             return tr(" ×", "how many times");
         }});
}

void PostPanel::addRetime()
{
    const auto hasRetime = [](const AnimationEntry& entry) { return entry.post.steps.retime.has_value(); };
    m_form->addHeading([] { return tr("Time"); });
    m_retime =
        addChoice({"postRetime", [] { return tr("Retime"); },
                   [] { return tr("Plays the clip faster or slower, as a whole or from moment to moment"); },
                   [](const AnimationEntry& entry) { return static_cast<int>(kindOf(entry)); },
                   [this](AnimationEntry& entry, int index) {
                       auto& retime = entry.post.steps.retime;
                       if (index == 0) {
                           retime.reset();
                           return;
                       }
                       if (!retime)
                           retime.emplace();
                       const Seconds length{std::max(clipSeconds(), 1 / fps())};
                       if (index == static_cast<int>(RetimeKind::Factor))
                           retime->time = RetimeFactor();
                       else if (index == static_cast<int>(RetimeKind::Duration))
                           retime->time = length;
                       else
                           retime->time = RetimeSettings::Curve{{Seconds{0}, Seconds{0}}, {length, length}};
                   }},
                  {[] { return tr("Not at all"); }, [] { return tr("By a factor"); },
                   [] { return tr("To a duration"); }, [] { return tr("By a curve"); }});
    addNumber(
        {"postFactor", [] { return tr("Factor"); },
         [] { return tr("Times as long as the clip: 2 is half as fast"); },
         [](const AnimationEntry& entry) {
             return std::optional(isKind(entry, RetimeKind::Factor)
                                      ? std::get<RetimeFactor>(entry.post.steps.retime->time).value
                                      : 1.0);
         },
         [](AnimationEntry& entry, std::optional<double> value) {
             entry.post.steps.retime->time = RetimeFactor{value.value_or(1)};
         },
         [](const AnimationEntry& entry) { return isKind(entry, RetimeKind::Factor); }},
        {.lowest = 0.05, .highest = 20, .step = 0.05, .unit = [] { return tr(" ×", "how many times"); }});
    addNumber(
        {"postDuration", [] { return tr("Duration"); }, [] { return tr("How long the result lasts"); },
         [this](const AnimationEntry& entry) {
             return std::optional(isKind(entry, RetimeKind::Duration)
                                      ? std::get<Seconds>(entry.post.steps.retime->time).value
                                      : clipSeconds());
         },
         [](AnimationEntry& entry, std::optional<double> value) {
             entry.post.steps.retime->time = Seconds{*value};
         },
         [](const AnimationEntry& entry) { return isKind(entry, RetimeKind::Duration); }},
        {.lowest = 0.01, .highest = 3600, .step = 0.1, .unit = [] { return tr(" s", "unit of a number"); }});
    addCurve();
    addSwitch({"postRootSpeed", [] { return tr("Keep the speed over the &ground"); },
               [] {
                   return tr("The figure goes as fast as in the clip, and its feet slide; otherwise its way "
                             "slows with its poses");
               },
               [](const AnimationEntry& entry) {
                   return entry.post.steps.retime && entry.post.steps.retime->keepsRootSpeed;
               },
               [](AnimationEntry& entry, bool on) { entry.post.steps.retime->keepsRootSpeed = on; },
               hasRetime});
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
    const auto hasContacts = [](const AnimationEntry& entry) {
        return entry.post.steps.contacts.has_value();
    };
    const auto percent = [] { return tr(" %", "unit of a number"); };
    const auto addPart = [&](const char* name, Text label, Text tip,
                             double ContactCorrectionSettings::*member, double unit,
                             const NumberRange& range) {
        addNumber({name, std::move(label), std::move(tip),
                   [member, unit](const AnimationEntry& entry) {
                       return std::optional(contactsOf(entry).*member / unit);
                   },
                   [member, unit](AnimationEntry& entry, std::optional<double> value) {
                       (*entry.post.steps.contacts).*member = *value * unit;
                   },
                   hasContacts},
                  range);
    };
    m_form->addHeading([] { return tr("Feet"); });
    m_contacts =
        addSwitch({"postContacts", [] { return tr("Keep standing &feet still"); },
                   [] { return tr("Takes slip from feet while they touch the ground"); }, hasContacts,
                   [](AnimationEntry& entry, bool on) {
                       entry.post.steps.contacts =
                           on ? std::optional(ContactCorrectionSettings()) : std::nullopt;
                   }});
    addPart(
        "postStrength", [] { return tr("Strength"); },
        [] { return tr("Share of the slip that is taken out"); }, &ContactCorrectionSettings::strength, 0.01,
        {.highest = 100, .step = 5, .decimals = 0, .unit = percent});
    addPart(
        "postEase", [] { return tr("Ease"); },
        [] { return tr("How long before a contact it sets in, and how long after it dies away"); },
        &ContactCorrectionSettings::easeSeconds, 1,
        {.highest = 5, .step = 0.05, .unit = [] { return tr(" s", "unit of a number"); }});
    addPart(
        "postShift", [] { return tr("Greatest shift"); },
        [] {
            return tr("How far a foot is moved at most, of the height of the figure; the rest of the slip "
                      "stays");
        },
        &ContactCorrectionSettings::greatestShift, 0.01,
        {.highest = 100, .step = 1, .decimals = 1, .unit = percent});
    addPart(
        "postTurn", [] { return tr("Greatest turn"); },
        [] { return tr("How far a foot is turned about the vertical at most"); },
        &ContactCorrectionSettings::greatestTurn, degree,
        {.highest = 180, .step = 1, .decimals = 1, .unit = [] { return tr("°", "unit of a number"); }});
    addPart(
        "postLift", [] { return tr("Greatest lift"); },
        [] { return tr("How far a foot is lifted or lowered at most, of the height of the figure"); },
        &ContactCorrectionSettings::greatestLift, 0.01,
        {.highest = 100, .step = 0.5, .decimals = 1, .unit = percent});
}

void PostPanel::addMirror()
{
    m_form->addHeading([] { return tr("Mirror"); });
    m_mirror = addSwitch({"postMirror", [] { return tr("Exchange left and &right"); },
                          [] { return tr("Needs the symmetry of the mesh: found, or read from a file"); },
                          [](const AnimationEntry& entry) { return entry.post.steps.mirror; },
                          [](AnimationEntry& entry, bool on) { entry.post.steps.mirror = on; }});
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
    m_form->add(
        "postSymmetry", [] { return tr("Symmetry"); },
        [] { return tr("A file that names, for each vertex, the one opposite to it"); }, m_symmetry, forget);
    m_bindings.push_back({m_symmetry, showFile,
                          [](const AnimationEntry& entry) { return entry.post.symmetry.empty(); },
                          [](const AnimationEntry& entry) { return entry.post.steps.mirror; }});
    m_texts.emplace_back([this, showFile] {
        if (m_animation.entry() != nullptr)
            showFile(*m_animation.entry());
    });
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
