/*
 * An ensemble on many machines: spreads the runs of a scene over the ranks of MPI 3, and writes the statistics that sins ensemble
 * writes.
 *
 *     mpirun -n 4 ensemble_mpi SCENE.toml RUNS OUT.csv [LOG.csv]          a log replaces the scene's flight, and is flown whole
 *
 * Runs are flown in blocks of 64. Rank r flies the r-th of the blocks that are missing, the (r + ranks)-th and so on. All blocks
 * take the same time, so no rank needs anything from another rank before the end. Statistics are exact sums: the bytes of OUT.csv
 * depend neither on the number of ranks nor on interruptions.
 *
 * After a block, but at most every 10 s, a rank writes all that it has flown into its file OUT.csv.N. If a rank dies, MPI ends the
 * job: the blocks of the last 10 s and those that were not complete are lost. The next start, with any number of ranks, takes the
 * blocks of all these files, flies the others into files with new numbers, and removes the files when OUT.csv is written. The
 * blocks of a damaged file are flown again.
 */

#include <errno.h>
#include <mpi.h>

#include "ensemble_job.h"

#define SAVED_EVERY_S 10.0

static int rank, ranks;

/* The results of a rank. In memory and in its file they are the key of the job, the statistics, a byte for each block, and a hash
 * of all these. */
struct flown {
    size_t size;
    char *bytes;
    sins_statistics *statistics;
    unsigned char *done;
};

static void fail(const char *what, const char *why)
{
    double until_s = MPI_Wtime() + 0.1;

    fprintf(stderr, "ensemble_mpi: %s: %s\n", what, why);
    /* MPI_Abort() ends the launcher too. It first needs the time to pass the sentence on. */
    while (MPI_Wtime() < until_s) {
    }
    MPI_Abort(MPI_COMM_WORLD, 1);
    exit(1);
}

/* The file name PATH.NUMBER with the ending. The text is valid until the next call. */
static const char *numbered(const char *path, int number, const char *ending)
{
    static char name[4096];

    if (snprintf(name, sizeof name, "%s.%d%s", path, number, ending) >= (int)sizeof name) {
        fail(path, "is too long");
    }
    return name;
}

/* The bytes of a file, or NULL if the file does not exist. */
static char *read_file(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    long length = file != NULL && fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    char *bytes = length >= 0 ? room((size_t)length + 1) : NULL;

    *size = length >= 0 ? (size_t)length : 0;
    if (bytes != NULL && (fseek(file, 0, SEEK_SET) != 0 || fread(bytes, 1, *size, file) != *size)) {
        fail(path, strerror(errno));
    }
    if (file != NULL) {
        fclose(file);
    }
    return bytes;
}

/* Opens a temporary file. put_in_place() renames it to `path`, so a file of this name is always complete. */
static FILE *open_part(const char *path, char *part, size_t capacity)
{
    FILE *file = snprintf(part, capacity, "%s.part", path) < (int)capacity ? fopen(part, "wb") : NULL;

    if (file == NULL) {
        fail(path, strerror(errno));
    }
    return file;
}

static void put_in_place(FILE *file, const char *part, const char *path)
{
    int is_bad = ferror(file);

    if (fclose(file) != 0 || is_bad || rename(part, path) != 0) {
        fail(path, strerror(errno));
    }
}

/* The text of a file. Rank 0 reads it, and all ranks get it. */
static char *shared_text(const char *path, size_t *size)
{
    char *text = rank == 0 ? read_file(path, size) : NULL;
    int length = text != NULL && *size < 1 << 30 ? (int)*size : -1;

    MPI_Bcast(&length, 1, MPI_INT, 0, MPI_COMM_WORLD);
    if (length < 0) {
        fail(path, "cannot be read, or has 1 GiB or more");
    }
    *size = (size_t)length;
    text = rank == 0 ? text : room(*size + 1);
    MPI_Bcast(text, length, MPI_BYTE, 0, MPI_COMM_WORLD);
    return text;
}

static struct flown nothing_flown(void)
{
    struct flown flown;

    flown.size = sizeof job.key + job.count * sizeof *flown.statistics + (size_t)job.blocks + sizeof job.key;
    flown.bytes = room(flown.size);
    memcpy(flown.bytes, &job.key, sizeof job.key);
    flown.statistics = (sins_statistics *)(void *)(flown.bytes + sizeof job.key);
    flown.done = (unsigned char *)(flown.statistics + job.count);
    clear_statistics(flown.statistics);
    return flown;
}

/* Writes the results of this rank into its file. A size of 0 makes an empty file: no results yet. */
static void save(const char *path, struct flown *flown, size_t size)
{
    uint64_t sum = hash(0, flown->bytes, flown->size - sizeof sum);
    char part[4096];
    FILE *file = open_part(path, part, sizeof part);

    memcpy(flown->bytes + flown->size - sizeof sum, &sum, sizeof sum);
    fwrite(flown->bytes, 1, size, file);
    put_in_place(file, part, path);
}

