/*
 * Drives SINS_Emulator through its dialogs, as a user does:
 *
 *     driver fly HOURS     sets the time, types nonsense into every field of every page and restores its value, saves the
 *                          scene, flies it to its end, flies again and closes the window in flight
 *     driver exercise      flies, takes a snapshot, lets a gyro fail in flight, goes back and flies to the end, saves the scene
 *     driver pages         shows each page and dialog: prints "page NAME" and waits for a line; then closes the window
 *     driver files DIR     opens DIR\exercise.toml and saves it as DIR\again.toml by the file dialogs, flies it, exports, saves and
 *                          copies the picture, drops DIR\trainer.toml and a log, opens a recent scene
 *     driver studies       cancels a study, starts another at once, closes its dialog and the window while one computes
 *     driver edit          composes manoeuvres, takes a preset, types a value in SI and for one axis, pauses, stops and resets a
 *                          flight, saves the scene
 *     driver keys          goes through the presets by the arrow key, applies one, and uses Ctrl+Z, F5, F1 and Ctrl+N
 *     driver stick         taxies, takes off and banks in the cockpit by keys, works at the panel of the INS, and types nonsense there
 *     driver sentence      reads the name of a built-in flight, chooses a word in the list of effects, types a number beyond its
 *                          limit, and prints the status line; asks for a study beyond a limit of its struct, and prints the dialog's line
 */
#include "window.h"

static int fields;

static BOOL CALLBACK try_field(HWND control, LPARAM parameter)
{
    static const wchar_t *const NONSENSE[] = {L"text", L"", L"1e308", L"-1e9", L"0,5", L"\"", L"[1, 2", L"\x4e2d\x6587"};
    wchar_t name[32] = L"", before[1024] = L"";
    size_t k;
    (void)parameter;
    GetClassNameW(control, name, 32);
    if (_wcsicmp(name, L"Edit") != 0 || !IsWindowEnabled(control) || (GetWindowLongW(GetParent(control), GWL_STYLE) & WS_CHILD) == 0) {
        return TRUE;
    }
    ask(control, WM_GETTEXT, 1024, (LPARAM)before);
    for (k = 0; k < sizeof NONSENSE / sizeof NONSENSE[0]; k++) {
        type(control, NONSENSE[k]);
    }
    type(control, before);
    fields++;
    return TRUE;
}

static void fly(const char *hours)
{
    wchar_t text[32];
    MultiByteToWideChar(CP_ACP, 0, hours, -1, text, 32);
    type(GetDlgItem(page_of(IDC_HOURS), IDC_HOURS), text);
    EnumChildWindows(main_window, try_field, 0);
    printf("%d fields took nonsense and have their values again\n", fields);
    command(ID_SAVE);
    command(ID_FLY);
    wait_for_end(GetDlgItem(page_of(IDC_PROGRESS), IDC_PROGRESS));
    Sleep(1000); /* the records are written */
    command(ID_FLY);
    close_window();
    printf("closed in flight\n");
}

static void look(const char *name)
{
    char line[64];
    Sleep(2000); /* until it is drawn */
    printf("page %s\n", name);
    fflush(stdout);
    if (fgets(line, sizeof line, stdin) == NULL) {
        fail("nobody looks");
    }
}

/* Opens a dialog by a message, shows it and closes it. In the dialog of a study, the study is computed first. */
static void dialog(HWND window, UINT id, const char *name)
{
    HWND dialog;
    int k;
    PostMessageW(window, WM_COMMAND, id, 0);
    for (k = 0; k < 300 && (dialog = box()) == NULL; k++) {
        Sleep(100);
    }
    if (dialog == NULL) {
        fail(name);
    }
    if (GetDlgItem(dialog, IDC_COMPUTE) != NULL) {
        ask(GetDlgItem(dialog, IDC_TO), WM_SETTEXT, 0, (LPARAM)L"20");
        ask(dialog, WM_COMMAND, IDC_COMPUTE, 0);
        for (k = 0; k < 600 && ask(GetDlgItem(dialog, IDC_RESULT), LVM_GETITEMCOUNT, 0, 0) == 0; k++) {
            Sleep(100);
        }
        if (k == 600) {
            fail("a study has no result");
        }
    }
    look(name);
    ask(dialog, WM_COMMAND, IDCANCEL, 0);
    while (box() != NULL) {
        Sleep(100);
    }
}

