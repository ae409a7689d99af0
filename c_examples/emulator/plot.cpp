#include "plot.h"

#include <objidl.h>

#include <gdiplus.h>

#include <algorithm>

#include "dialog.h"

void Plot::register_class()
{
    WNDCLASSW plot = {};
    plot.style = CS_DBLCLKS | CS_HREDRAW | CS_VREDRAW;
    plot.lpfnWndProc = procedure;
    plot.hCursor = LoadCursorW(NULL, (LPCWSTR)IDC_CROSS);
    plot.lpszClassName = L"SinsPlot";
    RegisterClassW(&plot);
}

void Plot::attach(HWND control)
{
    window_ = control;
    SetWindowLongPtrW(control, GWLP_USERDATA, (LONG_PTR)this);
}

LRESULT CALLBACK Plot::procedure(HWND window, UINT message, WPARAM wparam, LPARAM lparam)
{
    Plot *plot = (Plot *)GetWindowLongPtrW(window, GWLP_USERDATA);
    return plot == NULL || message == WM_DESTROY ? DefWindowProcW(window, message, wparam, lparam)
                                                 : plot->handle(message, wparam, lparam);
}

LRESULT Plot::handle(UINT message, WPARAM wparam, LPARAM lparam)
{
    int x = (short)LOWORD(lparam);
    switch (message) {
    case WM_ERASEBKGND: return 1;
    case WM_PAINT: {
        PAINTSTRUCT paint;
        RECT area;
        HDC dc = BeginPaint(window_, &paint), memory = CreateCompatibleDC(dc);
        GetClientRect(window_, &area);
        HBITMAP bitmap = picture(area.right, area.bottom);
        SelectObject(memory, bitmap);
        BitBlt(dc, 0, 0, area.right, area.bottom, memory, 0, 0, SRCCOPY);
        DeleteDC(memory);
        DeleteObject(bitmap);
        EndPaint(window_, &paint);
        return 0;
    }
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
        if (drag_ >= 0 && abs(x - drag_) > 4) {
            zoom({x_at(std::min(x, drag_)), x_at(std::max(x, drag_))});
        }
        drag_ = -1;
        break;
    case WM_LBUTTONDBLCLK:
    case WM_RBUTTONUP:
        drag_ = -1;
        zoomed_ = {0, 0};
        break;
    case WM_MOUSEWHEEL: {
        POINT at = {x, (short)HIWORD(lparam)};
        ScreenToClient(window_, &at);
        Range all = zoomed_.high > zoomed_.low ? zoomed_ : whole_x();
        double middle = x_at(at.x), factor = (short)HIWORD(wparam) > 0 ? 0.7 : 1 / 0.7;
        zoom({middle + (all.low - middle) * factor, middle + (all.high - middle) * factor});
        break;
    }
    default: return DefWindowProcW(window_, message, wparam, lparam);
    }
    InvalidateRect(window_, NULL, FALSE);
    return 0;
}

void Plot::show(std::vector<Panel> panels, Quantity x_quantity, bool is_logarithmic)
{
    if (x_quantity != x_quantity_) {
        zoomed_ = {0, 0};
    }
    panels_ = std::move(panels);
    x_quantity_ = x_quantity;
    is_logarithmic_ = is_logarithmic && x_quantity == DURATION;
    InvalidateRect(window_, NULL, FALSE);
}

double Plot::x_at(int pixel) const
{
    RECT area;
    GetClientRect(window_, &area);
    if (panels_.empty()) {
        return 0;
    }
    Scale first = scale(0, area);
    double share = (double)(pixel - first.box.left) / std::max(1L, first.box.right - first.box.left);
    return first.x.low + share * (first.x.high - first.x.low);
}

/* No closer than 1e-6 of all, and no farther than all. */
void Plot::zoom(Range x)
{
    Range all = whole_x();
    x = {std::max(x.low, all.low), std::min(x.high, all.high)};
    if (x.high - x.low > 1e-6 * (all.high - all.low)) {
        zoomed_ = x.low > all.low || x.high < all.high ? x : Range{0, 0};
    }
}

HBITMAP Plot::picture(int width, int height) const
{
    HDC screen = GetDC(NULL), memory = CreateCompatibleDC(screen);
    HBITMAP bitmap = CreateCompatibleBitmap(screen, std::max(1, width), std::max(1, height));
    HGDIOBJ before = SelectObject(memory, bitmap);
    draw(memory, {0, 0, width, height});
    SelectObject(memory, before);
    DeleteDC(memory);
    ReleaseDC(NULL, screen);
    return bitmap;
}

void Plot::save(const fs::path &path) const
{
    static const CLSID PNG = {0x557cf406, 0x1a04, 0x11d3, {0x9a, 0x73, 0x00, 0x00, 0xf8, 0x1e, 0xf3, 0x2e}};
    ULONG_PTR token = 0;
    Gdiplus::GdiplusStartupInput input;
    Gdiplus::GdiplusStartup(&token, &input, NULL);
    cursor_ = -1;
    HBITMAP bitmap = picture(scaled(1000), scaled(700));
    auto write = [bitmap](const fs::path &to) {
        return Gdiplus::Bitmap(bitmap, (HPALETTE)NULL).Save(to.c_str(), &PNG, NULL) == Gdiplus::Ok;
    };
    write_file(path, write);
    DeleteObject(bitmap);
    Gdiplus::GdiplusShutdown(token);
}

bool Plot::copy() const
{
    cursor_ = -1;
    HBITMAP bitmap = picture(scaled(1000), scaled(700));
    bool done = OpenClipboard(window_) && EmptyClipboard() && SetClipboardData(CF_BITMAP, bitmap) != NULL;
    CloseClipboard();
    if (!done) { /* else it is the clipboard's */
        DeleteObject(bitmap);
    }
    return done;
}
