#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
"""play.py FILM: plays a film in Chromium, without a window, and prints what the browser says of it, a word and its
numbers a line. Ends with 77 where there is no Chromium, with 1 where it says nothing in time."""
import http.server
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import threading

SECONDS = 60
PAGE = b"""<!doctype html><video id="film" muted src="/film"></video><script>
const film = document.getElementById("film");
const lines = [];
const tell = (word, ...values) => lines.push([word, ...values].join(" "));
const finish = () => fetch("/said", { method: "POST", body: lines.join("\\n") });

// The corners of what is shown, and its middle.
function tellColors() {
    const canvas = document.createElement("canvas");
    canvas.width = film.videoWidth;
    canvas.height = film.videoHeight;
    const context = canvas.getContext("2d");
    context.drawImage(film, 0, 0);
    const across = [0.25, 0.75], down = [0.25, 0.75];
    for (const y of down)
        for (const x of across)
            tell("color", ...context.getImageData(x * canvas.width, y * canvas.height, 1, 1).data.slice(0, 3));
}

// When the sound is first heard, when last, and how loud it is.
async function tellSound() {
    const bytes = await (await fetch("/film")).arrayBuffer();
    const sound = await new OfflineAudioContext(1, 1, 48000).decodeAudioData(bytes).catch(() => null);
    if (!sound)
        return;
    const samples = sound.getChannelData(0);
    const heard = value => Math.abs(value) > 0.1;
    tell("sound", samples.findIndex(heard) / 48000, samples.findLastIndex(heard) / 48000,
         samples.reduce((most, value) => Math.max(most, Math.abs(value)), 0), sound.duration);
}

film.onerror = () => { tell("error", film.error.code, film.error.message); finish(); };
film.onended = async () => {
    tell("size", film.videoWidth, film.videoHeight);
    tell("time", film.currentTime, film.duration);
    tell("frames", film.getVideoPlaybackQuality().totalVideoFrames);
    tell("bytes", film.webkitVideoDecodedByteCount, film.webkitAudioDecodedByteCount);
    tellColors();
    await tellSound();
    finish();
};
film.play();
</script>"""

browser = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
if browser is None:
    print("Chromium is not installed.")
    sys.exit(77)
with open(sys.argv[1], "rb") as file:
    film = file.read()
said = []
done = threading.Event()


class Server(http.server.BaseHTTPRequestHandler):
    def do_GET(self):
        found = {"/": ("text/html", PAGE), "/film": ("video/" + sys.argv[1].rsplit(".", 1)[1], film)}.get(self.path)
        self.send_response(200 if found else 404)
        if found:
            self.send_header("Content-Type", found[0])
            self.send_header("Content-Length", str(len(found[1])))
        self.end_headers()
        if found:
            self.wfile.write(found[1])

    def do_POST(self):
        said.append(self.rfile.read(int(self.headers["Content-Length"])).decode())
        self.send_response(204)
        self.end_headers()
        done.set()

    def log_message(self, *_):
        pass


server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Server)
threading.Thread(target=server.serve_forever, daemon=True).start()
with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
    command = [browser, "--headless=new", "--no-sandbox", "--disable-gpu", "--mute-audio", "--no-first-run",
               "--disable-extensions", "--disable-sync", "--disable-background-networking",
               "--autoplay-policy=no-user-gesture-required", "--user-data-dir=" + profile,
               f"http://127.0.0.1:{server.server_port}/"]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                          start_new_session=True) as process:
        done.wait(SECONDS)
        os.killpg(process.pid, signal.SIGKILL)
print("\n".join(said))
sys.exit(0 if said else 1)
