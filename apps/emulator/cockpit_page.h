/* The cockpit: the aircraft is flown by arrow keys or a joystick in real time, beside attitude indicators of truth and INS, the panel of
 * the INS and its errors. */
#pragma once
#include "document.h"
#include "instruments.h"

#include <mmsystem.h>

class CockpitPage : public Page {
public:
    using Page::Page;
    ~CockpitPage() { RemoveWindowSubclass(screen_, procedure, 0); }

    void refresh(bool) override { show(); }

protected:
    void on_init() override {
        plot_.attach(item(IDC_ERRORS));
        fill(item(IDC_SPEEDUP), parts("speedups"));
        fill(item(IDC_POWER), parts("powers"));
        fill(item(IDC_CHANNEL), parts("channels"));
        screen_ = item(IDC_COCKPIT);
        SetWindowSubclass(screen_, procedure, 0, (DWORD_PTR)this);
        SetTimer(window_, 1, 33, NULL);
        tip(screen_, text("cockpit_tip"));
        show();
    }

    void on_command(int id, int code) override {
        if (code != BN_CLICKED && code != CBN_SELCHANGE)
            return;
        if (id == IDC_TAKE_OFF)
            start();
        else if (id == IDC_LEAVE)
            cockpit_.reset();
        else if (id >= IDC_MODE && id <= IDC_ENTER_HEADING && cockpit_)
            at_panel(id);
        show();
        SetFocus(screen_); /* the arrow keys belong to the stick again */
    }

    bool on_message(UINT message, WPARAM, LPARAM) override {
        if (message != WM_TIMER)
            return false;
        if (cockpit_) {
            fly();
            show();
        }
        return true;
    }

    void on_refusal(const std::wstring &sentence) override { document_.say_line(sentence); }

private:
    void start() {
        cockpit_.emplace(scene_, document_.folder());
        before_ms_ = GetTickCount64();
        due_s_ = 0;
        held_.clear();
        joystick_ms_ = 0;
        choose(IDC_POWER, 0);
        document_.say_line(L"");
    }

    void at_panel(int id) {
        sins::Unit &unit = cockpit_->unit();
        auto number = [this](int field) {
            double value;
            if (!number_of(narrow(get(field)), value))
                throw Refusal(text("not_a_number", {parts("entries")[field - IDC_LATITUDE], get(field)}));
            return value * SINS_DEG;
        };
        if (id < IDC_MODE + 4)
            unit.select(id - IDC_MODE); /* the buttons are in the order of enum sins_unit_mode */
        else if (id == IDC_POWER)
            unit.set_power(chosen(IDC_POWER));
        else if (id == IDC_TEST)
            unit.press_test();
        else if (id == IDC_ENTER_TRUE)
            unit.enter_position(cockpit_->truth().latitude_rad, cockpit_->truth().longitude_rad);
        else if (id == IDC_ENTER_POSITION) {
            double latitude_rad = number(IDC_LATITUDE);
            unit.enter_position(latitude_rad, number(IDC_LONGITUDE));
        } else if (id == IDC_ENTER_HEADING)
            unit.enter_heading(number(IDC_HEADING_ENTERED));
        document_.say_line(L"");
    }

    /* Flies the time since the last call, at most half a second: longer, the window was held. */
    void fly() {
        static constexpr double SPEEDUPS[] = {1, 10, 60}; /* in the order of the text "speedups" */
        ULONGLONG now_ms = GetTickCount64();
        double passed_s = min((double)(now_ms - before_ms_) / 1000, 0.5);
        before_ms_ = now_ms;
        steer(passed_s);
        due_s_ += passed_s * SPEEDUPS[chosen(IDC_SPEEDUP)];
        try {
            for (; due_s_ >= cockpit_->step_s; due_s_ -= cockpit_->step_s)
                cockpit_->step();
        } catch (const std::exception &error) {
            std::wstring sentence = shown(cockpit_->time_s(), 8) + L" s: " + told(error);
            cockpit_.reset();
            throw Refusal(sentence);
        }
    }