static void exercise(void)
{
    HWND display = page_of(IDC_PROGRESS), failures;
    int k;
    command(ID_PAGE + 3);
    choose(display, IDC_PACE, 2);                      /* 100 times real time: the flight still runs when it goes back */
    ask(GetDlgItem(display, ID_FLY), BM_CLICK, 0, 0); /* the button has the focus from now on */
    Sleep(500);
    command(ID_SNAPSHOT);
    Sleep(500);
    PostMessageW(main_window, WM_COMMAND, ID_FAILURE, 0);
    for (k = 0; k < 300 && (failures = box()) == NULL; k++) {
        Sleep(10);
    }
    choose(failures, IDC_KIND, 3); /* bias step */
    ask(GetDlgItem(failures, IDC_FAILURE_SIZE), WM_SETTEXT, 0, (LPARAM)L"0.5");
    ask(failures, WM_COMMAND, IDC_ADD, 0);
    ask(failures, WM_COMMAND, IDCANCEL, 0);
    Sleep(300);
    command(ID_GO_BACK);
    choose(display, IDC_PACE, 4); /* as fast as it goes */
    wait_for_end(GetDlgItem(display, IDC_PROGRESS));
    Sleep(2000); /* the records are written */
    command(ID_SAVE);
    close_window();
    printf("a failure in flight, and back to a snapshot before it\n");
}

static void pages(void)
{
    HWND trajectory = page_of(IDC_SOURCE), display = page_of(IDC_PROGRESS), plot = GetDlgItem(display, IDC_PLOT);
    command(ID_PAGE);
    look("1");
    command(ID_PAGE + 1);
    look("2");
    command(ID_PAGE + 2);
    look("3");
    command(ID_PAGE + 3);
    look("4");
    command(ID_PAGE + 4);
    ask(page_of(IDC_COCKPIT), WM_COMMAND, IDC_TAKE_OFF, 0);
    look("5");
    command(ID_PAGE + 3);
    choose(display, IDC_QUANTITY, 7);
    look("track");
    choose(display, IDC_QUANTITY, 1);
    ask(GetDlgItem(display, IDC_LOGARITHMIC), BM_CLICK, 0, 0);
    ask(GetDlgItem(display, IDC_AXIS + 1), BM_CLICK, 0, 0); /* without north */
    ask(plot, WM_LBUTTONDOWN, MK_LBUTTON, MAKELPARAM(200, 100));
    ask(plot, WM_LBUTTONUP, 0, MAKELPARAM(400, 100));
    look("zoomed");
    dialog(main_window, ID_FAILURE, "failures");
    dialog(main_window, ID_RECOMMEND, "recommend");
    dialog(main_window, ID_BUDGET, "budget");
    command(ID_PAGE);
    choose(trajectory, IDC_SOURCE, 1); /* manoeuvres */
    dialog(trajectory, IDC_ADD, "manoeuvre");
    PostMessageW(main_window, WM_CLOSE, 0, 0); /* the scene was changed: it asks */
    Sleep(2000);
    ask(box(), WM_COMMAND, IDNO, 0);
}

static void expect_picture_in_clipboard(void)
{
    const BITMAPINFOHEADER *header;
    HANDLE dib;
    if (!OpenClipboard(NULL) || (dib = GetClipboardData(CF_DIB)) == NULL || (header = GlobalLock(dib)) == NULL) {
        fail("no picture in the clipboard");
    } else if (header->biWidth < 900 || labs(header->biHeight) < 600) {
        fail("the picture in the clipboard is too small");
    } else {
        printf("a picture of %ld x %ld in the clipboard\n", (long)header->biWidth, labs(header->biHeight));
    }
    CloseClipboard();
}

