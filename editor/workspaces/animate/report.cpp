// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/report.h"

#include "model/project/steps/walkrequest.h"
#include "model/synthesis/walks/pathfollowing.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

struct Texts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::AnimationReport)
};

/// Collects the rows of one result.
class Report
{
public:
    Report(const AnimationResult& result, double fps) : m_result(result), m_fps(fps) {}

    std::vector<ReportRow> rows()
    {
        addWhole();
        if (!m_result.entry.walk) {
            addSearch();
            addKeys();
            addPath();
            addActions();
        }
        return std::move(m_rows);
    }

private:
    const WalkSolution& solution() const { return m_result.walk.solution; }
    const WalkConstraints& constraints() const { return m_result.walk.constraints; }
    static QString seconds() { return Texts::tr("s", "seconds"); }
    static QString squareMetres() { return Texts::tr("m²", "square metres"); }
    CostWeights weights() const { return costWeights(m_result.entry, m_result.character->graph); }
    static QString centimetres() { return Texts::tr("cm", "centimetres"); }

    void add(const QString& what, double obtained, const QString& unit = {})
    {
        m_rows.push_back({what, {}, {}, obtained, unit});
    }

    void addWanted(const QString& what, const QString& name, std::optional<double> wanted, double obtained)
    {
        const bool isOff = wanted && std::abs(obtained - *wanted) * m_fps > 0.5 + 1e-9;
        m_rows.push_back({what, name, wanted, obtained, seconds(), {}, isOff});
    }

    void addWhole()
    {
        add(Texts::tr("Duration"), static_cast<double>(m_result.sequence.frameCount()) / m_fps, seconds());
        if (m_result.sequence.frameCount() != m_result.plan.frameCount())
            add(Texts::tr("Duration before finishing"),
                static_cast<double>(m_result.plan.frameCount()) / m_fps, seconds());
        add(Texts::tr("Transitions"), static_cast<double>(solution().walk.transitionCount()));
        add(Texts::tr("Cost of all edges"), solution().cost.edges);
        if (!m_result.entry.walk && constraints().path)
            add(Texts::tr("Their weight μ"), weights().mu, squareMetres());
        if (m_result.entry.post.variations) {
            const auto& spans = m_result.spans;
            const auto drawn =
                std::ranges::count_if(spans, [](const SpanDraw& span) { return span.variation.has_value(); });
            add(Texts::tr("Repeats drawn from variations"), static_cast<double>(drawn));
        }
    }

    void addSearch()
    {
        const QString unit = constraints().path ? squareMetres() : QString();
        add(Texts::tr("Cost of timing"), solution().cost.timing, unit);
        add(Texts::tr("Weight β of a frame"), weights().beta, unit);
        if (constraints().path)
            add(Texts::tr("Cost of deviation"), solution().cost.deviation, squareMetres());
        add(Texts::tr("Total cost"), solution().totalCost, unit);
        if (solution().bound > 0)
            add(Texts::tr("Lower bound of the cost"), solution().bound, unit);
        add(Texts::tr("States looked at"), static_cast<double>(solution().expansions));
        const QString best = solution().optimal
                                 ? solution().eachLeg ? Texts::tr("from key to key") : Texts::tr("yes")
                             : m_result.isFinal ? Texts::tr("not proven")
                                                : Texts::tr("still seeking");
        m_rows.push_back({Texts::tr("Proven best in the Essential graph"), {}, {}, {}, {}, best});
    }

    void addKeys()
    {
        for (std::size_t k = 0; k < solution().keys.size(); ++k)
            addWanted(Texts::tr("Key"), QString::number(k + 1), solution().keys[k].wanted / m_fps,
                      static_cast<double>(solution().keys[k].obtained) / m_fps);
    }

