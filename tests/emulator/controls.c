/*
 * Checks what the controls of SINS_Emulator offer to a user besides their values:
 *
 *     controls reach M     every field of every page and dialog has a tool tip with its range, the tab key goes down or to the
 *                          right, the letter of a label leads to the field after it, and no letter of a page hides one of
 *                          the menu, M
 *     controls language    the language changes in flight, and the flight continues to its end
 *     controls adopt       the recommended options are put into the scene, which is saved
 *     controls wheel DIR   the wheel and a double-click zoom the diagram: DIR\whole.png, DIR\near.png, DIR\far.png
 *     controls dll         the library in use cannot be deleted; a second window opens in addition
 */
#include <ctype.h>

#include "window.h"

static int fields, labels, steps;

/* The text of a control's tool tip. The tool tip is in the memory of the other process. */
static void tip_of(HWND page, HWND control, wchar_t *text, size_t size)
{
    unsigned char bytes[sizeof(TOOLINFOW) + 2048] = {0};
    TOOLINFOW *tool = (TOOLINFOW *)bytes;
    HWND tips = NULL;
    DWORD process_id = 0, own_id;
    HANDLE process;
    unsigned char *there;
    GetWindowThreadProcessId(page, &process_id);
    process = OpenProcess(PROCESS_VM_OPERATION | PROCESS_VM_READ | PROCESS_VM_WRITE, FALSE, process_id);
    there = VirtualAllocEx(process, NULL, sizeof bytes, MEM_COMMIT | MEM_RESERVE, PAGE_READWRITE);
    text[0] = L'\0';
    while (there != NULL && text[0] == L'\0' && (tips = FindWindowExW(NULL, tips, TOOLTIPS_CLASSW, NULL)) != NULL) {
        GetWindowThreadProcessId(tips, &own_id);
        if (own_id == process_id) {
            tool->cbSize = TTTOOLINFOW_V1_SIZE;
            tool->hwnd = page;
            tool->uId = (UINT_PTR)control;
            tool->lpszText = (wchar_t *)(there + sizeof *tool);
            WriteProcessMemory(process, there, bytes, sizeof bytes, NULL);
            ask(tips, TTM_GETTEXTW, 1000, (LPARAM)there);
            ReadProcessMemory(process, there + sizeof *tool, text, size * sizeof *text, NULL);
        }
    }
    VirtualFreeEx(process, there, 0, MEM_RELEASE);
    CloseHandle(process);
}

static void expect_tips(HWND page)
{
    HWND control = NULL;
    wchar_t text[512];
    while ((control = FindWindowExW(page, control, L"Edit", NULL)) != NULL) {
        if (IsWindowVisible(control)) {
            tip_of(page, control, text, 512);
            if (text[0] == L'\0') {
                printf("driver: control %d has no tool tip\n", GetDlgCtrlID(control));
                exit(1);
            }
            if (fields++ % 9 == 0) {
                print(text);
            }
        }
    }
}

/* Each control that the tab key reaches begins below the previous one, or to its right. */
static void expect_tab_order(HWND page)
{
    HWND first = GetNextDlgTabItem(page, NULL, FALSE), control = first, next;
    for (; (next = GetNextDlgTabItem(page, control, FALSE)) != first && next != NULL; control = next) {
        RECT from, to;
        GetWindowRect(control, &from);
        GetWindowRect(next, &to);
        if (to.top <= from.top && to.left <= from.left) {
            printf("driver: the tab key goes from control %d back to %d\n", GetDlgCtrlID(control), GetDlgCtrlID(next));
            exit(1);
        }
        steps++;
    }
}

static int letter_of(HWND control)
{
    wchar_t text[256] = L"";
    const wchar_t *mark;
    ask(control, WM_GETTEXT, 256, (LPARAM)text);
    mark = wcschr(text, L'&');
    return mark == NULL ? 0 : towupper(mark[1]);
}

static HWND focus(void)
{
    GUITHREADINFO info = {0};
    info.cbSize = sizeof info;
    GetGUIThreadInfo(GetWindowThreadProcessId(main_window, NULL), &info);
    return info.hwndFocus;
}