static void files(const wchar_t *folder)
{
    wchar_t path[1024];
    HWND display = page_of(IDC_PROGRESS);
    name_file(ID_OPEN, IN_FOLDER(L"exercise.toml"));
    expect_title(L"exercise.toml - ");
    name_file(ID_SAVE_AS, IN_FOLDER(L"again.toml"));
    expect_title(L"again.toml - ");
    command(ID_FLY);
    wait_for_end(GetDlgItem(display, IDC_PROGRESS));
    name_file(ID_EXPORT, IN_FOLDER(L"new.csv"));
    name_file(ID_PICTURE, IN_FOLDER(L"again.png"));
    command(ID_COPY);
    expect_picture_in_clipboard();
    drop(IN_FOLDER(L"trainer.toml"));
    expect_title(L"trainer.toml - ");
    command(ID_RECENT + 1);
    expect_title(L"again.toml - ");
    drop(IN_FOLDER(L"log.csv"));
    expect_title(L"again.toml* - ");
    drop(IN_FOLDER(L"log.toml")); /* the scene is valid, its log is not; the program asks before it drops changes */
    answer(IDCANCEL);
    expect_title(L"again.toml* - ");
    PostMessageW(main_window, WM_CLOSE, 0, 0);
    answer(IDNO);
    printf("files by dialogs, dropped and recent\n");
}

/* Starts a study of a piece that ends at `to_s` [s]. */
static void compute(HWND dialog, const wchar_t *to_s)
{
    ask(GetDlgItem(dialog, IDC_TO), WM_SETTEXT, 0, (LPARAM)to_s);
    ask(dialog, WM_COMMAND, IDC_COMPUTE, 0);
}

static void studies(void)
{
    HWND dialog = open_box(main_window, ID_RECOMMEND, IDC_COMPUTE), list = GetDlgItem(dialog, IDC_RESULT);
    DWORD from_ms, process_id = 0;
    HANDLE process;
    int k;
    GetWindowThreadProcessId(main_window, &process_id);
    process = OpenProcess(SYNCHRONIZE, FALSE, process_id);
    compute(dialog, L"3500"); /* tens of seconds; on a fast machine ten */
    Sleep(2500); /* the samples are made: the library computes */
    from_ms = GetTickCount();
    ask(dialog, WM_COMMAND, IDC_COMPUTE, 0); /* cancelled */
    printf("cancelled in %lu ms\n", (unsigned long)(GetTickCount() - from_ms));
    if (GetTickCount() - from_ms > 2000 || ask(list, LVM_GETITEMCOUNT, 0, 0) != 0) {
        fail("a cancel waits for the library");
    }
    compute(dialog, L"20");
    for (k = 0; k < 1200 && ask(list, LVM_GETITEMCOUNT, 0, 0) == 0; k++) {
        Sleep(100);
    }
    if (k == 1200) {
        fail("after a cancel no study has a result");
    }
    printf("the next study had its result after %lu ms\n", (unsigned long)(GetTickCount() - from_ms));
    compute(dialog, L"3500");
    Sleep(2500);
    ask(dialog, WM_COMMAND, IDCANCEL, 0);
    wait_for_no_box(dialog);
    close_window();
    if (WaitForSingleObject(process, 10000) != WAIT_OBJECT_0) {
        fail("the program does not end while a study computes");
    }
    CloseHandle(process);
    printf("ended while a study computed\n");
}

static void sentence(void)
{
    wchar_t text[512] = L"";
    HWND study;
    int k;
    HWND general = page_of(IDC_SECTION);
    ask(GetDlgItem(page_of(IDC_SOURCE), IDC_BUILTIN), CB_GETLBTEXT, 0, (LPARAM)text);
    if (text[0] < 0x80) {
        print(text);
        fail("a built-in flight has no name in Chinese");
    }
    command(ID_PAGE + 1);
    choose(general, IDC_SECTION, 8); /* output */
    ask(GetDlgItem(general, IDC_EFFECTS), WM_KEYDOWN, VK_END, 0);
    choose(general, IDC_WORD, 1); /* its last key is true or false: quiet */
    ask(main_window, WM_GETTEXT, 512, (LPARAM)text);
    if (wcschr(text, L'*') == NULL) {
        fail("a word of the list does not change the scene");
    }
    type(GetDlgItem(page_of(IDC_HOURS), IDC_HOURS), L"-1");
    ask(FindWindowExW(main_window, NULL, STATUSCLASSNAMEW, NULL), WM_GETTEXT, 512, (LPARAM)text);
    print(text);
    study = open_box(main_window, ID_RECOMMEND, IDC_COMPUTE);
    ask(GetDlgItem(study, IDC_LAST), WM_SETTEXT, 0, (LPARAM)L"1e9"); /* a duration beyond the limit of its struct */
    compute(study, L"1");
    for (k = 0; k < 100; k++) {
        Sleep(100);
        ask(GetDlgItem(study, IDC_STATE), WM_GETTEXT, 512, (LPARAM)text);
        if (wcsstr(text, L"1e+09") != NULL || wcsstr(text, L"1e9") != NULL) {
            break;
        }
    }
    print(text);
    ask(study, WM_COMMAND, IDCANCEL, 0);
    wait_for_no_box(study);
    PostMessageW(main_window, WM_CLOSE, 0, 0); /* the scene was changed: it asks */
    answer(IDNO);
}

