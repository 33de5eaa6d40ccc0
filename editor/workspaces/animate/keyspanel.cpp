// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/keyspanel.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/numberfield.h"
#include "editor/fields/ownkeys.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/keysmodel.h"
#include "widgets/controls/elidedlabel.h"
#include "widgets/theme/icons.h"

#include <QAction>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QStackedWidget>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

namespace quadrille {

namespace {

constexpr int pictureSide = 32;
constexpr int keysMargin = 8;

/// Edits times in steps of a frame.
class TimeDelegate : public QStyledItemDelegate
{
public:
    TimeDelegate(CurrentAnimation& animation, QObject* parent)
        : QStyledItemDelegate(parent), m_animation(animation)
    {
    }

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                          const QModelIndex& index) const override
    {
        const double frame = 1.0 / m_animation.context().document.project().settings.fps;
        NumberLook look{.path = "key.time", .step = frame, .decimals = 3, .highest = 3600};
        if (index.column() == KeysModel::Tolerance) {
            look.path = "key.tolerance";
            look.automatic = [] { return KeysPanel::tr("any"); };
        }
        QDoubleSpinBox* field = makeNumberField(look);
        field->setParent(parent);
        field->setObjectName(QStringLiteral("keyTime"));
        field->setFrame(false);
        if (look.automatic)
            field->setSpecialValueText(look.automatic());
        field->setAccessibleName(index.model()->headerData(index.column(), Qt::Horizontal).toString());
        return field;
    }
    void setEditorData(QWidget* editor, const QModelIndex& index) const override
    {
        // What was typed is not taken back when a result arrives meanwhile, nor before it is taken over.
        auto* field = static_cast<QDoubleSpinBox*>(editor);
        const auto* line = field->findChild<QLineEdit*>();
        if (!isEdited(*field) && (line == nullptr || !line->isModified())) {
            field->setValue(index.data(Qt::EditRole).toDouble());
            field->setProperty(filledWith, field->value());
        }
    }
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override
    {
        auto* field = static_cast<QDoubleSpinBox*>(editor);
        field->interpretText();
        // A time that is not of three decimals stays what it was while nobody changes it.
        if (isEdited(*field))
            model->setData(index, field->value(), Qt::EditRole);
    }

private:
    static constexpr const char* filledWith = "filledWith";

    static bool isEdited(const QDoubleSpinBox& field)
    {
        const QVariant filled = field.property(filledWith);
        return filled.isValid() && std::abs(field.value() - filled.toDouble()) > 0.0005;
    }

    CurrentAnimation& m_animation;
};

} // namespace

