#include "dialog.h"

static const COLORREF HEADING = RGB(0, 70, 140), WRONG = RGB(255, 214, 214), MESSAGE = RGB(170, 0, 0);

Dialog::~Dialog()
{
    if (window_ != NULL) {
        DestroyWindow(window_);
    }
}

static const DLGTEMPLATE *template_of(UINT id)
{
    return (const DLGTEMPLATE *)resource(MAKEINTRESOURCEW(5), id); /* RT_DIALOG */
}

void Dialog::create(HWND parent, UINT id)
{
    CreateDialogIndirectParamW(NULL, template_of(id), parent, procedure, (LPARAM)this);
}

INT_PTR Dialog::modal(HWND parent, UINT id)
{
    return DialogBoxIndirectParamW(NULL, template_of(id), parent, procedure, (LPARAM)this);
}

INT_PTR CALLBACK Dialog::procedure(HWND window, UINT message, WPARAM wparam, LPARAM lparam)
{
    Dialog *dialog = (Dialog *)GetWindowLongPtrW(window, GWLP_USERDATA);
    if (message == WM_INITDIALOG) {
        SetWindowLongPtrW(window, GWLP_USERDATA, lparam);
        dialog = (Dialog *)lparam;
        dialog->window_ = window;
    }
    if (dialog == NULL) {
        return FALSE;
    }
    try {
        return dialog->handle(message, wparam, lparam);
    } catch (const Refusal &refusal) {
        dialog->on_refusal(refusal.sentence);
    } catch (const std::exception &error) {
        dialog->on_refusal(wide(error.what()));
    }
    return TRUE;
}

/* Translates the controls. */
void Dialog::init()
{
    RECT client;
    GetClientRect(window_, &client);
    size_ = {client.right, client.bottom};
    SetWindowTextW(window_, text(narrow(window_text(window_))).c_str());
    tips_ = CreateWindowExW(WS_EX_TOPMOST, TOOLTIPS_CLASSW, NULL, WS_POPUP | TTS_ALWAYSTIP | TTS_NOPREFIX, 0,
                            0, 0, 0, window_, NULL, NULL, NULL);
    SendMessageW(tips_, TTM_SETMAXTIPWIDTH, 0, scaled(360));
    SendMessageW(tips_, TTM_SETDELAYTIME, TTDT_AUTOPOP, 30000);
    for (HWND own = GetWindow(window_, GW_CHILD); own != NULL; own = GetWindow(own, GW_HWNDNEXT)) {
        std::vector<std::string> pieces = split(narrow(window_text(own)) + "|", "|");
        if (!pieces[0].empty()) {
            SetWindowTextW(own, text(pieces[0]).c_str());
        }
        if (GetDlgCtrlID(own) == IDC_HEADING) {
            static HFONT bold = NULL;
            LOGFONTW font;
            if (bold == NULL &&
                GetObjectW((HFONT)SendMessageW(own, WM_GETFONT, 0, 0), sizeof font, &font) != 0) {
                font.lfWeight = FW_BOLD;
                bold = CreateFontIndirectW(&font);
            }
            SendMessageW(own, WM_SETFONT, (WPARAM)bold, FALSE);
        }
        on_control(own, pieces[1]);
    }
    on_init();
}

INT_PTR Dialog::handle(UINT message, WPARAM wparam, LPARAM lparam)
{
    NMHDR *notice = (NMHDR *)lparam;
    switch (message) {
    case WM_INITDIALOG: init(); return TRUE;
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
        if (notice->code == (UINT)NM_CUSTOMDRAW && rows_.count(notice->idFrom) != 0) {
            SetWindowLongPtrW(window_, DWLP_MSGRESULT, draw_row((NMLVCUSTOMDRAW *)notice));
        } else if (notice->code == (UINT)LVN_GETDISPINFOW && !rows_[notice->idFrom].empty()) {
            LVITEMW &entry = ((NMLVDISPINFOW *)notice)->item;
            const Rows &rows = rows_[notice->idFrom];
            const Texts &cells = rows[min((size_t)entry.iItem, rows.size() - 1)].cells;
            if ((entry.mask & LVIF_TEXT) != 0 && entry.iSubItem < (int)cells.size()) {
                lstrcpynW(entry.pszText, cells[entry.iSubItem].c_str(), entry.cchTextMax);
            }
        } else {
            on_notify(notice);
        }
        return TRUE;
    case WM_SIZE: layout(); break;
    case WM_CTLCOLORDLG:
    case WM_CTLCOLORSTATIC:
    case WM_CTLCOLORBTN:
    case WM_CTLCOLOREDIT: return (INT_PTR)color((HDC)wparam, (HWND)lparam);
    case WM_DESTROY: window_ = NULL;
    }
    return on_message(message, wparam, lparam);
}

