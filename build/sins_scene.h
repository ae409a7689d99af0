/*
 * sins_scene.h - scenes and flight logs, as texts. The conventions are those of sins.h.
 *
 * A scene describes a flight, the settings of the simulator, and the planned failures of the sensors. Its text
 * form is TOML. A log is a flight as a table of samples, also as text. The host reads the files; the library parses their
 * bytes:
 *
 *     sins_scene_parse(text, size, &scene);          SINS_SCENE_HAS_FAULTS: sins_scene_get_fault() gives each fault and its place
 *     sins_play_create(scene, log, &play);           log: sins_log_parse() of the file that SINS_SCENE_TEXT_LOG names, or NULL
 *     while (sins_play_run(play, records, 100, &written) == SINS_OK)   with temperature, failures, updates and unit of the scene;
 *         ...                                                          SINS_PLAY_END: the flight is over
 *     sins_play_get_simulator(play, &sim);           for every read
 *
 * A library that was built without the feature "scenes" lacks all functions of this header. A program that calls them directly
 * does not link with such a library, or does not start. A program that loads the library at run time looks up
 * sins_scene_create by dlsym() or GetProcAddress(): if it is not found, there are no scenes. All else is the same.
 *
 * build/ writes this file; do not edit it.
 */

#ifndef SINS_SCENE_H
#define SINS_SCENE_H

#include "sins_ensemble.h"
#include "sins_flight.h"
#include "sins_unit.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Scenes. */

@scene/fault scene/mod scene/prepare scene/unit scene/settings scene/flight scene/text scene/failure

/* Values of a scene by their paths. */

@scene/key scene/value

/* Flight logs, and the samples of a scene. */

@scene/log_file scene/log scene/samples

/* Scenes in flight. */

@scene/play scene/play_saved

/** Sizes of the structs in bytes, as enum sins_sizeof. */
enum sins_scene_sizeof {
@sizes
};

#ifdef __cplusplus
}
#endif

#endif /* SINS_SCENE_H */