    void addPath()
    {
        if (!constraints().path)
            return;
        add(Texts::tr("Path length"), solution().pathLength, Texts::tr("m", "metres"));
        add(Texts::tr("Mean deviation"), 100 * solution().meanDeviation, centimetres());
        add(Texts::tr("Greatest deviation"), 100 * solution().greatestDeviation, centimetres());
        for (std::size_t s = 0; s < solution().spans.size(); ++s) {
            const PathSpan& span = constraints().path->spans[s];
            addRange(Texts::tr("Span from"), Texts::tr("Span lasts"),
                     span.demanded ? QString::fromStdString(span.demanded->name) : QString::number(s + 1),
                     solution().spans[s], span.duration);
        }
    }

    void addActions()
    {
        for (std::size_t a = 0; a < solution().actions.size(); ++a) {
            const Action& action = constraints().actions[a];
            addRange(Texts::tr("Action from"), Texts::tr("Action lasts"),
                     QString::fromStdString(action.frames.name), solution().actions[a], action.duration);
        }
    }

    void addRange(const QString& from, const QString& lasts, const QString& name, const FrameRange& range,
                  const std::optional<double>& wanted)
    {
        addWanted(from, name, {}, static_cast<double>(range.first.value) / m_fps);
        addWanted(lasts, name, wanted ? std::optional(*wanted / m_fps) : std::nullopt,
                  static_cast<double>(range.count()) / m_fps);
    }

    const AnimationResult& m_result;
    double m_fps;
    std::vector<ReportRow> m_rows;
};

QString quoted(QString text)
{
    if (!text.contains(QLatin1Char(',')) && !text.contains(QLatin1Char('"')) &&
        !text.contains(QLatin1Char('\n')))
        return text;
    text.replace(QLatin1String("\""), QLatin1String("\"\""));
    return QLatin1Char('"') + text + QLatin1Char('"');
}

QString number(const std::optional<double>& value)
{
    return value ? QString::number(*value, 'g', 9) : QString();
}

QString line(const QStringList& cells)
{
    return cells.join(QLatin1Char(',')) + QLatin1Char('\n');
}

} // namespace

std::vector<ReportRow> reportOf(const AnimationResult& result, double fps)
{
    return Report(result, fps).rows();
}

std::vector<DeviationAt> deviationsOf(const AnimationResult& result, double fps)
{
    std::vector<DeviationAt> deviations;
    const auto& path = result.walk.constraints.path;
    if (!path || path->points.size() < 2)
        return deviations;
    for (const FollowedFrame& frame : followPath(*path, result.plan, result.character->graph.metresPerUnit()))
        deviations.push_back({static_cast<double>(deviations.size()) / fps, frame.deviation});
    return deviations;
}

QString reportCsv(const std::vector<ReportRow>& rows)
{
    QString csv = line({"what", "name", "wanted", "obtained", "unit"});
    for (const ReportRow& row : rows)
        csv += line({quoted(row.what), quoted(row.name), number(row.wanted),
                     row.obtained ? number(row.obtained) : quoted(row.text), quoted(row.unit)});
    return csv;
}

QString framesCsv(const AnimationResult& result, double fps)
{
    const CharacterGraph& graph = result.character->graph;
    const bool isAsPlanned = !result.entry.post.steps.loop && !result.entry.post.steps.retime;
    const auto deviations = isAsPlanned ? deviationsOf(result, fps) : std::vector<DeviationAt>();
    QString csv = line({"frame", "time_s", "sequence", "source_frame", "to_sequence", "to_frame", "lambda",
                        "deviation_m", "variation", "to_variation"});
    for (std::size_t f = 0; f < result.origins.size(); ++f) {
        const FrameProvenance& origin = result.origins[f];
        const NamedFrame from = graph.nameOf(origin.source);
        const NamedFrame to = graph.nameOf(origin.destination);
        const auto name = [](const NamedFrame& frame) {
            return quoted(QString::fromStdString(frame.sequence));
        };
        csv += line({QString::number(f), number(static_cast<double>(f) / fps), name(from),
                     QString::number(from.frame.value), name(to), QString::number(to.frame.value),
                     number(origin.lambda), f < deviations.size() ? number(deviations[f].metres) : QString(),
                     quoted(QString::fromStdString(result.variationName(origin.sourceVariation))),
                     quoted(QString::fromStdString(result.variationName(origin.destinationVariation)))});
    }
    return csv;
}

} // namespace quadrille
