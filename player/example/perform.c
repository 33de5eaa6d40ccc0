/* SPDX-FileCopyrightText: 2026 The Quadrille developers
 * SPDX-License-Identifier: MIT
 *
 * perform PLAYER [--list | --recording | --steer] OUT
 *
 * Plays a file that Quadrille exported as “player”, as a game would, without a window.
 *   --recording  the recording that it holds (the default); OUT gets the frames of its clip
 *   --steer      ten seconds: each space for a while, its first parameter from least to greatest; OUT gets all frames
 *   --list       says what can be steered; no OUT
 * OUT: the positions of all vertices, frame after frame: three floats each, metres.
 *
 * cc perform.c -lquadrille_player -o perform */
#include <quadrille_player.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void list(const QuadrillePlayer* player)
{
    printf("%u vertices, %u triangles, a tick each %.4f s\n", quadrille_player_vertex_count(player),
           quadrille_player_triangle_count(player), quadrille_player_tick_seconds(player));
    for (uint32_t space = 0; space < quadrille_player_space_count(player); ++space) {
        printf("%s%s\n", quadrille_player_space_name(player, space),
               quadrille_player_space_is_cyclic(player, space) ? "" : " (once)");
        QuadrilleParameter parameter;
        for (uint32_t p = 0; quadrille_player_parameter(player, space, p, &parameter); ++p)
            printf("    %s %g … %g %s\n", parameter.name, parameter.least, parameter.greatest, parameter.unit);
    }
}

/* What is wanted at a tick: that is all a game has to say. */
static QuadrilleInput steered(const QuadrillePlayer* player, int64_t tick, int64_t ticks)
{
    const uint32_t spaces = quadrille_player_space_count(player);
    const int64_t each = (ticks + spaces - 1) / spaces;
    QuadrilleInput input;
    memset(&input, 0, sizeof input);
    input.space = (uint32_t)(tick / each);
    QuadrilleParameter parameter;
    for (uint32_t p = 0; quadrille_player_parameter(player, input.space, p, &parameter); ++p) {
        const double share = p == 0 ? (double)(tick % each) / (double)each : 0.5;
        input.parameters[p] = parameter.least + share * (parameter.greatest - parameter.least);
    }
    return input;
}

static int writePose(QuadrillePlayer* player, float* pose, FILE* out)
{
    const size_t coordinates = 3 * (size_t)quadrille_player_vertex_count(player);
    quadrille_player_pose(player, pose);
    return fwrite(pose, sizeof *pose, coordinates, out) == coordinates;
}

/* Plays from one tick to another. Returns 0 where writing fails. */
static int perform(QuadrillePlayer* player, int isRecording, FILE* out)
{
    const int64_t second = (int64_t)(1 / quadrille_player_tick_seconds(player) + 0.5);
    const int64_t ticks = isRecording ? quadrille_player_recorded_ticks(player) : 10 * second;
    const int64_t from = isRecording ? quadrille_player_recorded_from(player) : 0;
    const int64_t perFrame = quadrille_player_ticks_per_frame(player);
    float* pose = malloc(3 * sizeof *pose * quadrille_player_vertex_count(player));
    int isWritten = pose != NULL;
    QuadrilleTransition last;
    int64_t told = -1;
    for (int64_t tick = 0; isWritten && tick <= ticks; ++tick) {
        if (tick >= from && (tick - from) % perFrame == 0)
            isWritten = writePose(player, pose, out);
        QuadrilleInput input = steered(player, tick < ticks ? tick : ticks - 1, ticks);
        if (isRecording)
            quadrille_player_recorded(player, tick, &input);
        if (tick < ticks)
            quadrille_player_tick(player, &input);
        if (quadrille_player_transition(player, &last) && last.tick != told) {
            told = last.tick;
            printf("%.2f s: from %s to %s in %.2f s\n", (double)told * quadrille_player_tick_seconds(player),
                   quadrille_player_space_name(player, last.from), quadrille_player_space_name(player, last.to),
                   last.latency);
        }
    }
    free(pose);
    return isWritten;
}

int main(int count, char** words)
{
    const char* what = count > 2 && strncmp(words[2], "--", 2) == 0 ? words[2] : "--recording";
    const int isList = strcmp(what, "--list") == 0;
    const int isRecording = strcmp(what, "--recording") == 0;
    const char* file = isList || count < 3 ? NULL : words[count - 1];
    if (count < 3 || count > 4 || (!isList && !isRecording && strcmp(what, "--steer") != 0) ||
        (file != NULL && strncmp(file, "--", 2) == 0)) {
        fprintf(stderr, "Usage: perform PLAYER [--list | --recording | --steer] OUT\n");
        return 2;
    }
    char error[1000];
    QuadrillePlayer* player = quadrille_player_open(words[1], error, sizeof error);
    if (player == NULL) {
        fprintf(stderr, "error: %s\n", error);
        return 1;
    }
    int isDone = 1;
    if (isList) {
        list(player);
    } else {
        FILE* out = fopen(file, "wb");
        if (out != NULL) {
            isDone = perform(player, isRecording, out);
            isDone = fclose(out) == 0 && isDone;
        } else {
            isDone = 0;
        }
        if (!isDone)
            fprintf(stderr, "error: %s cannot be written.\n", file);
    }
    quadrille_player_close(player);
    return isDone ? 0 : 1;
}
