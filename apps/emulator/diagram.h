/* A diagram: panels one above the other, with scales, axes, curves and legends. */
#pragma once
#include "curves.h"
#include "dialog.h"

/* A unit and its size in the SI unit. */
struct Unit {
    const wchar_t *name;
    double si;
};

/* Quantity of an axis. */
enum Quantity { LENGTH, SPEED, ANGLE, ANGULAR_RATE, ACCELERATION, DEGREES, DURATION };
static const double DEG = 3.14159265358979323846 / 180;
static const std::vector<Unit> UNITS[] = {
    {{L"mm", 1e-3}, {L"m", 1}, {L"km", 1000}},
    {{L"mm/s", 1e-3}, {L"m/s", 1}},
    {{L"\u2033", DEG / 3600}, {L"\u2032", DEG / 60}, {L"\u00b0", DEG}},
    {{L"\u00b0/h", DEG / 3600}, {L"\u00b0/s", DEG}},
    {{L"\u00b5g", 9.80665e-6}, {L"m/s\u00b2", 1}},
    {{L"\u00b0", DEG}},
    {{L"s", 1}, {L"min", 60}, {L"h", 3600}},
};
/* Smallest range of an axis of each quantity [SI]: smaller errors are rounding. */
static const double FLOORS[] = {1e-3, 1e-5, 0.01 * DEG / 3600, 1e-3 * DEG / 3600, 0.01 * 9.80665e-6, 1e-9, 0};

struct Trace {
    std::wstring name;
    COLORREF color;
    bool is_wide; /* visible below another curve */
    Cells cells;
};

struct Panel {
    std::wstring title;
    Quantity quantity;
    Cells x; /* x of a point: the last value of the cell */
    std::vector<Trace> traces;
};

struct Range {
    double low, high;
    bool has(double value) const { return value >= low && value <= high; }
    double at(double share) const { return low + share * (high - low); }
    double share_of(double value) const { return (value - low) / (high - low); }
};

class Diagram {
public:
    std::vector<Panel> panels;
    Quantity x_quantity = DURATION; /* DEGREES: a map, on which x and y have the same scale */
    bool is_logarithmic = false;
    Range zoomed = {0, 0}; /* range of x; equal ends: the whole range */

    Range whole_x() const {
        Cell all;
        for (const Panel &panel : panels)
            for (const Cell &x : panel.x)
                all.join(Cell(x.last));
        if (all.low > all.high)
            return {0, 1};
        all.low = x_quantity == DURATION ? min(all.low, 0.0) : all.low;
        return all.high > all.low ? Range{all.low, all.high} : Range{all.low - 1e-9, all.high + 1e-9};
    }

    Range seen_x() const { return zoomed.high > zoomed.low ? zoomed : whole_x(); }

    /* Draws the diagram into an area; cursor: a pixel of x, or -1 for none. */
    void draw(HDC dc, RECT area, int cursor) const {
        static HFONT font = CreateFontW(-scaled(11), 0, 0, 0, FW_NORMAL, 0, 0, 0, DEFAULT_CHARSET, 0, 0,
                                        CLEARTYPE_QUALITY, 0, L"MS Shell Dlg 2");
        HGDIOBJ before = SelectObject(dc, font);
        FillRect(dc, &area, GetSysColorBrush(COLOR_WINDOW));
        SetBkMode(dc, TRANSPARENT);
        SelectObject(dc, GetStockObject(DC_PEN));
        for (size_t k = 0; k < panels.size(); k++) {
            Scale own = scale(k, area);
            draw_axes(dc, own, panels[k], k + 1 == panels.size(), cursor);
            IntersectClipRect(dc, own.box.left, own.box.top, own.box.right, own.box.bottom);
            for (const Trace &trace : panels[k].traces)
                draw_trace(dc, own, panels[k], trace);
            SelectClipRgn(dc, NULL);
        }
        SelectObject(dc, before);
    }

    /* The value of x at a pixel. */
    double x_at(int pixel, RECT area) const {
        Scale first = scale(0, area);
        return first.x.at(first.share(pixel));
    }

    /* The largest unit that fits into a range at least twice. */
    static Unit unit_for(Quantity quantity, Range range) {
        const std::vector<Unit> &units = UNITS[quantity];
        double size = max(std::fabs(range.low), std::fabs(range.high));
        size_t k = units.size() - 1;
        while (k > 0 && size < 2 * units[k].si)
            k--;
        return units[k];
    }

private:
    static const COLORREF FRAME = RGB(150, 150, 150), GRID = RGB(228, 228, 228), INK = RGB(60, 60, 60);
    static constexpr double DECADES = 8; /* largest number of decades of a logarithmic axis */

