#include "dialog.h"

static const COLORREF HEADING = RGB(0, 70, 140), WRONG = RGB(255, 214, 214);

Dialog::~Dialog()
{
    if (window_ != NULL) {
        DestroyWindow(window_);
    }
}

bool Dialog::create(HWND parent, UINT id)
{
    return CreateDialogIndirectParamW(NULL, dialog_template(id), parent, procedure, (LPARAM)this) != NULL;
}

INT_PTR Dialog::modal(HWND parent, UINT id)
{
    return DialogBoxIndirectParamW(NULL, dialog_template(id), parent, procedure, (LPARAM)this);
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

/* Headings, as group boxes would be. */
static BOOL CALLBACK make_bold(HWND control, LPARAM)
{
    static HFONT bold = NULL;
    LOGFONTW font;
    if (GetDlgCtrlID(control) == IDC_HEADING) {
        if (bold == NULL && GetObjectW((HFONT)SendMessageW(control, WM_GETFONT, 0, 0), sizeof font, &font) != 0) {
            font.lfWeight = FW_BOLD;
            bold = CreateFontIndirectW(&font);
        }
        SendMessageW(control, WM_SETFONT, (WPARAM)bold, FALSE);
    }
    return TRUE;
}

void Dialog::init()
{
    RECT client;
    GetClientRect(window_, &client);
    size_ = {client.right, client.bottom};
    tips_ = CreateWindowExW(WS_EX_TOPMOST, TOOLTIPS_CLASSW, NULL, WS_POPUP | TTS_ALWAYSTIP | TTS_NOPREFIX, 0, 0, 0, 0, window_, NULL,
                            NULL, NULL);
    SendMessageW(tips_, TTM_SETMAXTIPWIDTH, 0, scaled(360));
    SendMessageW(tips_, TTM_SETDELAYTIME, TTDT_AUTOPOP, 30000);
    EnumChildWindows(window_, make_bold, 0);
    on_init();
}

INT_PTR Dialog::handle(UINT message, WPARAM wparam, LPARAM lparam)
{
    switch (message) {
    case WM_COMMAND:
        if (LOWORD(wparam) == IDCANCEL && GetParent(window_) != NULL && (GetWindowLongW(window_, GWL_STYLE) & WS_POPUP) != 0) {
            finish(IDCANCEL);
            return TRUE;
        }
        on_command(LOWORD(wparam), HIWORD(wparam));
        return TRUE;
    case WM_NOTIFY:
        SetWindowLongPtrW(window_, DWLP_MSGRESULT, 0);
        on_notify((NMHDR *)lparam);
        return TRUE;
    case WM_SIZE:
        layout();
        return TRUE;
    case WM_CTLCOLORDLG:
    case WM_CTLCOLORSTATIC:
    case WM_CTLCOLORBTN:
    case WM_CTLCOLOREDIT:
        return (INT_PTR)color((HDC)wparam, (HWND)lparam);
    case WM_DESTROY:
        window_ = NULL;
        return FALSE;
    }
    on_message(message, wparam, lparam);
    return FALSE;
}

HBRUSH Dialog::color(HDC dc, HWND control)
{
    static const HBRUSH wrong = CreateSolidBrush(WRONG);
    int id = control == window_ ? 0 : GetDlgCtrlID(control);
    SetBkMode(dc, TRANSPARENT);
    if (id == IDC_HEADING) {
        SetTextColor(dc, HEADING);
    } else if (id == IDC_MESSAGE) {
        SetTextColor(dc, RGB(170, 0, 0));
    } else if (id != 0 && is_marked(id)) {
        SetBkColor(dc, WRONG);
        return wrong;
    } else if (id != 0 && !IsWindowEnabled(control)) {
        SetTextColor(dc, GetSysColor(COLOR_GRAYTEXT));
    }
    return GetSysColorBrush(COLOR_WINDOW);
}

void Dialog::layout()
{
    RECT client;
    GetClientRect(window_, &client);
    int wider = max(0, (int)client.right - (int)size_.cx), higher = max(0, (int)client.bottom - (int)size_.cy);
    for (const auto &entry : growth_) {
        RECT &place = places_[entry.first];
        const Growth &growth = entry.second;
        if (IsRectEmpty(&place)) {
            GetWindowRect(item(entry.first), &place);
            MapWindowPoints(NULL, window_, (POINT *)&place, 2);
        }
        auto part = [](int share, int of) { return share == 2 ? of / 2 : share * of; };
        MoveWindow(item(entry.first), place.left + part(growth.x, wider), place.top + part(growth.y, higher),
                   place.right - place.left + part(growth.w, wider), place.bottom - place.top + part(growth.h, higher), TRUE);
    }
}

std::wstring Dialog::get(int id) const
{
    std::wstring text((size_t)GetWindowTextLengthW(item(id)) + 1, L'\0');
    text.resize((size_t)GetWindowTextW(item(id), &text[0], (int)text.size()));
    return text;
}

void Dialog::set(int id, const std::wstring &text) const
{
    if (get(id) != text) {
        SetWindowTextW(item(id), text.c_str());
    }
}

void Dialog::fill(int id, const std::vector<std::wstring> &words) const
{
    SendMessageW(item(id), CB_RESETCONTENT, 0, 0);
    for (const std::wstring &word : words) {
        SendMessageW(item(id), CB_ADDSTRING, 0, (LPARAM)word.c_str());
    }
    choose(id, 0);
}

void Dialog::tip(int id, const std::wstring &text)
{
    TOOLINFOW tool = {};
    bool is_new = tip_texts_.count(id) == 0;
    tip_texts_[id] = text;
    tool.cbSize = TTTOOLINFOW_V1_SIZE;
    tool.uFlags = TTF_IDISHWND | TTF_SUBCLASS;
    tool.hwnd = window_;
    tool.uId = (UINT_PTR)item(id);
    tool.lpszText = &tip_texts_[id][0];
    SendMessageW(tips_, is_new ? TTM_ADDTOOLW : TTM_UPDATETIPTEXTW, 0, (LPARAM)&tool);
}

void Dialog::cue(int id, const std::wstring &text) const
{
    SendMessageW(item(id), EM_SETCUEBANNER, FALSE, (LPARAM)text.c_str());
}

void Dialog::mark(int id, const std::wstring &sentence)
{
    if (sentence.empty() ? marked_.erase(id) != 0 : marked_[id] != sentence) {
        if (!sentence.empty()) {
            marked_[id] = sentence;
        }
        InvalidateRect(item(id), NULL, TRUE);
    }
}

void Dialog::columns(int id, const std::vector<std::wstring> &titles, const std::vector<int> &widths) const
{
    SendMessageW(item(id), LVM_SETEXTENDEDLISTVIEWSTYLE, 0, LVS_EX_FULLROWSELECT | LVS_EX_DOUBLEBUFFER | LVS_EX_LABELTIP);
    for (int k = 0; k < (int)titles.size(); k++) {
        LVCOLUMNW column = {};
        column.mask = LVCF_TEXT | LVCF_WIDTH | LVCF_SUBITEM;
        column.cx = scaled(widths[(size_t)k]);
        column.pszText = (LPWSTR)titles[(size_t)k].c_str();
        column.iSubItem = k;
        SendMessageW(item(id), LVM_INSERTCOLUMNW, (WPARAM)k, (LPARAM)&column);
    }
}

void Dialog::row(int id, int row, const std::vector<std::wstring> &texts) const
{
    LVITEMW entry = {};
    WCHAR now[256];
    entry.mask = LVIF_TEXT;
    entry.iItem = row;
    entry.pszText = (LPWSTR)L"";
    if (row >= (int)SendMessageW(item(id), LVM_GETITEMCOUNT, 0, 0)) {
        SendMessageW(item(id), LVM_INSERTITEMW, 0, (LPARAM)&entry);
    }
    for (entry.iSubItem = 0; entry.iSubItem < (int)texts.size(); entry.iSubItem++) {
        entry.pszText = now;
        entry.cchTextMax = 256;
        SendMessageW(item(id), LVM_GETITEMTEXTW, (WPARAM)row, (LPARAM)&entry);
        if (texts[(size_t)entry.iSubItem] != now) {
            entry.pszText = (LPWSTR)texts[(size_t)entry.iSubItem].c_str();
            SendMessageW(item(id), LVM_SETITEMTEXTW, (WPARAM)row, (LPARAM)&entry);
        }
    }
}

void Dialog::select(int id, int row) const
{
    LVITEMW entry = {};
    entry.stateMask = entry.state = LVIS_SELECTED | LVIS_FOCUSED;
    SendMessageW(item(id), LVM_SETITEMSTATE, (WPARAM)row, (LPARAM)&entry);
    SendMessageW(item(id), LVM_ENSUREVISIBLE, (WPARAM)row, FALSE);
}

void Dialog::keep_rows(int id, int count) const
{
    for (int k = (int)SendMessageW(item(id), LVM_GETITEMCOUNT, 0, 0); k > count; k--) {
        SendMessageW(item(id), LVM_DELETEITEM, (WPARAM)(k - 1), 0);
    }
}

std::wstring ask_file(HWND owner, bool save, UINT filter, const wchar_t *ending, const std::wstring &proposal)
{
    WCHAR path[32768] = L"";
    std::wstring pairs = text(filter);
    OPENFILENAMEW ask = {};
    for (WCHAR &letter : pairs) {
        letter = letter == L';' ? L'\0' : letter;
    }
    pairs += L'\0';
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

int scaled(int pixels)
{
    HDC screen = GetDC(NULL);
    int dots = GetDeviceCaps(screen, LOGPIXELSY);
    ReleaseDC(NULL, screen);
    return MulDiv(pixels, dots, 96);
}

bool is_unattended = false, has_failed = false;

void say(HWND owner, const std::wstring &sentence, UINT icon)
{
    if (is_unattended) {
        std::string line = "SINS_Emulator: " + narrow(sentence) + "\n";
        DWORD written;
        WriteFile(GetStdHandle(STD_ERROR_HANDLE), line.data(), (DWORD)line.size(), &written, NULL);
        has_failed = true;
        return;
    }
    MessageBoxW(owner, sentence.c_str(), text(IDS_TITLE).c_str(), MB_OK | icon);
}
