// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/graphstatepage.h"

#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/language/retranslate.h"

#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <unistd.h>

namespace quadrille {

namespace {

constexpr int progressWidth = 240;
// Of a pair of frames, as measured while a graph is computed: distances, costs, lengths and windows, and what
// they are made with.
constexpr double bytesPerPair = 28;

double physicalBytes()
{
    return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

} // namespace

GraphStatePage::GraphStatePage(EditorContext& context, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_title(new QLabel)
    , m_text(new QLabel)
    , m_memory(new QLabel)
    , m_progress(new QProgressBar)
    , m_button(new QPushButton)
{
    setObjectName(QStringLiteral("graphState"));
    m_title->setObjectName(QStringLiteral("graphStateTitle"));
    m_text->setObjectName(QStringLiteral("graphStateText"));
    m_memory->setObjectName(QStringLiteral("graphStateMemory"));
    m_progress->setObjectName(QStringLiteral("graphStateProgress"));
    m_button->setObjectName(QStringLiteral("graphStateButton"));
    QFont heavier = font();
    heavier.setWeight(QFont::DemiBold);
    m_title->setFont(heavier);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(24, 24, 24, 24);
    column->setSpacing(12);
    column->addStretch(1);
    for (QLabel* label : {m_title, m_text, m_memory}) {
        label->setAlignment(Qt::AlignCenter);
        label->setWordWrap(true);
        column->addWidget(label);
    }
    m_text->setForegroundRole(QPalette::PlaceholderText);
    m_memory->setForegroundRole(QPalette::PlaceholderText);
    m_progress->setFixedWidth(progressWidth);
    m_progress->setRange(0, 1000);
    column->addWidget(m_progress, 0, Qt::AlignHCenter);
    column->addWidget(m_button, 0, Qt::AlignHCenter);
    column->addStretch(1);
    connect(m_button, &QPushButton::clicked, this, &GraphStatePage::act);
    connect(&context.graphs, &GraphResults::changed, this, &GraphStatePage::refresh);
    connect(&context.media, &SequenceMedia::changed, this, &GraphStatePage::refresh);
    connect(&context.document, &ProjectDocument::changed, this, &GraphStatePage::refresh);
    retranslates(this, [this] { refresh(); });
}

void GraphStatePage::show(const QString& character)
{
    m_character = character;
    refresh();
}

void GraphStatePage::act()
{
    const auto* resultState = m_context.graphs.resultState(m_character);
    if (resultState == nullptr)
        m_context.actions.action(QStringLiteral("file.import"))->trigger();
    else if (resultState->phase == ResultPhase::Computing)
        m_context.graphs.stop(m_character);
    else
        m_context.graphs.ask(m_character);
}

std::int64_t GraphStatePage::frameCount() const
{
    std::int64_t frames = 0;
    for (const SequenceEntry& entry : m_context.document.project().sequences) {
        const bool isIts = m_character.isEmpty() || entry.character.empty() ||
                           QString::fromStdString(entry.character) == m_character;
        const MeshSequence* sequence =
            isIts ? m_context.media.sequence(QString::fromStdString(entry.name)) : nullptr;
        frames += sequence != nullptr ? sequence->frameCount() : 0;
    }
    return frames;
}

QString GraphStatePage::memoryText() const
{
    const auto frames = static_cast<double>(frameCount());
    const double bytes = frames * frames * bytesPerPair;
    const QString size = QLocale().formattedDataSize(static_cast<qint64>(bytes), 1);
    const QString count = QLocale().toString(static_cast<qlonglong>(frames));
    if (bytes > physicalBytes())
        return tr("%1 frames need about %2 of memory, more than this computer has. Trim sequences or remove "
                  "some.")
            .arg(count, size);
    return frames > 0 ? tr("%1 frames, about %2 of memory").arg(count, size) : QString();
}

void GraphStatePage::refresh()
{
    const auto* resultState = m_context.graphs.resultState(m_character);
    const ResultPhase phase = resultState != nullptr ? resultState->phase : ResultPhase::Idle;
    QString title = tr("No graph yet");
    QString text = tr("The graph holds every transition from one frame to another. It is computed from all "
                      "sequences of the character.");
    QString button = tr("&Compute the graph");
    if (resultState == nullptr) {
        title = tr("No sequences yet");
        text = tr("Transitions lead from one sequence to another: import some first.");
        button = tr("&Import sequences…");
    } else if (phase == ResultPhase::Computing) {
        title = tr("Computing the graph");
        text = tr("Pose distances, transitions and both graphs. You can go on working meanwhile.");
        button = tr("&Stop");
    } else if (phase == ResultPhase::Failed && resultState->error) {
        const ErrorText error = describe(*resultState->error);
        title = error.sentence;
        text = error.where.isEmpty() ? error.remedy : tr("%1 (%2)").arg(error.remedy, error.where);
        button = tr("&Try again");
    }
    m_title->setText(title);
    m_text->setText(text);
    m_memory->setText(resultState != nullptr ? memoryText() : QString());
    m_button->setText(button);
    m_progress->setVisible(phase == ResultPhase::Computing);
    Job* job = phase == ResultPhase::Computing ? resultState->job.data() : nullptr;
    if (job != m_job) {
        m_job = job;
        if (job != nullptr)
            connect(job, &Job::changed, this, &GraphStatePage::showProgress);
    }
    showProgress();
}

void GraphStatePage::showProgress()
{
    if (m_job)
        m_progress->setValue(static_cast<int>(m_job->fraction() * m_progress->maximum()));
}

} // namespace quadrille

#include "moc_graphstatepage.cpp"