static void edit(void)
{
    HWND trajectory = page_of(IDC_SOURCE), general = page_of(IDC_SECTION), display = page_of(IDC_PROGRESS), manoeuvre, channel;
    wchar_t text[16] = L"";
    manoeuvre = open_box(trajectory, IDC_ADD, IDC_KIND);
    choose(manoeuvre, IDC_KIND, 8); /* sinusoids */
    if (!IsWindowEnabled(field(manoeuvre, 7)) || IsWindowEnabled(field(manoeuvre, 8)) || IsWindowEnabled(field(manoeuvre, 2))) {
        fail("the fields of sinusoids are not those that they use");
    }
    channel = field(manoeuvre, 7);
    ask(channel, CB_SETCURSEL, 4, 0); /* roll */
    ask(manoeuvre, WM_COMMAND, MAKEWPARAM(IDC_FIELD, CBN_SELCHANGE), (LPARAM)channel);
    if (!IsWindowEnabled(field(manoeuvre, 8)) || IsWindowEnabled(field(manoeuvre, 9))) {
        fail("the amplitude of a roll is no angle");
    }
    type(field(manoeuvre, 8), L"5");
    type(field(manoeuvre, 10), L"0.25");
    ask(manoeuvre, WM_COMMAND, IDOK, 0);
    wait_for_no_box(manoeuvre);
    ask(trajectory, WM_COMMAND, IDC_UP, 0); /* a row is chosen: the new manoeuvre */
    manoeuvre = open_box(trajectory, IDC_ADD, IDC_KIND);
    ask(manoeuvre, WM_COMMAND, IDOK, 0);
    wait_for_no_box(manoeuvre);
    ask(trajectory, WM_COMMAND, IDC_REMOVE, 0);

    type(GetDlgItem(general, IDC_HOURS), L"soon");
    choose(general, IDC_PRESET, 4); /* tactical */
    ask(general, WM_COMMAND, IDC_APPLY, 0);
    ask(GetDlgItem(general, IDC_HOURS), WM_GETTEXT, 16, (LPARAM)text);
    if (wcscmp(text, L"soon") != 0) {
        fail("a preset drops what was rejected in another field");
    }
    type(GetDlgItem(general, IDC_HOURS), L"");
    ask(GetDlgItem(general, IDC_EFFECTS), WM_KEYDOWN, VK_HOME, 0); /* constant bias */
    type(GetDlgItem(general, IDC_VALUE), L"text");
    ask(GetDlgItem(general, IDC_VALUE), WM_GETTEXT, 16, (LPARAM)text);
    if (wcscmp(text, L"text") != 0) {
        fail("a rejected value of an effect does not stay in its field");
    }
    choose(general, IDC_UNIT, 1); /* SI */
    type(GetDlgItem(general, IDC_VALUE), L"1e-6");
    ask(GetDlgItem(general, IDC_SAME), BM_SETCHECK, BST_UNCHECKED, 0);
    type(GetDlgItem(general, IDC_VALUE + 1), L"2e-6");

    choose(display, IDC_PACE, 0); /* real time */
    command(ID_FLY);
    Sleep(500);
    command(ID_PAUSE);
    expect_state(display, L"Paused");
    command(ID_PAUSE);
    command(ID_FLY);
    expect_state(display, L"Flying");
    command(ID_STOP);
    expect_state(display, L"Stopped");
    command(ID_RESET);
    expect_state(display, L"Ready");
    command(ID_SAVE);
    close_window();
    printf("manoeuvres, a preset, units and axes edited; paused, stopped, reset\n");
}