    struct Scale { /* from values to pixels of one panel; y of a logarithmic axis is the logarithm in the unit */
        RECT box;
        Range x, y;
        Unit x_unit, y_unit;
        int x_of(double value) const { return pixel(box.left, box.right, x.share_of(value)); }
        int y_of(double value) const { return pixel(box.bottom, box.top, y.share_of(value)); }
        double share(int pixel) const { return (double)(pixel - box.left) / max(1L, box.right - box.left); }
        static int pixel(double from, double to, double share) {
            return (int)std::clamp(from + share * (to - from), -30000.0, 30000.0); /* the range that GDI can draw */
        }
    };

    /* A value on a logarithmic axis. */
    static double level(double value, Unit unit) { return std::log10(max(std::fabs(value), 1e-300) / unit.si); }

    Range range_y(const Panel &panel, Range x, Unit unit) const {
        Cell all;
        for (const Trace &trace : panel.traces) {
            for (size_t k = 0; k < trace.cells.size(); k++) {
                const Cell &cell = trace.cells[k];
                if (x.has(panel.x[k].last) && (!is_logarithmic || cell.last != 0))
                    all.join(is_logarithmic ? Cell(level(cell.last, unit)) : cell);
            }
        }
        if (all.low > all.high)
            return {-1, 1};
        double least = FLOORS[panel.quantity], span = all.high - all.low, size = std::fabs(all.high);
        double top = std::ceil(is_logarithmic ? max(all.high, level(least, unit)) : all.high);
        double margin = max(span > 1e-6 * size ? 0.06 * span : 0.1 * size, (least - span) / 2); /* ticks have 6 digits */
        return is_logarithmic ? Range{std::clamp(std::floor(all.low), top - DECADES, top - 1), top}
                              : Range{all.low - margin, all.high + margin};
    }

    /* The unit of all panels of a quantity, which are compared: that of the smallest range, if it shows the largest with five digits. */
    Unit unit_y(const Panel &panel, Range x) const {
        Unit smallest = UNITS[panel.quantity].back();
        double size = 0;
        for (const Panel &other : panels) {
            if (other.quantity == panel.quantity) {
                const Range range = range_y(other, x, smallest);
                const Unit own = unit_for(panel.quantity, range);
                smallest = own.si < smallest.si ? own : smallest;
                size = std::max({size, std::fabs(range.low), std::fabs(range.high)});
            }
        }
        for (const Unit &unit : UNITS[panel.quantity])
            if (unit.si >= smallest.si && size < 1e5 * unit.si)
                return unit;
        return UNITS[panel.quantity].back();
    }

    /* Places of axes and curves. A map has one scale for both directions. */
    Scale scale(size_t index, RECT area) const {
        static const Panel NONE = {L"", LENGTH, {}, {}};
        const Panel &panel = index < panels.size() ? panels[index] : NONE;
        const bool is_angle = panel.quantity == ANGLE || panel.quantity == ANGULAR_RATE;
        int line = scaled(15), height = (area.bottom - area.top - 2 * line) / max(1, (int)panels.size());
        int top = area.top + (int)index * height;
        Scale scale = {{area.left + scaled(58), top + line + 2, area.right - scaled(10), top + height - line / 2},
                       seen_x(), {}, {}, {}};
        scale.x_unit = unit_for(x_quantity, scale.x);
        scale.y_unit = UNITS[panel.quantity][is_logarithmic && !is_angle]; /* the same unit for any size */
        scale.y = range_y(panel, scale.x, scale.y_unit);
        if (x_quantity == DEGREES) {
            double middle = (scale.y.low + scale.y.high) / 2, center = (scale.x.low + scale.x.high) / 2;
            double width = scale.box.right - scale.box.left, tall = scale.box.bottom - scale.box.top;
            double east = max(0.02, std::cos(middle));
            double wanted = (scale.x.high - scale.x.low) * 1.1 * east / width;
            double step = max(wanted, (scale.y.high - scale.y.low) / tall);
            scale.x = {center - step * width / east / 2, center + step * width / east / 2};
            scale.y = {middle - step * tall / 2, middle + step * tall / 2};
        }
        scale.y_unit = is_logarithmic ? scale.y_unit : x_quantity == DEGREES ? unit_for(panel.quantity, scale.y) : unit_y(panel, seen_x());
        return scale;
    }

    /* The ticks of an axis: about `count` multiples of 1, 2 or 5 times a power of ten. */
    static std::vector<double> ticks(Range range, int count, double least = 0) {
        double raw = (range.high - range.low) / max(1, count), power = std::pow(10, std::floor(std::log10(raw)));
        double step = max(least, power * (raw > 5 * power ? 10 : raw > 2 * power ? 5 : raw > power ? 2 : 1));
        double end = range.high * (1 + 1e-12 * (range.high > 0));
        std::vector<double> result;
        for (double tick = std::ceil(range.low / step); tick * step <= end; tick++)
            result.push_back(tick * step + 0.0); /* no -0 */
        return result;
    }