/* What is off is grey; the second column may be a bar. */
LRESULT Dialog::draw_row(NMLVCUSTOMDRAW *draw) const
{
    const Rows &rows = rows_.at(draw->nmcd.hdr.idFrom);
    DWORD stage = draw->nmcd.dwDrawStage;
    size_t row = draw->nmcd.dwItemSpec;
    if (stage == CDDS_PREPAINT) {
        return CDRF_NOTIFYITEMDRAW;
    }
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

void Dialog::mark(HWND control, const std::wstring &sentence)
{
    bool is_new = sentence.empty() ? marked_.erase(control) > 0 : marked_[control] != sentence;
    if (is_new) {
        InvalidateRect(control, NULL, TRUE);
    }
    if (!sentence.empty()) {
        marked_[control] = sentence;
    }
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
    RECT client, place;
    GetClientRect(window_, &client);
    int wider = max(0, (int)(client.right - size_.cx)), higher = max(0, (int)(client.bottom - size_.cy));
    auto part = [](int share, int of) { return share == 2 ? of / 2 : share * of; };
    for (const auto &[id, own] : growth_) {
        int width = own.place.right - own.place.left, height = own.place.bottom - own.place.top;
        MoveWindow(item(id), own.place.left + part(own.x, wider), own.place.top + part(own.y, higher),
                   width + part(own.w, wider), height + part(own.h, higher), TRUE);
    }
    for (const auto &[id, widths] : widths_) {
        GetWindowRect(item(id), &place);
        int rest = place.right - place.left - GetSystemMetrics(SM_CXVSCROLL) - scaled(4);
        for (int width : widths) {
            rest -= scaled(width);
        }
        for (size_t k = 0; k < widths.size(); k++) {
            ListView_SetColumnWidth(item(id), (int)k, widths[k] == 0 ? rest : scaled(widths[k]));
        }
    }
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
    tool.lpszText = tip_texts_[control].data();
    SendMessageW(tips_, is_new ? TTM_ADDTOOLW : TTM_UPDATETIPTEXTW, 0, (LPARAM)&tool);
}

void Dialog::columns(int id, const std::string &titles, const std::vector<int> &widths)
{
    Texts names = parts(titles);
    ListView_SetExtendedListViewStyle(item(id), LVS_EX_FULLROWSELECT | LVS_EX_DOUBLEBUFFER | LVS_EX_LABELTIP);
    for (size_t k = 0; k < names.size(); k++) {
        LVCOLUMNW column = {};
        column.mask = LVCF_TEXT | LVCF_SUBITEM;
        column.pszText = names[k].data();
        column.iSubItem = (int)k;
        ListView_InsertColumn(item(id), (int)k, &column);
    }
    widths_[id] = widths;
    layout();
}

void Dialog::rows(int id, const Rows &rows)
{
    if (rows_.count(id) == 0 || rows_[id] != rows) {
        rows_[id] = rows;
        ListView_SetItemCountEx(item(id), (int)rows.size(), LVSICF_NOSCROLL);
    }
}

void Dialog::select(int id, size_t row) const
{
    ListView_SetItemState(item(id), (int)row, LVIS_SELECTED | LVIS_FOCUSED, LVIS_SELECTED | LVIS_FOCUSED);
    ListView_EnsureVisible(item(id), (int)row, FALSE);
}

std::wstring window_text(HWND window)
{
    std::wstring text(GetWindowTextLengthW(window) + 1, L'\0');
    text.resize(GetWindowTextW(window, text.data(), (int)text.size()));
    return text;
}

std::wstring ask_file(HWND owner, bool save, const std::string &filter, const wchar_t *ending,
                      const std::wstring &proposal)
{
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
    if (!is_unattended) {
        MessageBoxW(owner, sentence.c_str(), text("title").c_str(), MB_OK | icon);
        return;
    }
    std::string line = "SINS_Emulator: " + narrow(sentence) + "\n";
    DWORD written;
    WriteFile(GetStdHandle(STD_ERROR_HANDLE), line.data(), (DWORD)line.size(), &written, NULL);
    has_failed = true;
}