/* Adds the results in a file of an earlier start to those of this rank. */
static void resume(const char *path, struct flown *flown)
{
    struct flown before = nothing_flown();
    size_t size, k;
    char *bytes = read_file(path, &size);
    uint64_t sum = size == before.size ? hash(0, bytes, size - sizeof sum) : 0;

    if (size >= sizeof job.key && memcmp(bytes, &job.key, sizeof job.key) != 0) {
        fail(path, "is of another scene, log, number of runs or version: remove it");
    }
    if (size == before.size && memcmp(bytes + size - sizeof sum, &sum, sizeof sum) == 0) {
        memcpy(before.bytes, bytes, size);
        merge_statistics(flown->statistics, before.statistics, job.count);
        for (k = 0; k < job.blocks; k++) {
            flown->done[k] = (unsigned char)(flown->done[k] + before.done[k]);
        }
    } else if (size > 0) {
        fprintf(stderr, "ensemble_mpi: %s is damaged: its blocks are flown again\n", path);
    }
    free(bytes);
    free(before.bytes);
}

static void merge_ranks(void *from, void *into, int *count, MPI_Datatype *type)
{
    (void)type;
    merge_statistics((sins_statistics *)into, (const sins_statistics *)from, (size_t)*count);
}

/* The statistics of all ranks together, on rank 0. */
static void reduce(sins_statistics *mine, sins_statistics *all)
{
    MPI_Datatype type;
    MPI_Op op;

    MPI_Type_contiguous((int)sizeof *mine, MPI_BYTE, &type);
    MPI_Type_commit(&type);
    MPI_Op_create(merge_ranks, 1, &op);
    MPI_Reduce(mine, all, (int)job.count, type, op, 0, MPI_COMM_WORLD);
    MPI_Op_free(&op);
    MPI_Type_free(&type);
}

static void fly(const char *path)
{
    struct flown before = nothing_flown(), mine = nothing_flown();
    unsigned char *done = (unsigned char *)room((size_t)job.blocks);
    uint64_t block, missing = 0, earlier = 0;
    double next_s = 0;
    int files = 0, number;
    size_t size;
    char *bytes, part[4096];
    FILE *file;

    /* Rank 0 makes the files of all ranks now, numbered after those of earlier starts. So the numbers have no gap, whichever rank
     * dies. */
    for (; rank == 0 && (bytes = read_file(numbered(path, files, ""), &size)) != NULL; files++) {
        free(bytes);
    }
    for (number = files; rank == 0 && number < files + ranks; number++) {
        save(numbered(path, number, ""), &mine, 0);
    }
    MPI_Bcast(&files, 1, MPI_INT, 0, MPI_COMM_WORLD);
    for (number = rank; number < files; number += ranks) {
        resume(numbered(path, number, ""), &before);
    }
    MPI_Allreduce(before.done, done, (int)job.blocks, MPI_UNSIGNED_CHAR, MPI_SUM, MPI_COMM_WORLD);
    for (block = 0; block < job.blocks; block++) {
        if (done[block] > 1) {
            fail(path, "two of its numbered files have the same block: remove the one that is a copy");
        }
        earlier += done[block];
    }
    if (rank == 0 && files > 0) {
        fprintf(stderr, "ensemble_mpi: %llu of %llu blocks were flown before\n", (unsigned long long)earlier,
                (unsigned long long)job.blocks);
    }
    for (block = 0; block < job.blocks; block++) {
        if (done[block] == 0 && missing++ % (uint64_t)ranks == (uint64_t)rank) {
            fly_block(block, mine.statistics);
            mine.done[block] = 1;
            if (MPI_Wtime() >= next_s) {
                save(numbered(path, files + rank, ""), &mine, mine.size);
                next_s = MPI_Wtime() + SAVED_EVERY_S;
            }
        }
    }
    merge_statistics(mine.statistics, before.statistics, job.count);
    reduce(mine.statistics, before.statistics);
    if (rank == 0) {
        file = open_part(path, part, sizeof part);
        write_table(file, before.statistics);
        put_in_place(file, part, path);
        for (number = 0; number < files + ranks; number++) {
            remove(numbered(path, number, ""));
            remove(numbered(path, number, ".part"));
        }
    }
    free(before.bytes);
    free(mine.bytes);
    free(done);
}

int main(int count, char **arguments)
{
    size_t scene_size, log_size = 0;
    char *scene, *log;
    long long runs;
    int k;

    MPI_Init(&count, &arguments);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    runs = count > 2 ? atoll(arguments[2]) : 0;
    if (count < 4 || count > 5 || runs < 1 || runs > 4294967295LL) {
        fail("usage", "ensemble_mpi SCENE.toml RUNS OUT.csv [LOG.csv], 1 to 4294967295 runs");
    }
    for (k = 1; k < count; k++) {
        if (k != 3 && strcmp(arguments[k], arguments[3]) == 0) {
            fail(arguments[3], "is an input");
        }
    }
    if (sins_abi_version() != SINS_HEADER_ABI) {
        fail("the library", "has another interface version than this program");
    }
    scene = shared_text(arguments[1], &scene_size);
    log = count > 4 ? shared_text(arguments[4], &log_size) : NULL;
    open_job((uint64_t)runs, scene, scene_size, log, log_size);
    free(scene);
    free(log);
    fly(arguments[3]);
    MPI_Finalize();
    return 0;
}