    static void line(HDC dc, COLORREF color, int x0, int y0, int x1, int y1) {
        SetDCPenColor(dc, color);
        MoveToEx(dc, x0, y0, NULL);
        LineTo(dc, x1, y1);
    }

    /* Writes a text and returns its width. */
    static int write(HDC dc, int x, int y, UINT align, COLORREF color, const std::wstring &text) {
        SIZE size;
        SetTextAlign(dc, align);
        SetTextColor(dc, color);
        TextOutW(dc, x, y, text.c_str(), (int)text.size());
        GetTextExtentPoint32W(dc, text.c_str(), (int)text.size(), &size);
        return size.cx;
    }

    void draw_axes(HDC dc, const Scale &scale, const Panel &panel, bool is_last, int cursor) const {
        const RECT &box = scale.box;
        double unit = scale.x_unit.si;
        for (double tick : ticks({scale.x.low / unit, scale.x.high / unit}, (box.right - box.left) / scaled(80))) {
            int x = scale.x_of(tick * unit);
            line(dc, GRID, x, box.top, x, box.bottom);
            if (is_last)
                write(dc, x, box.bottom + 2, TA_CENTER, INK, shown(tick, 7));
        }
        unit = is_logarithmic ? 1 : scale.y_unit.si;
        for (double tick : ticks({scale.y.low / unit, scale.y.high / unit}, (box.bottom - box.top) / scaled(26),
                                 is_logarithmic)) {
            int y = scale.y_of(tick * unit);
            line(dc, tick == 0 && !is_logarithmic ? FRAME : GRID, box.left, y, box.right, y);
            std::wstring value = shown(is_logarithmic ? std::pow(10, tick) : tick, 6);
            write(dc, box.left - 4, y - scaled(7), TA_RIGHT, INK, value);
        }
        SetDCPenColor(dc, FRAME);
        SelectObject(dc, GetStockObject(NULL_BRUSH));
        Rectangle(dc, box.left, box.top, box.right, box.bottom);
        if (is_last) {
            std::wstring title = x_quantity == DURATION ? text("time") : label("plot.longitude", "longitude");
            title += std::wstring(L" [") + scale.x_unit.name + L"]";
            write(dc, box.right, box.bottom + 2 + scaled(12), TA_RIGHT, INK, title);
        }
        draw_legend(dc, scale, panel, cursor);
    }

    /* Draws the title with the unit, and the name of each curve, with its value at the cursor. */
    void draw_legend(HDC dc, const Scale &scale, const Panel &panel, int cursor) const {
        const RECT &box = scale.box;
        int left = box.left, top = box.top - scaled(14);
        double share = scale.share(cursor);
        bool has_cursor = share >= 0 && share <= 1 && !panel.x.empty() && x_quantity == DURATION;
        std::wstring title = panel.title + L" [" + scale.y_unit.name + L"]";
        size_t k = 0;
        if (has_cursor) {
            while (k + 1 < panel.x.size() && panel.x[k].last < scale.x.at(share))
                k++;
            title += L"  @ " + shown(panel.x[k].last / scale.x_unit.si, 6) + L" " + scale.x_unit.name;
            line(dc, FRAME, cursor, box.top, cursor, box.bottom);
        }
        left += scaled(14) + write(dc, left, top, TA_LEFT, INK, title);
        for (const Trace &trace : panel.traces) {
            std::wstring value = has_cursor ? L" " + shown(trace.cells[k].last / scale.y_unit.si, 5) : L"";
            left += scaled(14) + write(dc, left, top, TA_LEFT, trace.color, trace.name + value);
        }
    }

    void draw_trace(HDC dc, const Scale &scale, const Panel &panel, const Trace &trace) const {
        std::vector<POINT> points;
        for (size_t k = 0; k < trace.cells.size(); k++) {
            const Cell &cell = trace.cells[k];
            for (double value : {cell.low, cell.high, cell.last}) {
                double y = is_logarithmic ? level(value, scale.y_unit) : value;
                if (x_quantity == DURATION || value == cell.last) /* a map has one point for each cell */
                    points.push_back({scale.x_of(panel.x[k].last), scale.y_of(y)});
            }
        }
        HPEN pen = CreatePen(PS_SOLID, scaled(trace.is_wide ? 3 : 1), trace.color);
        HGDIOBJ before = SelectObject(dc, pen);
        Polyline(dc, points.data(), (int)points.size());
        const auto is_near = [&](const POINT &point) { return abs(point.x - points[0].x) < 2 && abs(point.y - points[0].y) < 2; };
        if (x_quantity == DEGREES && !points.empty() && std::all_of(points.begin(), points.end(), is_near)) { /* a flight at rest */
            const int size = scaled(4);
            Ellipse(dc, points[0].x - size, points[0].y - size, points[0].x + size, points[0].y + size);
        }
        SelectObject(dc, before);
        DeleteObject(pen);
    }
};