/* Each letter occurs once and not in the menu. The letter of a label leads to the control after it. */
static void expect_letters(HWND page, const char *menu)
{
    HWND owners[256] = {0}, control, next;
    int letter, k;
    for (control = GetWindow(page, GW_CHILD); control != NULL; control = GetWindow(control, GW_HWNDNEXT)) {
        wchar_t name[32] = L"";
        letter = IsWindowVisible(control) ? letter_of(control) : 0;
        if (letter <= 0 || letter > 255) {
            continue;
        }
        if (owners[letter] != NULL) {
            printf("driver: %c stands twice, with controls %d and %d\n", letter, GetDlgCtrlID(owners[letter]), GetDlgCtrlID(control));
            exit(1);
        }
        if (strchr(menu, letter) != NULL) {
            printf("driver: %c of control %d hides a menu\n", letter, GetDlgCtrlID(control));
            exit(1);
        }
        owners[letter] = control;
        GetClassNameW(control, name, 32);
        next = GetWindow(control, GW_HWNDNEXT);
        if (_wcsicmp(name, L"Static") == 0 && IsWindowEnabled(next)) {
            PostMessageW(GetNextDlgTabItem(page, NULL, FALSE), WM_SYSCHAR, (WPARAM)tolower(letter), 1 << 29);
            for (k = 0; k < 30 && focus() != next && GetParent(focus()) != next; k++) {
                Sleep(50);
            }
            if (k == 30) {
                printf("driver: Alt+%c does not lead to control %d\n", letter, GetDlgCtrlID(next));
                exit(1);
            }
            labels++;
        }
    }
}

static void expect_all(HWND page, const char *menu)
{
    Sleep(300);
    expect_tips(page);
    expect_tab_order(page);
    expect_letters(page, menu);
}

static void expect_dialog(HWND window, UINT id)
{
    HWND dialog = open_box(window, id, 0);
    expect_all(dialog, ""); /* a dialog has no menu */
    ask(dialog, WM_COMMAND, IDCANCEL, 0);
    wait_for_no_box(dialog);
}

static void reach(const char *menu)
{
    static const int OF_PAGE[] = {IDC_SOURCE, IDC_SECTION, 0, IDC_PROGRESS};
    HWND trajectory = page_of(IDC_SOURCE), general = page_of(IDC_SECTION), start = NULL;
    int k;
    choose(trajectory, IDC_SOURCE, 1); /* manoeuvres: the start of the flight can be typed */
    while ((start = FindWindowExW(main_window, start, L"#32770", NULL)) != NULL
           && (start == trajectory || start == general || GetDlgItem(start, IDC_PROGRESS) != NULL)) {
    }
    for (k = 0; k < 4; k++) {
        command(ID_PAGE + k);
        expect_all(k == 2 ? start : page_of(OF_PAGE[k]), menu);
    }
    command(ID_PAGE + 1);
    for (k = 0; k < 9; k++) { /* each section of effects */
        choose(general, IDC_SECTION, k);
        ask(GetDlgItem(general, IDC_EFFECTS), WM_KEYDOWN, VK_HOME, 0);
        expect_tips(general);
    }
    expect_dialog(trajectory, IDC_ADD);
    expect_dialog(main_window, ID_FAILURE);
    expect_dialog(main_window, ID_RECOMMEND);
    PostMessageW(main_window, WM_CLOSE, 0, 0);
    answer(IDNO);
    printf("%d fields have a tool tip; %d labels lead to their fields; %d steps of the tab key\n", fields, labels, steps);
}

/* A change of the language creates a new main window. */
static void switch_language(int id, const wchar_t *title)
{
    wchar_t text[256] = L"";
    HWND before = main_window;
    int k;
    PostMessageW(main_window, WM_COMMAND, (WPARAM)id, 0);
    for (k = 0; k < 300 && ((main_window = find_main_window()) == NULL || main_window == before || wcsstr(text, title) == NULL); k++) {
        Sleep(100);
        if (main_window != NULL && main_window != before) {
            ask(main_window, WM_GETTEXT, 256, (LPARAM)text);
        }
    }
    if (k == 300) {
        fail("the language does not change");
    }
    Sleep(1000);
}

static void language(void)
{
    HWND display = page_of(IDC_PROGRESS);
    choose(display, IDC_PACE, 2); /* 100 times real time */
    command(ID_FLY);
    Sleep(500);
    switch_language(ID_CHINESE, L"\x4eff\x771f\x5668");
    display = page_of(IDC_PROGRESS);
    expect_state(display, L"\x98de\x884c\x4e2d");
    printf("page switched\n");
    fflush(stdout);
    getchar();
    switch_language(ID_ENGLISH, L"SINS Emulator");
    display = page_of(IDC_PROGRESS);
    expect_state(display, L"Flying");
    choose(display, IDC_PACE, 4);
    wait_for_end(GetDlgItem(display, IDC_PROGRESS));
    Sleep(1000); /* the records are written */
    close_window();
}

