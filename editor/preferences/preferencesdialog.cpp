// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/preferences/preferencesdialog.h"

#include "editor/context/editorcontext.h"
#include "editor/language/retranslate.h"
#include "editor/preferences/shortcutpage.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>

namespace quadrille {

PreferencesDialog::PreferencesDialog(EditorContext& context, QWidget* parent)
    : QDialog(parent)
    , m_context(context)
    , m_tabs(new QTabWidget)
    , m_theme(new QComboBox)
    , m_language(new QComboBox)
    , m_autosave(new QSpinBox)
    , m_history(new QSpinBox)
    , m_loops(new QCheckBox)
    , m_mouse(new QComboBox)
{
    setObjectName(QStringLiteral("preferencesDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(600, 520);
    m_tabs->addTab(makeGeneral(), QString());
    m_tabs->addTab(new ShortcutPage(context.actions), QString());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 12, 12, 12);
    column->addWidget(m_tabs, 1);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    retranslates(this, [this] { retranslate(); });
}

QWidget* PreferencesDialog::makeGeneral()
{
    Settings& settings = m_context.settings;
    m_theme->setObjectName(QStringLiteral("preferencesTheme"));
    m_theme->addItems({QString(), QString(), QString()});
    m_theme->setCurrentIndex(static_cast<int>(settings.theme()));
    m_language->setObjectName(QStringLiteral("preferencesLanguage"));
    m_language->addItem(QString(), QString());
    for (const Language& language : LanguageManager::languages())
        m_language->addItem(language.name, language.code);
    m_language->setCurrentIndex(std::max(0, m_language->findData(settings.language())));
    m_autosave->setObjectName(QStringLiteral("preferencesAutosave"));
    m_autosave->setRange(0, 10);
    m_autosave->setValue(settings.autosaveSeconds());
    m_history->setObjectName(QStringLiteral("preferencesHistory"));
    m_history->setRange(1, 4096);
    m_history->setValue(settings.historyMegabytes());
    m_loops->setObjectName(QStringLiteral("preferencesLoops"));
    m_loops->setChecked(settings.loopsPlayback());
    m_mouse->setObjectName(QStringLiteral("preferencesMouse"));
    m_mouse->addItems({QStringLiteral("Quadrille"), QStringLiteral("Blender"), QStringLiteral("Maya"),
                       QStringLiteral("ParaView")});
    m_mouse->setCurrentIndex(static_cast<int>(settings.mousePreset()));

    auto* page = new QWidget;
    m_form = new QFormLayout(page);
    m_form->setContentsMargins(16, 16, 16, 16);
    m_form->setSpacing(12);
    for (QWidget* field :
         std::initializer_list<QWidget*>{m_theme, m_language, m_autosave, m_history, m_loops, m_mouse})
        m_form->addRow(new QLabel, field);

    connect(m_theme, &QComboBox::activated, this, [this](int mode) {
        constexpr std::array actions{"theme.system", "theme.light", "theme.dark"};
        m_context.actions.action(QLatin1String(actions.at(static_cast<std::size_t>(mode))))->setChecked(true);
    });
    connect(m_language, &QComboBox::activated, this, [this] {
        m_context.settings.setLanguage(m_language->currentData().toString());
        m_context.languages.setLanguage(m_context.settings.language());
    });
    connect(m_autosave, &QSpinBox::valueChanged, &settings, &Settings::setAutosaveSeconds);
    connect(m_history, &QSpinBox::valueChanged, &settings, &Settings::setHistoryMegabytes);
    connect(m_loops, &QCheckBox::toggled, &settings, &Settings::setLoopsPlayback);
    connect(m_mouse, &QComboBox::activated, &settings,
            [&settings](int preset) { settings.setMousePreset(static_cast<widgets::MousePreset>(preset)); });
    return page;
}

void PreferencesDialog::retranslate()
{
    setWindowTitle(tr("Preferences"));
    m_tabs->setTabText(0, tr("General"));
    m_tabs->setTabText(1, tr("Shortcuts"));
    m_theme->setItemText(0, tr("As the system"));
    m_theme->setItemText(1, tr("Light"));
    m_theme->setItemText(2, tr("Dark"));
    m_language->setItemText(0, tr("As the system"));
    m_autosave->setSuffix(tr(" s"));
    m_autosave->setSpecialValueText(tr("never"));
    m_history->setSuffix(tr(" MB"));
    m_loops->setText(tr("Play over and over"));
    const QStringList labels{tr("Theme"),        tr("Language"), tr("Copy unsaved edits within"),
                             tr("Undo history"), tr("Playback"), tr("Mouse in the view")};
    const QStringList tips{{},
                           {},
                           tr("A copy is offered again after a crash"),
                           tr("Oldest edits beyond this can no longer be undone"),
                           {},
                           tr("Which buttons and keys turn, move and near the view")};
    const QList<QWidget*> fields{m_theme, m_language, m_autosave, m_history, m_loops, m_mouse};
    for (int row = 0; row < labels.size(); ++row) {
        auto* label = qobject_cast<QLabel*>(m_form->itemAt(row, QFormLayout::LabelRole)->widget());
        label->setText(labels[row]);
        label->setBuddy(fields[row]);
        fields[row]->setAccessibleName(labels[row]);
        fields[row]->setToolTip(tips[row]);
    }
}

} // namespace quadrille

#include "moc_preferencesdialog.cpp"
