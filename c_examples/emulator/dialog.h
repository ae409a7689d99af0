/* A dialog of the resources, as CDialog: one class derives from it for each. */
#pragma once
#include <windows.h>

#include <commctrl.h>

#include <map>
#include <set>

#include "text.h"

class Dialog {
public:
    virtual ~Dialog();
    bool create(HWND parent, UINT id);   /* a page: lives until the object is destroyed */
    INT_PTR modal(HWND parent, UINT id); /* returns what finish() got */
    HWND window() const { return window_; }

protected:
    virtual void on_init() {}
    virtual void on_command(int, int) {} /* control, code of its notification */
    virtual void on_notify(NMHDR *) {}
    virtual void on_message(UINT, WPARAM, LPARAM) {} /* timers and the program's own */
    void finish(INT_PTR result) { EndDialog(window_, result); }

    HWND item(int id) const { return GetDlgItem(window_, id); }
    std::wstring get(int id) const;
    void set(int id, const std::wstring &text) const;
    int chosen(int id) const { return (int)SendMessageW(item(id), CB_GETCURSEL, 0, 0); }
    void choose(int id, int index) const { SendMessageW(item(id), CB_SETCURSEL, (WPARAM)index, 0); }
    void fill(int id, const std::vector<std::wstring> &words) const;
    bool checked(int id) const { return IsDlgButtonChecked(window_, id) == BST_CHECKED; }
    void show(int id, bool visible) const { ShowWindow(item(id), visible ? SW_SHOW : SW_HIDE); }
    void enable(int id, bool enabled) const { EnableWindow(item(id), enabled); }
    void tip(int id, const std::wstring &text);
    void cue(int id, const std::wstring &text) const; /* shown grey while the field is empty */
    /* Marks a field as wrong, with the sentence as its tool tip; "": right again. */
    void mark(int id, const std::wstring &sentence);
    bool is_marked(int id) const { return marked_.count(id) != 0; }
    bool has_marks() const { return !marked_.empty(); }
    /* What of the window's growth moves (x, y) and stretches (w, h) a control, each 0 or 1; half of it: 2. */
    void grow(int id, int x, int y, int w, int h) { growth_[id] = {x, y, w, h}; }

    /* Lists. */
    void columns(int id, const std::vector<std::wstring> &titles, const std::vector<int> &widths) const;
    void row(int id, int row, const std::vector<std::wstring> &texts) const; /* writes what changed, or adds */
    int selected(int id) const { return (int)SendMessageW(item(id), LVM_GETNEXTITEM, (WPARAM)-1, LVNI_SELECTED); }
    void select(int id, int row) const;
    void keep_rows(int id, int count) const; /* those behind go */

    HWND window_ = NULL;

private:
    struct Growth {
        int x, y, w, h;
    };
    static INT_PTR CALLBACK procedure(HWND, UINT, WPARAM, LPARAM);
    INT_PTR handle(UINT message, WPARAM wparam, LPARAM lparam);
    void init();
    void layout();
    HBRUSH color(HDC dc, HWND control);

    HWND tips_ = NULL;
    std::map<int, std::wstring> tip_texts_; /* the tool tip does not copy them */
    std::map<int, std::wstring> marked_;
    std::map<int, Growth> growth_;
    std::map<int, RECT> places_;
    SIZE size_ = {};
};

/* A file that the user names; "": none. */
std::wstring ask_file(HWND owner, bool save, UINT filter, const wchar_t *ending, const std::wstring &proposal = L"");
/* Pixels of so many at 96 dots an inch. */
int scaled(int pixels);
/* Says a sentence in a box; while the program runs by itself (/quit) on the error output, and it fails. */
extern bool is_unattended, has_failed;
void say(HWND owner, const std::wstring &sentence, UINT icon = MB_ICONWARNING);