    /* Reads the held keys, and a joystick that is deflected. */
    void steer(double passed_s) {
        Stick &stick = cockpit_->stick;
        auto held = [this](WPARAM key) { return held_.count(key) != 0 ? 1.0 : 0.0; };
        stick.roll = held(VK_RIGHT) - held(VK_LEFT);
        stick.pitch = held(VK_DOWN) - held(VK_UP); /* pulled towards the pilot: up */
        stick.throttle = std::clamp(stick.throttle + 0.2 * passed_s * (held(VK_PRIOR) - held(VK_NEXT)), 0.0, 1.0);
        JOYINFOEX joystick = {.dwSize = sizeof joystick, .dwFlags = JOY_RETURNX | JOY_RETURNY | JOY_RETURNZ};
        if (before_ms_ < joystick_ms_) /* without one, the call takes time */
            return;
        if (joyGetPosEx(JOYSTICKID1, &joystick) != JOYERR_NOERROR) {
            joystick_ms_ = before_ms_ + 3000;
            return;
        }
        auto axis = [](DWORD position) {
            double value = ((double)position - 32767.5) / 32767.5;
            return std::fabs(value) < 0.08 ? 0.0 : value;
        };
        if (axis(joystick.dwXpos) != 0 || axis(joystick.dwYpos) != 0) {
            stick.roll = axis(joystick.dwXpos);
            stick.pitch = axis(joystick.dwYpos);
        }
        if (std::abs((int)joystick.dwZpos - lever_) > 600) {
            stick.throttle = lever_ < 0 ? stick.throttle : 1 - (double)joystick.dwZpos / 65535; /* forward is 0 */
            lever_ = (int)joystick.dwZpos;
        }
    }

    void show() {
        for (int id : {IDC_LEAVE, IDC_POWER, IDC_TEST, IDC_ENTER_TRUE, IDC_ENTER_POSITION, IDC_ENTER_HEADING})
            enable(id, cockpit_.has_value());
        for (int mode = 0; mode < 4; mode++)
            enable(IDC_MODE + mode, cockpit_.has_value());
        static const struct {
            Channel channel;
            Quantity quantity;
            const char *axes;
        } VIEWS[] = {{POSITION_ERROR, LENGTH, "axes_enu"}, {VELOCITY_ERROR, SPEED, "axes_enu"}, {ATTITUDE_ERROR, ANGLE, "axes_rph"}};
        const auto &view = VIEWS[chosen(IDC_CHANNEL)];
        const Curves curves = cockpit_ ? cockpit_->curves : Curves();
        std::vector<::Panel> panels;
        for (int k = 0; k < 3; k++)
            panels.push_back({parts(view.axes)[k], view.quantity, curves.cells[TIME],
                              {{L"", RGB(0, 70, 160), false, curves.cells[view.channel + k]}}});
        plot_.show(panels, DURATION, false);
        instruments();
        InvalidateRect(screen_, NULL, FALSE);
    }