KeysPanel::KeysPanel(CurrentAnimation& animation, FramePictures& pictures, QWidget* parent)
    : QWidget(parent)
    , m_animation(animation)
    , m_model(new KeysModel(animation, pictures, this))
    , m_table(new QTableView)
    , m_pages(new QStackedWidget)
    , m_empty(new widgets::ElidedLabel)
    , m_addFirst(new QPushButton)
    , m_summary(new QLabel)
    , m_add(new QToolButton)
    , m_remove(new QToolButton)
    , m_global(new QCheckBox)
{
    setObjectName(QStringLiteral("keysPanel"));
    m_table->setObjectName(QStringLiteral("keysTable"));
    m_table->setModel(m_model);
    m_table->setItemDelegate(new TimeDelegate(animation, this));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::AnyKeyPressed |
                             QAbstractItemView::SelectedClicked);
    m_table->setIconSize({pictureSide, pictureSide});
    m_table->setShowGrid(false);
    m_table->setFont(widgets::Theme::tabularFont(m_table->font()));
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(pictureSide + 4);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(KeysModel::Pose, QHeaderView::Stretch);
    m_table->installEventFilter(this);
    m_table->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_table, &QTableView::customContextMenuRequested, this, &KeysPanel::showMenu);
    arrange();
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
        m_remove->setEnabled(selected() >= 0);
        if (!m_isTaking)
            emit keySelected(selected());
    });
    connect(m_table, &QTableView::doubleClicked, this,
            [this](const QModelIndex& index) { emit keyChosen(index.row()); });
    connect(m_remove, &QToolButton::clicked, this, [this] { emit removalRequested(selected()); });
    connect(m_global, &QCheckBox::clicked, this, [this](bool checked) {
        m_animation.edit(tr("Change how keys are sought"), QStringLiteral("search"),
                         [&](AnimationEntry& entry) { entry.search.globalKeys = checked; });
    });
    connect(&animation, &CurrentAnimation::changed, this, &KeysPanel::follow);
    connect(m_model, &QAbstractItemModel::dataChanged, this, &KeysPanel::follow);
    connect(m_model, &QAbstractItemModel::rowsInserted, this, &KeysPanel::follow);
    connect(m_model, &QAbstractItemModel::rowsRemoved, this, &KeysPanel::follow);
    retranslates(this, [this] {
        m_table->setAccessibleName(tr("Keys"));
        m_empty->setText(tr("Poses at times: drag the picture of a card onto the timeline, or put the pose "
                            "that is shown at the playhead."));
        m_empty->setToolTip(m_empty->text());
        m_addFirst->setText(tr("Add the shown pose"));
        m_remove->setToolTip(tr("Remove the key"));
        m_remove->setAccessibleName(tr("Remove the key"));
        m_global->setText(tr("Seek all keys at once"));
        m_global->setToolTip(tr("Slower, and never worse: the errors of all keys are weighed against each "
                                "other instead of one key after the other"));
        follow();
    });
}

void KeysPanel::arrange()
{
    EditorContext& context = m_animation.context();
    QAction* add = context.actions.action(QStringLiteral("animate.addKey"));
    m_add->setObjectName(QStringLiteral("addKey"));
    m_add->setDefaultAction(add);
    m_add->setAutoRaise(true);
    m_remove->setObjectName(QStringLiteral("removeKey"));
    m_remove->setIcon(widgets::icons::icon(QStringLiteral("delete")));
    m_remove->setAutoRaise(true);
    m_remove->setEnabled(false);
    m_global->setObjectName(QStringLiteral("globalKeys"));
    m_summary->setObjectName(QStringLiteral("keysSummary"));
    m_summary->setForegroundRole(QPalette::PlaceholderText);
    m_summary->setFont(widgets::Theme::tabularFont(m_summary->font()));
    m_empty->setObjectName(QStringLiteral("keysEmpty"));
    m_empty->setForegroundRole(QPalette::PlaceholderText);

    auto* emptyPage = new QWidget;
    m_addFirst->setObjectName(QStringLiteral("addFirstKey"));
    connect(m_addFirst, &QPushButton::clicked, add, &QAction::trigger);
    connect(add, &QAction::changed, m_addFirst, [this, add] { m_addFirst->setEnabled(add->isEnabled()); });
    m_addFirst->setEnabled(add->isEnabled());
    auto* emptyRow = new QHBoxLayout(emptyPage);
    emptyRow->setContentsMargins(2 * keysMargin, keysMargin / 2, 2 * keysMargin, keysMargin / 2);
    emptyRow->setSpacing(2 * keysMargin);
    emptyRow->addWidget(m_empty, 1);
    emptyRow->addWidget(m_addFirst);
    m_table->setMinimumHeight(2 * pictureSide);

    auto* tools = new QHBoxLayout;
    tools->setContentsMargins(keysMargin, 0, keysMargin, keysMargin / 2);
    tools->setSpacing(keysMargin / 2);
    tools->addWidget(m_add);
    tools->addWidget(m_remove);
    tools->addSpacing(keysMargin);
    tools->addWidget(m_global);
    tools->addStretch();
    tools->addWidget(m_summary);
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(keysMargin / 2);
    column->addWidget(m_table, 1);
    column->addLayout(tools);
    m_pages->addWidget(emptyPage);
    m_pages->addWidget(page);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(m_pages);
}

