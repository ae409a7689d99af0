/* Dialogs for one item of a list of the scene: a manoeuvre with its sinusoids, and the failures of sensors.
 */
#include "app.h"

class ManoeuvreDialog : public Form {
public:
    ManoeuvreDialog(App &app, Items &all, size_t own) : app_(app), all_(all), own_(own) {}

protected:
    void on_init() override
    {
        all_[own_].items.resize(SINUSOIDS, {"manoeuvre.sinusoid", {}, {}});
        cue("manoeuvre.ramp_s", L"5");
        load([&](const Field &field) { return item_of(all_[own_], field.nested).get(field.key->path); },
             true);
        enable_used();
    }

    void on_command(int id, int) override
    {
        if (id == IDOK) {
            Faults faults = app_.scene.set_list("manoeuvre", edited()), own = faults;
            std::erase_if(own, [&](const Fault &fault) { return fault.item != own_; });
            mark_faults(own);
            set(IDC_MESSAGE, told(faults));
            if (faults.empty()) {
                finish(IDOK);
            }
        }
    }

    void on_change(int, int code) override
    {
        if (code == CBN_SELCHANGE) {
            enable_used();
        }
    }

private:
    static const size_t SINUSOIDS = 6; /* fields */

    /* The manoeuvre, or one of its sinusoids from 1 on. */
    static Item &item_of(Item &manoeuvre, size_t nested)
    {
        return nested > 0 ? manoeuvre.items[nested - 1] : manoeuvre;
    }

    static std::string channel(const Item &manoeuvre, const Field &field)
    {
        return manoeuvre.items[field.nested - 1].get("manoeuvre.sinusoid.channel");
    }

    Items edited() const
    {
        Items all = all_;
        for (const Change &change : changes()) {
            item_of(all[own_], change.nested).set(change.path, change.value);
        }
        return all;
    }

    /* Whether a field counts: for a sinusoid's numbers its channel must be chosen; the rest the library says.
     */
    static bool is_used(const Field &field, const Item &probe, const Faults &faults)
    {
        bool has_sinusoids = probe.get("manoeuvre.kind") == "\"sinusoids\"";
        bool has_item =
            field.nested == 0 || (has_sinusoids && (field.is_choice() || !channel(probe, field).empty()));
        return has_item && std::none_of(faults.begin(), faults.end(), [&](const Fault &fault) {
                   bool is_refused = fault.sentence.find("does not use it") != std::string::npos ||
                                     fault.sentence.find("not for this channel") != std::string::npos;
                   return key_of(fault.path) == field.key && fault.nested == field.nested && is_refused;
               });
    }

    /* The fields that a kind or a channel does not use are empty and off. */
    void enable_used()
    {
        Item probe = edited()[own_];
        for (const auto &[control, field] : fields_) {
            if (!field.is_choice()) {
                item_of(probe, field.nested).set(field.key->path, "1");
            }
        }
        Faults faults = Scene().set_list("manoeuvre", {probe});
        for (const auto &[control, field] : fields_) {
            bool used = is_used(field, probe, faults);
            EnableWindow(control, used);
            if (!used && field.is_choice()) {
                SendMessageW(control, CB_SETCURSEL, 0, 0);
            } else if (!used) {
                SetWindowTextW(control, L"");
            }
        }
    }

    App &app_;
    Items &all_;
    size_t own_;
};

bool edit_manoeuvre(App &app, Items &all, size_t own)
{
    return ManoeuvreDialog(app, all, own).modal(app.window(), IDD_MANOEUVRE) == IDOK;
}

/* The failures that the scene plans. In flight they begin and end with the next interval. */
class FailureDialog : public Form {
public:
    explicit FailureDialog(App &app) : app_(app) {}

protected:
    void on_init() override
    {
        columns(IDC_FAILING, "columns_manoeuvres", {28, 130, 0});
        choose_sensor();
        cue("failure.until_s", L"\u221e");
        load([this](const Field &field) { return field.key->path == "failure.from_s" ? now() : ""; }, true);
        choose(IDC_KIND, 1);
        show_list();
    }

