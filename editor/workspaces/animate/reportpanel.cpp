// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/reportpanel.h"

#include "editor/context/editorcontext.h"
#include "editor/documents/projectpaths.h"
#include "editor/errors/errortext.h"
#include "editor/fields/actionbutton.h"
#include "editor/fields/rightmenu.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/junctions.h"
#include "editor/workspaces/view/sceneview.h"
#include "model/core/stagedfiles.h"
#include "model/project/media/projectguard.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/graph/linechart.h"
#include "widgets/theme/icons.h"

#include <QClipboard>
#include <QFileDialog>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

constexpr double centimetres = 100;

QString valueText(const std::optional<double>& value, const QString& unit)
{
    if (!value)
        return {};
    const bool isCount = unit.isEmpty() && *value == std::floor(*value);
    const QString number = QLocale().toString(*value, 'f', isCount ? 0 : 2);
    return unit.isEmpty() ? number : ReportPanel::tr("%1 %2", "number and unit").arg(number, unit);
}

} // namespace

ReportPanel::ReportPanel(CurrentAnimation& animation, QWidget* parent)
    : QWidget(parent)
    , m_animation(animation)
    , m_message(new widgets::MessageStrip)
    , m_buttons(new QWidget)
    , m_table(new QTreeWidget)
    , m_chart(new widgets::LineChart)
    , m_empty(new QLabel)
{
    setObjectName(QStringLiteral("reportPanel"));
    makeActions();
    arrangeWidgets();
    connect(&animation, &CurrentAnimation::changed, this, &ReportPanel::refresh);
    connect(&animation, &CurrentAnimation::resultChanged, this, &ReportPanel::refresh);
    connect(&animation.view().player(), &Player::frameChanged, this, &ReportPanel::followPlayer);
    connect(m_chart, &widgets::LineChart::markerMoved, this, [this](double seconds) {
        if (m_result == nullptr)
            return;
        const auto frame = static_cast<std::int64_t>(std::lround(seconds * fps()));
        const auto shown =
            shownFrame(*m_result, std::clamp<std::int64_t>(frame, 0, m_result->plan.frameCount() - 1));
        if (shown)
            m_animation.view().player().goTo(*shown);
    });
    retranslates(this, [this] { retranslate(); });
}

void ReportPanel::makeActions()
{
    ActionRegistry& actions = m_animation.context().actions;
    const auto group = [] { return tr("Animate"); };
    actions.add({"report.copy",
                 group,
                 [] { return tr("&Copy the report"); },
                 [] { return tr("Copies what was wanted and obtained as comma-separated values"); },
                 "copy",
                 {}},
                [this] { copy(); });
    actions.add({"report.save",
                 group,
                 [] { return tr("Sa&ve the report…"); },
                 [] { return tr("Saves what was wanted and obtained as a CSV file"); },
                 "save",
                 {}},
                [this] { askAndSave(false); });
    actions.add({"report.saveFrames",
                 group,
                 [] { return tr("Save the &frames' origins…"); },
                 [] { return tr("Saves the time of every frame and where it comes from as a CSV file"); },
                 "export",
                 {}},
                [this] { askAndSave(true); });
}

void ReportPanel::arrangeWidgets()
{
    m_message->setObjectName(QStringLiteral("reportMessage"));
    m_table->setObjectName(QStringLiteral("reportTable"));
    m_chart->setObjectName(QStringLiteral("deviationChart"));
    m_empty->setObjectName(QStringLiteral("reportEmpty"));
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_empty->setMargin(16);
    m_table->setColumnCount(3);
    m_table->setRootIsDecorated(false);
    m_table->setUniformRowHeights(true);
    m_table->setAllColumnsShowFocus(true);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->header()->setStretchLastSection(false);
    m_table->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_table->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_table->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    auto* row = new QHBoxLayout(m_buttons);
    row->setContentsMargins(8, 4, 8, 4);
    row->setSpacing(4);
    QList<QAction*> actions;
    for (const char* id : {"report.copy", "report.save", "report.saveFrames"}) {
        actions += m_animation.context().actions.action(id);
        row->addWidget(makeActionButton(actions.back()));
    }
    addRightMenu(*m_table, actions);
    row->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_message);
    column->addWidget(m_buttons);
    column->addWidget(m_empty, 1);
    column->addWidget(m_table, 2);
    column->addWidget(m_chart, 1);
}

double ReportPanel::fps() const
{
    return m_animation.context().document.project().settings.fps;
}