static void press(BYTE key, int with_control)
{
    SetForegroundWindow(main_window);
    Sleep(200);
    if (with_control) {
        keybd_event(VK_CONTROL, 0, 0, 0);
    }
    keybd_event(key, 0, 0, 0);
    keybd_event(key, 0, KEYEVENTF_KEYUP, 0);
    if (with_control) {
        keybd_event(VK_CONTROL, 0, KEYEVENTF_KEYUP, 0);
    }
    Sleep(500);
}

/* With the focus within a page, another page is shown by Ctrl and a digit: it gets the focus, and keys change nothing that is hidden. */
static void focus_follows_the_page(HWND general)
{
    GUITHREADINFO thread = {.cbSize = sizeof thread};
    HWND earth = FindWindowExW(general, NULL, L"ComboBox", NULL);
    LRESULT before;
    int page;
    if (earth == NULL) {
        fail("no list");
    }
    before = ask(earth, CB_GETCURSEL, 0, 0);
    for (page = 1; page <= 5; page++) {
        press('2', 1);
        ask(general, WM_NEXTDLGCTL, (WPARAM)earth, TRUE);
        press((BYTE)('0' + page), 1);
        GetGUIThreadInfo(GetWindowThreadProcessId(main_window, NULL), &thread);
        if (thread.hwndFocus == NULL || !IsWindowVisible(thread.hwndFocus)) {
            fail("the focus stays in a hidden page");
        }
        if (page == 4) { /* of this page, a key changes nothing in the scene */
            press(VK_END, 0);
        }
        if (ask(earth, CB_GETCURSEL, 0, 0) != before) {
            fail("a key changes a hidden page");
        }
    }
    press('4', 1);
}

static void keys(void)
{
    HWND general = page_of(IDC_SECTION), display = page_of(IDC_PROGRESS), presets = GetDlgItem(general, IDC_PRESET);
    wchar_t text[256] = L"";
    int k;
    for (k = 1; k <= 4; k++) {
        ask(presets, WM_KEYDOWN, VK_DOWN, 0);
        if (ask(presets, CB_GETCURSEL, 0, 0) != k) {
            fail("an arrow key does not choose the next preset");
        }
    }
    expect_title(L"New scene - "); /* nothing was applied */
    ask(general, WM_COMMAND, IDC_APPLY, 0);
    expect_title(L"New scene* - ");
    press('Z', 1);
    expect_title(L"New scene - ");
    press(VK_F5, 0);
    wait_for_end(GetDlgItem(display, IDC_PROGRESS));
    choose(general, IDC_PRESET, 4);
    ask(general, WM_COMMAND, IDC_APPLY, 0);
    Sleep(500);
    ask(GetDlgItem(display, IDC_PROGRESS), WM_GETTEXT, 256, (LPARAM)text);
    if (wcsstr(text, L"settings changed since") == NULL) {
        fail("old curves are not marked");
    }
    press(VK_F1, 0);
    answer(IDOK);
    PostMessageW(main_window, WM_COMMAND, ID_ABOUT, 0);
    answer(IDOK);
    press('N', 1);
    answer(IDNO);
    expect_state(display, L"Ready");
    focus_follows_the_page(general);
    close_window();
    printf("the focus follows the page; presets by the arrow key and a button; Ctrl+Z, F5, F1 and Ctrl+N\n");
}

/* What the cockpit says: the state of the INS, and in the next line time [s], speed [kt], height [m]. */
static void read_cockpit(HWND cockpit, wchar_t *state, double *numbers)
{
    wchar_t text[512] = L"", *line;
    ask(GetDlgItem(cockpit, IDC_UNIT_STATE), WM_GETTEXT, 512, (LPARAM)text);
    line = wcschr(text, L'\n');
    if (line == NULL || swscanf(line, L"%lf s, %lf kt, %lf m", &numbers[0], &numbers[1], &numbers[2]) != 3) {
        print(text);
        fail("the cockpit says something else");
    }
    *line = 0;
    wcscpy(state, text);
}

/* Holds a key in the cockpit until one of its numbers is beyond a limit. */
static void hold(HWND cockpit, BYTE key, int which, double limit)
{
    HWND screen = GetDlgItem(cockpit, IDC_COCKPIT);
    wchar_t state[512];
    double numbers[3] = {0.0, 0.0, 0.0};
    int k;
    for (k = 0; k < 600 && numbers[which] < limit; k++) {
        ask(screen, WM_KEYDOWN, key, 0);
        Sleep(100);
        read_cockpit(cockpit, state, numbers);
    }
    ask(screen, WM_KEYUP, key, 0);
    if (numbers[which] < limit) {
        fail("a held key of the cockpit does nothing");
    }
}

