// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/audio/mp3.h"

#include <filesystem>

namespace quadrille {

/// Adds a sound to an MP4 file that has pictures only. The pictures are not touched; the sound begins with
/// the first of them, and ends with the last where it is not shorter.
///
/// OpenCV writes no sound, and the libraries that would write both are built under the GPL. A track is a
/// handful of tables (ISO/IEC 14496-12), so they are written here: MP3, which every player decodes in MP4 and
/// whose encoder may be linked, after the pictures, and its tables into the file's “moov” box.
/// \throws Error FileSyntax where the file is not such an MP4; ReadFailed, WriteFailed.
void addSound(const std::filesystem::path& mp4, const Mp3Stream& sound);

} // namespace quadrille
