#include "dialog.h"

static const COLORREF HEADING = RGB(0, 70, 140), WRONG = RGB(255, 214, 214), MESSAGE = RGB(170, 0, 0);

Dialog::~Dialog()
{
    if (window_ != NULL) {
        DestroyWindow(window_);
    }
}

static const DLGTEMPLATE *layout_of(UINT id)
{
    return (const DLGTEMPLATE *)resource(MAKEINTRESOURCEW(5), id); /* RT_DIALOG */
}

bool Dialog::create(HWND parent, UINT id)
{
    return CreateDialogIndirectParamW(NULL, layout_of(id), parent, procedure, (LPARAM)this) != NULL;
}

INT_PTR Dialog::modal(HWND parent, UINT id)
{
    return DialogBoxIndirectParamW(NULL, layout_of(id), parent, procedure, (LPARAM)this);
}

INT_PTR CALLBACK Dialog::procedure(HWND window, UINT message, WPARAM wparam, LPARAM lparam)
{
    Dialog *dialog = (Dialog *)GetWindowLongPtrW(window, GWLP_USERDATA);
    if (message == WM_INITDIALOG) {
        SetWindowLongPtrW(window, GWLP_USERDATA, lparam);
        dialog = (Dialog *)lparam;
        dialog->window_ = window;
        dialog->init();
        return TRUE;
    }
    return dialog == NULL ? FALSE : dialog->handle(message, wparam, lparam);
}

void Dialog::init()
{
    RECT client;
    std::vector<std::pair<std::string, size_t>> keys;
    GetClientRect(window_, &client);
    size_ = {client.right, client.bottom};
    SetWindowTextW(window_, text(narrow(window_text(window_))).c_str());
    tips_ = CreateWindowExW(WS_EX_TOPMOST, TOOLTIPS_CLASSW, NULL, WS_POPUP | TTS_ALWAYSTIP | TTS_NOPREFIX, 0,
                            0, 0, 0, window_, NULL, NULL, NULL);
    SendMessageW(tips_, TTM_SETMAXTIPWIDTH, 0, scaled(360));
    SendMessageW(tips_, TTM_SETDELAYTIME, TTDT_AUTOPOP, 30000);
    for (HWND own = GetWindow(window_, GW_CHILD); own != NULL; own = GetWindow(own, GW_HWNDNEXT)) {
        init_control(own, keys);
    }
    on_init();
}

/* Translates a control. A label names the keys of the fields behind it; each of these takes the next element.
 */
void Dialog::init_control(HWND control, std::vector<std::pair<std::string, size_t>> &keys)
{
    static HFONT bold = NULL;
    LOGFONTW font;
    WCHAR kind[16] = L"";
    std::vector<std::string> pieces = split(narrow(window_text(control)), "|");
    GetClassNameW(control, kind, 16);
    if (lstrcmpiW(kind, L"Static") == 0) {
        keys.clear();
        for (const std::string &path : split(pieces.size() > 1 ? pieces[1] : "", " ")) {
            const Key *key = key_of(path);
            for (size_t k = 0; key != NULL && k < max((size_t)1, key->count); k++) {
                keys.push_back({path, k});
            }
        }
    } else if (!keys.empty()) {
        bind(control, keys[0].first, keys[0].second);
        keys.erase(keys.begin());
    }
    if (!pieces[0].empty()) {
        SetWindowTextW(control, text(pieces[0]).c_str());
    }
    if (GetDlgCtrlID(control) == IDC_HEADING) {
        if (bold == NULL &&
            GetObjectW((HFONT)SendMessageW(control, WM_GETFONT, 0, 0), sizeof font, &font) != 0) {
            font.lfWeight = FW_BOLD;
            bold = CreateFontIndirectW(&font);
        }
        SendMessageW(control, WM_SETFONT, (WPARAM)bold, FALSE);
    }
}

INT_PTR Dialog::handle(UINT message, WPARAM wparam, LPARAM lparam)
{
    switch (message) {
    case WM_COMMAND:
        if (LOWORD(wparam) == IDCANCEL && (GetWindowLongW(window_, GWL_STYLE) & WS_POPUP) != 0) {
            finish(IDCANCEL);
        } else if (is_change((HWND)lparam, HIWORD(wparam))) {
            on_change(LOWORD(wparam), HIWORD(wparam));
        } else {
            on_command(LOWORD(wparam), HIWORD(wparam));
        }
        return TRUE;
    case WM_NOTIFY:
        SetWindowLongPtrW(window_, DWLP_MSGRESULT, 0);
        on_notify((NMHDR *)lparam);
        return TRUE;
    case WM_SIZE: layout(); return TRUE;
    case WM_TIMER: on_timer(); return TRUE;
    case WM_CTLCOLORDLG:
    case WM_CTLCOLORSTATIC:
    case WM_CTLCOLORBTN:
    case WM_CTLCOLOREDIT: return (INT_PTR)color((HDC)wparam, (HWND)lparam);
    case WM_DESTROY: window_ = NULL;
    }
    return FALSE;
}

