/* Flies a scene, writes its records and figures, prints a summary: sins_harness --help. */

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "harness/command_line.h"
#include "harness/flight_plan.h"
#include "harness/fly.h"
#include "harness/host.h"
#include "harness/option_table.h"
#include "harness/report.h"
#include "harness/summary.h"

static int library_fits(void)
{
    uint32_t version = sins_abi_version();

    if (version != SINS_HEADER_ABI) {
        report("the library has interface version %u, this program wants %u", (unsigned)version,
               (unsigned)SINS_HEADER_ABI);
    }
    return version == SINS_HEADER_ABI;
}

/* Puts all files in place. */
static int finish(sins_sim *sim, const struct settings *set, const struct scene *scene, const struct flown *flown,
                  struct flight_files *files)
{
    static struct summary sum;
    struct whole_file figures;

    if (summary_gather(&sum, sim, set, scene, flown) != DONE
        || whole_file_open(&figures, set->out, set->name, "_summary.csv") != 0) {
        return FAILED;
    }
    summary_write(&sum, &figures);
    if (whole_file_check(&figures) != 0 || (files->imu.stream != NULL && whole_file_commit(&files->imu) != 0)
        || whole_file_commit(&files->records) != 0) {
        whole_file_discard(&figures);
        return FAILED;
    }
    if (whole_file_commit(&figures) != 0) {
        return FAILED;
    }
    if (!set->quiet) {
        summary_print(&sum, files->records.path);
    }
    return DONE;
}

static int fly_and_write(sins_sim *sim, struct scene *scene, const struct settings *set)
{
    struct flight_files files;
    struct flown flown;
    int code;

    if (host_make_directory(set->out) != 0) {
        report("--out %s: cannot make the folder: %s", set->out, strerror(errno));
        return FAILED;
    }
    files.imu.stream = NULL;
    if (whole_file_open(&files.records, set->out, set->name, ".csv") != 0) {
        return FAILED;
    }
    if (set->imu[0] != '\0' && whole_file_open_path(&files.imu, set->imu) != 0) {
        whole_file_discard(&files.records);
        return FAILED;
    }
    code = fly(sim, scene, set, &files, &flown);
    if (code != BAD_INPUT && flown.records > 0 && !ferror(files.records.stream)) {
        /* Also what was flown before Ctrl-C, or before the solution left its range. */
        int finished;

        flown.interrupted = code != DONE;
        finished = finish(sim, set, scene, &flown, &files);
        code = finished == DONE ? code : finished;
    }
    whole_file_discard(&files.records);
    whole_file_discard(&files.imu);
    return code;
}

static int run_scene(const struct settings *set)
{
    static struct scene scene; /* too large for a small stack */
    sins_sim *sim = NULL;
    int code = settings_create(set, &sim);

    if (code != DONE) {
        return code;
    }
    code = scene_open(&scene, set);
    if (code == DONE) {
        code = fly_and_write(sim, &scene, set);
    }
    scene_close(&scene);
    sins_destroy(sim);
    return code;
}

static int run_command(int count, char **arguments)
{
    static struct settings set;
    int code = DONE;

    if (command_line_read(&set, count, arguments) != 0) {
        return BAD_INPUT;
    }
    if (set.help) {
        options_print_help();
    } else if (set.keys) {
        options_print_keys();
    } else if (set.kind == SCENE_EMBEDDED && strcmp(set.builtin, "list") == 0) {
        flight_plan_print_names();
    } else {
        host_catch_interrupt();
        code = run_scene(&set);
    }
    if (fflush(stdout) != 0 || ferror(stdout)) {
        report("cannot write the standard output");
        code = code == DONE ? FAILED : code;
    }
    if (code == INTERRUPTED) {
        report("interrupted; the files are whole");
    }
    return code;
}

int main(int count, char **arguments)
{
    return library_fits() ? run_command(count - 1, arguments + 1) : FAILED;
}
