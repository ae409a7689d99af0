/* A control that draws curves: panels one above the other, with axes, zoom and a cursor. Window class
 * "SinsPlot". */
#pragma once
#include <windows.h>

#include <string>
#include <vector>

#include "curves.h"

/* A unit and how much of the SI unit it is. */
struct Unit {
    const wchar_t *name;
    double si;
};

/* What an axis shows; the unit is the largest that the numbers fill. */
enum Quantity { LENGTH, SPEED, ANGLE, ANGULAR_RATE, ACCELERATION, DEGREES, DURATION };
Unit unit_for(Quantity quantity, double size);

struct Trace {
    std::wstring name;
    COLORREF color;
    bool is_wide; /* seen below another */
    std::vector<Cell> cells;
};

struct Panel {
    std::wstring title;
    Quantity quantity;
    std::vector<double> x;
    std::vector<Trace> traces;
};

class Plot
{
public:
    static void register_class();
    void attach(HWND control);
    /* x_quantity DEGREES: a map, on which x and y have the same scale. */
    void show(std::vector<Panel> panels, Quantity x_quantity, bool is_logarithmic);
    void draw(HDC dc, RECT area) const;
    /* The picture as it is seen, at a size of its own. The caller deletes it. */
    HBITMAP picture(int width, int height) const;
    void save(const fs::path &path) const; /* PNG */
    bool copy() const;                     /* to the clipboard */

private:
    struct Range {
        double low, high;
    };
    static double share(double value, Range range) { return (value - range.low) / (range.high - range.low); }
    struct Scale { /* from values to pixels of one panel */
        RECT box;
        Range x, y;
        bool is_logarithmic;
        double x_of(double value) const { return box.left + share(value, x) * (box.right - box.left); }
        double y_of(double value) const;
    };
    static LRESULT CALLBACK procedure(HWND, UINT, WPARAM, LPARAM);
    LRESULT handle(UINT message, WPARAM wparam, LPARAM lparam);
    Range whole_x() const;
    Range seen_y(const Panel &panel, Range x) const;
    Scale scale(size_t panel, RECT area) const;
    void draw_axes(HDC dc, const Scale &scale, const Panel &panel, bool is_last) const;
    void draw_trace(HDC dc, const Scale &scale, const Panel &panel, const Trace &trace) const;
    void draw_legend(HDC dc, const Scale &scale, const Panel &panel, Unit x_unit, Unit y_unit) const;
    double x_at(int pixel) const;
    void zoom(Range x);

    HWND window_ = NULL;
    std::vector<Panel> panels_;
    Quantity x_quantity_ = DURATION;
    bool is_logarithmic_ = false;
    Range zoomed_ = {0, 0};   /* of x; equal: all */
    mutable int cursor_ = -1; /* not in pictures */
    int drag_ = -1;
};