    void on_change(int id, int) override
    {
        if (id == IDC_SENSOR) {
            choose_sensor();
        }
    }

    void on_command(int id, int) override
    {
        Items items = app_.scene.list("failure");
        size_t row = selected(IDC_FAILING);
        bool has_row = row < items.size();
        /* In flight a failure begins and ends with the next interval, not earlier: the scene then flies to
         * the same bits again. */
        Flight *flight = app_.flight();
        bool is_flying = flight != NULL && flight->status().state == Flight::FLYING;
        if (is_flying) {
            flight->pause(true);
        }
        if (id == IDC_ADD) {
            items.push_back(fresh(is_flying));
        } else if (id == IDC_REMOVE && has_row) {
            items.erase(items.begin() + row);
        } else if (id == IDC_CLEAR && has_row && flight != NULL) {
            items[row].set("failure.until_s", now());
        }
        if (id == IDC_ADD || id == IDC_REMOVE || id == IDC_CLEAR) {
            take(items);
        }
        if (is_flying) {
            flight->pause(false);
        }
    }

    void on_notify(NMHDR *notice) override
    {
        if (notice->idFrom == IDC_FAILING && notice->code == (UINT)LVN_ITEMCHANGED) {
            enable(IDC_CLEAR, selected(IDC_FAILING) >= 0 && app_.flight() != NULL);
            enable(IDC_REMOVE, selected(IDC_FAILING) >= 0);
        }
    }

private:
    /* The time of the flight at hand; "": none flies. */
    std::string now() const { return app_.flight() == NULL ? "" : shortest(app_.flight()->status().time_s); }

    /* Size and density have units of the sensor that is chosen. */
    void choose_sensor()
    {
        static const char *const SIZES[] = {"failure.size_deg_h", "failure.size_micro_g", "failure.size_m"};
        static const char *const DENSITIES[] = {
            "failure.density_deg_sqrt_h", "failure.density_micro_g_sqrt_hz", "failure.density_m_sqrt_hz"};
        int sensor = chosen(IDC_SENSOR);
        bind(item(IDC_FAILURE_SIZE), SIZES[sensor]);
        bind(item(IDC_DENSITY), DENSITIES[sensor]);
        set(IDC_SIZE_UNIT, wide(key_of(SIZES[sensor])->unit));
        set(IDC_DENSITY_UNIT, wide(key_of(DENSITIES[sensor])->unit));
        enable(IDC_SENSOR_AXIS, sensor < 2);
    }

    void show_list()
    {
        Rows lines;
        for (const Item &failure : app_.scene.list("failure")) {
            Texts words = failure.described();
            lines.push_back({{std::to_wstring(lines.size() + 1), words[0], words[1]}});
        }
        rows(IDC_FAILING, lines);
    }

    /* What the fields say; in flight not earlier than now. */
    Item fresh(bool is_flying) const
    {
        Item failure = {"failure", {}, {}};
        double from_s = -1, now_s = 0;
        number_of(now(), now_s);
        if (is_flying &&
            (get(IDC_FROM).empty() || (number_of(narrow(get(IDC_FROM)), from_s) && from_s < now_s))) {
            set(IDC_FROM, wide(now()));
        }
        for (const auto &[control, field] : fields_) {
            if (IsWindowEnabled(control)) {
                failure.set(field.key->path, typed(control, field));
            }
        }
        return failure;
    }

    /* Makes these the failures of the scene and of the flight at hand. */
    void take(const Items &items)
    {
        Faults faults = app_.scene.set_list("failure", items);
        std::wstring sentence = mark_faults(faults);
        if (faults.empty() && app_.flight() != NULL) {
            app_.flight()->plan(app_.scene);
        }
        app_.edited(sentence);
        set(IDC_MESSAGE, sentence);
        show_list();
    }

    App &app_;
};

void edit_failures(App &app)
{
    FailureDialog(app).modal(app.window(), IDD_FAILURE);
}
