/* Windows: a thread that was terminated in a call holds the handle forever. Calls of other threads return SINS_ERROR_BAD_STATE,
 * including those that already wait. */

#include <windows.h>

#include "every_call.h"

static sins_flight_sample samples[SCENE_COUNT];
static sins_sim *sim;
/* Number of threads that have started. A thread is terminated only after its start, because a starting thread may hold locks of
 * Windows. */
static volatile LONG calling;

static DWORD WINAPI fly_all_the_time(LPVOID unused)
{
    static sins_record records[SCENE_COUNT - 1];
    (void)unused;
    InterlockedIncrement(&calling);
    for (;;) {
        scene_fly(sim, samples, records);
        CHECK(sins_reset(sim) == SINS_OK);
    }
}

static DWORD WINAPI read_until_refused(LPVOID unused)
{
    sins_options options = {.struct_size = sizeof options};
    sins_status status;
    (void)unused;
    InterlockedIncrement(&calling);
    do {
        status = sins_get_options(sim, &options);
    } while (status == SINS_OK);
    return (DWORD)status;
}

int main(void)
{
    static const sins_status bad_state = SINS_ERROR_BAD_STATE;
    int held = 0, rounds;
    scene_samples(samples);
    for (rounds = 0; held < 3; rounds++) {
        HANDLE flier, reader;
        DWORD answer;
        CHECK(rounds < 1000);
        calling = 0;
        sim = scene_simulator(NULL, 4);
        flier = CreateThread(NULL, 0, fly_all_the_time, NULL, 0, NULL);
        reader = CreateThread(NULL, 0, read_until_refused, NULL, 0, NULL);
        CHECK(flier != NULL && reader != NULL);
        while (calling < 2) {
            Sleep(1);
        }
        Sleep(20);
        CHECK(TerminateThread(flier, 1) && WaitForSingleObject(flier, INFINITE) == WAIT_OBJECT_0);
        if (sins_reset(sim) == SINS_ERROR_BAD_STATE) {
            held++;
            every_call(sim, every_answer_is, (void *)&bad_state);
            CHECK(sins_destroy(sim) == SINS_ERROR_BAD_STATE);
        } else {
            CHECK(sins_destroy(sim) == SINS_OK); /* terminated between two calls: the reader gets SINS_ERROR_BAD_HANDLE */
        }
        CHECK(WaitForSingleObject(reader, 60000) == WAIT_OBJECT_0 && GetExitCodeThread(reader, &answer));
        CHECK((sins_status)answer == SINS_ERROR_BAD_STATE || (sins_status)answer == SINS_ERROR_BAD_HANDLE);
        CHECK(CloseHandle(flier) && CloseHandle(reader));
    }
    printf("terminated: threads in a call, %d times: none waits for them\n", held);
    return 0;
}
