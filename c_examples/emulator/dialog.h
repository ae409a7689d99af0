/* A dialog of the resources, as CDialog: one class derives from it for each. The text of a control in a
 * layout has up to four pieces between "|": its text; the scene keys of the fields behind it; what of the
 * window's growth moves it (x, y) and stretches it (w, h), in capitals by half, for the controls without text
 * behind it too; of a list its columns. */
#pragma once
#include <commctrl.h>

#include "library.h"
#include "text.h"

std::wstring told(const std::exception &error); /* in the user's language */

/* Pixels of so many at 96 dots an inch. */
inline int scaled(int pixels) {
    HDC screen = GetDC(NULL);
    int dots = GetDeviceCaps(screen, LOGPIXELSY);
    ReleaseDC(NULL, screen);
    return MulDiv(pixels, dots, 96);
}

inline std::wstring window_text(HWND window) {
    std::wstring text(GetWindowTextLengthW(window) + 1, L'\0');
    text.resize(GetWindowTextW(window, text.data(), (int)text.size()));
    return text;
}

inline bool is_of_class(HWND window, const wchar_t *name) {
    WCHAR own[32] = L"";
    GetClassNameW(window, own, 32);
    return lstrcmpiW(own, name) == 0;
}

/* Says a sentence in a box; while the program runs by itself (/quit) on the error output, and it fails. */
inline bool is_unattended = false, has_failed = false;

inline void say(HWND owner, const std::wstring &sentence, UINT icon = MB_ICONWARNING) {
    if (!is_unattended) {
        MessageBoxW(owner, sentence.c_str(), text("title").c_str(), MB_OK | icon);
        return;
    }
    std::string line = "SINS_Emulator: " + narrow(sentence) + "\n";
    DWORD written;
    WriteFile(GetStdHandle(STD_ERROR_HANDLE), line.data(), (DWORD)line.size(), &written, NULL);
    has_failed = true;
}

/* A file that the user names; "": none. */
inline std::wstring ask_file(HWND owner, bool save, const std::string &filter, const wchar_t *ending,
                             const std::wstring &proposal = L"") {
    WCHAR path[32768] = L"";
    std::wstring pairs = text(filter) + L'\0';
    OPENFILENAMEW ask = {};
    std::replace(pairs.begin(), pairs.end(), L';', L'\0');
    lstrcpynW(path, proposal.c_str(), 32768);
    ask.lStructSize = sizeof ask;
    ask.hwndOwner = owner;
    ask.lpstrFilter = pairs.c_str();
    ask.lpstrFile = path;
    ask.nMaxFile = 32768;
    ask.lpstrDefExt = ending;
    ask.Flags = OFN_NOCHANGEDIR | OFN_HIDEREADONLY | (save ? OFN_OVERWRITEPROMPT : OFN_FILEMUSTEXIST);
    return (save ? GetSaveFileNameW(&ask) : GetOpenFileNameW(&ask)) ? path : L"";
}

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
    virtual ~Dialog() {
        if (window_ != NULL)
            DestroyWindow(window_);
    }

    void create(HWND parent, UINT id) /* a page: lives until the object is destroyed */
    {
        CreateDialogIndirectParamW(NULL, template_of(id), parent, procedure, (LPARAM)this);
    }

    INT_PTR modal(HWND parent, UINT id) /* returns what finish() got */
    {
        return DialogBoxIndirectParamW(NULL, template_of(id), parent, procedure, (LPARAM)this);
    }

    HWND window() const { return window_; }
    bool has_marks() const { return !marked_.empty(); }

