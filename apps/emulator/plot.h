/* A diagram in a control of a dialog, with zoom and a cursor. */
#pragma once
#include <objidl.h>

#include <gdiplus.h>

#include "diagram.h"

class Plot {
public:
    ~Plot() { RemoveWindowSubclass(window_, procedure, 0); }

    void attach(HWND control) { /* a static control with SS_NOTIFY, which gets mouse messages */
        window_ = control;
        SetWindowSubclass(control, procedure, 0, (DWORD_PTR)this);
    }

    void show(const std::vector<Panel> &panels, Quantity x_quantity, bool is_logarithmic) {
        Range zoomed = x_quantity == diagram_.x_quantity ? diagram_.zoomed : Range{0, 0};
        diagram_ = {panels, x_quantity, is_logarithmic && x_quantity == DURATION, zoomed};
        InvalidateRect(window_, NULL, FALSE);
    }

    /* The unit of the axis of time; on a map, the unit for a duration. */
    Unit time_unit(double duration_s) const {
        return Diagram::unit_for(DURATION, diagram_.x_quantity == DURATION ? diagram_.seen_x() : Range{0, duration_s});
    }

    void print(HWND owner, const std::wstring &name) const {
        PRINTDLGW ask = {.lStructSize = sizeof ask, .hwndOwner = owner, .Flags = PD_RETURNDC | PD_NOPAGENUMS | PD_NOSELECTION};
        if (!PrintDlgW(&ask))
            return;
        DOCINFOW document = {.cbSize = sizeof document, .lpszDocName = name.c_str()};
        ULONG_PTR token = 0;
        Gdiplus::GdiplusStartupInput input;
        Gdiplus::GdiplusStartup(&token, &input, NULL);
        HBITMAP bitmap = picture(2000, 1400, -1);
        bool done = StartDocW(ask.hDC, &document) > 0 && StartPage(ask.hDC) > 0;
        if (done) {
            int width = GetDeviceCaps(ask.hDC, HORZRES), height = min(width * 7 / 10, GetDeviceCaps(ask.hDC, VERTRES));
            Gdiplus::Graphics page(ask.hDC);
            Gdiplus::Bitmap drawn(bitmap, (HPALETTE)NULL);
            page.SetPageUnit(Gdiplus::UnitPixel);
            done = page.DrawImage(&drawn, 0, 0, width, height) == Gdiplus::Ok;
        }
        done = done && EndPage(ask.hDC) > 0 && EndDoc(ask.hDC) > 0;
        DeleteObject(bitmap);
        DeleteDC(ask.hDC);
        Gdiplus::GdiplusShutdown(token);
        if (!done)
            throw Refusal(text("not_printed"));
    }

    void save(const fs::path &path) const { /* PNG */
        static const CLSID PNG = {0x557cf406, 0x1a04, 0x11d3, {0x9a, 0x73, 0x00, 0x00, 0xf8, 0x1e, 0xf3, 0x2e}};
        ULONG_PTR token = 0;
        Gdiplus::GdiplusStartupInput input;
        Gdiplus::GdiplusStartup(&token, &input, NULL);
        write_file(path, [this](const fs::path &to) {
            HBITMAP bitmap = picture(scaled(1000), scaled(700), -1);
            bool done = Gdiplus::Bitmap(bitmap, (HPALETTE)NULL).Save(to.c_str(), &PNG, NULL) == Gdiplus::Ok;
            DeleteObject(bitmap);
            return done;
        });
        Gdiplus::GdiplusShutdown(token);
    }

    bool copy() const { /* to the clipboard */
        HBITMAP bitmap = picture(scaled(1000), scaled(700), -1);
        bool done = OpenClipboard(window_) && EmptyClipboard() && SetClipboardData(CF_BITMAP, bitmap) != NULL;
        CloseClipboard();
        if (!done) /* otherwise the clipboard owns it */
            DeleteObject(bitmap);
        return done;
    }

private:
    static LRESULT CALLBACK procedure(HWND, UINT message, WPARAM wparam, LPARAM lparam, UINT_PTR, DWORD_PTR plot) {
        return ((Plot *)plot)->handle(message, wparam, lparam);
    }

