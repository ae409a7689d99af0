/* Display of the simulation data: panel (d) of the paper's figure 2. */
#include "app.h"

static const double PACES[] = {1, 10, 100, 1000, 0}; /* as the text "paces"; 0: as fast as it goes */

/* What the diagram shows, in the order of the text "quantities". */
static const struct {
    Channel channel;
    Quantity quantity;
    const char *axes, *traces; /* two traces are error data 2 and 1, or navigation and truth */
} VIEWS[] = {{POSITION_ERROR, LENGTH, "axes_enu", "data"}, {VELOCITY_ERROR, SPEED, "axes_enu", "data"},
             {ATTITUDE_ERROR, ANGLE, "axes_rph", "data"},  {RATE, ANGULAR_RATE, "axes_xyz", ""},
             {FORCE, ACCELERATION, "axes_xyz", ""},        {ATTITUDE, ANGLE, "axes_rph", "values"},
             {VELOCITY, SPEED, "axes_enu", "values"},      {PLACE, DEGREES, "track", "values"}};

void DisplayPage::on_init()
{
    plot_.attach(item(IDC_PLOT));
    fill(item(IDC_QUANTITY), parts("quantities"));
    fill(item(IDC_PACE), parts("paces"));
    choose(IDC_PACE, 4);
    for (int id : {IDC_DATA2, IDC_DATA1, IDC_AXIS, IDC_AXIS + 1, IDC_AXIS + 2}) {
        check(id, true);
    }
    columns(IDC_VALUES, "columns_values", {92, 0});
    tip(item(IDC_PLOT), text("plot_tip"));
    grow({IDC_PLOT}, 0, 0, 1, 1);
    grow({IDC_VALUES}, 1, 0, 0, 1);
    grow({ID_FLY, ID_PAUSE, ID_STOP, ID_RESET, IDC_PACE, IDC_PROGRESS, IDC_PACE_LABEL}, 1, 0, 0, 0);
    grow({ID_FAILURE, ID_SNAPSHOT, ID_GO_BACK, ID_RECOMMEND, ID_BUDGET, ID_EXPORT, ID_PICTURE, ID_COPY}, 1, 1,
         0, 0);
}

double DisplayPage::pace() const
{
    return PACES[chosen(IDC_PACE)];
}

void DisplayPage::on_command(int id, int code)
{
    if (id >= ID_EXPORT && id <= ID_BUDGET) {
        app_.command(id);
    } else if (id == IDC_PACE && code == CBN_SELCHANGE && app_.flight() != NULL) {
        app_.flight()->pace(pace());
    } else if (code == CBN_SELCHANGE || code == BN_CLICKED) {
        update();
    }
}

void DisplayPage::update()
{
    static const COLORREF NEW = RGB(0, 70, 160), OTHER = RGB(255, 150, 60);
    const auto &view = VIEWS[chosen(IDC_QUANTITY)];
    const bool is_map = view.channel == PLACE, has_two = view.traces[0] != '\0',
               is_error = view.channel < RATE;
    const Texts axes = parts(view.axes), names = parts(has_two ? view.traces : "data");
    bool has_model = false;
    Curves curves;
    if (app_.flight() != NULL) {
        Flight::Status status = app_.flight()->status();
        has_model = (status.record.model_errors.flags & SINS_ERRORS_NOT_COMPUTED) == 0;
        curves = app_.flight()->curves();
        show_values(status);
    } else {
        rows(IDC_VALUES, {});
        set(IDC_PROGRESS, text("ready"));
    }
    auto trace = [&](const std::wstring &name, COLORREF color, bool is_wide, int channel) {
        Trace trace = {name, color, is_wide, {}};
        for (const Cells &cells : curves.cells) {
            trace.cells.push_back(cells[channel]);
        }
        return trace;
    };
    std::vector<Panel> panels;
    for (int k = 0; k < (is_map ? 1 : 3); k++) {
        Panel panel = {axes[k], view.quantity, curves.times, {}};
        for (size_t m = 0; is_map && m < panel.x.size(); m++) {
            panel.x[m] = curves.cells[m][PLACE + 1].last;
        }
        /* Error data 1 below error data 2; of motion the truth, which comes first, below the navigation. */
        int first = view.channel + k, second = first + 3;
        if (has_two && checked(IDC_DATA1) && (has_model || !is_error)) {
            panel.traces.push_back(trace(names[1], OTHER, true, is_error ? second : first));
        }
        if (!has_two || checked(IDC_DATA2)) {
            panel.traces.push_back(
                trace(has_two ? names[0] : L"", NEW, false, !has_two || is_error ? first : second));
        }
        if (is_map || checked(IDC_AXIS + k)) {
            panels.push_back(panel);
        }
    }
    for (int k = 0; k < 3; k++) {
        enable(IDC_AXIS + k, !is_map);
        set(IDC_AXIS + k, is_map ? get(IDC_AXIS + k) : axes[k]);
    }
    for (int k = 0; k < 2; k++) {
        enable(IDC_DATA2 + k, has_two);
        set(IDC_DATA2 + k, names[k]);
    }
    plot_.show(panels, is_map ? DEGREES : DURATION, checked(IDC_LOGARITHMIC));
}

static std::wstring of_three(const double *values, double unit)
{
    std::wstring text;
    for (int k = 0; k < 3; k++) {
        double value = values[k] / unit, size = std::fabs(value);
        text += k > 0 ? L"  " : L"";
        text += size < 5e-4 ? L"0" : size < 1000 ? shown(value, 3) : shown(std::round(value), 7);
    }
    return text;
}

void DisplayPage::show_values(const Flight::Status &status)
{
    const sins_record_solution &truth = status.record.truth, &navigation = status.record.navigation;
    const sins_record_errors &errors = status.record.navigation_errors, &model = status.record.model_errors;
    const sins_accuracy &accuracy = status.accuracy;
    const double *closure = accuracy.closure_position_enu_m;
    auto rate = [&](double m_s) {
        return accuracy.window_samples > 1 ? shown(m_s / SINS_NMI_PER_HOUR, 4) : L"-";
    };
    const Texts names = parts("progress");
    const Texts values = {shown(navigation.latitude_rad / SINS_DEG, 9),
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
                          rate(accuracy.radial_95_rate_m_s)};
    Rows lines;
    for (size_t k = 0; k < names.size(); k++) {
        lines.push_back({{names[k], values[k]}});
    }
    rows(IDC_VALUES, lines);
    std::wstring time = shown(status.time_s / 3600, 6) + L" / " + shown(status.duration_s / 3600, 6) + L" h";
    set(IDC_PROGRESS, parts("states")[status.state] + L"\n" + time);
    if (status.state == Flight::FAILED) {
        app_.say_line(status.sentence);
    }
    enable(ID_GO_BACK, status.snapshot_s >= 0);
}
