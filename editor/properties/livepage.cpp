// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/livepage.h"

#include "editor/commands/liveedits.h"
#include "editor/context/editorcontext.h"
#include "editor/fields/axesfields.h"
#include "model/project/document/findentry.h"
#include "widgets/controls/breakable.h"

#include <QLabel>
#include <QLocale>

namespace quadrille {

namespace {

/// Along one of the axes of the ground.
Lens<LiveEntry, double> placeAlong(Eigen::Index axis)
{
    Lens<LiveEntry, double> lens;
    lens.get = [axis](const LiveEntry& entry) { return entry.position.value_or(Vec2d::Zero())[axis]; };
    lens.set = [axis](LiveEntry& entry, double value) {
        Vec2d place = entry.position.value_or(Vec2d::Zero());
        place[axis] = value;
        entry.position = place.isZero(0) ? std::nullopt : std::optional(place);
    };
    return lens;
}

} // namespace

LivePage::LivePage(EditorContext& context)
    : EntryPage(context, {.section = Section::Lives,
                          .name = "live",
                          .workspace = "workspace.live",
                          .characterTip = [] { return tr("Whose motion spaces are played"); }})
    , m_form(new SettingForm)
    , m_fields(*m_form, [this](const QString& text, const char* property, const auto& change) {
        LiveEntry after = entry();
        change(after);
        setLive(EntryPage::context().document, entryName(), text, QLatin1String(property), std::move(after));
    })
{
    m_spaces = addFact("liveSpaces", [] { return tr("Motion spaces"); });
    m_spaces->setWordWrap(true);
    m_length = addFact("liveLength", [] { return tr("Length"); });
    m_length->setWordWrap(true);
    addBeginning();
    addPlaying();
    addWide("liveSettings", m_form);
    addOpen();
    retranslate();
}

void LivePage::addBeginning()
{
    const auto metres = [this] { return context().document.project().settings.axes.metresPerUnit; };
    const auto addPlace = [this, metres](const char* name, int axis) {
        const auto label = [this, axis] {
            return tr("Begins at %1")
                .arg(groundAxisName(context().document.project().settings.axes.up, axis));
        };
        m_fields.addNumber({name, label, [] { return tr("Where on the ground the performance begins"); }},
                           placeAlong(axis),
                           {.path = nullptr, .decimals = 3, .lowest = -1, .metresPerUnit = metres});
    };
    addPlace("livePlaceFirst", 0);
    addPlace("livePlaceSecond", 1);
    m_fields.addNumber({"liveHeading", [] { return tr("Looks to"); },
                        [] { return tr("Where the performance looks first: to the left of straight on"); }},
                       &LiveEntry::heading,
                       {.path = "live.heading",
                        .step = 5,
                        .decimals = 1,
                        .unit = [] { return tr(" °"); },
                        .lowest = -360,
                        .highest = 360});
}

void LivePage::addPlaying()
{
    m_fields.addNumber(
        {"liveDepth", [] { return tr("Transitions ahead"); },
         [] { return tr("How far ahead a transition is looked for, in either motion space"); }},
        &LiveEntry::depth,
        {.path = "live.depth", .step = 1, .decimals = 0, .unit = [] { return tr(" frames"); }});
    m_fields.addNumber(
        {"liveLatencyWeight", [] { return tr("Waiting costs"); },
         [] { return tr("A frame of waiting for a transition, against dissimilarities from 0 to 1000"); }},
        &LiveEntry::latencyWeight, {.path = "live.latency_weight", .step = 1, .decimals = 2});
    m_fields.addNumber({"liveResponsiveWeight", [] { return tr("Waiting costs, responsive"); },
                        [] { return tr("The same while it is steered responsively"); }},
                       &LiveEntry::responsiveWeight,
                       {.path = "live.responsive_weight", .step = 5, .decimals = 2});
    m_fields.addNumber({"liveFade", [] { return tr("Fade"); },
                        [] { return tr("In which one motion space takes over from another"); }},
                       &LiveEntry::fadeSeconds,
                       {.path = "live.fade", .step = 0.05, .decimals = 2, .unit = [] { return tr(" s"); }});
    m_fields.addNumber({"liveAcross", [] { return tr("Across a range"); },
                        [] { return tr("In which a parameter goes over all of its range at least"); }},
                       &LiveEntry::secondsAcross,
                       {.path = "live.across", .step = 0.1, .decimals = 2, .unit = [] { return tr(" s"); }});
    m_fields.addSwitch({"liveContacts", [] { return tr("Correct contacts"); },
                        [] { return tr("Feet that stand in the takes stand still in the clip as well"); }},
                       &LiveEntry::correctsContacts);
}

const LiveEntry& LivePage::entry() const
{
    return *findLive(context().document.project(), entryName().toStdString());
}

QString LivePage::character() const
{
    return QString::fromStdString(characterNameOf(context().document.project(), entry()));
}

/// Its motion spaces say it.
void LivePage::setCharacter(const QString& /*character*/)
{
    show(entryName());
}

void LivePage::retranslate()
{
    EntryPage::retranslate();
    m_fields.retranslate();
}

void LivePage::show(const QString& name)
{
    EntryPage::show(name);
    QStringList spaces;
    for (const std::string& space : entry().spaces)
        spaces += QString::fromStdString(space);
    m_spaces->setText(widgets::breakable(spaces.join(QStringLiteral(" · "))));
    const double seconds = static_cast<double>(entry().ticks - entry().from) /
                           (context().document.project().settings.fps * entry().ticksPerFrame);
    m_length->setText(tr("%1 s, steered %n time(s)", nullptr, static_cast<int>(entry().inputs.size()) - 1)
                          .arg(QLocale().toString(seconds, 'f', 1)));
    m_fields.show(entry());
}

} // namespace quadrille

#include "moc_livepage.cpp"
