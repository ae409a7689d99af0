/*
 * What the pages of SINS_Emulator show, and which keys change nothing:
 *
 *     views start          the greyed start of a built-in flight is that of the flight; arrow keys go through all built-in flights
 *     views errors DIR     flies, saves a picture of the errors of position, velocity and attitude (DIR\errors0.png to errors2.png), and
 *                          prints how many values the list shows, and whether error data 1 can be shown
 *     views print          Ctrl+P comes back from its dialog
 *     views cockpit        a list that was used gives the arrow keys back to the stick
 */
#include "window.h"

static void press(BYTE key, int with_control)
{
    SetForegroundWindow(main_window);
    Sleep(200);
    if (with_control) {
        keybd_event(VK_CONTROL, 0, 0, 0);
    }
    keybd_event(key, 0, 0, 0);
    Sleep(100);
    keybd_event(key, 0, KEYEVENTF_KEYUP, 0);
    if (with_control) {
        keybd_event(VK_CONTROL, 0, KEYEVENTF_KEYUP, 0);
    }
    Sleep(300);
}

/* The field with this place in the page that is greyed and has a number in it. */
static void expect_field(HWND page, int k, const wchar_t *expected)
{
    wchar_t text[64] = L"";
    ask(field(page, k), WM_GETTEXT, 64, (LPARAM)text);
    if (wcscmp(text, expected) != 0 || IsWindowEnabled(field(page, k))) {
        printf("driver: field %d has \"%ls\", not \"%ls\" in grey\n", k, text, expected);
        exit(1);
    }
}

static void expect_place(HWND list, int place, const char *what)
{
    if (ask(list, CB_GETCURSEL, 0, 0) != place) {
        fail(what);
    }
}

/* The patrol that simulation 2 flies begins at latitude 40, longitude 116.4, 8000 m and 200 m/s. */
static void start(void)
{
    HWND trajectory = page_of(IDC_SOURCE), list = GetDlgItem(trajectory, IDC_BUILTIN), general = page_of(IDC_PRESET);
    int count = (int)ask(list, CB_GETCOUNT, 0, 0), k;
    expect_field(trajectory, 2, L"40");
    expect_field(trajectory, 3, L"116.4");
    expect_field(trajectory, 4, L"8000");
    expect_field(trajectory, 5, L"200");
    command(ID_PAGE);
    ask(trajectory, WM_NEXTDLGCTL, (WPARAM)list, TRUE);
    press(VK_HOME, 0);
    for (k = 1; k < count; k++) {
        press(VK_DOWN, 0);
        expect_place(list, k, "an arrow key does not reach the next built-in flight");
    }
    while (--k > 0) {
        press(VK_UP, 0);
        expect_place(list, k - 1, "an arrow key does not reach the built-in flight before");
    }
    expect_field(trajectory, 4, L"8000"); /* that of simulation 1, which is the same patrol */
    choose(general, IDC_PRESET, 2);
    choose(general, IDC_SECTION, 1);
    expect_place(GetDlgItem(general, IDC_PRESET), 0, "the list shows a grade that was not applied");
    close_window();
    printf("the start of a built-in flight is its own; %d flights by arrow keys\n", count);
}

static void errors(const wchar_t *folder)
{
    HWND display = page_of(IDC_PROGRESS);
    wchar_t path[1024];
    int k;
    if (IsWindowEnabled(GetDlgItem(display, ID_STOP)) || IsWindowEnabled(GetDlgItem(display, ID_RESET))) {
        fail("a flight can be stopped before it begins");
    }
    command(ID_FLY);
    wait_for_end(GetDlgItem(display, IDC_PROGRESS));
    if (IsWindowEnabled(GetDlgItem(display, ID_PAUSE)) || !IsWindowEnabled(GetDlgItem(display, ID_RESET))) {
        fail("a flight can be paused after its end, or not be reset");
    }
    for (k = 0; k < 3; k++) {
        choose(display, IDC_QUANTITY, k);
        swprintf(path, 1024, L"%ls\\errors%d.png", folder, k);
        name_file(ID_PICTURE, path);
    }
    printf("values %d, error data 1 %d\n", (int)ask(GetDlgItem(display, IDC_VALUES), LVM_GETITEMCOUNT, 0, 0),
           IsWindowEnabled(GetDlgItem(display, IDC_DATA1)) != 0);
    close_window();
}

static void print_and_cancel(void)
{
    HWND display = page_of(IDC_PROGRESS), dialog = NULL;
    int k;
    command(ID_FLY);
    wait_for_end(GetDlgItem(display, IDC_PROGRESS));
    press('P', 1);
    for (k = 0; k < 100 && dialog == NULL; k++) { /* of printers, or the sentence that there is none, which no window owns */
        Sleep(100);
        while ((dialog = FindWindowExW(NULL, dialog, L"#32770", NULL)) != NULL && (dialog == main_window || !IsWindowVisible(dialog))) {
        }
    }
    if (dialog == NULL) {
        fail("Ctrl+P asks for no printer");
    }
    Sleep(300);
    PostMessageW(dialog, WM_COMMAND, IDCANCEL, 0);
    PostMessageW(dialog, WM_COMMAND, IDOK, 0);
    wait_for_no_box(dialog);
    expect_state(display, L"Finished");
    close_window();
    printf("Ctrl+P asks for a printer\n");
}

static void cockpit(void)
{
    HWND page = page_of(IDC_COCKPIT);
    static const int LISTS[] = {IDC_SPEEDUP, IDC_CHANNEL};
    int k;
    command(ID_PAGE + 4);
    ask(page, WM_COMMAND, IDC_TAKE_OFF, 0);
    for (k = 0; k < 2; k++) {
        HWND list = GetDlgItem(page, LISTS[k]);
        ask(page, WM_NEXTDLGCTL, (WPARAM)list, TRUE);
        choose(page, LISTS[k], 1);
        press(VK_DOWN, 0);
        press(VK_RIGHT, 0);
        press(VK_UP, 0);
        press(VK_UP, 0);
        expect_place(list, 1, "an arrow key for the stick changes a list of the cockpit");
    }
    if (!IsWindowVisible(page)) {
        fail("an arrow key leaves the cockpit");
    }
    close_window();
    printf("the arrow keys belong to the stick\n");
}

int main(int count, char **arguments)
{
    const char *what = wait_for_window(count, arguments);
    if (strcmp(what, "start") == 0) {
        start();
    } else if (strcmp(what, "errors") == 0 && count == 3) {
        wchar_t folder[512] = L"";
        MultiByteToWideChar(CP_UTF8, 0, arguments[2], -1, folder, 512);
        errors(folder);
    } else if (strcmp(what, "print") == 0) {
        print_and_cancel();
    } else {
        cockpit();
    }
    return 0;
}
