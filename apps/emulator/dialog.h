/* A dialog of the resources, like CDialog: each dialog has a derived class. The text of a control in a layout has up to
 * four pieces between "|": its text; the scene keys of the fields after it; letters for the growth of the window, which
 * moves the control (x, y) and stretches it (w, h), by half with capital letters; the columns of a list. Controls
 * without text use the letters of the control before them. */
#pragma once
#include <commctrl.h>

#include <numeric>
#include <set>

#include "system.h"

std::wstring told(const std::exception &error); /* in the user's language */

/* A row of a list. bar: length of a bar in its second column, as a share of the column. */
struct Row {
    Texts cells;
    bool is_grey = false;
    double bar = 0;
    bool operator==(const Row &) const = default;
};
typedef std::vector<Row> Rows;

/* Makes a row for each part of a text, with its value. */
inline Rows rows_of(const std::string &names, const Texts &values) {
    Rows rows;
    for (const std::wstring &name : parts(names))
        rows.push_back({{name, values[rows.size()]}});
    return rows;
}

class Dialog {
public:
    virtual ~Dialog() { DestroyWindow(window_); }

    void create(HWND parent, UINT id) { /* a page: exists until the object is destroyed */
        CreateDialogIndirectParamW(NULL, template_of(id), parent, procedure, (LPARAM)this);
    }

    INT_PTR modal(HWND parent, UINT id) { /* returns the result of finish() */
        return DialogBoxIndirectParamW(NULL, template_of(id), parent, procedure, (LPARAM)this);
    }

    HWND window() const { return window_; }
    bool has_marks() const { return !marked_.empty(); }
    std::wstring first_fault() const { return has_marks() ? tip_texts_.at(*marked_.begin()) : L""; }

protected:
    virtual void on_control(HWND, const std::string &) {} /* a control and the second piece of its text */
    virtual void on_init() {}
    virtual void on_command(int, int) {} /* control or menu, and code of its notification, also of lists and tabs */
    virtual bool is_change(HWND, int) const { return false; }
    virtual void on_change(int id, int code) { on_command(id, code); } /* a field has a new value */
    virtual bool on_message(UINT, WPARAM, LPARAM) { return false; } /* any other message; true: it is handled */
    virtual void on_refusal(const std::wstring &sentence) { say(window_, sentence); }
    void finish(INT_PTR result) { EndDialog(window_, result); }

    HWND item(int id) const { return GetDlgItem(window_, id); }
    std::wstring get(int id) const { return window_text(item(id)); }
    void set(int id, const std::wstring &text) const {
        if (get(id) != text)
            SetWindowTextW(item(id), text.c_str());
    }
    int chosen(int id) const { return max(0, (int)SendMessageW(item(id), CB_GETCURSEL, 0, 0)); }
    void choose(int id, size_t index) const { SendMessageW(item(id), CB_SETCURSEL, index, 0); }
    bool checked(int id) const { return IsDlgButtonChecked(window_, id) == BST_CHECKED; }
    void check(int id, bool on) { CheckDlgButton(window_, id, on ? BST_CHECKED : BST_UNCHECKED); }
    void show(int id, bool visible) const { ShowWindow(item(id), visible ? SW_SHOW : SW_HIDE); }
    /* The focus does not stay in a control that is off, where it would take no keys. */
    void enable(int id, bool enabled) const {
        if (!enabled && GetFocus() == item(id))
            SendMessageW(window_, WM_NEXTDLGCTL, 0, FALSE);
        EnableWindow(item(id), enabled);
    }

    void fill(HWND combo, const Texts &words) const {
        SendMessageW(combo, CB_RESETCONTENT, 0, 0);
        for (const std::wstring &word : words)
            SendMessageW(combo, CB_ADDSTRING, 0, (LPARAM)word.c_str());
        SendMessageW(combo, CB_SETCURSEL, 0, 0);
    }

    void tip(HWND control, const std::wstring &text) {
        bool is_new = tip_texts_.count(control) == 0;
        tip_texts_[control] = text;
        TOOLINFOW tool = {.cbSize = TTTOOLINFOW_V1_SIZE, .uFlags = TTF_IDISHWND | TTF_SUBCLASS, .hwnd = window_,
                          .uId = (UINT_PTR)control, .lpszText = tip_texts_[control].data()};
        SendMessageW(tips_, is_new ? TTM_ADDTOOLW : TTM_UPDATETIPTEXTW, 0, (LPARAM)&tool);
    }

    void mark(HWND control, bool is_wrong) {
        if (is_wrong ? marked_.insert(control).second : marked_.erase(control) > 0)
            InvalidateRect(control, NULL, TRUE);
    }