static void adopt(void)
{
    HWND dialog = open_box(main_window, ID_RECOMMEND, IDC_COMPUTE);
    int k;
    ask(GetDlgItem(dialog, IDC_TO), WM_SETTEXT, 0, (LPARAM)L"20");
    ask(dialog, WM_COMMAND, IDC_COMPUTE, 0);
    for (k = 0; k < 600 && !IsWindowEnabled(GetDlgItem(dialog, IDC_ADOPT)); k++) {
        Sleep(100);
    }
    ask(dialog, WM_COMMAND, IDC_ADOPT, 0);
    ask(dialog, WM_COMMAND, IDCANCEL, 0);
    wait_for_no_box(dialog);
    command(ID_SAVE);
    close_window();
    printf("recommended options in the scene\n");
}

static void wheel(const wchar_t *folder)
{
    HWND display = page_of(IDC_PROGRESS), plot = GetDlgItem(display, IDC_PLOT);
    wchar_t path[1024];
    RECT area;
    int k;
    command(ID_FLY);
    wait_for_end(GetDlgItem(display, IDC_PROGRESS));
    GetWindowRect(plot, &area);
    name_file(ID_PICTURE, IN_FOLDER(L"whole.png"));
    for (k = 0; k < 3; k++) {
        ask(plot, WM_MOUSEWHEEL, MAKEWPARAM(0, WHEEL_DELTA), MAKELPARAM((area.left + area.right) / 2, (area.top + area.bottom) / 2));
    }
    name_file(ID_PICTURE, IN_FOLDER(L"near.png"));
    ask(plot, WM_LBUTTONDBLCLK, MK_LBUTTON, MAKELPARAM(100, 100));
    name_file(ID_PICTURE, IN_FOLDER(L"far.png"));
    close_window();
    printf("zoomed by the wheel, and back\n");
}

static void dll(void)
{
    wchar_t path[1024];
    HANDLE process;
    DWORD process_id = 0, size = 1024;
    HWND first = main_window, second = NULL;
    STARTUPINFOW how = {0};
    PROCESS_INFORMATION made;
    int k;
    GetWindowThreadProcessId(main_window, &process_id);
    process = OpenProcess(PROCESS_QUERY_LIMITED_INFORMATION, FALSE, process_id);
    if (!QueryFullProcessImageNameW(process, 0, path, &size)) {
        fail("the program has no path");
    }
    how.cb = sizeof how;
    if (!CreateProcessW(path, NULL, NULL, NULL, FALSE, 0, NULL, NULL, &how, &made)) {
        fail("no second program");
    }
    wcscpy(wcsrchr(path, L'\\'), L"\\sins.dll");
    if (DeleteFileW(path)) {
        fail("the library in use was deleted");
    }
    printf("the library in use cannot be deleted: error %lu\n", GetLastError());
    for (k = 0; k < 300 && (second = find_main_window()) != NULL && second == first; k++) {
        Sleep(100);
        while ((second = FindWindowExW(NULL, second, L"#32770", NULL)) != NULL && (second == first || GetDlgItem(second, IDC_TABS) == NULL)) {
        }
        if (second != NULL) {
            break;
        }
    }
    if (second == NULL || second == first) {
        fail("no second window");
    }
    Sleep(2000);
    main_window = second;
    command(ID_FLY);
    close_window();
    main_window = first;
    command(ID_FLY);
    close_window();
    printf("two windows flew\n");
}

int main(int count, char **arguments)
{
    const char *what = wait_for_window(count, arguments);
    if (strcmp(what, "reach") == 0 && count == 3) {
        reach(arguments[2]);
    } else if (strcmp(what, "language") == 0) {
        language();
    } else if (strcmp(what, "adopt") == 0) {
        adopt();
    } else if (strcmp(what, "wheel") == 0 && count == 3) {
        wchar_t folder[512] = L"";
        MultiByteToWideChar(CP_UTF8, 0, arguments[2], -1, folder, 512);
        wheel(folder);
    } else {
        dll();
    }
    return 0;
}
