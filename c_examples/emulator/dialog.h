/* A dialog of the resources, as CDialog: one class derives from it for each. */
#pragma once
#include <windows.h>

#include <commctrl.h>

#include <map>

#include "text.h"

/* Pixels of so many at 96 dots an inch. */
int scaled(int pixels);
/* Says a sentence in a box; while the program runs by itself (/quit) on the error output, and it fails. */
extern bool is_unattended, has_failed;
void say(HWND owner, const std::wstring &sentence, UINT icon = MB_ICONWARNING);
/* A file that the user names; "": none. */
std::wstring ask_file(HWND owner, bool save, const std::string &filter, const wchar_t *ending,
                      const std::wstring &proposal = L"");
std::wstring window_text(HWND window);

/* A row of a list; a bar in its second column is this much of the column. */
struct Row {
    Texts cells;
    bool is_grey = false;
    double bar = 0;
    bool operator==(const Row &) const = default;
};
typedef std::vector<Row> Rows;

class Dialog {
public:
    virtual ~Dialog();
    void create(HWND parent, UINT id);   /* a page: lives until the object is destroyed */
    INT_PTR modal(HWND parent, UINT id); /* returns what finish() got */
    HWND window() const { return window_; }
    bool has_marks() const { return !marked_.empty(); }

protected:
    virtual void on_control(HWND, const std::string &) {} /* behind: what stands behind the "|" of its text */
    virtual void on_init() {}
    virtual void on_command(int, int) {} /* control or menu, code of its notification */
    virtual bool is_change(HWND, int) const { return false; }
    virtual void on_change(int id, int code) { on_command(id, code); } /* a field has a new value */
    virtual void on_notify(NMHDR *) {}
    virtual bool on_message(UINT, WPARAM, LPARAM) { return false; } /* of another kind; true: it is done */
    virtual void on_refusal(const std::wstring &sentence) { say(window_, sentence); }
    void finish(INT_PTR result) { EndDialog(window_, result); }

    HWND item(int id) const { return GetDlgItem(window_, id); }
    std::wstring get(int id) const { return window_text(item(id)); }
    void set(int id, const std::wstring &text) const;
    int chosen(int id) const { return max(0, (int)SendMessageW(item(id), CB_GETCURSEL, 0, 0)); }
    void choose(int id, size_t index) const { SendMessageW(item(id), CB_SETCURSEL, index, 0); }
    void fill(HWND combo, const Texts &words) const;
    bool checked(int id) const { return IsDlgButtonChecked(window_, id) == BST_CHECKED; }
    void check(int id, bool on) { CheckDlgButton(window_, id, on ? BST_CHECKED : BST_UNCHECKED); }
    void show(int id, bool visible) const { ShowWindow(item(id), visible ? SW_SHOW : SW_HIDE); }
    void enable(int id, bool enabled) const { EnableWindow(item(id), enabled); }
    void tip(HWND control, const std::wstring &text);
    /* Marks a field as wrong; "": right again. */
    void mark(HWND control, const std::wstring &sentence);
    /* What of the window's growth moves (x, y) and stretches (w, h) a control, each 0 or 1; half of it: 2. */
    void grow(std::initializer_list<int> ids, int x, int y, int w, int h);
    /* Lists. A width of 0 takes what the others leave. */
    void columns(int id, const std::string &titles, const std::vector<int> &widths);
    void rows(int id, const Rows &rows);
    int selected(int id) const { return SendMessageW(item(id), LVM_GETNEXTITEM, -1, LVNI_SELECTED); }
    void select(int id, size_t row) const;

    HWND window_ = NULL;
    std::map<HWND, std::wstring> marked_;

private:
    struct Growth {
        int x, y, w, h;
        RECT place;
    };
    static INT_PTR CALLBACK procedure(HWND, UINT, WPARAM, LPARAM);
    INT_PTR handle(UINT message, WPARAM wparam, LPARAM lparam);
    void init();
    LRESULT draw_row(NMLVCUSTOMDRAW *draw) const;
    HBRUSH color(HDC dc, HWND control) const;
    void layout() const;

    HWND tips_ = NULL;
    std::map<HWND, std::wstring> tip_texts_; /* the tool tip does not copy them */
    std::map<int, Growth> growth_;
    std::map<int, std::vector<int>> widths_; /* of the columns of lists */
    std::map<int, Rows> rows_;
    SIZE size_ = {};
};
