/* The drawing of a plot: scales, axes, curves, legends. */
#include <algorithm>
#include <cmath>

#include "dialog.h"
#include "plot.h"

static const COLORREF FRAME = RGB(150, 150, 150), GRID = RGB(228, 228, 228), INK = RGB(60, 60, 60);
/* Decades of a logarithmic axis at the most. */
static const double DECADES = 8;
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

Unit unit_for(Quantity quantity, double size)
{
    const std::vector<Unit> &units = UNITS[quantity];
    size_t k = units.size() - 1;
    while (k > 0 && size < 2 * units[k].si) {
        k--;
    }
    return units[k];
}

Plot::Range Plot::whole_x() const
{
    Range range = {INFINITY, -INFINITY};
    for (const Panel &panel : panels_) {
        for (double x : panel.x) {
            range = {std::min(range.low, x), std::max(range.high, x)};
        }
    }
    range = range.low <= range.high ? range : Range{0, 1};
    range.low = x_quantity_ == DURATION ? std::min(range.low, 0.0) : range.low;
    return range.high > range.low ? range : Range{range.low - 1e-9, range.high + 1e-9};
}

Plot::Range Plot::seen_y(const Panel &panel, Range x) const
{
    Range range = {INFINITY, -INFINITY};
    for (const Trace &trace : panel.traces) {
        for (size_t k = 0; k < trace.cells.size(); k++) {
            if (panel.x[k] >= x.low && panel.x[k] <= x.high) {
                Cell cell = trace.cells[k];
                if (is_logarithmic_) {
                    cell.high = std::max(std::fabs(cell.low), std::fabs(cell.high));
                    cell.low = std::fabs(cell.last);
                    cell.low = cell.low > 0 ? cell.low : cell.high;
                }
                if (!is_logarithmic_ || cell.high > 0) {
                    range = {std::min(range.low, cell.low), std::max(range.high, cell.high)};
                }
            }
        }
    }
    if (is_logarithmic_) {
        range = range.low <= range.high ? Range{std::log10(range.low), std::log10(range.high)} : Range{-1, 0};
        range = {std::max(std::floor(range.low), std::ceil(range.high) - DECADES), std::ceil(range.high)};
        return range.low < range.high ? range : Range{range.low - 1, range.high};
    }
    range = range.low <= range.high ? range : Range{-1, 1};
    double span = range.high - range.low,
           margin = span > 0 ? 0.06 * span : std::max(1e-12, 0.1 * std::fabs(range.high));
    return {range.low - margin, range.high + margin};
}

double Plot::Scale::y_of(double value) const
{
    double place = is_logarithmic ? std::log10(std::max(std::fabs(value), 1e-300)) : value;
    double share = (std::max(place, is_logarithmic ? y.low : place) - y.low) / (y.high - y.low);
    return box.bottom - share * (box.bottom - box.top);
}

/* The places of axes and curves; the map has one scale for both directions. */
Plot::Scale Plot::scale(size_t panel, RECT area) const
{
    Scale scale = {{}, zoomed_.high > zoomed_.low ? zoomed_ : whole_x(), {}, is_logarithmic_};
    int line = scaled(15), count = std::max(1, (int)panels_.size());
    int height = (int)(area.bottom - area.top - 2 * line) / count, top = (int)area.top + (int)panel * height;
    scale.box = {area.left + scaled(58), top + line + 2, area.right - scaled(10), top + height - line / 2};
    scale.y = seen_y(panels_[panel], scale.x);
    if (x_quantity_ == DEGREES) {
        double middle = (scale.y.low + scale.y.high) / 2, center = (scale.x.low + scale.x.high) / 2;
        double width = scale.box.right - scale.box.left, tall = scale.box.bottom - scale.box.top;
        double east = std::max(0.02, std::cos(middle));
        double step =
            std::max((scale.x.high - scale.x.low) * 1.1 * east / width, (scale.y.high - scale.y.low) / tall);
        scale.x = {center - step * width / east / 2, center + step * width / east / 2};
        scale.y = {middle - step * tall / 2, middle + step * tall / 2};
    }
    return scale;
}

