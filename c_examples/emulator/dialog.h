/* A dialog of the resources, as CDialog: one class derives from it for each. A label that names keys of a
 * scene binds the fields behind it to them, as DoDataExchange() of MFC would: "L&atitude
 * [deg]|flight.latitude_deg". */
#pragma once
#include <windows.h>

#include <commctrl.h>

#include <map>

#include "scene.h"

class Dialog {
public:
    virtual ~Dialog();
    bool create(HWND parent, UINT id);   /* a page: lives until the object is destroyed */
    INT_PTR modal(HWND parent, UINT id); /* returns what finish() got */
    HWND window() const { return window_; }
    bool has_marks() const { return !marked_.empty(); }

protected:
    virtual void on_init() {}
    virtual void on_command(int, int) {} /* control, code of its notification */
    virtual void on_change(int id, int code)
    {
        on_command(id, code);
    } /* a field that is bound has a new value */
    virtual void on_notify(NMHDR *) {}
    virtual void on_timer() {}
    void finish(INT_PTR result) { EndDialog(window_, result); }

    HWND item(int id) const { return GetDlgItem(window_, id); }
    std::wstring get(int id) const;
    void set(int id, const std::wstring &text) const;
    int chosen(int id) const { return max(0, (int)SendMessageW(item(id), CB_GETCURSEL, 0, 0)); }
    void choose(int id, size_t index) const { SendMessageW(item(id), CB_SETCURSEL, index, 0); }
    void fill(HWND combo, const Texts &words) const;
    bool checked(int id) const { return IsDlgButtonChecked(window_, id) == BST_CHECKED; }
    void check(int id, bool is_checked)
    {
        CheckDlgButton(window_, id, is_checked ? BST_CHECKED : BST_UNCHECKED);
    }
    void show(int id, bool visible) const { ShowWindow(item(id), visible ? SW_SHOW : SW_HIDE); }
    void enable(int id, bool enabled) const { EnableWindow(item(id), enabled); }
    void tip(HWND control, const std::wstring &text);
    /* Marks a field as wrong, with the sentence as its tool tip; "": right again. */
    void mark(HWND control, const std::wstring &sentence);
    /* What of the window's growth moves (x, y) and stretches (w, h) a control, each 0 or 1; half of it: 2. */
    void grow(std::initializer_list<int> ids, int x, int y, int w, int h);

    /* Lists. */
    /* A width of 0 takes what the others leave. */
    void columns(int id, const std::string &titles, const std::vector<int> &widths);
    void rows(int id, const std::vector<Texts> &rows) const; /* writes what changed */
    int selected(int id) const
    {
        return (int)SendMessageW(item(id), LVM_GETNEXTITEM, (WPARAM)-1, LVNI_SELECTED);
    }
    void select(int id, size_t row) const;

    /* Exchange with the keys of a scene. */
    struct Field {
        const Key *key;
        size_t element;     /* of a key of several numbers */
        std::string loaded; /* the whole value, of which the control shows 15 digits */
        std::wstring shown;
    };
    /* Fills a combo box with the words, and gives the tool tip. */
    void bind(HWND control, const std::string &path, size_t element = 0);
    void unbind(HWND control);
    /* What an empty field stands for, shown grey. */
    void cue(const std::string &path, const std::wstring &text) const;
    void enable_fields(const std::string &begin, bool enabled) const; /* whose paths begin so */
    /* From keys to controls. What a user typed wrong stays while it is marked, unless all is new. */
    void load(const std::function<std::string(const std::string &path)> &value, bool all_is_new);
    /* What the user changed since the load. */
    std::vector<Change> changes() const;
    /* Marks the fields at fault; the sentence of the first fault, "" if there is none. */
    std::wstring mark_faults(const Faults &faults);

    HWND window_ = NULL;
    std::string si_path_; /* the key whose fields are in SI units now; "": none */

private:
    static INT_PTR CALLBACK procedure(HWND, UINT, WPARAM, LPARAM);
    INT_PTR handle(UINT message, WPARAM wparam, LPARAM lparam);
    void init();
    void init_control(HWND control, std::vector<std::pair<std::string, size_t>> &keys);
    void layout() const;
    void fit_columns() const;
    HBRUSH color(HDC dc, HWND control) const;
    std::wstring text_of(HWND control, const Field &field) const;
    std::string value_of(HWND control, const Field &field) const;
    bool is_change(HWND control, int code) const;

    struct Growth {
        int x, y, w, h;
        RECT place;
    };
    HWND tips_ = NULL;
    std::map<HWND, std::wstring> tip_texts_; /* the tool tip does not copy them */
    std::map<HWND, std::wstring> marked_;
    std::map<HWND, Field> fields_;
    std::map<int, Growth> growth_;
    std::map<int, std::vector<int>> widths_; /* of the columns of lists */
    SIZE size_ = {};
};

std::wstring window_text(HWND window);
/* A file that the user names; "": none. */
std::wstring ask_file(HWND owner, bool save, const std::string &filter, const wchar_t *ending,
                      const std::wstring &proposal = L"");
/* Pixels of so many at 96 dots an inch. */
int scaled(int pixels);
/* Says a sentence in a box; while the program runs by itself (/quit) on the error output, and it fails. */
extern bool is_unattended, has_failed;
void say(HWND owner, const std::wstring &sentence, UINT icon = MB_ICONWARNING);
