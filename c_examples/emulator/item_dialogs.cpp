/* Dialogs for one item of a list of the scene: a manoeuvre with its sinusoids, and the failures of sensors.
 */
#include "app.h"

class ManoeuvreDialog : public Dialog {
public:
    ManoeuvreDialog(App &app, Items &all, size_t own) : app_(app), all_(all), own_(own) {}

protected:
    void on_init() override
    {
        const Item &item = all_[own_];
        Texts channels = channel_.word_labels();
        cue("manoeuvre.ramp_s", L"5");
        load([&](const std::string &path) { return item.get(path); }, true);
        channels.insert(channels.begin(), L"-");
        for (int k = 0; k < SINUSOIDS; k++) {
            fill(Dialog::item(IDC_CHANNEL + k), channels);
            if ((size_t)k < item.items.size()) {
                const Item &sinusoid = item.items[(size_t)k];
                choose(IDC_CHANNEL + k, channel_.index_of(sinusoid.get(channel_)) + 1);
                set(IDC_AMPLITUDE + k, wide(sinusoid.get(amplitude(k))));
                set(IDC_FREQUENCY + k, wide(sinusoid.get("manoeuvre.sinusoid.frequency_hz")));
                set(IDC_PHASE + k, wide(sinusoid.get("manoeuvre.sinusoid.phase_deg")));
            }
        }
        enable_used();
    }

    void on_command(int id, int code) override
    {
        if (code == CBN_SELCHANGE) {
            enable_used();
        } else if (id == IDOK) {
            all_[own_] = edited();
            Faults faults = app_.scene.set_list("manoeuvre", all_), own;
            std::copy_if(faults.begin(), faults.end(), std::back_inserter(own),
                         [&](const Fault &fault) { return fault.item == own_; });
            mark_faults(own);
            set(IDC_MESSAGE, told(faults));
            if (faults.empty()) {
                finish(IDOK);
            }
        }
    }

private:
    static const int SINUSOIDS = 6;

    /* The key of an amplitude: in degrees, but for one of the speed. */
    std::string amplitude(int k) const
    {
        bool is_speed = channel_.words[(size_t)max(0, chosen(IDC_CHANNEL + k) - 1)] == "speed";
        return is_speed ? "manoeuvre.sinusoid.amplitude_m_s" : "manoeuvre.sinusoid.amplitude_deg";
    }

    /* The fields that a kind uses: one bit each, from the duration on; the last is for sinusoids. */
    void enable_used()
    {
        static const int USED[] = {0x01, 0x01, 0x05, 0x0b, 0x32, 0x41, 0x43, 0x53, 0x83};
        int used = USED[chosen(IDC_KIND)];
        for (int k = 0; k < 7; k++) {
            enable(IDC_DURATION + k, (used >> k & 1) != 0);
            if ((used >> k & 1) == 0) {
                set(IDC_DURATION + k, L""); /* what a kind does not use must be 0 */
            }
        }
        for (int k = 0; k < SINUSOIDS; k++) {
            bool is_used = (used & 0x80) != 0;
            enable(IDC_CHANNEL + k, is_used);
            for (int first : {IDC_AMPLITUDE, IDC_FREQUENCY, IDC_PHASE}) {
                enable(first + k, is_used && chosen(IDC_CHANNEL + k) > 0);
            }
        }
    }

    Item edited() const
    {
        Item item = {"manoeuvre", all_[own_].entries, {}};
        for (const Change &change : changes()) {
            item.set(change.path, change.value);
        }
        for (int k = 0; k < SINUSOIDS; k++) {
            if (IsWindowEnabled(Dialog::item(IDC_AMPLITUDE + k))) {
                Item sinusoid = {"manoeuvre.sinusoid", {}, {}};
                sinusoid.set(channel_.path(), quoted(channel_.words[(size_t)chosen(IDC_CHANNEL + k) - 1]));
                sinusoid.set(amplitude(k), toml(get(IDC_AMPLITUDE + k)));
                sinusoid.set("manoeuvre.sinusoid.frequency_hz", toml(get(IDC_FREQUENCY + k)));
                sinusoid.set("manoeuvre.sinusoid.phase_deg", toml(get(IDC_PHASE + k)));
                item.items.push_back(sinusoid);
            }
        }
        return item;
    }

    const Key &channel_ = *key_of("manoeuvre.sinusoid.channel");
    App &app_;
    Items &all_;
    size_t own_;
};

bool edit_manoeuvre(App &app, Items &all, size_t own)
{
    return ManoeuvreDialog(app, all, own).modal(app.window(), IDD_MANOEUVRE) == IDOK;
}

/* The failures that the scene plans. In flight they begin and end with the next interval. */
class FailureDialog : public Dialog {
public:
    explicit FailureDialog(App &app) : app_(app) {}

protected:
    void on_init() override
    {
        columns(IDC_FAILING, "columns_manoeuvres", {28, 130, 0});
        bind_sizes();
        cue("failure.until_s", L"\u221e");
        load([this](const std::string &path) { return path == "failure.from_s" ? now() : std::string(); },
             true);
        choose(IDC_KIND, 1);
        show_list();
    }

    void on_command(int id, int) override
    {
        Items items = app_.scene.list("failure");
        size_t row = (size_t)selected(IDC_FAILING);
        Flight *flight = app_.flight();
        /* In flight a failure begins and ends with the next interval, not earlier: the scene then flies to
         * the same bits again. */
        bool is_flying = flight != NULL && flight->status().state == Flight::FLYING;
        if (is_flying) {
            flight->pause(true);
        }
        if (id == IDC_SENSOR) {
            bind_sizes();
        } else if (id == IDC_ADD) {
            items.push_back(fresh(is_flying));
            take(items);
        } else if (id == IDC_REMOVE && row < items.size()) {
            items.erase(items.begin() + (ptrdiff_t)row);
            take(items);
        } else if (id == IDC_CLEAR && row < items.size() && flight != NULL) {
            items[row].set("failure.until_s", now());
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
    void bind_sizes()
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
        std::vector<Texts> lines;
        for (const Item &failure : app_.scene.list("failure")) {
            Texts words = failure.described();
            lines.push_back({std::to_wstring(lines.size() + 1), words[0], words[1]});
        }
        rows(IDC_FAILING, lines);
    }

    /* What the fields say; in flight not earlier than now. */
    Item fresh(bool is_flying) const
    {
        Item failure = {"failure", {}, {}};
        const Key &sensor = *key_of("failure.sensor"), &axis = *key_of("failure.axis");
        double from_s = -1, now_s = 0;
        number_of(now(), now_s);
        if (is_flying &&
            (get(IDC_FROM).empty() || (number_of(narrow(get(IDC_FROM)), from_s) && from_s < now_s))) {
            set(IDC_FROM, wide(now()));
        }
        for (const Change &change : changes()) {
            failure.set(change.path, change.value);
        }
        failure.set("failure.sensor", quoted(sensor.words[(size_t)chosen(IDC_SENSOR)]));
        failure.set("failure.axis",
                    chosen(IDC_SENSOR) < 2 ? quoted(axis.words[(size_t)chosen(IDC_SENSOR_AXIS)]) : "");
        failure.set("failure.from_s", toml(get(IDC_FROM)));
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
