// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/help/helptopics.h"

#include <QApplication>
#include <QCursor>
#include <QHash>
#include <QWidget>
#include <array>
#include <optional>

namespace quadrille {

namespace {

struct Row
{
    const char* object; ///< name of a widget, for what is in it, too
    const char* page;
    const char* heading = "";
};

constexpr std::array table{
    // Around the workspaces
    Row{"welcomePage", "first-steps"},
    Row{"projectPanel", "project"},
    Row{"cardsPanel", "playing", "Cards"},
    Row{"propertiesPanel", "project"},
    Row{"texturePanel", "textures", "The texture view"},
    Row{"issuesPanel", "importing"},
    Row{"evaluationPanel", "evaluations"},
    Row{"historyView", "project"},
    Row{"jobsPopup", "project"},
    // Views
    Row{"sequencesWorkspace", "playing"},
    Row{"timeline", "labels"},
    Row{"playbackBar", "playing"},
    Row{"tool.view.sideBySide", "comparing"},
    Row{"tool.view.overlay", "comparing"},
    Row{"tool.view.heatMap", "comparing", "Where two poses differ"},
    // Graph
    Row{"graphWorkspace", "graph"},
    Row{"graphTabs", "graph"},
    Row{"graphMap", "graph", "The matrix"},
    Row{"graphAlpha", "graph", "α"},
    Row{"transitionPanel", "graph", "Why this transition"},
    Row{"gapsPanel", "graph", "Gaps"},
    Row{"graphSettingsPanel", "graph", "Settings"},
    Row{"graphChartsPanel", "graph", "α"},
    // Animate
    Row{"animateWorkspace", "animating", "In the editor"},
    Row{"animateViewport", "animate-paths", "Drawing"},
    Row{"animateTimeline", "animate-keys", "The clip strip"},
    Row{"pathPanel", "animate-paths", "Changing"},
    Row{"keysPanel", "animate-keys", "Keys"},
    Row{"storyboardPanel", "animate-keys", "Storyboard"},
    Row{"notesPanel", "playing", "Timeline"},
    Row{"soundLane", "animate-audio-camera", "Sound"},
    Row{"cameraLane", "animate-audio-camera", "Camera"},
    Row{"junctionPanel", "animate-finish", "Transitions"},
    Row{"postPanel", "animate-finish", "Finish"},
    Row{"reportPanel", "animate-finish", "Report"},
    // Variations
    Row{"variationsWorkspace", "variations"},
    Row{"bodyPartsPanel", "body-parts"},
    Row{"movementPanel", "variations", "Movement"},
    Row{"warpPanel", "variations", "Movement"},
    Row{"learningPanel", "variations", "Learning"},
    Row{"samplesPanel", "variations", "Samples"},
    Row{"latentPanel", "variations", "Latent space"},
    // Appearance
    Row{"appearanceWorkspace", "appearance"},
    Row{"textureComparison", "appearance", "The texture view"},
    Row{"coefficientsPanel", "appearance", "Coefficients"},
    Row{"componentsPanel", "appearance", "Components"},
    Row{"masksPanel", "appearance", "Masks"},
    Row{"betweenPanel", "appearance", "Between"},
    Row{"qualityPanel", "appearance", "Quality"},
    // Live
    Row{"liveWorkspace", "live"},
    Row{"steeringPanel", "live", "Steering"},
    Row{"rewindPanel", "live", "Rewind"},
    // Transfer
    Row{"transferWorkspace", "transfer"},
    Row{"pairsPanel", "transfer", "Pairs"},
    Row{"transferSettingsPanel", "transfer", "Settings"},
    Row{"transferChart", "transfer", "Report"},
    // Dialogs
    Row{"importDialog", "importing"},
    Row{"exportDialog", "exporting"},
    Row{"relinkDialog", "project", "Files that moved"},
    Row{"preferencesDialog", "keyboard"},
    Row{"actionPalette", "keyboard"},
};

HelpTopic topicOf(const Row& row)
{
    return {QString::fromUtf8(row.page), QString::fromUtf8(row.heading)};
}

std::optional<HelpTopic> find(const QWidget* widget)
{
    static const QHash<QString, const Row*> rows = [] {
        QHash<QString, const Row*> byName;
        for (const Row& row : table)
            byName.insert(QLatin1String(row.object), &row);
        return byName;
    }();
    for (; widget != nullptr; widget = widget->parentWidget()) {
        if (const Row* row = rows.value(widget->objectName()))
            return topicOf(*row);
    }
    return std::nullopt;
}

} // namespace

HelpTopic helpTopicOf(const QWidget* widget)
{
    return find(widget).value_or(HelpTopic{});
}

HelpTopic helpTopicIn(const QWidget& window)
{
    const QWidget* pointed = QApplication::widgetAt(QCursor::pos());
    if (pointed != nullptr && pointed->window() == &window) {
        if (const auto topic = find(pointed))
            return *topic;
    }
    return helpTopicOf(window.focusWidget() != nullptr ? window.focusWidget() : &window);
}

QList<HelpTopic> helpTopics()
{
    QList<HelpTopic> topics;
    for (const Row& row : table)
        topics += topicOf(row);
    return topics;
}

} // namespace quadrille
