/*
 * MEX file for MATLAB and Octave: flies a matrix of samples.
 *
 *     table = sins_fly(samples, scene)
 *
 * samples has a row for each instant: time s; latitude, longitude rad; height m; velocity east, north, up m/s; roll, pitch,
 * heading rad. scene, a text in TOML, sets options, sensors, failures, updates and the unit; without it the options are the defaults and
 * the sensors are ideal. table has a row for each row of samples: time; then the navigation in the same columns; then its errors: position
 * m, velocity m/s, misalignment rad, each east, north, up. If a call fails, the error has the identifier "sins:" with the name of
 * the status.
 */

#include <stdio.h>

#include "mex.h"
#include "sins_scene.h"

/*
 * Destroys the handles and ends the MEX file with the library's sentence, or with the first fault of the scene. row: the faulty
 * row, from 1, or 0.
 */
static void fail(sins_play *play, sins_scene *scene, sins_status status, size_t row)
{
    char sentence[512] = "", identifier[64];
    int length = row > 0 ? sprintf(sentence, "row %d: ", (int)row) : 0;
    sins_fault fault;

    SINS_INIT(fault);
    if (status == SINS_SCENE_HAS_FAULTS && sins_scene_get_fault(scene, 0, &fault) == SINS_OK) {
        sprintf(sentence, "scene, line %d: %s", (int)fault.line, fault.sentence);
    } else {
        sins_last_error(NULL, sentence + length, sizeof sentence - (size_t)length, NULL);
    }
    sprintf(identifier, "sins:%s", sins_status_string(status));
    sins_play_destroy(play); /* a NULL handle is harmless: the library returns an error */
    sins_scene_destroy(scene);
    mexErrMsgIdAndTxt(identifier, "%s", sentence);
}

void mexFunction(int outputs, mxArray *output[], int inputs, const mxArray *input[])
{
    sins_scene *scene = NULL;
    sins_play *play = NULL;
    sins_sim *sim = NULL;
    sins_flight_sample sample;
    sins_record record;
    const sins_record_solution *navigation = &record.navigation;
    const sins_record_errors *errors = &record.navigation_errors;
    /* Targets of the input columns, and sources of the output columns. */
    double *const fields[] = {&sample.time_s, &sample.latitude_rad, &sample.longitude_rad, &sample.height_m,
                              &sample.velocity_enu_m_s[0], &sample.velocity_enu_m_s[1], &sample.velocity_enu_m_s[2],
                              &sample.roll_rad, &sample.pitch_rad, &sample.heading_rad};
    const double *const values[] = {
        &record.time_s, &navigation->latitude_rad, &navigation->longitude_rad, &navigation->height_m,
        &navigation->velocity_enu_m_s[0], &navigation->velocity_enu_m_s[1], &navigation->velocity_enu_m_s[2],
        &navigation->roll_rad, &navigation->pitch_rad, &navigation->heading_rad,
        &errors->position_enu_m[0], &errors->position_enu_m[1], &errors->position_enu_m[2],
        &errors->velocity_enu_m_s[0], &errors->velocity_enu_m_s[1], &errors->velocity_enu_m_s[2],
        &errors->misalignment_enu_rad[0], &errors->misalignment_enu_rad[1], &errors->misalignment_enu_rad[2]};
    const size_t inputs_of_row = sizeof fields / sizeof fields[0], outputs_of_row = sizeof values / sizeof values[0];
    const double *samples;
    sins_status status;
    size_t rows, k, column;
    char *text;

    (void)outputs;
    if (inputs < 1 || inputs > 2 || !mxIsDouble(input[0]) || mxIsComplex(input[0]) || mxGetN(input[0]) != inputs_of_row
        || (inputs == 2 && !mxIsChar(input[1]))) {
        mexErrMsgIdAndTxt("sins:usage", "table = sins_fly(samples, scene): a real matrix of %d columns, and a text",
                          (int)inputs_of_row);
    }
    samples = mxGetPr(input[0]);
    rows = mxGetM(input[0]);
    output[0] = mxCreateDoubleMatrix(rows, outputs_of_row, mxREAL);

    text = inputs == 2 ? mxArrayToString(input[1]) : NULL;
    status = text != NULL ? sins_scene_parse(text, strlen(text), &scene) : sins_scene_create(&scene);
    mxFree(text);
    status = status == SINS_OK ? sins_play_create(scene, NULL, &play) : status;
    status = status == SINS_OK ? sins_play_get_simulator(play, &sim) : status;
    if (status != SINS_OK) {
        fail(NULL, scene, status, 0);
    }

    SINS_INIT(sample);
    SINS_INIT(record);
    for (k = 0; k < rows; k++) {
        for (column = 0; column < inputs_of_row; column++) {
            *fields[column] = samples[k + column * rows];
        }
        if ((status = sins_play_push(play, &sample)) < 0 || (status = sins_get_record(sim, &record)) < 0) {
            fail(play, scene, status, k + 1);
        }
        for (column = 0; column < outputs_of_row; column++) {
            mxGetPr(output[0])[k + column * rows] = *values[column];
        }
    }
    sins_play_destroy(play);
    sins_scene_destroy(scene);
}
