/* Instruments of a cockpit: attitude indicators, lamps and displays of the panel. */
#pragma once
#include "cockpit.h"
#include "system.h"

class Instruments {
public:
    /* What the panel of the box has to say. */
    struct Panel {
        Texts lamps;                 /* names of the annunciators; a lamp is lit if its flag is set */
        std::vector<COLORREF> inks;  /* their colours when they are lit */
        std::vector<bool> is_lit;
        Texts displays;              /* lines of the two displays */
    };

    struct Attitude {
        std::wstring title;
        double roll_rad, pitch_rad, heading_rad;
        bool is_valid, has_heading;
    };

    Panel panel;
    std::vector<Attitude> attitudes;

    void draw(HDC dc, RECT area) const {
        static HFONT font = CreateFontW(-scaled(12), 0, 0, 0, FW_BOLD, 0, 0, 0, DEFAULT_CHARSET, 0, 0, CLEARTYPE_QUALITY, 0,
                                        L"MS Shell Dlg 2");
        HGDIOBJ before = SelectObject(dc, font);
        SelectObject(dc, GetStockObject(DC_BRUSH));
        SelectObject(dc, GetStockObject(DC_PEN));
        SetBkMode(dc, TRANSPARENT);
        fill(dc, area, RGB(52, 56, 60));
        const int third = (area.right - area.left) / 3;
        for (size_t k = 0; k < attitudes.size(); k++)
            draw_attitude(dc, {area.left + (int)k * third, area.top, area.left + (int)(k + 1) * third, area.bottom}, attitudes[k]);
        draw_panel(dc, {area.left + 2 * third, area.top, area.right, area.bottom});
        SelectObject(dc, before);
    }

private:
    static constexpr COLORREF WHITE = RGB(240, 240, 240), AMBER = RGB(255, 190, 60), BLACK = RGB(14, 14, 14);

    static void fill(HDC dc, RECT area, COLORREF color) {
        SetDCBrushColor(dc, color);
        FillRect(dc, &area, (HBRUSH)GetStockObject(DC_BRUSH));
    }

    static void write(HDC dc, RECT area, const std::wstring &text, COLORREF color) {
        SetTextColor(dc, color);
        DrawTextW(dc, text.c_str(), -1, &area, DT_CENTER | DT_VCENTER | DT_SINGLELINE | DT_NOPREFIX);
    }

    static std::wstring degrees(double angle_rad) {
        int whole = (int)std::lround(angle_rad / SINS_DEG) % 360;
        WCHAR text[16];
        swprintf(text, 16, L"%03d\u00b0", whole < 0 ? whole + 360 : whole);
        return text;
    }

    /* A ball with horizon and ladder; up on it is up on the screen at roll 0. */
    static void draw_attitude(HDC dc, RECT area, const Attitude &attitude) {
        const int line = scaled(18), width = area.right - area.left, middle = (area.left + area.right) / 2;
        const int radius = max(min(width / 2, (int)(area.bottom - area.top) / 2 - line) - scaled(6), 4);
        const int center = (area.top + area.bottom) / 2;
        write(dc, {area.left, area.top, area.right, area.top + line}, attitude.title, WHITE);
        std::wstring below = attitude.is_valid && attitude.has_heading ? degrees(attitude.heading_rad) : L"---";
        write(dc, {area.left, area.bottom - line, area.right, area.bottom}, below, WHITE);
        RECT box = {middle - radius, center - radius, middle + radius, center + radius};
        if (!attitude.is_valid) {
            SetDCBrushColor(dc, BLACK);
            Ellipse(dc, box.left, box.top, box.right, box.bottom);
            write(dc, box, L"ATT", RGB(230, 60, 50));
            return;
        }
        const double sin = std::sin(attitude.roll_rad), cos = std::cos(attitude.roll_rad), by = radius / (35 * SINS_DEG);
        /* A point to the right of the ball's middle and above the horizon, in the ball's own axes. */
        auto at = [&](double right, double above) -> POINT {
            double down = attitude.pitch_rad * by - above;
            return {middle + (LONG)std::lround(right * cos + down * sin), center + (LONG)std::lround(down * cos - right * sin)};
        };
        const double far_off = 20.0 * radius;
        HRGN round = CreateEllipticRgnIndirect(&box);
        SelectClipRgn(dc, round);
        fill(dc, box, RGB(70, 140, 220));
        POINT ground[] = {at(-far_off, 0), at(far_off, 0), at(far_off, -far_off), at(-far_off, -far_off)};
        SetDCBrushColor(dc, RGB(140, 95, 50));
        SetDCPenColor(dc, WHITE);
        Polygon(dc, ground, 4);
        for (int step = -8; step <= 8; step++) {
            double half = step % 2 == 0 ? radius * 0.3 : radius * 0.15;
            POINT rung[] = {at(-half, step * 5 * SINS_DEG * by), at(half, step * 5 * SINS_DEG * by)};
            Polyline(dc, rung, 2);
        }
        SelectClipRgn(dc, NULL);
        DeleteObject(round);
        SetDCPenColor(dc, AMBER);
        for (int side : {-1, 1}) {
            const LONG inner = middle + side * radius / 4;
            POINT wing[] = {{middle + side * radius * 6 / 10, center}, {inner, center}, {inner, center + radius / 12}};
            Polyline(dc, wing, 3);
        }
        POINT nose[] = {{middle - 3, center}, {middle + 4, center}};
        Polyline(dc, nose, 2);
    }

    void draw_panel(HDC dc, RECT area) const {
        const int line = scaled(20), gap = scaled(4), left = area.left + gap, right = area.right - gap;
        int top = area.top + gap;
        for (size_t k = 0; k < panel.lamps.size(); k++) {
            int half = (right - left) / 2, x = left + (int)(k % 2) * half;
            RECT lamp = {x, top, x + half - gap, top + line};
            fill(dc, lamp, panel.is_lit[k] ? panel.inks[k] : BLACK);
            write(dc, lamp, panel.lamps[k], panel.is_lit[k] ? BLACK : RGB(110, 110, 110));
            top += k % 2 == 1 ? line + gap : 0;
        }
        for (const std::wstring &text : panel.displays) {
            RECT display = {left, top, right - gap, top + line};
            fill(dc, display, BLACK);
            write(dc, display, text, AMBER);
            top += line + 1;
        }
    }
};
