/* Display of the simulation data: panel (d) of the paper's figure 2. */
#pragma once
#include "document.h"

class DisplayPage : public Page {
public:
    using Page::Page;

    void refresh(bool) override {
        enable(IDC_PACE, !document_.is_live);
        update();
    }
    double pace() const { return PACES[chosen(IDC_PACE)]; }
    const Plot &plot() const { return plot_; }

    /* Shows the flight so far. */
    void update() {
        Flight *flight = document_.flight.get();
        bool has_model = true, is_old = false;
        const bool is_under_way = flight != NULL && flight->is_under_way();
        enable(ID_PAUSE, is_under_way);
        enable(ID_STOP, is_under_way);
        enable(ID_RESET, flight != NULL);
        if (flight != NULL) {
            Flight::Status status = flight->status();
            has_model = (status.record.model_errors.flags & SINS_ERRORS_NOT_COMPUTED) == 0;
            is_old = flight->settings() != document_.flown().write();
            draw(flight->curves(), has_model, is_old);
            show_values(status, has_model, is_old);
        } else {
            rows(IDC_VALUES, {});
            set(IDC_PROGRESS, text("ready"));
            draw(Curves(), has_model, is_old);
        }
    }

protected:
    void on_init() override {
        plot_.attach(item(IDC_PLOT));
        fill(item(IDC_QUANTITY), parts("quantities"));
        fill(item(IDC_PACE), parts("paces"));
        choose(IDC_PACE, 4);
        for (int id : {IDC_DATA2, IDC_DATA1, IDC_AXIS, IDC_AXIS + 1, IDC_AXIS + 2})
            check(id, true);
        tip(item(IDC_PLOT), text("plot_tip"));
    }

    void on_command(int id, int code) override {
        if (id >= ID_EXPORT && id <= ID_BUDGET)
            document_.command(id);
        else if (id == IDC_PACE && code == CBN_SELCHANGE && document_.flight != NULL)
            document_.flight->set_pace(pace());
        else if (code == CBN_SELCHANGE || code == BN_CLICKED)
            update();
    }

private:
    static constexpr double PACES[] = {1, 10, 100, 1000, 0}; /* in the order of the text "paces"; 0: as fast as possible */

    /* The quantities of the diagram, in the order of the text "quantities". */
    struct View {
        Channel channel;
        Quantity quantity;
        const char *axes, *data; /* data: names of two curves: error data 2 and 1, or navigation and truth */
    };
    static constexpr View VIEWS[] = {
        {POSITION_ERROR, LENGTH, "axes_enu", "data"}, {VELOCITY_ERROR, SPEED, "axes_enu", "data"},
        {ATTITUDE_ERROR, ANGLE, "axes_rph", "data"},  {RATE, ANGULAR_RATE, "axes_xyz", NULL},
        {FORCE, ACCELERATION, "axes_xyz", NULL},      {ATTITUDE, ANGLE, "axes_rph", "values"},
        {VELOCITY, SPEED, "axes_enu", "values"},      {PLACE, DEGREES, "track", "values"}};

    void draw(const Curves &curves, bool has_model, bool is_old) {
        const COLORREF NEW = is_old ? RGB(120, 120, 120) : RGB(0, 70, 160), OTHER = is_old ? RGB(200, 200, 200) : RGB(255, 150, 60);
        const View &view = VIEWS[chosen(IDC_QUANTITY)];
        const bool is_map = view.channel == PLACE, has_two = view.data != NULL, is_error = view.channel < ATTITUDE;
        const bool has_below = has_two && checked(IDC_DATA1) && (has_model || !is_error);
        const Texts axes = parts(view.axes), names = parts(has_two ? view.data : "data");
        std::vector<Panel> panels;
        for (int k = 0; k < (is_map ? 1 : 3); k++) {
            Panel panel = {axes[k], view.quantity, curves.cells[is_map ? PLACE + 1 : TIME], {}};
            const Cells *own = &curves.cells[view.channel + k];
            if (has_below)
                panel.traces.push_back({names[1], OTHER, true, own[0]});
            if (!has_two)
                panel.traces.push_back({L"", NEW, false, own[0]});
            else if (checked(IDC_DATA2))
                panel.traces.push_back({names[0], NEW, false, own[3]});
            if (is_map || checked(IDC_AXIS + k))
                panels.push_back(panel);
        }
        for (int k = 0; k < 3; k++) {
            enable(IDC_AXIS + k, !is_map);
            set(IDC_AXIS + k, is_map ? get(IDC_AXIS + k) : axes[k]);
        }
        for (int k = 0; k < 2; k++) {
            enable(IDC_DATA2 + k, has_two && (k == 0 || has_model || !is_error));
            set(IDC_DATA2 + k, names[k]);
        }
        plot_.show(panels, is_map ? DEGREES : DURATION, checked(IDC_LOGARITHMIC));
    }

