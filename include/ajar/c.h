#ifndef AJAR_C_H
#define AJAR_C_H
#include <stddef.h>
#include <stdint.h>

/*
The library for other languages: C, opaque handles, and JSON for all that has names
(docs/c-interface.md). It prints nothing, handles no signals and replaces no allocator.

    ajar_scene* scene = NULL;
    ajar_render* render = NULL;
    ajar_picture* picture = NULL;
    if (ajar_scene_load("builtin:cornell", &scene) == AJAR_OK &&
        ajar_render_start(scene, "{\"seconds\": 10}", &render) == AJAR_OK &&
        ajar_render_wait(render, -1, NULL) == AJAR_OK &&
        ajar_render_picture(render, &picture) == AJAR_OK) {
      ajar_picture_save(picture, "cornell.png", NULL);
    } else {
      fprintf(stderr, "%s\n", ajar_last_error());
    }
    ajar_picture_free(picture);
    ajar_render_free(render);
    ajar_scene_free(scene);

All functions may be called from any thread, with the same handles, too, but for what frees a
handle: that comes last. Texts are UTF-8 and end with a zero. What is given out with `char**` is
freed with `ajar_text_free`. Freeing NULL does nothing; elsewhere NULL is an error, AJAR_USAGE,
unless it is said what it stands for.
*/
#ifdef __cplusplus
extern "C" {
#endif

#ifndef AJAR_API
#define AJAR_API __attribute__((visibility("default")))
#endif

/* What a function has to say. */
enum {
  AJAR_OK = 0,
  AJAR_USAGE = 1,   /* an unknown name, or a value that cannot be */
  AJAR_SCENE = 2,   /* a scene that cannot be used; the message begins with the place */
  AJAR_FILE = 3,    /* a file that cannot be read or written */
  AJAR_STOPPED = 4, /* a render that was stopped before there was a picture */
  AJAR_MEMORY = 5,  /* too little memory */
  AJAR_OTHER = 6    /* anything else */
};

typedef struct ajar_scene ajar_scene;
typedef struct ajar_render ajar_render;
typedef struct ajar_picture ajar_picture;

/* Grows with every function or member of JSON that is added. */
#define AJAR_C_VERSION 3
AJAR_API int ajar_c_version(void);
/* Of the library, such as "0.2.0". */
AJAR_API const char* ajar_version(void);
/* Of the function that failed last on this thread; valid until the next call there. */
AJAR_API const char* ajar_last_error(void);
AJAR_API void ajar_text_free(char* text);

/* What there is to choose from, as `ajar list KIND --json` has it. */
AJAR_API int ajar_catalog(const char* kind, char** json);
/* Whether {"model": …, "parameters": …} makes a node of a scene; `kind` is material, texture,
   light, emission or shape. */
AJAR_API int ajar_node_check(const char* kind, const char* node);

/* ---- Scenes: read or described once, rendered as often as wanted, never changed. */

/* A file in any format that `ajar render` takes, or builtin:NAME. */
AJAR_API int ajar_scene_load(const char* name, ajar_scene** scene);

/* Numbers of the caller, row by row; copied while the scene is made. */
typedef struct ajar_array {
  const void* data;
  int type; /* AJAR_FLOAT32, AJAR_UINT32, AJAR_UINT8 */
  int dimensions;
  size_t shape[3];
} ajar_array;
enum { AJAR_FLOAT32 = 0, AJAR_UINT32 = 1, AJAR_UINT8 = 2 };

/* A new scene that is `base` (NULL: an empty one) with changes: docs/c-interface.md. Without arrays
   `arrays` may be NULL. */
AJAR_API int ajar_scene_change(const ajar_scene* base, const char* changes,
                               const ajar_array* arrays, size_t count, ajar_scene** scene);
/* Name, width, height, and what is unusual in its files. */
AJAR_API int ajar_scene_information(const ajar_scene* scene, char** json);
/* Textures, materials, lights and shapes with their parameters: what changes can edit. */
AJAR_API int ajar_scene_parts(const ajar_scene* scene, char** json);
/* Renders of it go on. */
AJAR_API void ajar_scene_free(ajar_scene* scene);

/* ---- Renders */

/* Begins to render on a thread of its own. `settings`: a JSON object, NULL for all defaults. */
AJAR_API int ajar_render_start(const ajar_scene* scene, const char* settings, ajar_render** render);
/* Waits for the end, at most so many seconds (below 0: as long as it takes), and says in `done`,
   which may be NULL, whether it came. If the render failed, with what it failed. */
AJAR_API int ajar_render_wait(ajar_render* render, double seconds, int* done);
/* Ends it after the pass that runs; called twice, within it. Does not wait. */
AJAR_API int ajar_render_stop(ajar_render* render);
/* The picture as it is; waits for the end of the pass that runs. Before the first pass, a rough
   look of 0 samples per pixel if the method has one, without other layers; else NULL. */
AJAR_API int ajar_render_picture(ajar_render* render, ajar_picture** picture);
/* How far it is: preparing, seconds, samples_per_pixel, fraction, estimated_error,
   error_is_lower_bound, done. */
AJAR_API int ajar_render_progress(ajar_render* render, char** json);
/* All that is known, with the keys of `ajar render --stats`; waits as `ajar_render_picture` does.
 */
AJAR_API int ajar_render_statistics(ajar_render* render, char** json);
/* What was said so far: {"warnings": […], "troubles": […], "notes": […]}. Troubles are files that
   could not be written, such as the checkpoint, and where they are instead. */
AJAR_API int ajar_render_messages(ajar_render* render, char** json);
/* Stops it, and waits until it has. */
AJAR_API void ajar_render_free(ajar_render* render);

/* ---- Pictures: they never change. */

/* Pixels; 0 for NULL. */
AJAR_API int ajar_picture_width(const ajar_picture* picture);
AJAR_API int ajar_picture_height(const ajar_picture* picture);
/* Names of the layers; "" is the picture itself, always the first. */
AJAR_API int ajar_picture_layers(const ajar_picture* picture, char** json);
/* Rows from the top, channels (1 or 3) interleaved; valid as long as the handle is. */
AJAR_API int ajar_picture_pixels(const ajar_picture* picture, const char* layer, int* channels,
                                 const float** pixels);
/* What is known of its making. */
AJAR_API int ajar_picture_metadata(const ajar_picture* picture, char** json);
/* Writes .exr, .pfm, .hdr, .png or .jpg. `display`: {"exposure": stops, "tone_map": name}, or NULL.
 */
AJAR_API int ajar_picture_save(const ajar_picture* picture, const char* path, const char* display);
/* A scene-linear picture of a file: .exr with its layers, .hdr, .pfm. */
AJAR_API int ajar_picture_load(const char* path, ajar_picture** picture);
AJAR_API void ajar_picture_free(ajar_picture* picture);

/* Files against a reference, as `ajar compare --json`: {"reference": file, "pictures": [file, …],
   "metrics": [name, …], "pixels_per_degree": number}, of which the last two may be left out. */
AJAR_API int ajar_compare(const char* request, char** json);

#ifdef __cplusplus
}
#endif
#endif