void KeysPanel::follow()
{
    m_pages->setCurrentIndex(m_model->rowCount() > 0 ? 1 : 0);
    // The page behind would ask for its height, too.
    for (int page = 0; page < m_pages->count(); ++page)
        m_pages->widget(page)->setSizePolicy(QSizePolicy::Preferred, page == m_pages->currentIndex()
                                                                         ? QSizePolicy::Preferred
                                                                         : QSizePolicy::Ignored);
    const AnimationEntry* entry = m_animation.entry();
    m_global->setChecked(entry != nullptr && entry->search.globalKeys);
    const std::vector<double> off = m_model->deviations();
    double greatest = 0;
    for (const double each : off)
        greatest = std::max(greatest, std::abs(each));
    m_summary->setText(off.empty() ? QString()
                                   : tr("At most %1 s off").arg(QLocale().toString(greatest, 'f', 2)));
}

void KeysPanel::showMenu(const QPoint& position)
{
    const ActionRegistry& actions = m_animation.context().actions;
    const int key = m_table->indexAt(position).row();
    QMenu menu(m_table);
    menu.setObjectName(QStringLiteral("keysMenu"));
    if (key >= 0) {
        menu.addAction(tr("Go to key"), this, [&] { emit keyChosen(key); });
        menu.addAction(tr("Edit the time"), this, [&] { editCell(key, KeysModel::Wanted); });
        menu.addAction(tr("Edit the tolerance"), this, [&] { editCell(key, KeysModel::Tolerance); });
        menu.addAction(tr("Remove key"), this, [&] { emit removalRequested(key); });
        menu.addSeparator();
    }
    menu.addAction(actions.action(QStringLiteral("animate.addKey")));
    menu.exec(m_table->viewport()->mapToGlobal(position));
}

int KeysPanel::selected() const
{
    return m_table->selectionModel()->hasSelection() ? m_table->currentIndex().row() : -1;
}

void KeysPanel::selectKey(int key)
{
    const QScopedValueRollback taking(m_isTaking, true);
    if (key < 0) {
        m_table->setCurrentIndex({});
        m_table->clearSelection();
    } else if (key < m_model->rowCount() && key != selected()) {
        m_table->setCurrentIndex(m_model->index(key, KeysModel::Wanted));
    }
    m_remove->setEnabled(selected() >= 0);
}

void KeysPanel::editKey(int key)
{
    editCell(key, KeysModel::Wanted);
}

void KeysPanel::editCell(int key, int column)
{
    if (key < 0 || key >= m_model->rowCount())
        return;
    window()->activateWindow();
    m_table->setFocus();
    m_table->setCurrentIndex(m_model->index(key, column));
    m_table->edit(m_table->currentIndex());
}

bool KeysPanel::eventFilter(QObject* watched, QEvent* event)
{
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    // Keys that a field in the table has no use for arrive here, too.
    const bool isEditing = m_table->isPersistentEditorOpen(m_table->currentIndex());
    if (watched == m_table && isKey && !isEditing && selected() >= 0) {
        // These come before what the window does with them.
        if (event->type() == QEvent::ShortcutOverride)
            return takesOwnKeys(*event, {Qt::Key_Delete, Qt::Key_Backspace, Qt::Key_F2});
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Delete || key == Qt::Key_Backspace) {
            emit removalRequested(selected());
            return true;
        }
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            emit keyChosen(selected());
            return true;
        }
        if (key == Qt::Key_F2) {
            const QModelIndex current = m_table->currentIndex();
            editCell(current.row(),
                     current.flags().testFlag(Qt::ItemIsEditable) ? current.column() : KeysModel::Wanted);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace quadrille

#include "moc_keyspanel.cpp"