    /* Adds the columns of a list, each with a title and a width. A column of width 0 gets the remaining width. */
    void add_columns(HWND list, const std::string &titles) {
        ListView_SetExtendedListViewStyle(list, LVS_EX_FULLROWSELECT | LVS_EX_DOUBLEBUFFER | LVS_EX_LABELTIP);
        for (const std::wstring &title : parts(titles)) {
            std::wstring name = title.substr(0, title.rfind(L' '));
            int index = (int)widths_[list].size();
            LVCOLUMNW column = {.mask = LVCF_TEXT | LVCF_SUBITEM, .pszText = name.data(), .iSubItem = index};
            ListView_InsertColumn(list, index, &column);
            widths_[list].push_back(scaled(_wtoi(&title[name.size()])));
        }
    }

    void rows(int id, const Rows &rows) {
        if (rows_[id] != rows) {
            rows_[id] = rows;
            ListView_SetItemCountEx(item(id), (int)rows.size(), LVSICF_NOSCROLL);
        }
    }

    size_t selected(int id) const { return SendMessageW(item(id), LVM_GETNEXTITEM, -1, LVNI_SELECTED); }

    void select(int id, size_t row) const {
        const UINT STATE = LVIS_SELECTED | LVIS_FOCUSED;
        ListView_SetItemState(item(id), (int)row, STATE, STATE);
        ListView_EnsureVisible(item(id), (int)row, FALSE);
    }

    HWND window_ = NULL;
    std::set<HWND> marked_; /* fields with faults */

private:
    struct Growth {
        std::string ways;
        RECT place;
        int of(char whole, char half, int by) const {
            return ways.find(whole) != ways.npos ? by : ways.find(half) != ways.npos ? by / 2 : 0;
        }
    };

    static const DLGTEMPLATE *template_of(UINT id) {
        return (const DLGTEMPLATE *)resource(MAKEINTRESOURCEW(5), id).data(); /* RT_DIALOG */
    }

    static INT_PTR CALLBACK procedure(HWND window, UINT message, WPARAM wparam, LPARAM lparam) {
        if (message == WM_INITDIALOG) {
            SetWindowLongPtrW(window, GWLP_USERDATA, lparam);
            ((Dialog *)lparam)->window_ = window;
        }
        Dialog *dialog = (Dialog *)GetWindowLongPtrW(window, GWLP_USERDATA);
        try {
            return dialog == NULL ? FALSE : dialog->handle(message, wparam, lparam);
        } catch (const std::exception &error) {
            dialog->on_refusal(told(error));
        }
        return TRUE;
    }

    INT_PTR handle(UINT message, WPARAM wparam, LPARAM lparam) {
        switch (message) {
        case WM_INITDIALOG: init(); return TRUE;
        case WM_COMMAND:
            if (LOWORD(wparam) == IDCANCEL && (GetWindowLongW(window_, GWL_STYLE) & WS_POPUP) != 0)
                finish(IDCANCEL);
            else if (is_change((HWND)lparam, HIWORD(wparam)))
                on_change(LOWORD(wparam), HIWORD(wparam));
            else
                on_command(LOWORD(wparam), HIWORD(wparam));
            return TRUE;
        case WM_NOTIFY: notify((NMHDR *)lparam); return TRUE;
        case WM_SIZE: layout(); break;
        case WM_CTLCOLORDLG:
        case WM_CTLCOLORSTATIC:
        case WM_CTLCOLORBTN:
        case WM_CTLCOLOREDIT: return (INT_PTR)color((HDC)wparam, (HWND)lparam);
        case WM_DESTROY: window_ = NULL;
        }
        return on_message(message, wparam, lparam);
    }

    /* Translates and binds the controls. */
    void init() {
        RECT client;
        std::string ways;
        GetClientRect(window_, &client);
        size_ = {client.right, client.bottom};
        SetWindowTextW(window_, text(narrow(window_text(window_))).c_str());
        tips_ = CreateWindowExW(WS_EX_TOPMOST, TOOLTIPS_CLASSW, NULL, WS_POPUP | TTS_ALWAYSTIP | TTS_NOPREFIX, 0, 0, 0,
                                0, window_, NULL, NULL, NULL);
        SendMessageW(tips_, TTM_SETMAXTIPWIDTH, 0, scaled(360));
        SendMessageW(tips_, TTM_SETDELAYTIME, TTDT_AUTOPOP, 30000);
        for (HWND own = GetWindow(window_, GW_CHILD); own != NULL; own = GetWindow(own, GW_HWNDNEXT)) {
            std::vector<std::string> pieces = split(narrow(window_text(own)), '|');
            bool has_text = !pieces.empty();
            pieces.resize(4);
            if (has_text) {
                SetWindowTextW(own, pieces[0].empty() ? L"" : text(pieces[0]).c_str());
                ways = pieces[2];
            }
            if (!ways.empty()) {
                GetWindowRect(own, &client);
                MapWindowPoints(NULL, window_, (POINT *)&client, 2);
                growth_[own] = {ways, client};
            }
            if (GetDlgCtrlID(own) == IDC_HEADING)
                SendMessageW(own, WM_SETFONT, (WPARAM)bold(own), FALSE);
            if (!pieces[3].empty())
                add_columns(own, pieces[3]);
            on_control(own, pieces[1]);
        }
        on_init();
        layout();
    }