    LRESULT handle(UINT message, WPARAM wparam, LPARAM lparam) {
        int x = (short)LOWORD(lparam);
        switch (message) {
        case WM_ERASEBKGND: return 1;
        case WM_PAINT: paint(); return 0;
        case WM_SETCURSOR: SetCursor(LoadCursorW(NULL, (LPCWSTR)IDC_CROSS)); return TRUE;
        case WM_SIZE: break;
        case WM_MOUSEMOVE: {
            TRACKMOUSEEVENT leave = {sizeof leave, TME_LEAVE, window_, 0};
            TrackMouseEvent(&leave);
            cursor_ = x;
            break;
        }
        case WM_MOUSELEAVE: cursor_ = -1; break;
        case WM_LBUTTONDOWN:
            SetFocus(window_);
            SetCapture(window_);
            drag_ = x;
            break;
        case WM_LBUTTONUP:
            ReleaseCapture();
            if (drag_ >= 0 && abs(x - drag_) > 4)
                zoom({x_at(min(x, drag_)), x_at(max(x, drag_))});
            drag_ = -1;
            break;
        case WM_LBUTTONDBLCLK:
        case WM_RBUTTONUP:
            drag_ = -1;
            diagram_.zoomed = {0, 0};
            break;
        case WM_MOUSEWHEEL: {
            POINT at = {x, (short)HIWORD(lparam)};
            ScreenToClient(window_, &at);
            Range all = diagram_.seen_x();
            double middle = x_at(at.x), factor = (short)HIWORD(wparam) > 0 ? 0.7 : 1 / 0.7;
            zoom({middle + (all.low - middle) * factor, middle + (all.high - middle) * factor});
            break;
        }
        default: return DefSubclassProc(window_, message, wparam, lparam);
        }
        InvalidateRect(window_, NULL, FALSE);
        return 0;
    }

    RECT area() const {
        RECT area;
        GetClientRect(window_, &area);
        return area;
    }

    double x_at(int pixel) const { return diagram_.x_at(pixel, area()); }

    void paint() const {
        PAINTSTRUCT paint;
        RECT all = area(), band = {min(drag_, cursor_), 0, max(drag_, cursor_), all.bottom};
        HDC dc = BeginPaint(window_, &paint);
        HBITMAP bitmap = picture(all.right, all.bottom, cursor_);
        DrawStateW(dc, NULL, NULL, (LPARAM)bitmap, 0, 0, 0, 0, 0, DST_BITMAP);
        if (drag_ >= 0)
            InvertRect(dc, &band);
        DeleteObject(bitmap);
        EndPaint(window_, &paint);
    }

    /* Zooms to at least 1e-6 of the whole range and at most the whole range. */
    void zoom(Range x) {
        Range all = diagram_.whole_x();
        x = {max(x.low, all.low), min(x.high, all.high)};
        if (x.high - x.low > 1e-6 * (all.high - all.low))
            diagram_.zoomed = x.low > all.low || x.high < all.high ? x : Range{0, 0};
    }

    /* A picture of the diagram at a given size. The caller deletes it. */
    HBITMAP picture(int width, int height, int cursor) const {
        HDC screen = GetDC(NULL), memory = CreateCompatibleDC(screen);
        HBITMAP bitmap = CreateCompatibleBitmap(screen, max(1, width), max(1, height));
        HGDIOBJ before = SelectObject(memory, bitmap);
        diagram_.draw(memory, {0, 0, width, height}, cursor);
        SelectObject(memory, before);
        DeleteDC(memory);
        ReleaseDC(NULL, screen);
        return bitmap;
    }

    HWND window_ = NULL;
    Diagram diagram_;
    int cursor_ = -1, drag_ = -1; /* pixels */
};