void ReportPanel::refresh()
{
    if (m_result == m_animation.result())
        return;
    m_result = m_animation.result();
    m_rows = m_result == nullptr ? std::vector<ReportRow>() : reportOf(*m_result, fps());
    m_message->clear();
    m_table->clear();
    for (const ReportRow& row : m_rows) {
        auto* item = new QTreeWidgetItem(m_table);
        item->setText(0, row.name.isEmpty() ? row.what
                                            : tr("%1: %2", "what, and of which").arg(row.what, row.name));
        item->setToolTip(0, item->text(0));
        item->setText(1, valueText(row.wanted, row.unit));
        item->setText(2, row.obtained ? valueText(row.obtained, row.unit) : row.text);
        item->setToolTip(2, row.text);
        for (const int number : {1, 2}) {
            item->setTextAlignment(number, Qt::AlignRight | Qt::AlignVCenter);
            item->setFont(number, widgets::Theme::tabularFont(m_table->font()));
        }
        if (row.isOff) {
            item->setIcon(2,
                          widgets::icons::icon(QStringLiteral("warning"), widgets::ColorRole::WarningText));
            item->setToolTip(
                2,
                tr("Missed by %1 s").arg(QLocale().toString(std::abs(*row.obtained - *row.wanted), 'f', 3)));
        }
    }
    refreshChart();
    const bool isEmpty = m_rows.empty();
    m_empty->setVisible(isEmpty);
    m_table->setVisible(!isEmpty);
    for (const char* id : {"report.copy", "report.save", "report.saveFrames"})
        m_animation.context().actions.action(id)->setEnabled(!isEmpty);
}

void ReportPanel::refreshChart()
{
    widgets::ChartSeries series{.name = tr("Deviation"),
                                .color = widgets::Theme::color(widgets::ColorRole::AccentText)};
    if (m_result != nullptr) {
        for (const DeviationAt& at : deviationsOf(*m_result, fps()))
            series.points.emplace_back(at.seconds, at.metres * centimetres);
    }
    m_chart->setVisible(!series.points.empty());
    m_chart->setSeries(series.points.empty() ? std::vector<widgets::ChartSeries>() : std::vector{series});
    followPlayer(m_animation.view().player().frame().value);
}

void ReportPanel::followPlayer(qint64 frame)
{
    // Where finishing changes the frames, the chart is of another time.
    const bool isSameTime = m_result != nullptr && !m_result->entry.post.steps.loop &&
                            !m_result->entry.post.steps.retime && frame < m_result->plan.frameCount();
    m_chart->setMarker(isSameTime ? std::optional(static_cast<double>(frame) / fps()) : std::nullopt,
                       tr("now", "time of the frame that is shown"));
}

void ReportPanel::copy() const
{
    QGuiApplication::clipboard()->setText(reportCsv(m_rows));
}

void ReportPanel::askAndSave(bool ofFrames)
{
    const QString file = QFileDialog::getSaveFileName(
        this, ofFrames ? tr("Save the frames' origins") : tr("Save the report"),
        m_animation.name() + QStringLiteral(".csv"), tr("Comma-separated values (*.csv)"));
    if (!file.isEmpty())
        save(file, ofFrames);
}

void ReportPanel::save(const QString& file, bool ofFrames)
{
    if (m_result == nullptr)
        return;
    const QString csv = ofFrames ? framesCsv(*m_result, fps()) : reportCsv(m_rows);
    try {
        // Whether a file may be replaced was asked where its name was chosen.
        const ProjectDocument& document = m_animation.context().document;
        const auto guard =
            projectGuard(document.snapshot(), document.workingFile(), {.overwrite = true, .outside = true});
        const WrittenNote note(*guard, document.workingFile());
        writeGuarded(toPath(file), csv.toStdString(), guard.get());
        m_message->clear();
    } catch (const Error& error) {
        const ErrorText text = describe(error);
        m_message->show(widgets::MessageStrip::Kind::Error, text.placed(), text.remedy);
    }
}

void ReportPanel::retranslate()
{
    m_table->setHeaderLabels({tr("What"), tr("Wanted"), tr("Obtained")});
    m_table->setAccessibleName(tr("What was wanted and obtained"));
    m_empty->setText(tr("What was asked of the animation and what it does comes here, as soon as there is a "
                        "clip."));
    m_chart->setAxes({tr("Time"), tr("s", "seconds")}, {tr("Deviation"), tr("cm", "centimetres")});
    m_chart->setAccessibleName(tr("Deviation from the path over time"));
    m_result.reset();
    m_rows.clear();
    if (m_animation.result() != nullptr) {
        refresh();
        return;
    }
    m_table->hide();
    m_chart->hide();
    for (const char* id : {"report.copy", "report.save", "report.saveFrames"})
        m_animation.context().actions.action(id)->setEnabled(false);
}

} // namespace quadrille

#include "moc_reportpanel.cpp"
