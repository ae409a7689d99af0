/*
 * Drives SINS_Emulator through its dialogs, as a user does:  driver HOURS
 *
 * Sets the flight and the time through the fields, types nonsense into every field of every page and puts back what was there,
 * saves the scene, flies it to its end, shows each page for a picture, flies again and closes the window in flight. Each message
 * has to be answered within a time: the window lives. Prints "page K" when page K is to be seen, and waits for a line.
 */
#include <stdio.h>
#include <stdlib.h>
#include <wchar.h>
#include <windows.h>

#include "../../c_examples/emulator/resource.h"

#define ANSWER_MS 60000

static HWND main_window;
static int fields, marked;

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

int main(int count, char **arguments)
{
    wchar_t hours[32];
    char line[64];
    int k;
    HWND general, display;

    for (k = 0; k < 300 && (main_window = FindWindowW(L"SINS_Emulator", NULL)) == NULL; k++) {
        Sleep(100);
    }
    if (main_window == NULL || count < 2) {
        fail("no window");
    }
    MultiByteToWideChar(CP_ACP, 0, arguments[1], -1, hours, 32);
    general = page_of(IDC_HOURS);
    display = page_of(IDC_PROGRESS);
    command(ID_FLY + 0 * ID_STOP);
    command(ID_RESET);
    type(GetDlgItem(general, IDC_HOURS), hours);
    EnumChildWindows(main_window, try_field, 0);
    printf("%d fields, %d\n", fields, marked);
    command(ID_SAVE);
    command(ID_FLY);
    wait_for_end(GetDlgItem(display, IDC_PROGRESS));
    Sleep(500);
    for (k = 0; k < 4; k++) {
        command(ID_PAGE + k);
        printf("page %d\n", k);
        fflush(stdout);
        if (fgets(line, sizeof line, stdin) == NULL) {
            break;
        }
    }
    command(ID_FLY);
    ask(main_window, WM_CLOSE, 0, 0);
    for (k = 0; k < 100 && IsWindow(main_window); k++) {
        Sleep(100);
    }
    if (IsWindow(main_window)) {
        fail("the window stays open");
    }
    printf("closed in flight\n");
    return 0;
}
