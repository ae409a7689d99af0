/*
 * Flies SINS_Emulator on packets, as a flight simulator on the same machine:
 *
 *     live fly DLL      chooses the packets by arrow keys, types nonsense as their port, sends wrong packets, and flies a minute of
 *                       a built-in flight with losses, repeated packets, another sender and a pause; then stops
 *     live again DLL    flies lines with their own time, moves the aircraft, sends nothing, and starts again at the same port
 *
 * The samples are those of the library DLL, so that only rounding to the packet's single precision makes errors.
 */
#include <winsock2.h>

#include <math.h>

#include "window.h"

#include "../../c_examples/sins_loader.h"

#define RATE_HZ 50
#define FOOT_M 0.3048

static sins_loader sins;
static sins_flight *flight;
static SOCKET own, other;
static struct sockaddr_in to;
static HWND display;

static sins_flight_sample sample_at(int tick)
{
    sins_flight_sample sample = {0};
    sample.struct_size = sizeof sample;
    if (sins.sins_flight_sample_at(flight, (double)tick / RATE_HZ, &sample) != SINS_OK) {
        fail("the flight has no such sample");
    }
    return sample;
}

/* The numbers of FlightGear's packet are big-endian. */
static void put(unsigned char *packet, const void *value, int size)
{
    int k;
    for (k = 0; k < size; k++) {
        packet[k] = ((const unsigned char *)value)[size - 1 - k];
    }
}

static void put_double(unsigned char *packet, double value)
{
    put(packet, &value, 8);
}

static void put_float(unsigned char *packet, double value)
{
    float single = (float)value;
    put(packet, &single, 4);
}

/* Writes FlightGear's packet of version 24, 408 bytes, from the layout of its header. */
static void native(unsigned char *packet, const sins_flight_sample *sample)
{
    const unsigned version = 24;
    memset(packet, 0, 408);
    put(packet, &version, 4);
    put_double(packet + 8, sample->longitude_rad);
    put_double(packet + 16, sample->latitude_rad);
    put_double(packet + 24, sample->height_m);
    put_float(packet + 36, sample->roll_rad);
    put_float(packet + 40, sample->pitch_rad);
    put_float(packet + 44, sample->heading_rad);
    put_float(packet + 76, sample->velocity_enu_m_s[1] / FOOT_M);
    put_float(packet + 80, sample->velocity_enu_m_s[0] / FOOT_M);
    put_float(packet + 84, -sample->velocity_enu_m_s[2] / FOOT_M);
}

static void send_bytes(SOCKET from, const void *packet, int size)
{
    if (sendto(from, packet, size, 0, (const struct sockaddr *)&to, sizeof to) != size) {
        fail("a packet is not sent");
    }
}

static void send_native(int tick)
{
    unsigned char packet[408];
    sins_flight_sample sample = sample_at(tick);
    native(packet, &sample);
    send_bytes(own, packet, sizeof packet);
}

/* A line with its own time; the aircraft may be moved to the east. */
static void send_line(int tick, double east_deg)
{
    char line[512];
    sins_flight_sample sample = sample_at(tick);
    const double *v = sample.velocity_enu_m_s;
    snprintf(line, sizeof line, "%.9f,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\r\n", (double)tick / RATE_HZ + 1000,
             sample.latitude_rad / SINS_DEG, sample.longitude_rad / SINS_DEG + east_deg, sample.height_m, v[0], v[1], v[2],
             sample.roll_rad / SINS_DEG, sample.pitch_rad / SINS_DEG, sample.heading_rad / SINS_DEG);
    send_bytes(own, line, (int)strlen(line));
}

/* Waits until a control has a text with this piece. */
static void expect(HWND control, const wchar_t *piece)
{
    wchar_t text[512] = L"";
    int k;
    for (k = 0; k < 300 && wcsstr(text, piece) == NULL; k++) {
        Sleep(k == 0 ? 0 : 50);
        ask(control, WM_GETTEXT, 512, (LPARAM)text);
    }
    if (wcsstr(text, piece) == NULL) {
        printf("driver: \"%ls\" instead of \"%ls\"\n", text, piece);
        exit(1);
    }
}

static void expect_progress(const wchar_t *piece)
{
    expect(GetDlgItem(display, IDC_PROGRESS), piece);
}

