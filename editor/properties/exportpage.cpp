// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/exportpage.h"

#include "editor/context/editorcontext.h"

#include <QFileInfo>
#include <QLocale>
#include <QPushButton>

namespace quadrille {

ExportPage::ExportPage(EditorContext& context) : m_context(context), m_change(new QPushButton)
{
    m_what = addFact("exportWhat", [] { return tr("Of"); });
    m_file = addFact("exportFile", [] { return tr("File"); });
    m_frames = addFact("exportFrames", [] { return tr("Frames"); });
    m_state = addFact("exportState", [] { return tr("Written"); });
    addWide("exportChange", m_change);
    connect(m_change, &QPushButton::clicked, this,
            [this] { m_context.actions.action(QStringLiteral("file.export"))->trigger(); });
    retranslate();
}

void ExportPage::show(const QString& name)
{
    const ExportEntry& entry = *m_context.document.exportEntry(name);
    const QString what = QString::fromStdString(entry.what);
    const QString path = QString::fromStdString(entry.path);
    const QFileInfo file(path);
    m_what->setText(what.section(QLatin1Char('/'), 1));
    m_file->setText(file.fileName());
    m_file->setToolTip(path);
    const double fps = entry.fps.value_or(m_context.document.project().settings.fps);
    const QString rate = tr("%1 fps").arg(QLocale().toString(fps, 'g', 5));
    m_frames->setText(
        entry.range ? tr("%1 to %2, %3").arg(entry.range->first.value).arg(entry.range->last.value).arg(rate)
                    : tr("all, %1").arg(rate));
    m_state->setText(file.exists() ? QLocale().toString(file.lastModified(), QLocale::ShortFormat)
                                   : tr("not as one file"));
}

void ExportPage::retranslate()
{
    m_change->setText(tr("Change or write again…"));
}

} // namespace quadrille

#include "moc_exportpage.cpp"
