/* Windows: in a process without a free TLS index, a call returns SINS_ERROR_OUT_OF_MEMORY and does not abort. A library that
 * was loaded while indexes were free works, and its threads end. Arguments: the library, and a copy of it to load at run time. */

#include <string.h>

#include "../../c_examples/sins_loader.h"
#include "every_call.h"

static DWORD taken[4096];
static int count;

static void take_all(void)
{
    while ((taken[count] = TlsAlloc()) != TLS_OUT_OF_INDEXES) {
        count++;
    }
}

static void give_back_all(void)
{
    while (count > 0) {
        CHECK(TlsFree(taken[--count]));
    }
}

/* Runs in a new thread: the library creates its data of a thread in the first call and frees them at the end of the thread. */
static DWORD WINAPI fly(LPVOID unused)
{
    static sins_flight_sample samples[SCENE_COUNT];
    static sins_record records[SCENE_COUNT - 1];
    sins_sim *sim = scene_simulator(NULL, 4);
    char text[200];
    (void)unused;
    scene_samples(samples);
    scene_fly(sim, samples, records);
    CHECK(sins_destroy(sim) == SINS_OK);
    CHECK(sins_create(NULL, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_last_error(NULL, text, sizeof text, NULL) == SINS_OK && strstr(text, "sim") == text);
    return 0;
}

/* CreateThread() instead of pthread_create(), which takes a TLS index. */
static void fly_in_a_thread(void)
{
    HANDLE thread = CreateThread(NULL, 0, fly, NULL, 0, NULL);
    CHECK(thread != NULL && WaitForSingleObject(thread, INFINITE) == WAIT_OBJECT_0 && CloseHandle(thread));
}

int main(int arguments, char **paths)
{
    sins_loader late;
    sins_sim *sim = NULL;
    sins_navigation navigation = {.struct_size = sizeof navigation};
    char text[200];
    double duration;

    CHECK(arguments == 3);
    take_all();
    CHECK(count > 1000);
    fly_in_a_thread();

    CHECK(sins_loader_open(&late, paths[2], text, sizeof text) && late.library != GetModuleHandleA("sins.dll"));
    CHECK(late.sins_create(NULL, &sim) == SINS_ERROR_OUT_OF_MEMORY && sim == NULL);
    CHECK(late.sins_last_error(NULL, text, sizeof text, NULL) == SINS_OK && strstr(text, "TLS") != NULL);
    CHECK(late.sins_get_truth(NULL, &navigation) == SINS_ERROR_BAD_HANDLE);
    CHECK(late.sins_flight_duration(NULL, &duration) == SINS_ERROR_BAD_HANDLE);

    give_back_all();
    CHECK(late.sins_create(NULL, &sim) == SINS_OK && late.sins_destroy(sim) == SINS_OK);
    take_all();
    CHECK(late.sins_create(NULL, &sim) == SINS_OK && late.sins_destroy(sim) == SINS_OK);
    fly_in_a_thread();
    CHECK(sins_loader_close(&late));
    printf("tls_indexes: answers without one of them\n");
    return 0;
}