/* 1, 2 or 5 times a power of ten, so that there are about so many steps. */
static double nice_step(double span, double count)
{
    double raw = span / std::max(1.0, count), power = std::pow(10, std::floor(std::log10(raw)));
    return power * (raw > 5 * power ? 10 : raw > 2 * power ? 5 : raw > power ? 2 : 1);
}

static void line(HDC dc, double x0, double y0, double x1, double y1)
{
    MoveToEx(dc, (int)x0, (int)y0, NULL);
    LineTo(dc, (int)x1, (int)y1);
}

static void write(HDC dc, int x, int y, UINT align, COLORREF color, const std::wstring &text)
{
    SetTextAlign(dc, align);
    SetTextColor(dc, color);
    TextOutW(dc, x, y, text.c_str(), (int)text.size());
}

/* Where an axis has ticks, in its unit: from the first in the range on. */
static std::vector<double> ticks(double low, double high, double step)
{
    std::vector<double> result;
    for (double tick = std::ceil(low / step); tick * step <= high * (1 + 1e-12 * (high > 0)); tick++) {
        result.push_back(tick * step + 0.0); /* no -0 */
    }
    return result;
}

void Plot::draw_axes(HDC dc, const Scale &scale, const Panel &panel, bool is_last) const
{
    const RECT &box = scale.box;
    Unit x_unit = unit_for(x_quantity_, std::max(std::fabs(scale.x.low), std::fabs(scale.x.high)));
    Unit y_unit = unit_for(panel.quantity, std::max(std::fabs(scale.y.low), std::fabs(scale.y.high)));
    SelectObject(dc, GetStockObject(DC_PEN));
    double low = scale.x.low / x_unit.si, high = scale.x.high / x_unit.si;
    for (double tick : ticks(low, high, nice_step(high - low, (box.right - box.left) / scaled(80)))) {
        double x = scale.x_of(tick * x_unit.si);
        SetDCPenColor(dc, GRID);
        line(dc, x, box.top, x, box.bottom);
        if (is_last) {
            write(dc, (int)x, box.bottom + 2, TA_CENTER, INK, shown(tick, 7));
        }
    }
    low = scale.y.low / y_unit.si;
    high = scale.y.high / y_unit.si;
    double step = nice_step(high - low, (box.bottom - box.top) / scaled(26));
    if (is_logarithmic_) { /* decades, in one unit whatever the size */
        bool is_first =
            panel.quantity == ANGLE || panel.quantity == ANGULAR_RATE || panel.quantity == DEGREES;
        y_unit = UNITS[panel.quantity][is_first ? 0 : 1];
        low = scale.y.low - std::log10(y_unit.si);
        high = scale.y.high - std::log10(y_unit.si);
        step = std::max(1.0, std::ceil((high - low) * scaled(16) / (box.bottom - box.top)));
    }
    for (double tick : ticks(low, high, step)) {
        double value = is_logarithmic_ ? std::pow(10, tick) : tick, y = scale.y_of(value * y_unit.si);
        SetDCPenColor(dc, value == 0 ? FRAME : GRID);
        line(dc, box.left, y, box.right, y);
        write(dc, box.left - 4, (int)y - scaled(7), TA_RIGHT, INK, shown(value, 6));
    }
    SetDCPenColor(dc, FRAME);
    SelectObject(dc, GetStockObject(NULL_BRUSH));
    Rectangle(dc, box.left, box.top, box.right, box.bottom);
    if (is_last) {
        std::wstring title = x_quantity_ == DURATION ? text("time") : label("plot.longitude", "longitude");
        write(dc, box.right, box.bottom + 2 + scaled(12), TA_RIGHT, INK, title + L" [" + x_unit.name + L"]");
    }
    draw_legend(dc, scale, panel, x_unit, y_unit);
}

