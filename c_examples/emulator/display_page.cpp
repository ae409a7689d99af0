/* Display of the simulation data: panel (d) of the paper's figure 2. */
#include "app.h"

#include <cmath>

static const double PACES[] = {1, 10, 100, 1000, 0}; /* as IDS_PACES; 0: as fast as it goes */

/* What the diagram shows, in the order of IDS_QUANTITIES. */
static const struct {
    Channel channel;
    Quantity quantity;
    UINT axes;
    bool has_two; /* error data 2 and 1, or navigation and truth */
} VIEWS[] = {{POSITION_ERROR, LENGTH, IDS_AXES_ENU, true}, {VELOCITY_ERROR, SPEED, IDS_AXES_ENU, true},
             {ATTITUDE_ERROR, ANGLE, IDS_AXES_RPH, true},  {RATE, ANGULAR_RATE, IDS_AXES_XYZ, false},
             {FORCE, ACCELERATION, IDS_AXES_XYZ, false},   {ATTITUDE, ANGLE, IDS_AXES_RPH, true},
             {VELOCITY, SPEED, IDS_AXES_ENU, true},        {PLACE, DEGREES, IDS_TRACK, true}};

void DisplayPage::on_init()
{
    plot_.attach(item(IDC_PLOT));
    fill(IDC_QUANTITY, parts(IDS_QUANTITIES));
    fill(IDC_PACE, parts(IDS_PACES));
    choose(IDC_PACE, 4);
    for (int id : {IDC_DATA2, IDC_DATA1, IDC_AXIS, IDC_AXIS + 1, IDC_AXIS + 2}) {
        CheckDlgButton(window_, id, BST_CHECKED);
    }
    columns(IDC_VALUES, parts(IDS_COLUMNS_VALUES), {92, 106});
    tip(IDC_PLOT, text(IDS_PLOT_TIP));
    grow(IDC_PLOT, 0, 0, 1, 1);
    grow(IDC_VALUES, 1, 0, 0, 1);
    for (int id : {ID_FLY, ID_PAUSE, ID_STOP, ID_RESET, IDC_PACE, IDC_PROGRESS, IDC_PACE_LABEL}) {
        grow(id, 1, 0, 0, 0);
    }
    for (int id : {ID_FAILURE, ID_SNAPSHOT, ID_GO_BACK, ID_RECOMMEND, ID_BUDGET, ID_EXPORT, ID_PICTURE, ID_COPY}) {
        grow(id, 1, 1, 0, 0);
    }
}

double DisplayPage::pace() const
{
    return PACES[max(0, chosen(IDC_PACE))];
}

void DisplayPage::refresh(bool)
{
    update(app_.flight());
}

void DisplayPage::on_command(int id, int code)
{
    if (id >= ID_EXPORT && id <= ID_BUDGET) {
        app_.command(id);
    } else if (id == IDC_PACE && code == CBN_SELCHANGE) {
        if (app_.flight() != NULL) {
            app_.flight()->pace(pace());
        }
    } else if (code == CBN_SELCHANGE || code == BN_CLICKED) {
        update(app_.flight());
    }
}