static void expect_unit(HWND cockpit, const wchar_t *expected)
{
    wchar_t state[512] = L"";
    double numbers[3];
    int k;
    for (k = 0; k < 600 && wcsstr(state, expected) == NULL; k++) {
        Sleep(50);
        read_cockpit(cockpit, state, numbers);
    }
    if (k == 600) {
        print(state);
        fail("the unit does something else");
    }
}

static void stick(void)
{
    HWND cockpit = page_of(IDC_COCKPIT);
    wchar_t text[512] = L"";
    double numbers[3];
    command(ID_PAGE + 4);
    ask(cockpit, WM_COMMAND, IDC_TAKE_OFF, 0);
    expect_unit(cockpit, L"Navigation");
    /* The parked aircraft aligns. */
    choose(cockpit, IDC_SPEEDUP, 2); /* 60 times */
    ask(cockpit, WM_COMMAND, IDC_MODE, 0); /* OFF */
    expect_unit(cockpit, L"Off");
    ask(cockpit, WM_COMMAND, IDC_MODE + 1, 0); /* ALIGN */
    expect_unit(cockpit, L"Coarse alignment");
    ask(cockpit, WM_COMMAND, IDC_ENTER_TRUE, 0);
    expect_unit(cockpit, L"Ready");
    ask(cockpit, WM_COMMAND, IDC_MODE + 2, 0); /* NAV */
    expect_unit(cockpit, L"Navigation");
    choose(cockpit, IDC_SPEEDUP, 1); /* 10 times */
    hold(cockpit, VK_PRIOR, 1, 150.0);
    hold(cockpit, VK_DOWN, 2, 200.0);
    SetForegroundWindow(main_window);
    ask(GetDlgItem(cockpit, IDC_COCKPIT), WM_LBUTTONDOWN, 0, 0); /* has the focus from now on */
    press(VK_LEFT, 0);
    press(VK_UP, 0);
    press(VK_RIGHT, 0);
    expect_title(L"New scene - "); /* the arrow keys belong to the stick alone */
    if (!IsWindowVisible(cockpit)) {
        fail("an arrow key leaves the cockpit");
    }
    ask(GetDlgItem(cockpit, IDC_LATITUDE), WM_SETTEXT, 0, (LPARAM)L"north");
    ask(cockpit, WM_COMMAND, IDC_ENTER_POSITION, 0);
    ask(FindWindowExW(main_window, NULL, STATUSCLASSNAMEW, NULL), WM_GETTEXT, 512, (LPARAM)text);
    if (wcsstr(text, L"Latitude = north: expected a number") == NULL) {
        print(text);
        fail("a latitude in words is taken");
    }
    ask(cockpit, WM_COMMAND, IDC_MODE + 3, 0); /* ATT */
    expect_unit(cockpit, L"Erection");
    ask(cockpit, WM_COMMAND, IDC_MODE, 0); /* OFF */
    expect_unit(cockpit, L"Off");
    read_cockpit(cockpit, text, numbers);
    ask(cockpit, WM_COMMAND, IDC_LEAVE, 0);
    close_window();
    printf("flown by keys: %.0f kt, %.0f m; the panel: aligned, ATT, OFF\n", numbers[1], numbers[2]);
}

int main(int count, char **arguments)
{
    const char *what = wait_for_window(count, arguments);
    if (strcmp(what, "fly") == 0 && count == 3) {
        fly(arguments[2]);
    } else if (strcmp(what, "exercise") == 0) {
        exercise();
    } else if (strcmp(what, "files") == 0 && count == 3) {
        wchar_t folder[512] = L"";
        MultiByteToWideChar(CP_UTF8, 0, arguments[2], -1, folder, 512);
        files(folder);
    } else if (strcmp(what, "studies") == 0) {
        studies();
    } else if (strcmp(what, "edit") == 0) {
        edit();
    } else if (strcmp(what, "keys") == 0) {
        keys();
    } else if (strcmp(what, "stick") == 0) {
        stick();
    } else if (strcmp(what, "sentence") == 0) {
        sentence();
    } else {
        pages();
    }
    return 0;
}