static void expect_flown(int count)
{
    wchar_t text[64];
    swprintf(text, 64, L" %d packets", count);
    expect_progress(text);
}

static void expect_line(const wchar_t *piece)
{
    expect(FindWindowExW(main_window, NULL, STATUSCLASSNAMEW, NULL), piece);
}

/* A port at which nobody listens. */
static int free_port(void)
{
    struct sockaddr_in place = {0};
    SOCKET probe = socket(AF_INET, SOCK_DGRAM, IPPROTO_UDP);
    int size = sizeof place;
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (bind(probe, (struct sockaddr *)&place, sizeof place) != 0 || getsockname(probe, (struct sockaddr *)&place, &size) != 0) {
        fail("no free port");
    }
    closesocket(probe);
    return ntohs(place.sin_port);
}

static void press(BYTE key)
{
    SetForegroundWindow(main_window);
    Sleep(200);
    keybd_event(key, 0, 0, 0);
    Sleep(100);
    keybd_event(key, 0, KEYEVENTF_KEYUP, 0);
    Sleep(300);
}

/* Arrow keys pass over the kinds of a flight; the one at which they stop is taken with the tab key. */
static void choose_by_keys(HWND trajectory)
{
    HWND kinds = GetDlgItem(trajectory, IDC_SOURCE);
    static const int KINDS[] = {2, 3, 4, 3}; /* a log, whose file is asked for, lies on the way */
    int k;
    command(ID_PAGE);
    ask(trajectory, WM_NEXTDLGCTL, (WPARAM)kinds, TRUE);
    for (k = 0; k < 4; k++) {
        press(k < 3 ? VK_DOWN : VK_UP);
        if (ask(kinds, CB_GETCURSEL, 0, 0) != KINDS[k] || box() != NULL || IsWindowEnabled(GetDlgItem(trajectory, IDC_PORT))) {
            fail("an arrow key does more than to choose the next kind of a flight");
        }
    }
    press(VK_TAB);
    if (!IsWindowEnabled(GetDlgItem(trajectory, IDC_PORT)) || !IsWindowEnabled(GetDlgItem(trajectory, IDC_RATE))) {
        fail("the packets were not chosen by the tab key");
    }
    expect_title(L"New scene - "); /* the arrow keys have changed nothing */
}

static void type_port(HWND trajectory)
{
    static const wchar_t *const NONSENSE[] = {L"port", L"0", L"65536", L"5500.5", L"-1", L"1e9"};
    wchar_t text[128];
    size_t k;
    int port = free_port();
    for (k = 0; k < sizeof NONSENSE / sizeof NONSENSE[0]; k++) {
        type(GetDlgItem(trajectory, IDC_PORT), NONSENSE[k]);
        swprintf(text, 128, L" = %ls: must be a whole number from 1 to 65535", NONSENSE[k]);
        expect_line(text);
    }
    PostMessageW(main_window, WM_COMMAND, ID_FLY, 0);
    answer(IDOK); /* a marked field is not valid */
    swprintf(text, 128, L"%d", port);
    type(GetDlgItem(trajectory, IDC_PORT), text);
    type(GetDlgItem(trajectory, IDC_RATE), L"0");
    expect_line(L" = 0: must be from ");
    type(GetDlgItem(trajectory, IDC_RATE), L"50");
    expect_title(L"New scene - ");
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    to.sin_port = htons((unsigned short)port);
}

/* Packets that are none: each is named in the status line with its limit, and none is flown. */
static void send_wrong(void)
{
    unsigned char packet[408];
    sins_flight_sample sample = sample_at(0);
    native(packet, &sample);
    send_bytes(own, packet, 407);
    expect_line(L"length = 407: must be 408 or 552 bytes");
    packet[3] = 23;
    send_bytes(own, packet, 408);
    expect_line(L"version = 23: must be 24");
    native(packet, &sample);
    put_double(packet + 16, NAN);
    send_bytes(own, packet, 408);
    expect_line(L"latitude: must be a finite number");
    put_double(packet + 16, 2.0);
    send_bytes(own, packet, 408);
    expect_line(L"latitude_rad = 2");
    expect_progress(L"refused: 1 length, 1 version, 1 no number, 1 range");
    expect_flown(0);
}