void DisplayPage::update(const Flight *flight)
{
    static const COLORREF NEW = RGB(0, 70, 160), OTHER = RGB(255, 150, 60);
    const auto &view = VIEWS[max(0, chosen(IDC_QUANTITY))];
    std::vector<std::wstring> axes = parts(view.quantity == DEGREES ? IDS_TRACK : view.axes);
    bool is_map = view.channel == PLACE, has_model = false;
    Curves curves;
    std::vector<Panel> panels;
    if (flight != NULL) {
        Flight::Status status = flight->status();
        has_model = (status.record.model_errors.flags & SINS_ERRORS_NOT_COMPUTED) == 0;
        flight->read(curves);
        show_values(status);
    } else {
        keep_rows(IDC_VALUES, 0);
        set(IDC_PROGRESS, text(IDS_READY));
    }
    std::vector<std::wstring> names = parts(view.channel >= ATTITUDE ? IDS_VALUES : IDS_DATA);
    for (int k = 0; k < (is_map ? 1 : 3); k++) {
        if (!is_map) {
            set(IDC_AXIS + k, axes[(size_t)k]);
        }
        enable(IDC_AXIS + k, !is_map);
        if (!is_map && !checked(IDC_AXIS + k)) {
            continue;
        }
        Panel panel = {axes[is_map ? 0 : (size_t)k], view.quantity, curves.times(), {}};
        if (is_map) {
            panel.x.clear();
            for (const Cell &cell : curves.channel(PLACE + 1)) {
                panel.x.push_back(cell.last);
            }
        }
        /* Error data 1 below error data 2; of motion the truth below the navigation. */
        if (view.has_two && checked(IDC_DATA1) && (view.channel >= RATE || has_model)) {
            panel.traces.push_back({names[1], OTHER, true, curves.channel(view.channel + (view.channel < RATE ? 3 : 0) + k)});
        }
        if (checked(IDC_DATA2) || !view.has_two) {
            panel.traces.push_back({view.has_two ? names[0] : L"", NEW, false,
                                    curves.channel(view.channel + (view.channel < RATE || !view.has_two ? 0 : 3) + k)});
        }
        panels.push_back(panel);
    }
    for (int k = 0; k < 2; k++) {
        set(IDC_DATA2 + k, names[(size_t)k]);
        enable(IDC_DATA2 + k, view.has_two);
    }
    plot_.show(panels, is_map ? DEGREES : DURATION, checked(IDC_LOGARITHMIC), is_map ? label("plot.longitude", "longitude") : text(IDS_TIME));
}

static std::wstring of_three(const double *values, double unit)
{
    std::wstring text;
    for (int k = 0; k < 3; k++) {
        double value = values[k] / unit;
        text += (k > 0 ? L"  " : L"") + (std::fabs(value) < 5e-4 ? L"0" : std::fabs(value) < 1000 ? shown(value, 3) : shown(std::round(value), 7));
    }
    return text;
}

void DisplayPage::show_values(const Flight::Status &status)
{
    const sins_record_solution &truth = status.record.truth, &navigation = status.record.navigation;
    const sins_record_errors &errors = status.record.navigation_errors, &model = status.record.model_errors;
    const sins_accuracy &accuracy = status.accuracy;
    const double rates = SINS_NMI_PER_HOUR;
    std::vector<std::wstring> rows = parts(IDS_PROGRESS);
    const std::wstring values[] = {
        shown(navigation.latitude_rad / SINS_DEG, 9), shown(navigation.longitude_rad / SINS_DEG, 9), shown(navigation.height_m, 7),
        of_three(navigation.velocity_enu_m_s, 1), of_three(&navigation.roll_rad, SINS_DEG), of_three(&truth.roll_rad, SINS_DEG),
        of_three(errors.position_enu_m, 1), of_three(model.position_enu_m, 1), of_three(errors.velocity_enu_m_s, 1),
        of_three(errors.misalignment_enu_rad, SINS_ARCMIN),
        shown(std::hypot(accuracy.closure_position_enu_m[0], accuracy.closure_position_enu_m[1]), 5),
        accuracy.window_samples < 2 ? L"-" : shown(accuracy.cep_rate_m_s / rates, 4),
        accuracy.window_samples < 2 ? L"-" : shown(accuracy.radial_95_rate_m_s / rates, 4)};
    for (size_t k = 0; k < rows.size() && k < sizeof values / sizeof values[0]; k++) {
        row(IDC_VALUES, (int)k, {rows[k], values[k]});
    }
    std::wstring state = parts(IDS_STATES)[(size_t)status.state];
    set(IDC_PROGRESS, state + L"\n" + shown(status.time_s / 3600, 6) + L" / " + shown(status.duration_s / 3600, 6) + L" h");
    if (status.state == Flight::FAILED) {
        app_.say_line(status.sentence);
    }
    enable(ID_GO_BACK, status.snapshot_s >= 0);
}