/* The title with the unit, and each curve's name; with the cursor its value there. */
void Plot::draw_legend(HDC dc, const Scale &scale, const Panel &panel, Unit x_unit, Unit y_unit) const
{
    const RECT &box = scale.box;
    int x = box.left;
    auto add = [&](COLORREF color, const std::wstring &words) {
        SIZE size;
        write(dc, x, box.top - scaled(14), TA_LEFT, color, words);
        GetTextExtentPoint32W(dc, words.c_str(), (int)words.size(), &size);
        x += size.cx + scaled(14);
    };
    double share = (double)(cursor_ - box.left) / std::max(1L, box.right - box.left);
    bool has_cursor = share >= 0 && share <= 1 && !panel.x.empty() && x_quantity_ == DURATION;
    std::wstring title = panel.title + L" [" + y_unit.name + L"]";
    size_t k = 0;
    if (has_cursor) {
        double at = scale.x.low + share * (scale.x.high - scale.x.low);
        k = (size_t)(std::lower_bound(panel.x.begin(), panel.x.end() - 1, at) - panel.x.begin());
        title += L"  @ " + shown(panel.x[k] / x_unit.si, 6) + L" " + x_unit.name;
        line(dc, cursor_, box.top, cursor_, box.bottom);
    }
    add(INK, title);
    for (const Trace &trace : panel.traces) {
        bool has_value = has_cursor && k < trace.cells.size();
        add(trace.color, trace.name + (has_value ? L" " + shown(trace.cells[k].last / y_unit.si, 5) : L""));
    }
}

void Plot::draw_trace(HDC dc, const Scale &scale, const Panel &panel, const Trace &trace) const
{
    std::vector<POINT> points;
    double reach = 30000; /* pixels of GDI */
    for (size_t k = 0; k < trace.cells.size() && k < panel.x.size(); k++) {
        const Cell &cell = trace.cells[k];
        double x = std::clamp(scale.x_of(panel.x[k]), -reach, reach);
        for (double value : {cell.low, cell.high, cell.last}) {
            if (x_quantity_ == DURATION || value == cell.last) { /* a map has one point a cell */
                points.push_back({(LONG)x, (LONG)std::clamp(scale.y_of(value), -reach, reach)});
            }
        }
    }
    if (points.size() < 2) {
        return;
    }
    HPEN pen = CreatePen(PS_SOLID, scaled(trace.is_wide ? 3 : 1), trace.color);
    HGDIOBJ before = SelectObject(dc, pen);
    Polyline(dc, points.data(), (int)points.size());
    SelectObject(dc, before);
    DeleteObject(pen);
}

void Plot::draw(HDC dc, RECT area) const
{
    static HFONT font = CreateFontW(-scaled(11), 0, 0, 0, FW_NORMAL, 0, 0, 0, DEFAULT_CHARSET, 0, 0,
                                    CLEARTYPE_QUALITY, 0, L"MS Shell Dlg 2");
    HGDIOBJ before = SelectObject(dc, font);
    FillRect(dc, &area, GetSysColorBrush(COLOR_WINDOW));
    SetBkMode(dc, TRANSPARENT);
    for (size_t k = 0; k < panels_.size(); k++) {
        Scale own = scale(k, area);
        draw_axes(dc, own, panels_[k], k + 1 == panels_.size());
        HRGN inside = CreateRectRgn(own.box.left, own.box.top, own.box.right, own.box.bottom);
        SelectClipRgn(dc, inside);
        for (const Trace &trace : panels_[k].traces) {
            draw_trace(dc, own, panels_[k], trace);
        }
        SelectClipRgn(dc, NULL);
        DeleteObject(inside);
    }
    if (drag_ >= 0) {
        RECT band = {std::min(drag_, cursor_), area.top, std::max(drag_, cursor_), area.bottom};
        InvertRect(dc, &band);
    }
    SelectObject(dc, before);
}