static void fly(void)
{
    HWND trajectory = page_of(IDC_SOURCE);
    unsigned char packet[408];
    sins_flight_sample sample;
    int tick, flown = 0, k;
    choose_by_keys(trajectory);
    type_port(trajectory);
    command(ID_FLY);
    expect_progress(L"Waits for packets");
    send_wrong();
    for (tick = 0; tick <= 60 * RATE_HZ; tick++) {
        if (tick % 10 == 7) { /* lost */
            continue;
        }
        send_native(tick);
        if (++flown % 50 == 0) {
            expect_flown(flown);
        }
        if (tick == 1000) {
            send_native(tick - 1); /* late */
            sample = sample_at(tick + 1);
            native(packet, &sample);
            send_bytes(other, packet, sizeof packet);
        }
        if (tick == 2000) {
            expect_flown(flown);
            for (k = 0; k < 100; k++) {
                send_native(tick);
            }
            expect_progress(L"Paused by the flight simulator: 40 s");
        }
    }
    expect_flown(flown);
    expect_progress(L"refused: 1 address, 1 length, 1 version, 1 no number, 1 range, 1 late");
    expect_progress(L": 60 s"); /* lost packets and the pause do not change the time */
    command(ID_STOP);
    expect_state(display, L"Stopped");
    Sleep(1000); /* the records are written */
    close_window();
    printf("%d packets flown; wrong, late and foreign ones refused\n", flown);
}

static void again(void)
{
    HWND trajectory = page_of(IDC_SOURCE);
    int tick;
    choose(trajectory, IDC_SOURCE, 4); /* lines */
    type_port(trajectory);
    command(ID_FLY);
    expect_progress(L"Waits for packets");
    send_bytes(own, "1,2,3", 5);
    expect_line(L"length = 3: must be");
    send_bytes(own, "1,2,3,4,five,6,7,8,9,10", 23);
    expect_line(L"velocity_east_m_s = five: expected a number");
    for (tick = 0; tick <= 100; tick++) {
        send_line(tick, 0);
    }
    expect_progress(L"Flying: 2 s, 101 packets");
    send_line(101, 10);
    expect_line(L"does not follow");
    send_line(102, 0);
    expect_progress(L"Flying: 2.04 s, 102 packets");
    for (tick = 103; tick <= 155; tick++) { /* the third begins another flight */
        send_line(tick, 10);
    }
    expect_progress(L"Flying: 1 s, 153 packets");
    expect_progress(L"3 jump");
    PostMessageW(main_window, WM_COMMAND, ID_SNAPSHOT, 0);
    answer(IDOK); /* no snapshot in a live flight */
    PostMessageW(main_window, WM_COMMAND, ID_BUDGET, 0);
    answer(IDOK);
    expect_progress(L"Waits for packets: 1 s"); /* two seconds without a packet */
    command(ID_STOP);
    Sleep(1000);     /* the records are written */
    command(ID_FLY); /* at the same port */
    expect_progress(L"Waits for packets: 0 s, 0 packets");
    for (tick = 0; tick <= 50; tick++) {
        send_line(tick, 0);
    }
    expect_progress(L"Flying: 1 s, 51 packets");
    command(ID_FLY); /* while it flies */
    expect_progress(L"Waits for packets: 0 s, 0 packets");
    close_window();
    printf("lines flown; moved, silent, started again\n");
}

int main(int count, char **arguments)
{
    const char *what = wait_for_window(count, arguments);
    char message[512];
    WSADATA data;
    sins_scene *scene = NULL;
    if (count != 3 || !sins_loader_open(&sins, arguments[2], message, sizeof message)) {
        fail(count != 3 ? "no DLL" : message);
    }
    if (sins.sins_scene_create_builtin("aerobatics", &scene) != SINS_OK || sins.sins_scene_create_flight(scene, &flight) != SINS_OK) {
        fail("no flight");
    }
    WSAStartup(MAKEWORD(2, 2), &data);
    own = socket(AF_INET, SOCK_DGRAM, IPPROTO_UDP);
    other = socket(AF_INET, SOCK_DGRAM, IPPROTO_UDP);
    display = page_of(IDC_PROGRESS);
    if (strcmp(what, "fly") == 0) {
        fly();
    } else {
        again();
    }
    return 0;
}