HBRUSH Dialog::color(HDC dc, HWND control) const
{
    static const HBRUSH wrong = CreateSolidBrush(WRONG);
    int id = control == window_ ? 0 : GetDlgCtrlID(control);
    SetBkMode(dc, TRANSPARENT);
    if (marked_.count(control) != 0) {
        SetBkColor(dc, WRONG);
        return wrong;
    }
    if (id == IDC_HEADING || id == IDC_MESSAGE) {
        SetTextColor(dc, id == IDC_HEADING ? HEADING : MESSAGE);
    } else if (!IsWindowEnabled(control)) {
        SetTextColor(dc, GetSysColor(COLOR_GRAYTEXT));
    }
    return GetSysColorBrush(COLOR_WINDOW);
}

void Dialog::grow(std::initializer_list<int> ids, int x, int y, int w, int h)
{
    for (int id : ids) {
        Growth growth = {x, y, w, h, {}};
        GetWindowRect(item(id), &growth.place);
        MapWindowPoints(NULL, window_, (POINT *)&growth.place, 2);
        growth_[id] = growth;
    }
}

void Dialog::layout() const
{
    RECT client;
    GetClientRect(window_, &client);
    int wider = max(0, (int)(client.right - size_.cx)), higher = max(0, (int)(client.bottom - size_.cy));
    auto part = [](int share, int of) { return share == 2 ? of / 2 : share * of; };
    for (const auto &entry : growth_) {
        const Growth &own = entry.second;
        int width = own.place.right - own.place.left, height = own.place.bottom - own.place.top;
        MoveWindow(item(entry.first), own.place.left + part(own.x, wider),
                   own.place.top + part(own.y, higher), width + part(own.w, wider),
                   height + part(own.h, higher), TRUE);
    }
    fit_columns();
}

std::wstring window_text(HWND window)
{
    std::wstring text((size_t)GetWindowTextLengthW(window) + 1, L'\0');
    text.resize((size_t)GetWindowTextW(window, &text[0], (int)text.size()));
    return text;
}

std::wstring Dialog::get(int id) const
{
    return window_text(item(id));
}

void Dialog::set(int id, const std::wstring &text) const
{
    if (get(id) != text) {
        SetWindowTextW(item(id), text.c_str());
    }
}

void Dialog::fill(HWND combo, const Texts &words) const
{
    SendMessageW(combo, CB_RESETCONTENT, 0, 0);
    for (const std::wstring &word : words) {
        SendMessageW(combo, CB_ADDSTRING, 0, (LPARAM)word.c_str());
    }
    SendMessageW(combo, CB_SETCURSEL, 0, 0);
}

void Dialog::tip(HWND control, const std::wstring &text)
{
    TOOLINFOW tool = {};
    bool is_new = tip_texts_.count(control) == 0;
    tip_texts_[control] = text;
    tool.cbSize = TTTOOLINFOW_V1_SIZE;
    tool.uFlags = TTF_IDISHWND | TTF_SUBCLASS;
    tool.hwnd = window_;
    tool.uId = (UINT_PTR)control;
    tool.lpszText = &tip_texts_[control][0];
    SendMessageW(tips_, is_new ? TTM_ADDTOOLW : TTM_UPDATETIPTEXTW, 0, (LPARAM)&tool);
}

void Dialog::columns(int id, const std::string &titles, const std::vector<int> &widths)
{
    Texts names = parts(titles);
    ListView_SetExtendedListViewStyle(item(id), LVS_EX_FULLROWSELECT | LVS_EX_DOUBLEBUFFER | LVS_EX_LABELTIP);
    for (size_t k = 0; k < names.size(); k++) {
        LVCOLUMNW column = {};
        column.mask = LVCF_TEXT | LVCF_SUBITEM;
        column.pszText = &names[k][0];
        column.iSubItem = (int)k;
        ListView_InsertColumn(item(id), (int)k, &column);
    }
    widths_[id] = widths;
    fit_columns();
}

void Dialog::fit_columns() const
{
    for (const auto &entry : widths_) {
        RECT client;
        GetWindowRect(item(entry.first), &client);
        int rest = client.right - client.left - GetSystemMetrics(SM_CXVSCROLL) - scaled(4);
        for (int width : entry.second) {
            rest -= scaled(width);
        }
        for (size_t k = 0; k < entry.second.size(); k++) {
            int width = entry.second[k] == 0 ? rest : scaled(entry.second[k]);
            ListView_SetColumnWidth(item(entry.first), (int)k, width);
        }
    }
}

void Dialog::rows(int id, const std::vector<Texts> &rows) const
{
    HWND list = item(id);
    LVITEMW entry = {};
    WCHAR now[256];
    while ((size_t)ListView_GetItemCount(list) > rows.size()) {
        ListView_DeleteItem(list, (int)rows.size());
    }
    for (size_t k = 0; k < rows.size(); k++) {
        entry.iItem = (int)k;
        if (ListView_GetItemCount(list) <= (int)k) {
            SendMessageW(list, LVM_INSERTITEMW, 0, (LPARAM)&entry);
        }
        for (int column = 0; column < (int)rows[k].size(); column++) {
            std::wstring text = rows[k][(size_t)column];
            ListView_GetItemText(list, (int)k, column, now, 256);
            if (text != now) {
                ListView_SetItemText(list, (int)k, column, &text[0]);
            }
        }
    }
}

void Dialog::select(int id, size_t row) const
{
    ListView_SetItemState(item(id), (int)row, LVIS_SELECTED | LVIS_FOCUSED, LVIS_SELECTED | LVIS_FOCUSED);
    ListView_EnsureVisible(item(id), (int)row, FALSE);
}
