// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#ifndef QUADRILLE_PLAYER_H
#define QUADRILLE_PLAYER_H

/* Plays a performer's motion spaces live, from a file that Quadrille exports (format “player”): inputs go in,
 * pose, place and texture come out (4D parametric motion graphs: Casas, Tejera, Guillemaut & Hilton 2013).
 *
 * Lengths are metres, angles radians counter-clockwise seen from above. The axes are those of the project;
 * the ground has two of them, as QuadrilleRoot says. The same file, start and inputs give the same bytes as
 * the editor's.
 *
 * A player belongs to one thread at a time; several players may be used by several threads. What a function
 * returns a pointer to stays until the player is closed, unless it says otherwise. Nothing is allocated after
 * quadrille_player_open but by quadrille_player_texture. Indices that are not there are answered by 0, or
 * NULL. */

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
#define QUADRILLE_API __declspec(dllexport)
#else
#define QUADRILLE_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef struct QuadrillePlayer QuadrillePlayer;

/* A parameter that steers a space. */
typedef struct QuadrilleParameter
{
    const char* name;
    const char* unit; /* "m/s", "deg/s", "m", or "" of one that was placed by hand */
    double least;     /* what is beyond is taken to the limits */
    double greatest;
} QuadrilleParameter;

/* What is wanted at a tick. */
typedef struct QuadrilleInput
{
    uint32_t space;
    uint32_t responsive;  /* not 0: waiting counts more than likeness when a transition is chosen */
    double parameters[3]; /* of that space, in their units */
} QuadrilleInput;

/* Where the body is on the ground: turned, then shifted. The ground's axes are z and x where y is up, x and y
 * where z is up, y and z where x is up. */
typedef struct QuadrilleRoot
{
    double turn;
    double shift[2];
} QuadrilleRoot;

/* The captured frame that the pose is most like. */
typedef struct QuadrilleFrame
{
    const char* sequence; /* its name in the project */
    int64_t frame;
    uint32_t mirrored; /* not 0: left and right are exchanged */
    int32_t texture;   /* for quadrille_player_texture; -1 without one */
    double share;      /* of its take in the pose, 0 … 1 */
} QuadrilleFrame;

/* The transition that was decided last. */
typedef struct QuadrilleTransition
{
    int64_t tick; /* at which it was */
    uint32_t from;
    uint32_t to;
    double latency;       /* seconds since it was wished for, until the target is as it was wanted */
    double dissimilarity; /* of both poses, 0 … 1000 */
} QuadrilleTransition;

/* Opens a file. Returns NULL where that fails, with an English sentence in `error` (ended by 0, cut where it
 * is too long), which may be NULL where `errorSize` is 0. */
QUADRILLE_API QuadrillePlayer* quadrille_player_open(const char* path, char* error, size_t errorSize);
/* NULL is allowed. */
QUADRILLE_API void quadrille_player_close(QuadrillePlayer* player);

/* What there is. */
QUADRILLE_API uint32_t quadrille_player_space_count(const QuadrillePlayer* player);
QUADRILLE_API const char* quadrille_player_space_name(const QuadrillePlayer* player, uint32_t space);
/* Whether it goes on and on; others end, and lead on where it is wanted or back to the last one that goes on.
 */
QUADRILLE_API int quadrille_player_space_is_cyclic(const QuadrillePlayer* player, uint32_t space);
QUADRILLE_API uint32_t quadrille_player_parameter_count(const QuadrillePlayer* player, uint32_t space);
/* Returns 0 where there is none. */
QUADRILLE_API int quadrille_player_parameter(const QuadrillePlayer* player, uint32_t space,
                                             uint32_t parameter, QuadrilleParameter* out);
/* The axis that is up: 0 x, 1 y, 2 z. */
QUADRILLE_API int quadrille_player_up_axis(const QuadrillePlayer* player);
QUADRILLE_API double quadrille_player_tick_seconds(const QuadrillePlayer* player);
QUADRILLE_API uint32_t quadrille_player_ticks_per_frame(const QuadrillePlayer* player);

/* The mesh: three vertices for each triangle, counter-clockwise seen from outside. Texture coordinates belong
 * to the corners of triangles, two for each, with their origin at the lower left; NULL where the mesh has
 * none. */
QUADRILLE_API uint32_t quadrille_player_vertex_count(const QuadrillePlayer* player);
QUADRILLE_API uint32_t quadrille_player_triangle_count(const QuadrillePlayer* player);
QUADRILLE_API const uint32_t* quadrille_player_triangles(const QuadrillePlayer* player);
QUADRILLE_API const float* quadrille_player_texture_coordinates(const QuadrillePlayer* player);

/* Begins anew, in the cycle of a space, at a place. Returns 0, and changes nothing, where there is no such
 * space or a number is not finite. */
QUADRILLE_API int quadrille_player_start(QuadrillePlayer* player, const QuadrilleInput* input,
                                         const QuadrilleRoot* root);
/* One tick. An input that makes no sense is left out: what was wanted before still is. */
QUADRILLE_API void quadrille_player_tick(QuadrillePlayer* player, const QuadrilleInput* input);
QUADRILLE_API int64_t quadrille_player_tick_count(const QuadrillePlayer* player);
/* The space that is played. */
QUADRILLE_API uint32_t quadrille_player_space(const QuadrillePlayer* player);
/* Three coordinates for each vertex. */
QUADRILLE_API void quadrille_player_pose(QuadrillePlayer* player, float* positions);
/* The same, and normals, three coordinates of length 1 for each vertex. */
QUADRILLE_API void quadrille_player_surface(QuadrillePlayer* player, float* positions, float* normals);
QUADRILLE_API void quadrille_player_root(const QuadrillePlayer* player, QuadrilleRoot* out);
QUADRILLE_API void quadrille_player_frame(const QuadrillePlayer* player, QuadrilleFrame* out);
/* Two captured frames whose textures the pose fades between; the same ones where it has one.
 * Their shares are of the whole pose. Returns the
 * weight of the second's texture, 0 … 0.5: it changes without jumps while frames follow each other. */
QUADRILLE_API double quadrille_player_look(const QuadrillePlayer* player, QuadrilleFrame* first,
                                           QuadrilleFrame* second);
/* Returns 0 where none was decided yet. */
QUADRILLE_API int quadrille_player_transition(const QuadrillePlayer* player, QuadrilleTransition* out);

/* A texture as a PNG or JPEG file holds it; NULL where there is none, or it cannot be read. It stays until
 * the next call. */
QUADRILLE_API const void* quadrille_player_texture(QuadrillePlayer* player, int32_t texture, size_t* size);

/* Going back: a state takes so many bytes, is valid for all players of the same file, and is the same after
 * the same inputs. Restoring returns 0, and changes nothing, where the bytes are no state of such a player.
 */
QUADRILLE_API size_t quadrille_player_state_size(const QuadrillePlayer* player);
QUADRILLE_API void quadrille_player_save(QuadrillePlayer* player, void* state);
QUADRILLE_API int quadrille_player_restore(QuadrillePlayer* player, const void* state);

/* The recording that the file was made from: the player begins where it does. */
QUADRILLE_API int64_t quadrille_player_recorded_ticks(const QuadrillePlayer* player);
/* The tick of the first frame of its clip. */
QUADRILLE_API int64_t quadrille_player_recorded_from(const QuadrillePlayer* player);
/* Returns 0 where there is no such tick. */
QUADRILLE_API int quadrille_player_recorded(const QuadrillePlayer* player, int64_t tick, QuadrilleInput* out);

#ifdef __cplusplus
}
#endif

#endif