    static HFONT bold(HWND control) {
        LOGFONTW font = {};
        GetObjectW((HFONT)SendMessageW(control, WM_GETFONT, 0, 0), sizeof font, &font);
        font.lfWeight = FW_BOLD;
        static const HFONT bold = CreateFontIndirectW(&font);
        return bold;
    }

    void layout() const {
        RECT client;
        GetClientRect(window_, &client);
        int wider = max(0, (int)(client.right - size_.cx)), higher = max(0, (int)(client.bottom - size_.cy));
        for (const auto &[control, own] : growth_) {
            int width = own.place.right - own.place.left, height = own.place.bottom - own.place.top;
            MoveWindow(control, own.place.left + own.of('x', 'X', wider), own.place.top + own.of('y', 'Y', higher),
                       width + own.of('w', 'W', wider), height + own.of('h', 'H', higher), TRUE);
        }
        for (const auto &[list, widths] : widths_) {
            GetWindowRect(list, &client);
            int rest = client.right - client.left - GetSystemMetrics(SM_CXVSCROLL) - scaled(4);
            rest -= std::accumulate(widths.begin(), widths.end(), 0);
            for (size_t k = 0; k < widths.size(); k++)
                ListView_SetColumnWidth(list, (int)k, widths[k] == 0 ? rest : widths[k]);
        }
    }

    void notify(NMHDR *notice) {
        int id = (int)notice->idFrom, code = (int)notice->code;
        const Rows &rows = rows_[id];
        SetWindowLongPtrW(window_, DWLP_MSGRESULT, 0);
        if (code == (int)NM_CUSTOMDRAW && !rows.empty()) {
            SetWindowLongPtrW(window_, DWLP_MSGRESULT, draw_row((NMLVCUSTOMDRAW *)notice, rows));
        } else if (code == (int)LVN_GETDISPINFOW && !rows.empty()) {
            LVITEMW &entry = ((NMLVDISPINFOW *)notice)->item;
            const Texts &cells = rows[min((size_t)entry.iItem, rows.size() - 1)].cells;
            if ((entry.mask & LVIF_TEXT) != 0 && entry.iSubItem < (int)cells.size())
                lstrcpynW(entry.pszText, cells[entry.iSubItem].c_str(), entry.cchTextMax);
        } else if (code == (int)LVN_ITEMCHANGED || code == (int)NM_DBLCLK || code == (int)TCN_SELCHANGE) {
            on_command(id, code);
        }
    }

    /* Effects that are off are grey; the second column may show a bar. */
    static LRESULT draw_row(NMLVCUSTOMDRAW *draw, const Rows &rows) {
        if (draw->nmcd.dwDrawStage == CDDS_PREPAINT)
            return CDRF_NOTIFYITEMDRAW;
        const Row &row = rows[min((size_t)draw->nmcd.dwItemSpec, rows.size() - 1)];
        if (draw->nmcd.dwDrawStage == CDDS_ITEMPREPAINT) {
            draw->clrText = row.is_grey ? RGB(150, 150, 150) : RGB(0, 0, 0);
            return CDRF_NOTIFYPOSTPAINT;
        }
        if (draw->nmcd.dwDrawStage == CDDS_ITEMPOSTPAINT && row.bar > 0) {
            RECT bar;
            ListView_GetSubItemRect(draw->nmcd.hdr.hwndFrom, (int)draw->nmcd.dwItemSpec, 1, LVIR_BOUNDS, &bar);
            InflateRect(&bar, -3, -3);
            bar.right = bar.left + (LONG)((bar.right - bar.left) * row.bar);
            SetDCBrushColor(draw->nmcd.hdc, RGB(0, 110, 200));
            FillRect(draw->nmcd.hdc, &bar, (HBRUSH)GetStockObject(DC_BRUSH));
        }
        return CDRF_DODEFAULT;
    }

    HBRUSH color(HDC dc, HWND control) const {
        static const COLORREF WRONG = RGB(255, 214, 214), HEADING = RGB(0, 70, 140), MESSAGE = RGB(170, 0, 0);
        static const HBRUSH wrong = CreateSolidBrush(WRONG);
        int id = control == window_ ? 0 : GetDlgCtrlID(control);
        SetBkMode(dc, TRANSPARENT);
        if (marked_.count(control) != 0) {
            SetBkColor(dc, WRONG);
            return wrong;
        }
        if (id == IDC_HEADING || id == IDC_MESSAGE)
            SetTextColor(dc, id == IDC_HEADING ? HEADING : MESSAGE);
        else if (!IsWindowEnabled(control))
            SetTextColor(dc, GetSysColor(COLOR_GRAYTEXT));
        return GetSysColorBrush(COLOR_WINDOW);
    }

    HWND tips_ = NULL;
    std::map<HWND, std::wstring> tip_texts_; /* the tool tip does not copy its text */
    std::map<HWND, Growth> growth_;
    std::map<HWND, std::vector<int>> widths_; /* widths of the columns of lists [pixels] */
    std::map<int, Rows> rows_;
    SIZE size_ = {};
};
