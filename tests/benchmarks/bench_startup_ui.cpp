// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// From starting the editor's process until its window has been painted for the first time. Settings are of
// its own, so that it begins with the welcome page; with the argument 1 it opens a project of one sequence.
#include <QProcess>
#include <QProcessEnvironment>
#include <QTemporaryDir>
#include <benchmark/benchmark.h>
#include <fstream>

namespace {

/// What Qt says when it brings a painted window to the screen.
constexpr const char* painted = "Painting and flushing";

void writeMesh(const QString& file)
{
    std::ofstream(file.toStdString())
        << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
}

void startEditor(benchmark::State& state)
{
    const QTemporaryDir home;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* folder : {"HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"})
        environment.insert(folder, home.path());
    environment.insert("QT_LOGGING_RULES", "qt.widgets.painting.info=true");
    const QString mesh = home.filePath("mesh.obj");
    writeMesh(mesh);
    for ([[maybe_unused]] auto _ : state) {
        QProcess editor;
        editor.setProcessEnvironment(environment);
        editor.setProcessChannelMode(QProcess::MergedChannels);
        editor.start(QUADRILLE_EDITOR, state.range(0) == 0 ? QStringList() : QStringList(mesh));
        QByteArray said;
        while (!said.contains(painted) && editor.waitForReadyRead())
            said += editor.readAll();
        if (!said.contains(painted)) {
            state.SkipWithError("the editor painted nothing within 30 s");
            break;
        }
        state.PauseTiming();
        editor.kill();
        editor.waitForFinished();
        state.ResumeTiming();
    }
}

} // namespace

BENCHMARK(startEditor)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(5);
