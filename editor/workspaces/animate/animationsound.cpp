// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/animationsound.h"

#include "editor/context/editorcontext.h"
#include "editor/documents/projectpaths.h"
#include "editor/errors/errortext.h"
#include "editor/language/retranslate.h"
#include "editor/playback/deviceoutput.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/view/sceneview.h"
#include "widgets/timeline/soundlane.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <utility>

namespace quadrille {

namespace {

struct ReadSound
{
    std::shared_ptr<const Sound> sound;
    std::shared_ptr<const Waveform> waveform;
};

ReadSound readWithPeaks(const std::filesystem::path& file, const Progress& progress)
{
    auto sound = std::make_shared<const Sound>(readSound(file, progress.part(0, 0.5)));
    return {sound, std::make_shared<const Waveform>(*sound, progress.part(0.5, 1))};
}

} // namespace

AnimationSound::AnimationSound(CurrentAnimation& animation, QObject* parent)
    : QObject(parent)
    , m_animation(animation)
    , m_lane(new widgets::SoundLane(animation.view().timeline()))
    , m_player(new SoundPlayer(animation.view().player(), makeDeviceOutput(), this))
{
    m_lane->setObjectName(QStringLiteral("soundLane"));
    animation.view().addBelowTimeline(m_lane);
    makeActions();
    connect(m_lane, &widgets::SoundLane::offsetEdited, this, &AnimationSound::setOffset);
    connect(m_lane, &widgets::SoundLane::removalRequested, this, &AnimationSound::remove);
    connect(m_lane, &widgets::SoundLane::choiceRequested, this, &AnimationSound::choose);
    connect(m_lane, &widgets::SoundLane::menuRequested, this, [this](double, const QPoint& position) {
        QMenu menu;
        for (const char* id : {"animate.sound.choose", "animate.sound.mute", "animate.sound.remove"})
            menu.addAction(m_animation.context().actions.action(QLatin1String(id)));
        menu.exec(position);
    });
    connect(&animation, &CurrentAnimation::changed, this, &AnimationSound::refresh);
    connect(&animation.context().document, &ProjectDocument::changed, this, &AnimationSound::refresh);
    retranslates(m_lane, [this] { show(); });
    refresh();
}

void AnimationSound::makeActions()
{
    ActionRegistry& actions = m_animation.context().actions;
    const auto group = [] { return tr("Animate"); };
    actions.add({"animate.sound.choose",
                 group,
                 [] { return tr("Choose soun&d…"); },
                 [] { return tr("Let a sound be heard with the animation, and in its videos"); },
                 "sound",
                 {QKeySequence(Qt::ALT | Qt::SHIFT | Qt::Key_S)}},
                [this] { choose(); });
    actions.addToggle({"animate.sound.mute",
                       group,
                       [] { return tr("&Mute"); },
                       [] { return tr("Play in silence here; videos keep their sound"); },
                       "mute",
                       {QKeySequence(Qt::Key_M | Qt::ALT)}},
                      false, [this](bool muted) {
                          m_player->setMuted(muted);
                          m_lane->setMuted(muted);
                      });
    actions.add({"animate.sound.remove",
                 group,
                 [] { return tr("Remove the sound"); },
                 [] { return tr("Take the sound away from the animation; its file stays"); },
                 "delete",
                 {}},
                [this] { remove(); });
}

void AnimationSound::choose()
{
    if (m_animation.context().document.project().sequences.empty())
        return;
    const QString file =
        QFileDialog::getOpenFileName(m_lane->window(), tr("Choose a sound"), m_folder,
                                     tr("Sounds (*.wav *.flac *.aif *.aiff *.ogg *.mp3);;All files (*)"));
    if (file.isEmpty())
        return;
    m_folder = QFileInfo(file).path();
    use(toPath(file));
}

void AnimationSound::use(const std::filesystem::path& file)
{
    m_animation.edit(tr("Choose the sound"), QStringLiteral("audio"), [&](AnimationEntry& entry) {
        AudioEntry audio;
        audio.file = std::filesystem::absolute(file).lexically_normal().generic_string();
        entry.audio = std::move(audio);
    });
}

void AnimationSound::remove()
{
    if (m_animation.entry() == nullptr)
        return;
    m_animation.edit(tr("Remove the sound"), QStringLiteral("audio"),
                     [](AnimationEntry& entry) { entry.audio.reset(); });
}

void AnimationSound::setOffset(double seconds, bool committed)
{
    const AnimationEntry* entry = m_animation.entry();
    if (entry == nullptr || !entry->audio)
        return;
    m_animation.edit(
        tr("Move the sound"), QStringLiteral("audio offset"),
        [seconds](AnimationEntry& edited) { edited.audio->offset = seconds; },
        committed ? EditPhase::Final : EditPhase::Dragging);
}

void AnimationSound::refresh()
{
    const AnimationEntry* entry = m_animation.entry();
    const bool hasSound = entry != nullptr && entry->audio.has_value();
    const std::filesystem::path file = hasSound ? std::filesystem::path(entry->audio->file) : "";
    if (file != m_file) {
        m_file = file;
        m_sound.reset();
        m_waveform.reset();
        m_error.reset();
        if (m_job)
            m_job->cancel();
        if (hasSound)
            read(file);
    }
    show();
}

void AnimationSound::read(const std::filesystem::path& file)
{
    m_job = m_animation.context().jobs.start(
        {.name = tr("Reading %1").arg(toQString(file.filename())),
         .receiver = this,
         .stillStands = [this, file] { return file == m_file; },
         .failed =
             [this](const Error& error) {
                 m_error = error;
                 m_animation.context().issues.add(error, m_animation.name());
                 show();
             }},
        [file](const Progress& progress) { return readWithPeaks(file, progress); },
        [this](const ReadSound& read) {
            m_sound = read.sound;
            m_waveform = read.waveform;
            show();
        });
}

void AnimationSound::show()
{
    const AnimationEntry* entry = m_animation.entry();
    const bool hasSound = entry != nullptr && entry->audio.has_value();
    const double fps = m_animation.context().document.project().settings.fps;
    QString notice = tr("No sound: click to choose a WAV file");
    if (m_error)
        notice = describe(*m_error).sentence;
    else if (hasSound)
        notice = tr("Reading the sound…");
    m_lane->setFps(fps);
    m_lane->setTexts(tr("Sound"), notice);
    m_lane->setOffset(hasSound ? entry->audio->offset : 0);
    const auto waveform = m_waveform;
    if (m_waveform != nullptr)
        m_lane->setSound(toQString(m_file.filename()), m_waveform->seconds(),
                         [waveform](double from, double seconds, int count) {
                             std::vector<std::pair<float, float>> peaks;
                             for (const SoundPeak& peak : waveform->peaks(from, seconds, count))
                                 peaks.emplace_back(peak.low, peak.high);
                             return peaks;
                         });
    else
        m_lane->setSound({}, 0, {});
    m_player->setFps(fps);
    m_player->setSound(m_sound, hasSound ? entry->audio->offset : 0, hasSound ? entry->audio->gain : 0);
    for (const char* id : {"animate.sound.mute", "animate.sound.remove"})
        m_animation.context().actions.action(QLatin1String(id))->setEnabled(hasSound);
}

} // namespace quadrille

#include "moc_animationsound.cpp"
