// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/importing/importdialog.h"

#include "editor/commands/entrynames.h"
#include "editor/context/editorcontext.h"
#include "editor/documents/editcheck.h"
#include "editor/documents/projectpaths.h"
#include "editor/errors/errortext.h"
#include "editor/fields/axesfields.h"
#include "editor/fields/numberfield.h"
#include "editor/fields/rangefield.h"
#include "editor/fields/texturefield.h"
#include "editor/importing/taketable.h"
#include "editor/language/retranslate.h"
#include "editor/pictures/takepreview.h"
#include "widgets/controls/fieldnote.h"
#include "widgets/theme/icons.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace quadrille {

ImportDialog::ImportDialog(EditorContext& context, FoundSources found, QWidget* parent)
    : QDialog(parent)
    , m_context(context)
    , m_found(std::move(found))
    , m_takes(new TakeTable(context.jobs))
    , m_strip(new widgets::MessageStrip)
    , m_notes(new QLabel)
    , m_preview(new TakePreview(context.jobs))
    , m_height(new QLabel)
    , m_character(new QComboBox)
    , m_mesh(new QLineEdit)
    , m_chooseMesh(new QToolButton)
    , m_axes(new AxesFields)
    , m_fps(makeNumberField(rateLook("sequence.source_fps")))
    , m_rateReason(new QLabel)
    , m_range(new RangeField("import"))
    , m_texture(new TextureField)
    , m_import(new QPushButton)
    , m_cancel(new QPushButton)
{
    setObjectName(QStringLiteral("importDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(1000, 640);
    makeControls();
    connectAll();
    retranslates(this, [this] { retranslate(); });
    survey();
}

ImportDialog::~ImportDialog() = default;

void ImportDialog::makeControls()
{
    m_height->setObjectName(QStringLiteral("importHeight"));
    m_height->setAlignment(Qt::AlignCenter);
    m_notes->setObjectName(QStringLiteral("importNotes"));
    m_notes->setWordWrap(true);
    m_notes->setMargin(8);
    m_import->setObjectName(QStringLiteral("importAccept"));
    m_import->setDefault(true);
    m_cancel->setObjectName(QStringLiteral("importCancel"));

    auto* left = new QVBoxLayout;
    left->setSpacing(8);
    left->addWidget(m_takes, 1);
    left->addWidget(m_strip);
    left->addWidget(m_notes);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(16);
    middle->addLayout(left, 1);
    middle->addWidget(makeSettings());
    auto* buttons = new QHBoxLayout;
    buttons->addStretch();
    buttons->addWidget(m_cancel);
    buttons->addWidget(m_import);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(16);
    column->addLayout(middle, 1);
    column->addLayout(buttons);
}

QWidget* ImportDialog::makeSettings()
{
    m_character->setObjectName(QStringLiteral("importCharacter"));
    m_character->setEditable(true);
    m_mesh->setObjectName(QStringLiteral("importMesh"));
    m_mesh->setReadOnly(true);
    m_chooseMesh->setObjectName(QStringLiteral("importChooseMesh"));
    m_chooseMesh->setIcon(widgets::icons::icon(QStringLiteral("folder")));
    m_axes->setObjectName(QStringLiteral("importAxes"));
    m_fps->setObjectName(QStringLiteral("importFps"));
    m_rateReason->setObjectName(QStringLiteral("importRateReason"));
    m_rateReason->setWordWrap(true);
    m_rateReason->setForegroundRole(QPalette::PlaceholderText);
    m_texture->setObjectName(QStringLiteral("importTexture"));
    m_texture->setStartFolder(toQString(m_found.sources.front().parent_path()));

    auto* mesh = new QHBoxLayout;
    mesh->setSpacing(4);
    mesh->addWidget(m_mesh, 1);
    mesh->addWidget(m_chooseMesh);
    auto* settings = new QWidget;
    settings->setFixedWidth(TakePreview::side + 40);
    auto* column = new QVBoxLayout(settings);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addWidget(m_preview, 0, Qt::AlignHCenter);
    column->addWidget(m_height);
    m_form = new QFormLayout;
    m_form->setSpacing(8);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_form->addRow(new QLabel, m_character);
    m_form->addRow(new QLabel, mesh);
    m_form->addRow(new QLabel, m_axes);
    auto* rate = new QVBoxLayout;
    rate->setSpacing(4);
    rate->addWidget(m_fps);
    rate->addWidget(m_rateReason);
    m_form->addRow(new QLabel, rate);
    m_form->addRow(new QLabel, m_range);
    m_form->addRow(new QLabel, m_texture);
    column->addLayout(m_form);
    column->addStretch();
    return settings;
}

void ImportDialog::connectAll()
{
    const auto changed = [this] {
        readControls();
        showPlan();
    };
    connect(m_takes, &TakeTable::edited, this, [this] {
        readControls();
        showProblems();
    });
    connect(m_takes, &QTreeWidget::currentItemChanged, this, &ImportDialog::showTake);
    connect(m_character, &QComboBox::editTextChanged, this, [this] { readControls(); });
    connect(m_axes, &AxesFields::edited, this, changed);
    connect(m_fps, &QDoubleSpinBox::valueChanged, this, &ImportDialog::setRate);
    connect(m_range, &RangeField::edited, this, &ImportDialog::readControls);
    connect(m_texture, &TextureField::chosen, this, &ImportDialog::setTexture);
    connect(m_chooseMesh, &QToolButton::clicked, this, &ImportDialog::chooseMesh);
    connect(m_strip, &widgets::MessageStrip::actionTriggered, this, &ImportDialog::triggerStrip);
    connect(m_cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_import, &QPushButton::clicked, this, &ImportDialog::import);
}

void ImportDialog::survey()
{
    m_isSurveyed = false;
    m_import->setEnabled(false);
    m_notes->setText(tr("Looking at what is there…"));
    const SurveyOptions options = surveyOptions(m_found.mesh, m_context.document.project());
    m_context.jobs.start(
        {.name = tr("Looking at %n source(s)", nullptr, static_cast<int>(m_found.sources.size())),
         .receiver = this,
         .failed =
             [this](const Error& error) {
                 m_strip->show(widgets::MessageStrip::Kind::Error, describe(error).oneLine());
             }},
        [sources = m_found.sources, options](const Progress& progress) {
            return surveySources(sources, options, progress);
        },
        [this](std::vector<SurveyedTake> takes) { takeSurvey(std::move(takes)); });
}

void ImportDialog::takeSurvey(std::vector<SurveyedTake> takes)
{
    m_plan = planFor(std::move(takes), m_found.mesh, m_context.document.project());
    m_isSurveyed = true;
    const QSignalBlocker block(m_character);
    m_character->clear();
    for (const CharacterEntry& character : m_context.document.project().characters)
        m_character->addItem(QString::fromStdString(character.name));
    m_character->setCurrentText(QString::fromStdString(m_plan.character));
    showPlan();
    if (!m_plan.withUnknownRate().empty()) {
        m_fps->setFocus();
        m_fps->selectAll();
    }
}

PlannedTake* ImportDialog::current()
{
    const int take = m_takes->currentTake();
    return take < 0 ? nullptr : &m_plan.takes.at(static_cast<std::size_t>(take));
}

/// Takes over what the user set.
void ImportDialog::readControls()
{
    if (!m_isSurveyed)
        return;
    m_plan.character = m_character->currentText().trimmed().toStdString();
    m_plan.axes = m_axes->axes();
    for (std::size_t i = 0; i < m_plan.takes.size(); ++i) {
        m_plan.takes[i].isWanted = m_takes->isWanted(static_cast<int>(i));
        m_plan.takes[i].name = m_takes->nameOf(static_cast<int>(i)).trimmed().toStdString();
    }
    if (PlannedTake* planned = current(); planned != nullptr && planned->take.sequence)
        planned->range = m_range->range();
}

void ImportDialog::showPlan()
{
    m_axes->setAxes(m_plan.axes);
    m_mesh->setText(toQString(m_plan.mesh.filename()));
    m_mesh->setToolTip(toQString(m_plan.mesh));
    m_takes->setPlan(m_plan);
    showTake();
}

void ImportDialog::showTake()
{
    const PlannedTake* planned = current();
    const bool isOpen = planned != nullptr && planned->take.sequence.has_value();
    const bool namesAxes = isOpen && planned->take.coordinates.has_value();
    const bool namesRate = isOpen && planned->take.hasOwnFps;
    m_axes->setEnabled(!namesAxes);
    m_axes->setToolTip(namesAxes ? tr("The file names its axes and unit itself") : QString());
    m_fps->setEnabled(isOpen && !namesRate);
    m_fps->setToolTip(namesRate ? tr("The file names its rate itself")
                                : tr("Frames a second of this take and of those with the same rate"));
    m_rateReason->setText(isOpen ? rateReason(*planned) : QString());
    if (isOpen) {
        const QSignalBlocker block(m_fps);
        m_fps->setValue(namesRate ? planned->take.sequence->fps : planned->rate.fps);
    }
    m_texture->setEnabled(isOpen);
    m_range->setEnabled(isOpen);
    if (isOpen) {
        m_range->setRange(planned->range, planned->take.sequence->frameCount());
        m_height->setText(tr("%1 m high").arg(QLocale().toString(m_plan.heightOf(planned->take), 'f', 2)));
    } else {
        m_height->clear();
    }
    m_texture->setTexture(isOpen ? planned->texture : TextureReference(), tr("as found"));
    m_preview->draw(isOpen ? &*planned->take.sequence : nullptr,
                    namesAxes ? CoordinateSystem{} : m_plan.axes);
    showProblems();
}

void ImportDialog::showProblems()
{
    const PlannedTake* planned = current();
    const bool isOpen = planned != nullptr && !planned->take.error;
    const ImportMessage message = importMessage(m_plan, planned);
    m_import->setEnabled(m_isSurveyed && !m_plan.wanted().empty() && !m_plan.character.empty() &&
                         !message.forbidsImport);
    m_import->setText(importText(m_plan));
    m_notes->setText(isOpen ? importNotes(*planned) : QString());
    m_help = message.help;
    m_strip->clear();
    m_strip->setAction(message.button);
    if (!message.sentence.isEmpty())
        m_strip->show(message.kind, message.sentence, message.remedy);
}

void ImportDialog::setRate(double fps)
{
    readControls();
    const PlannedTake* planned = current();
    if (planned == nullptr || planned->take.hasOwnFps)
        return;
    m_plan.setRate(*planned, fps);
    m_takes->showValues(m_plan);
    if (planned->take.isSampled)
        showTake(); // has other frames now
    m_rateReason->setText(rateReason(*planned));
    showProblems();
}

void ImportDialog::triggerStrip()
{
    if (m_help == ImportMessage::Help::ChooseMesh) {
        chooseMesh();
        return;
    }
    while (!m_plan.withUnknownRate().empty()) {
        const PlannedTake& first = *m_plan.withUnknownRate().front();
        m_plan.setRate(first, first.rate.fps);
    }
    m_takes->showValues(m_plan);
    showTake();
}

void ImportDialog::chooseMesh()
{
    const QString file = QFileDialog::getOpenFileName(this, tr("Mesh with the faces"),
                                                      toQString(m_found.sources.front().parent_path()),
                                                      tr("Meshes (*.obj *.ply *.off *.stl)"));
    if (file.isEmpty())
        return;
    m_found.mesh = toPath(file);
    survey();
}

void ImportDialog::setTexture(const TextureReference& texture)
{
    if (PlannedTake* planned = current(); planned != nullptr)
        planned->texture = texture;
    showPlan();
}

void ImportDialog::import()
{
    readControls();
    if (const auto problem = problemWithText(m_character->currentText())) {
        const ErrorText text = describe(*problem);
        widgets::FieldNote::show(*m_character, text.sentence, text.remedy);
        return;
    }
    std::optional<Error> refusal;
    const auto listening = connect(&EditRefusals::of(m_context.document), &EditRefusals::refused, this,
                                   [&refusal](const Error& error) { refusal = error; });
    const QStringList names = carryOut(m_plan, m_context.document);
    disconnect(listening);
    if (refusal) {
        const ErrorText text = describe(*refusal);
        m_strip->show(widgets::MessageStrip::Kind::Error, text.placed(), text.remedy);
        return;
    }
    for (const PlannedTake* planned : m_plan.wanted()) {
        for (const Issue& issue : planned->take.issues) {
            if (issue.code != Issue::Code::FpsAssumed)
                m_context.issues.add(issue, QString::fromStdString(planned->name));
        }
    }
    emit imported(names);
    accept();
}

void ImportDialog::retranslate()
{
    setWindowTitle(tr("Import"));
    m_takes->retranslate();
    m_cancel->setText(tr("Cancel"));
    m_mesh->setPlaceholderText(tr("in the files"));
    m_chooseMesh->setToolTip(tr("Choose the mesh that gives faces and texture coordinates"));
    m_fps->setSuffix(tr(" fps"));
    m_preview->setAccessibleName(tr("Preview"));
    const QStringList labels{tr("Character"), tr("Mesh"),   tr("Up, unit"),
                             tr("Rate"),      tr("Frames"), tr("Textures")};
    const QList<QWidget*> fields{m_character, m_mesh, m_axes, m_fps, m_range, m_texture};
    for (int row = 0; row < labels.size(); ++row) {
        auto* label = qobject_cast<QLabel*>(m_form->itemAt(row, QFormLayout::LabelRole)->widget());
        label->setText(labels[row]);
        label->setBuddy(fields[row]);
        fields[row]->setAccessibleName(labels[row]);
    }
    showProblems();
}

} // namespace quadrille

#include "moc_importdialog.cpp"