protected:
    virtual void on_control(HWND, const std::string &) {} /* with its second piece */
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
    void set(int id, const std::wstring &text) const {
        if (get(id) != text)
            SetWindowTextW(item(id), text.c_str());
    }
    int chosen(int id) const { return max(0, (int)SendMessageW(item(id), CB_GETCURSEL, 0, 0)); }
    void choose(int id, size_t index) const { SendMessageW(item(id), CB_SETCURSEL, index, 0); }
    bool checked(int id) const { return IsDlgButtonChecked(window_, id) == BST_CHECKED; }
    void check(int id, bool on) { CheckDlgButton(window_, id, on ? BST_CHECKED : BST_UNCHECKED); }
    void show(int id, bool visible) const { ShowWindow(item(id), visible ? SW_SHOW : SW_HIDE); }
    void enable(int id, bool enabled) const { EnableWindow(item(id), enabled); }

    void fill(HWND combo, const Texts &words) const {
        SendMessageW(combo, CB_RESETCONTENT, 0, 0);
        for (const std::wstring &word : words)
            SendMessageW(combo, CB_ADDSTRING, 0, (LPARAM)word.c_str());
        SendMessageW(combo, CB_SETCURSEL, 0, 0);
    }

    void tip(HWND control, const std::wstring &text) {
        TOOLINFOW tool = {};
        bool is_new = tip_texts_.count(control) == 0;
        tip_texts_[control] = text;
        tool.cbSize = TTTOOLINFOW_V1_SIZE;
        tool.uFlags = TTF_IDISHWND | TTF_SUBCLASS;
        tool.hwnd = window_;
        tool.uId = (UINT_PTR)control;
        tool.lpszText = tip_texts_[control].data();
        SendMessageW(tips_, is_new ? TTM_ADDTOOLW : TTM_UPDATETIPTEXTW, 0, (LPARAM)&tool);
    }

    /* Marks a field as wrong; "": right again. */
    void mark(HWND control, const std::wstring &sentence) {
        bool is_new = sentence.empty() ? marked_.erase(control) > 0 : marked_[control] != sentence;
        if (is_new)
            InvalidateRect(control, NULL, TRUE);
        if (!sentence.empty())
            marked_[control] = sentence;
    }

    /* Lists. */

    /* The columns of a text, each a title and a width, of which 0 takes what the others leave. */
    void add_columns(HWND list, const std::string &titles) {
        ListView_SetExtendedListViewStyle(list, LVS_EX_FULLROWSELECT | LVS_EX_DOUBLEBUFFER | LVS_EX_LABELTIP);
        for (const std::wstring &title : parts(titles)) {
            std::wstring name = title.substr(0, title.rfind(L' '));
            LVCOLUMNW column = {};
            column.mask = LVCF_TEXT | LVCF_SUBITEM;
            column.pszText = name.data();
            column.iSubItem = (int)widths_[list].size();
            ListView_InsertColumn(list, column.iSubItem, &column);
            widths_[list].push_back(_wtoi(&title[name.size()]));
        }
    }

    void rows(int id, const Rows &rows) {
        if (rows_.count(id) == 0 || rows_[id] != rows) {
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
    std::map<HWND, std::wstring> marked_;

private:
    struct Growth {
        std::string ways;
        RECT place;
    };

    static const DLGTEMPLATE *template_of(UINT id) {
        return (const DLGTEMPLATE *)resource(MAKEINTRESOURCEW(5), id); /* RT_DIALOG */
    }

    static INT_PTR CALLBACK procedure(HWND window, UINT message, WPARAM wparam, LPARAM lparam) {
        Dialog *dialog = (Dialog *)GetWindowLongPtrW(window, GWLP_USERDATA);
        if (message == WM_INITDIALOG) {
            SetWindowLongPtrW(window, GWLP_USERDATA, lparam);
            dialog = (Dialog *)lparam;
            dialog->window_ = window;
        }
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

    /* Translates the controls. */
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
            std::string whole = narrow(window_text(own));
            std::vector<std::string> pieces = split(whole + "|||", "|");
            if (!whole.empty()) {
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
        static HFONT bold = NULL;
        LOGFONTW font;
        if (bold == NULL && GetObjectW((HFONT)SendMessageW(control, WM_GETFONT, 0, 0), sizeof font, &font)) {
            font.lfWeight = FW_BOLD;
            bold = CreateFontIndirectW(&font);
        }
        return bold;
    }

    void layout() const {
        RECT client;
        GetClientRect(window_, &client);
        for (const auto &[control, growth] : growth_) {
            auto grown = [&growth](char whole, char half, int by) {
                bool is_whole = growth.ways.find(whole) != std::string::npos;
                return is_whole ? by : growth.ways.find(half) != std::string::npos ? by / 2 : 0;
            };
            int wider = max(0, (int)(client.right - size_.cx)), higher = max(0, (int)(client.bottom - size_.cy));
            const RECT &place = growth.place;
            MoveWindow(control, place.left + grown('x', 'X', wider), place.top + grown('y', 'Y', higher),
                       place.right - place.left + grown('w', 'W', wider),
                       place.bottom - place.top + grown('h', 'H', higher), TRUE);
        }
        for (const auto &[list, widths] : widths_) {
            GetWindowRect(list, &client);
            int rest = client.right - client.left - GetSystemMetrics(SM_CXVSCROLL) - scaled(4);
            for (int width : widths)
                rest -= scaled(width);
            for (size_t k = 0; k < widths.size(); k++)
                ListView_SetColumnWidth(list, (int)k, widths[k] == 0 ? rest : scaled(widths[k]));
        }
    }

    void notify(NMHDR *notice) {
        const Rows &rows = rows_[(int)notice->idFrom];
        SetWindowLongPtrW(window_, DWLP_MSGRESULT, 0);
        if (notice->code == (UINT)NM_CUSTOMDRAW && !rows.empty()) {
            SetWindowLongPtrW(window_, DWLP_MSGRESULT, draw_row((NMLVCUSTOMDRAW *)notice, rows));
        } else if (notice->code == (UINT)LVN_GETDISPINFOW && !rows.empty()) {
            LVITEMW &entry = ((NMLVDISPINFOW *)notice)->item;
            const Texts &cells = rows[min((size_t)entry.iItem, rows.size() - 1)].cells;
            if ((entry.mask & LVIF_TEXT) != 0 && entry.iSubItem < (int)cells.size())
                lstrcpynW(entry.pszText, cells[entry.iSubItem].c_str(), entry.cchTextMax);
        } else {
            on_notify(notice);
        }
    }

    /* What is off is grey; the second column may be a bar. */
    static LRESULT draw_row(NMLVCUSTOMDRAW *draw, const Rows &rows) {
        DWORD stage = draw->nmcd.dwDrawStage;
        size_t row = draw->nmcd.dwItemSpec;
        if (stage == CDDS_PREPAINT)
            return CDRF_NOTIFYITEMDRAW;
        if (stage == CDDS_ITEMPREPAINT && row < rows.size()) {
            draw->clrText = rows[row].is_grey ? RGB(150, 150, 150) : RGB(0, 0, 0);
            return CDRF_NOTIFYPOSTPAINT;
        }
        if (stage == CDDS_ITEMPOSTPAINT && row < rows.size() && rows[row].bar > 0) {
            RECT bar;
            ListView_GetSubItemRect(draw->nmcd.hdr.hwndFrom, (int)row, 1, LVIR_BOUNDS, &bar);
            InflateRect(&bar, -3, -3);
            bar.right = bar.left + (LONG)((bar.right - bar.left) * rows[row].bar);
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
    std::map<HWND, std::wstring> tip_texts_; /* the tool tip does not copy them */
    std::map<HWND, Growth> growth_;
    std::map<HWND, std::vector<int>> widths_; /* of the columns of lists */
    std::map<int, Rows> rows_;
    SIZE size_ = {};
};
