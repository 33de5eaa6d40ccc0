// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/animationjson.h"
#include "model/project/projectkeys.h"

namespace quadrille {

AudioEntry readAudio(const ObjectReader& reader)
{
    AudioEntry audio;
    audio.file = reader.requiredText("file");
    audio.offset = reader.number("offset").value_or(0);
    audio.gain = reader.number("gain").value_or(0);
    audio.unknown = reader.unknown(projectkeys::audio);
    return audio;
}

CameraKeyEntry readCameraKey(const ObjectReader& reader)
{
    CameraKeyEntry entry;
    const auto required = [&](const char* key) {
        if (reader.find(key) == nullptr)
            reader.missing(key);
        return reader.number(key).value_or(0);
    };
    entry.key.time = required("time");
    if (reader.find("target") == nullptr)
        reader.missing("target");
    if (const auto target = reader.numbers("target", 3, "three coordinates, [x, y, z]"))
        entry.key.target = {(*target)[0], (*target)[1], (*target)[2]};
    entry.key.distance = required("distance");
    entry.key.azimuth = reader.number("azimuth").value_or(entry.key.azimuth);
    entry.key.elevation = reader.number("elevation").value_or(entry.key.elevation);
    entry.key.fieldOfView = reader.number("fov").value_or(entry.key.fieldOfView);
    entry.unknown = reader.unknown(projectkeys::cameraKey);
    return entry;
}

} // namespace quadrille
