/*
 * Actions of a user in a window of another process: finds it, types, chooses, opens and closes dialogs, drops files. If a
 * message is not answered within a minute, the driver ends with status 1.
 */
#ifndef WINDOW_H
#define WINDOW_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wchar.h>
#include <windows.h>

#include <commctrl.h>
#include <dlgs.h>
#include <shlobj.h>

#include "../../apps/emulator/resource.h"

#define ANSWER_MS 60000

/* The main window of the program that is driven. */
static HWND main_window;

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

/* The program's window: the dialog with the tabs. */
static HWND find_main_window(void)
{
    HWND window = NULL;
    while ((window = FindWindowExW(NULL, window, L"#32770", NULL)) != NULL && GetDlgItem(window, IDC_TABS) == NULL) {
    }
    return window;
}

/* The page that has a control. At the start the pages appear after the window. */
static HWND page_of(int id)
{
    HWND page = NULL;
    int k;
    for (k = 0; k < 300 && page == NULL; k++) {
        Sleep(k == 0 ? 0 : 100);
        while ((page = FindWindowExW(main_window, page, L"#32770", NULL)) != NULL && GetDlgItem(page, id) == NULL) {
        }
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

/* Waits until the first line of the progress says that the flight has finished. */
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

/* The dialog or message box of the main window, or NULL. */
static HWND box(void)
{
    HWND window = NULL;
    while ((window = FindWindowExW(NULL, window, L"#32770", NULL)) != NULL
           && (GetWindow(window, GW_OWNER) != main_window || !IsWindowVisible(window))) {
    }
    return window;
}

/* Opens a dialog by a command and returns it. Waits until it has `control`, unless that is 0. */
static HWND open_box(HWND window, UINT command_id, int control)
{
    HWND found = NULL;
    int k;
    PostMessageW(window, WM_COMMAND, command_id, 0);
    for (k = 0; k < 300 && ((found = box()) == NULL || (control != 0 && GetDlgItem(found, control) == NULL)); k++) {
        Sleep(100);
    }
    if (k == 300) {
        fail("no dialog opens");
    }
    return found;
}

static void wait_for_no_box(HWND window)
{
    int k;
    for (k = 0; k < 300 && IsWindow(window); k++) { /* the program takes the values of a hidden dialog before it destroys it */
        Sleep(100);
    }
    if (k == 300) {
        fail("a dialog stays open");
    }
}

static void choose(HWND page, int id, int index)
{
    HWND combo = GetDlgItem(page, id);
    ask(combo, CB_SETCURSEL, (WPARAM)index, 0);
    ask(page, WM_COMMAND, MAKEWPARAM(id, CBN_SELCHANGE), (LPARAM)combo);
}

/* Names a file in the dialog that a command opens. */
static void name_file(UINT command_id, const wchar_t *path)
{
    HWND dialog = open_box(main_window, command_id, cmb13), field, inside;
    Sleep(500);
    for (field = GetDlgItem(dialog, cmb13); (inside = GetWindow(field, GW_CHILD)) != NULL; field = inside) {
    }
    ask(field, WM_SETTEXT, 0, (LPARAM)path);
    PostMessageW(dialog, WM_COMMAND, IDOK, 0);
    wait_for_no_box(dialog);
    Sleep(500);
}

static void expect_title(const wchar_t *begin)
{
    wchar_t title[256] = L"";
    int k;
    for (k = 0; k < 100 && wcsncmp(title, begin, wcslen(begin)) != 0; k++) {
        Sleep(100);
        ask(main_window, WM_GETTEXT, 256, (LPARAM)title);
    }
    if (k == 100) {
        printf("driver: the title is \"%ls\", not \"%ls\"\n", title, begin);
        exit(1);
    }
}

/* Waits for a message box and closes it. */
static void answer(int button)
{
    HWND message = NULL;
    int k;
    for (k = 0; k < 100 && (message = box()) == NULL; k++) {
        Sleep(100);
    }
    if (message == NULL) {
        fail("no message comes up");
    }
    Sleep(300);
    ask(message, WM_COMMAND, (WPARAM)button, 0);
    wait_for_no_box(message);
}

/* Drops a file on the window. Its name is written into the memory of the other process, like the system does. */
static void drop(const wchar_t *path)
{
    unsigned char bytes[sizeof(DROPFILES) + 2048] = {0};
    DROPFILES *files = (DROPFILES *)bytes;
    DWORD process = 0;
    HANDLE handle;
    void *there;
    files->pFiles = sizeof *files;
    files->fWide = TRUE;
    memcpy(bytes + sizeof *files, path, wcslen(path) * sizeof *path);
    GetWindowThreadProcessId(main_window, &process);
    handle = OpenProcess(PROCESS_VM_OPERATION | PROCESS_VM_WRITE, FALSE, process);
    there = VirtualAllocEx(handle, NULL, sizeof bytes, MEM_COMMIT | MEM_RESERVE, PAGE_READWRITE);
    if (there == NULL || !WriteProcessMemory(handle, there, bytes, sizeof bytes, NULL)) {
        fail("nothing can be dropped");
    }
    PostMessageW(main_window, WM_DROPFILES, (WPARAM)there, 0);
    CloseHandle(handle);
}

static void print(const wchar_t *text)
{
    char utf8[2048] = "";
    WideCharToMultiByte(CP_UTF8, 0, text, -1, utf8, sizeof utf8, NULL, NULL);
    printf("%s\n", utf8);
}

/* The path of the file `name` in `folder`, in the variable `path`. */
#define IN_FOLDER(name) (wcscpy(path, folder), wcscat(path, L"\\" name), path)

/* Control number k, from 0, of the fields that belong to keys. */
static HWND field(HWND dialog, int k)
{
    HWND control = NULL;
    while ((control = FindWindowExW(dialog, control, NULL, NULL)) != NULL) {
        if (GetDlgCtrlID(control) == IDC_FIELD && k-- == 0) {
            return control;
        }
    }
    fail("no such field");
    return NULL;
}

static void expect_state(HWND display, const wchar_t *state)
{
    wchar_t text[256] = L"";
    ask(GetDlgItem(display, IDC_PROGRESS), WM_GETTEXT, 256, (LPARAM)text);
    if (wcsncmp(text, state, wcslen(state)) != 0) {
        printf("driver: the state is \"%ls\", not \"%ls\"\n", text, state);
        exit(1);
    }
}

/* Waits for the window; returns the first argument. */
static const char *wait_for_window(int count, char **arguments)
{
    int k;
    for (k = 0; k < 600 && (main_window = find_main_window()) == NULL; k++) {
        Sleep(100);
    }
    if (main_window == NULL || count < 2) {
        fail("no window");
    }
    page_of(IDC_PROGRESS);
    Sleep(1000);
    return arguments[1];
}

#endif