    static std::wstring of_three(const double *values, double unit) {
        std::wstring text;
        for (int k = 0; k < 3; k++) {
            double value = values[k] / unit, size = std::fabs(value);
            text += k > 0 ? L"  " : L"";
            text += size < 5e-4 ? L"0" : size < 1000 ? shown(value, 3) : shown(std::round(value), 7);
        }
        return text;
    }

    void show_values(const Flight::Status &status, bool has_model, bool is_old) {
        const sins_record_solution &truth = status.record.truth, &navigation = status.record.navigation;
        const sins_record_errors &errors = status.record.navigation_errors, &model = status.record.model_errors;
        const sins_accuracy &accuracy = status.accuracy;
        const double *closure = accuracy.closure_position_enu_m;
        auto rate = [&](double m_s) {
            return accuracy.has_rates ? shown(m_s / SINS_NMI_PER_HOUR, 4) : L"-";
        };
        Rows values = rows_of("progress", {shown(navigation.latitude_rad / SINS_DEG, 9),
                                         shown(navigation.longitude_rad / SINS_DEG, 9),
                                         shown(navigation.height_m, 7),
                                         of_three(navigation.velocity_enu_m_s, 1),
                                         of_three(&navigation.roll_rad, SINS_DEG),
                                         of_three(&truth.roll_rad, SINS_DEG),
                                         of_three(errors.position_enu_m, 1),
                                         of_three(model.position_enu_m, 1),
                                         of_three(errors.velocity_enu_m_s, 1),
                                         of_three(errors.misalignment_enu_rad, SINS_ARCMIN),
                                         shown(std::hypot(closure[0], closure[1]), 5),
                                         rate(accuracy.cep_rate_m_s),
                                         rate(accuracy.radial_95_rate_m_s)});
        if (!has_model)
            values.erase(values.begin() + 7); /* error data 1 */
        rows(IDC_VALUES, values);
        Unit unit = plot_.time_unit(status.duration_s);
        std::wstring time = shown(status.time_s / unit.si, 6) + L" / " + shown(status.duration_s / unit.si, 6) + L" " + unit.name;
        if (status.traffic)
            show_traffic(status, is_old);
        else
            set(IDC_PROGRESS, parts("states")[status.state] + (is_old ? text("old") : L"") + L"\n" + time);
        if (status.state == Flight::FAILED)
            document_.say_line(status.sentence);
        enable(ID_GO_BACK, status.snapshot_s >= 0);
    }

    /* What the packets of a live flight are; in the status line, the first packet of each reason to refuse one. */
    void show_traffic(const Flight::Status &status, bool is_old) {
        const Traffic &traffic = *status.traffic;
        const int under_way = traffic.is_silent ? 0 : traffic.standing < 10 ? 1 : 2;
        std::wstring state = status.state == Flight::FLYING ? parts("live_states")[under_way] : parts("states")[status.state], refused;
        Texts reasons = parts("refused");
        for (size_t k = 0; k < reasons.size(); k++)
            if (traffic.refused[k] > 0)
                refused += (refused.empty() ? L"" : L", ") + std::to_wstring(traffic.refused[k]) + L" " + reasons[k];
        Unit unit = Diagram::unit_for(DURATION, {0, status.time_s});
        std::wstring time = shown(status.time_s / unit.si, 6) + L" " + unit.name;
        set(IDC_PROGRESS, state + (is_old ? text("old") : L"") + L": " + text("live_flown", {time, std::to_wstring(traffic.flown)}) +
                              (refused.empty() ? L"" : L"\n" + text("live_refused", {refused})));
        if (traffic.newest != said_ && traffic.newest != Why::COUNT)
            document_.say_line(text("live_first", {text(narrow(parts("refusals")[(size_t)traffic.newest]), {wide(traffic.what)})}));
        said_ = traffic.newest;
    }

    Plot plot_;
    Why said_ = Why::COUNT; /* the reason in the status line */
};