    void instruments() {
        const COLORREF AMBER = RGB(255, 190, 60), GREEN = RGB(90, 220, 110), RED = RGB(240, 70, 60);
        sins_flight_sample truth = cockpit_ ? cockpit_->truth() : sins::make<sins_flight_sample>();
        sins_unit_status status = cockpit_ ? cockpit_->status() : sins::make<sins_unit_status>();
        sins_unit_navigation shown = cockpit_ ? cockpit_->shown() : sins::make<sins_unit_navigation>();
        auto valid = [&](uint32_t flag) { return (shown.validity & flag) != 0; };
        auto lit = [&](uint32_t flag) { return (status.annunciators & flag) != 0; };
        Texts titles = parts("indicators");
        instruments_.attitudes = {{titles[0], truth.roll_rad, truth.pitch_rad, truth.heading_rad, cockpit_.has_value(), true},
                                  {titles[1], shown.roll_rad, shown.pitch_rad, shown.heading_rad, valid(SINS_UNIT_VALID_ATTITUDE),
                                   valid(SINS_UNIT_VALID_HEADING)}};
        bool is_flashing = lit(SINS_UNIT_ALIGN_FLASHES) && GetTickCount64() % 1000 < 500;
        instruments_.panel.lamps = {L"ALIGN", L"NAV RDY", L"FAULT", L"ON BATT"};
        instruments_.panel.inks = {AMBER, GREEN, RED, AMBER};
        instruments_.panel.is_lit = {lit(SINS_UNIT_ALIGN_LIT) && !is_flashing, lit(SINS_UNIT_NAV_READY), lit(SINS_UNIT_FAULT),
                                     lit(SINS_UNIT_ON_BATTERY)};
        auto angle = [](double rad, const wchar_t *letters, int width) {
            WCHAR text[32];
            double minutes = std::fabs(rad) / SINS_DEG * 60;
            swprintf(text, 32, L"%c%0*d\u00b0%04.1f", letters[rad < 0], width, (int)(minutes / 60), std::fmod(minutes, 60));
            return std::wstring(text);
        };
        const double *v = shown.velocity_enu_m_s, speed = std::hypot(v[0], v[1]), track = std::atan2(v[0], v[1]) / SINS_DEG;
        WCHAR motion[64] = L"GS ---  TK ---";
        if (valid(SINS_UNIT_VALID_VELOCITY))
            swprintf(motion, 64, speed < 50 * SINS_KNOT ? L"GS %.0f  TK ---" : L"GS %.0f  TK %03.0f\u00b0", speed / SINS_KNOT,
                     track < 0 ? track + 360 : track);
        std::wstring place = L"--- ---";
        if (valid(SINS_UNIT_VALID_POSITION))
            place = angle(shown.latitude_rad, L"NS", 2) + L" " + angle(shown.longitude_rad, L"EW", 3);
        instruments_.panel.displays = {place, motion};
        std::wstring state = parts("unit_states")[status.state];
        if (status.minutes_to_go > 0)
            state += L", " + std::to_wstring(status.minutes_to_go) + L" min";
        Texts reasons = parts("unit_reasons");
        for (size_t k = 0; k < reasons.size(); k++)
            if ((status.reasons >> k & 1) != 0)
                state += L"; " + reasons[k];
        WCHAR flown[160] = L"";
        if (cockpit_)
            swprintf(flown, 160, L"%.0f s, %.0f kt, %.0f m, %.0f %%; %.1f m", cockpit_->time_s(), cockpit_->speed_m_s() / SINS_KNOT,
                     truth.height_m, 100 * cockpit_->stick.throttle,
                     std::hypot(cockpit_->errors.position_enu_m[0], cockpit_->errors.position_enu_m[1]));
        set(IDC_UNIT_STATE, cockpit_ ? state + L"\n" + flown : text("not_flown_by_hand"));
    }

    static LRESULT CALLBACK procedure(HWND window, UINT message, WPARAM wparam, LPARAM lparam, UINT_PTR, DWORD_PTR page) {
        CockpitPage &own = *(CockpitPage *)page;
        switch (message) {
        case WM_GETDLGCODE: return DLGC_WANTARROWS;
        case WM_ERASEBKGND: return 1;
        case WM_PAINT: own.paint(); return 0;
        case WM_LBUTTONDOWN: SetFocus(window); return 0;
        case WM_KEYDOWN: own.held_.insert(wparam); return 0;
        case WM_KEYUP: own.held_.erase(wparam); return 0;
        case WM_KILLFOCUS: own.held_.clear(); break;
        }
        return DefSubclassProc(window, message, wparam, lparam);
    }

    void paint() const {
        PAINTSTRUCT paint;
        RECT area;
        GetClientRect(screen_, &area);
        HDC dc = BeginPaint(screen_, &paint), memory = CreateCompatibleDC(dc);
        HBITMAP bitmap = CreateCompatibleBitmap(dc, max(1L, area.right), max(1L, area.bottom));
        HGDIOBJ before = SelectObject(memory, bitmap);
        instruments_.draw(memory, area);
        BitBlt(dc, 0, 0, area.right, area.bottom, memory, 0, 0, SRCCOPY);
        SelectObject(memory, before);
        DeleteObject(bitmap);
        DeleteDC(memory);
        EndPaint(screen_, &paint);
    }

    std::optional<Cockpit> cockpit_;
    Instruments instruments_;
    Plot plot_;
    HWND screen_ = NULL;
    std::set<WPARAM> held_;                   /* keys */
    ULONGLONG before_ms_ = 0, joystick_ms_ = 0; /* of the last flight; before it, no joystick is looked for */
    double due_s_ = 0;
    int lever_ = -1; /* position of the joystick's throttle; -1: not yet seen */
};
