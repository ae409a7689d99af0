/*
 * Drives SINS_Emulator through its dialogs, as a user does:
 *
 *     driver fly HOURS     sets the time, types nonsense into every field of every page and puts back what was there, saves the
 *                          scene, flies it to its end, flies again and closes the window in flight
 *     driver exercise      flies, keeps a snapshot, lets a gyro fail in flight, goes back and flies to the end, saves the scene
 *     driver pages         shows each page and dialog: prints "page NAME" and waits for a line; then closes the window
 *
 * Each message has to be answered within a minute: the window lives.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wchar.h>
#include <windows.h>

#include <commctrl.h>

#include "../../c_examples/emulator/resource.h"

#define ANSWER_MS 60000

static HWND main_window;
static int fields;

static void fail(const char *what)
{
    printf("driver: %s\n", what);
    exit(1);
}

static LRESULT ask(HWND window, UINT message, WPARAM wparam, LPARAM lparam)
{
    DWORD_PTR answer = 0;
    if (!SendMessageTimeoutW(window, message, wparam, lparam, SMTO_NORMAL, ANSWER_MS, &answer)) {
        fail("the window does not answer");
    }
    return (LRESULT)answer;
}

/* The page that has a control. */
static HWND page_of(int id)
{
    HWND page = NULL;
    while ((page = FindWindowExW(main_window, page, L"#32770", NULL)) != NULL && GetDlgItem(page, id) == NULL) {
    }
    if (page == NULL) {
        fail("no page has such a control");
    }
    return page;
}

static void type(HWND control, const wchar_t *text)
{
    ask(control, WM_SETTEXT, 0, (LPARAM)text);
    ask(GetParent(control), WM_COMMAND, MAKEWPARAM(GetDlgCtrlID(control), EN_KILLFOCUS), (LPARAM)control);
}

static void command(int id)
{
    ask(main_window, WM_COMMAND, (WPARAM)id, 0);
}

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

/* Waits until the state of the flight, the first line of its progress, is another than at first. */
static void wait_for_end(HWND progress)
{
    wchar_t text[256] = L"";
    int k;
    for (k = 0; k < 600; k++) {
        ask(progress, WM_GETTEXT, 256, (LPARAM)text);
        if (wcsncmp(text, L"Finished", 8) == 0) {
            return;
        }
        Sleep(200);
    }
    fail("the flight does not end");
}

static void close_window(void)
{
    int k;
    ask(main_window, WM_CLOSE, 0, 0);
    for (k = 0; k < 100 && IsWindow(main_window); k++) {
        Sleep(100);
    }
    if (IsWindow(main_window)) {
        fail("the window stays open");
    }
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
    Sleep(2000); /* it is drawn */
    printf("page %s\n", name);
    fflush(stdout);
    if (fgets(line, sizeof line, stdin) == NULL) {
        fail("nobody looks");
    }
}

/* The dialog or message box above the main window; NULL: none. */
static HWND box(void)
{
    HWND window = NULL;
    while ((window = FindWindowExW(NULL, window, L"#32770", NULL)) != NULL
           && (GetWindow(window, GW_OWNER) != main_window || !IsWindowVisible(window))) {
    }
    return window;
}

/* A dialog that a message opens; a study is computed. */
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

static void choose(HWND page, int id, int index)
{
    HWND combo = GetDlgItem(page, id);
    ask(combo, CB_SETCURSEL, (WPARAM)index, 0);
    ask(page, WM_COMMAND, MAKEWPARAM(id, CBN_SELCHANGE), (LPARAM)combo);
}

static void exercise(void)
{
    HWND display = page_of(IDC_PROGRESS), failures;
    int k;
    choose(display, IDC_PACE, 2); /* 100 times real time: it is in flight yet when it goes back */
    command(ID_FLY);
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
    HWND trajectory = page_of(IDC_SOURCE);
    command(ID_PAGE);
    look("1");
    command(ID_PAGE + 1);
    look("2");
    command(ID_PAGE + 2);
    look("3");
    command(ID_PAGE + 3);
    look("4");
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

int main(int count, char **arguments)
{
    int k;
    for (k = 0; k < 600 && (main_window = FindWindowW(L"SINS_Emulator", NULL)) == NULL; k++) {
        Sleep(100);
    }
    if (main_window == NULL || count < 2) {
        fail("no window");
    }
    Sleep(1000);
    if (strcmp(arguments[1], "fly") == 0 && count == 3) {
        fly(arguments[2]);
    } else if (strcmp(arguments[1], "exercise") == 0) {
        exercise();
    } else {
        pages();
    }
    return 0;
}
