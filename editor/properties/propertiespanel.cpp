// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/propertiespanel.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/verticalscroll.h"
#include "editor/language/retranslate.h"
#include "editor/properties/animationpage.h"
#include "editor/properties/brokenpage.h"
#include "editor/properties/characterpage.h"
#include "editor/properties/exportpage.h"
#include "editor/properties/projectpage.h"
#include "editor/properties/sequencepage.h"
#include "editor/properties/variationpage.h"
#include "model/project/document/brokenentry.h"

#include <QLabel>
#include <QLocale>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace quadrille {

PropertiesPanel::PropertiesPanel(EditorContext& context, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_title(new QLabel)
    , m_several(new QLabel)
    , m_pages(new QStackedWidget)
    , m_project(new ProjectPage(context))
    , m_character(new CharacterPage(context))
    , m_sequence(new SequencePage(context))
    , m_export(new ExportPage(context))
    , m_animation(new AnimationPage(context))
    , m_variation(new VariationPage(context))
    , m_broken(new BrokenPage(context))
{
    setObjectName(QStringLiteral("propertiesPanel"));
    setMinimumWidth(260);
    m_title->setObjectName(QStringLiteral("propertiesTitle"));
    m_title->setMargin(12);
    m_title->setWordWrap(true);
    QFont bold = m_title->font();
    bold.setWeight(QFont::DemiBold);
    m_title->setFont(bold);
    m_several->setObjectName(QStringLiteral("propertiesSeveral"));
    m_several->setMargin(12);
    m_several->setWordWrap(true);
    m_several->setAlignment(Qt::AlignTop | Qt::AlignLeading);
    for (QWidget* page : std::initializer_list<QWidget*>{m_project, m_character, m_sequence, m_export,
                                                         m_animation, m_variation, m_broken}) {
        m_pages->addWidget(verticalScroll(page));
    }
    m_pages->addWidget(m_several);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_title);
    column->addWidget(m_pages, 1);
    connect(&context.selection, &Selection::changed, this, &PropertiesPanel::refresh);
    connect(&context.document, &ProjectDocument::changed, this, &PropertiesPanel::refresh);
    connect(&context.media, &SequenceMedia::changed, this, [this](const QString& name) {
        const EntryRef& current = m_context.selection.current();
        if (current.section == Section::Characters || current == EntryRef{Section::Sequences, name} ||
            m_context.selection.sequences().contains(name))
            refresh();
    });
    retranslates(this, [this] {
        for (int page = 0; page < m_pages->count(); ++page) {
            if (auto* scroll = qobject_cast<QScrollArea*>(m_pages->widget(page)))
                scroll->setMinimumWidth(scroll->widget()->minimumSizeHint().width());
        }
        refresh();
    });
}

void PropertiesPanel::refresh()
{
    const EntryRef& current = m_context.selection.current();
    const ProjectDocument& document = m_context.document;
    const auto show = [this](int page, PropertyForm& form, const QString& name, const QString& title) {
        m_title->setText(title);
        form.show(name);
        m_pages->setCurrentIndex(page);
    };
    if (m_context.selection.sequences().size() > 1) {
        m_title->setText(
            tr("%n sequences", nullptr, static_cast<int>(m_context.selection.sequences().size())));
        m_several->setText(summary());
        m_pages->setCurrentWidget(m_several);
    } else if ((current.section == Section::Characters || current.section == Section::BodyParts) &&
               document.character(current.name) != nullptr) {
        show(1, *m_character, current.name, current.name);
    } else if (current.section == Section::Sequences && document.sequence(current.name) != nullptr) {
        show(2, *m_sequence, current.name, current.name);
    } else if (current.section == Section::Exports && document.exportEntry(current.name) != nullptr) {
        show(3, *m_export, current.name, current.name);
    } else if (current.section == Section::Animations && document.animation(current.name) != nullptr) {
        show(4, *m_animation, current.name, current.name);
    } else if (current.section == Section::Variations && document.variation(current.name) != nullptr) {
        show(5, *m_variation, current.name, current.name);
    } else if (current.section == Section::Project &&
               findBroken(document.project(), current.name.toStdString())) {
        show(6, *m_broken, current.name, current.name);
    } else {
        show(0, *m_project, {}, tr("Project"));
    }
}

QString PropertiesPanel::summary() const
{
    std::int64_t frames = 0;
    for (const QString& name : m_context.selection.sequences()) {
        if (const MeshSequence* sequence = m_context.media.sequence(name))
            frames += sequence->frameCount();
    }
    const double seconds = static_cast<double>(frames) / m_context.document.project().settings.fps;
    return tr("%n frames, %1 s", nullptr, static_cast<int>(frames)).arg(QLocale().toString(seconds, 'f', 2)) +
           QLatin1Char('\n') + tr("They are shown beside each other. Select one of them to edit it.");
}

} // namespace quadrille
