/* Dialogs for one item of a list of the scene: a manoeuvre with its sinusoids, and the failures of sensors. */
#include "app.h"

typedef std::function<std::vector<Fault>(const Items &)> Take;

class ManoeuvreDialog : public ExchangeDialog {
public:
    ManoeuvreDialog(Items &items, const Take &take) : items_(items), take_(take) {}

protected:
    void on_init() override;
    void on_command(int id, int code) override;

private:
    void enable_used();
    Items edited() const;
    const Key &key(const char *name) const { return *key_of(std::string("manoeuvre.sinusoid.") + name); }
    Items &items_;
    const Take &take_;
};

void ManoeuvreDialog::on_init()
{
    exchange({{IDC_KIND, "manoeuvre.kind", 0}, {IDC_DURATION, "manoeuvre.duration_s", 0}, {IDC_RAMP, "manoeuvre.ramp_s", 0},
              {IDC_SPEED_CHANGE, "manoeuvre.speed_change_m_s", 0}, {IDC_HEIGHT_CHANGE, "manoeuvre.height_change_m", 0},
              {IDC_HEADING_CHANGE, "manoeuvre.heading_change_deg", 0}, {IDC_BANK, "manoeuvre.bank_deg", 0},
              {IDC_TURNS, "manoeuvre.turns", 0}});
    cue(IDC_RAMP, L"5");
    load([this](const std::string &path) { return items_[0].get(*key_of(path)); }, true);
    std::vector<std::wstring> channels = {L"-"};
    for (const std::string &word : key("channel").words) {
        channels.push_back(label(key("channel").path() + "." + word, word));
    }
    for (int k = 0; k < 6; k++) {
        fill(IDC_CHANNEL + k, channels);
        if ((size_t)k + 1 < items_.size()) {
            const Item &sinusoid = items_[(size_t)k + 1];
            std::string word = unquoted(sinusoid.get(key("channel")));
            size_t index = 0;
            while (index < key("channel").words.size() && key("channel").words[index] != word) {
                index++;
            }
            choose(IDC_CHANNEL + k, (int)index + 1);
            set(IDC_AMPLITUDE + k, wide(sinusoid.get(key(word == "speed" ? "amplitude_m_s" : "amplitude_deg"))));
            set(IDC_FREQUENCY + k, wide(sinusoid.get(key("frequency_hz"))));
            set(IDC_PHASE + k, wide(sinusoid.get(key("phase_deg"))));
        }
    }
    enable_used();
}

/* The fields that a kind uses: one bit each, from the duration on; the last is for sinusoids. */
void ManoeuvreDialog::enable_used()
{
    static const int USED[] = {0x01, 0x01, 0x05, 0x0b, 0x32, 0x41, 0x43, 0x53, 0x83};
    int used = USED[max(0, chosen(IDC_KIND))];
    for (int k = 0; k < 7; k++) {
        enable(IDC_DURATION + k, (used >> k & 1) != 0);
        if ((used >> k & 1) == 0) {
            set(IDC_DURATION + k, L""); /* what a kind does not use must be 0 */
        }
    }
    for (int first : {IDC_CHANNEL, IDC_AMPLITUDE, IDC_FREQUENCY, IDC_PHASE}) {
        for (int k = 0; k < 6; k++) {
            enable(first + k, (used & 0x80) != 0 && (first == IDC_CHANNEL || chosen(IDC_CHANNEL + k) > 0));
        }
    }
}

Items ManoeuvreDialog::edited() const
{
    Items items(1, items_[0]);
    for (const Change &change : changes()) {
        items[0].set(*key_of(change.path), change.value);
    }
    for (int k = 0; k < 6; k++) {
        int index = IsWindowEnabled(item(IDC_CHANNEL + k)) ? chosen(IDC_CHANNEL + k) : 0;
        if (index > 0) {
            std::string word = key("channel").words[(size_t)index - 1];
            Item sinusoid = {"manoeuvre.sinusoid", {}};
            sinusoid.set(key("channel"), quoted(word));
            sinusoid.set(key(word == "speed" ? "amplitude_m_s" : "amplitude_deg"), toml(get(IDC_AMPLITUDE + k)));
            sinusoid.set(key("frequency_hz"), toml(get(IDC_FREQUENCY + k)));
            sinusoid.set(key("phase_deg"), toml(get(IDC_PHASE + k)));
            items.push_back(sinusoid);
        }
    }
    return items;
}

void ManoeuvreDialog::on_command(int id, int code)
{
    if (code == CBN_SELCHANGE) {
        enable_used();
    } else if (id == IDOK) {
        Items items = edited();
        std::vector<Fault> faults = take_(items);
        std::wstring sentence = mark_faults(faults);
        if (faults.empty()) {
            items_ = items;
            finish(IDOK);
        }
        set(IDC_MESSAGE, sentence);
    }
}

bool edit_manoeuvre(App &app, Items &manoeuvre, const Take &take)
{
    return ManoeuvreDialog(manoeuvre, take).modal(app.window(), IDD_MANOEUVRE) == IDOK;
}

/* The failures that the scene plans. In flight they begin and end with the next interval. */
class FailureDialog : public ExchangeDialog {
public:
    explicit FailureDialog(App &app) : app_(app) {}

protected:
    void on_init() override;
    void on_command(int id, int code) override;
    void on_notify(NMHDR *notice) override;

private:
    void set_fields();
    void show_list();
    void take(const Items &items);
    std::string now() const;
    std::vector<size_t> places() const;
    App &app_;
};

void FailureDialog::on_init()
{
    columns(IDC_FAILING, parts(IDS_COLUMNS_MANOEUVRES), {28, 90, 320});
    set_fields();
    load([this](const std::string &path) { return path == "failure.from_s" ? now() : std::string(); }, true);
    choose(IDC_KIND, 1);
    show_list();
}

/* The time of the flight at hand; "": none flies. */
std::string FailureDialog::now() const
{
    return app_.flight() == NULL ? "" : shortest(app_.flight()->status().time_s);
}

/* Size and density have units of the sensor that is chosen. */
void FailureDialog::set_fields()
{
    static const char *const SIZES[] = {"size_deg_h", "size_micro_g", "size_m"};
    static const char *const DENSITIES[] = {"density_deg_sqrt_h", "density_micro_g_sqrt_hz", "density_m_sqrt_hz"};
    int sensor = max(0, chosen(IDC_SENSOR)), axis = max(0, chosen(IDC_SENSOR_AXIS)), kind = max(0, chosen(IDC_KIND));
    std::string size = std::string("failure.") + SIZES[sensor], density = std::string("failure.") + DENSITIES[sensor];
    exchange({{IDC_SENSOR, "failure.sensor", 0}, {IDC_SENSOR_AXIS, "failure.axis", 0}, {IDC_KIND, "failure.kind", 0},
              {IDC_FROM, "failure.from_s", 0}, {IDC_TO, "failure.until_s", 0}, {IDC_FAILURE_SIZE, size, 0}, {IDC_DENSITY, density, 0},
              {IDC_INTERVAL, "failure.interval_s", 0}, {IDC_LENGTH, "failure.duration_s", 0}, {IDC_PROBABILITY, "failure.probability", 0}});
    choose(IDC_SENSOR, sensor);
    choose(IDC_SENSOR_AXIS, axis);
    choose(IDC_KIND, kind);
    cue(IDC_TO, L"\u221e");
    set(IDC_SIZE_UNIT, wide(key_of(size)->unit));
    set(IDC_DENSITY_UNIT, wide(key_of(density)->unit));
    enable(IDC_SENSOR_AXIS, sensor < 2);
}

std::vector<size_t> FailureDialog::places() const
{
    std::vector<size_t> result;
    for (size_t k = 0; k < app_.scene.items().size(); k++) {
        if (app_.scene.items()[k].section == "failure") {
            result.push_back(k);
        }
    }
    return result;
}

void FailureDialog::show_list()
{
    int count = 0;
    for (size_t place : places()) {
        std::vector<std::wstring> words;
        std::string rest;
        for (const auto &entry : app_.scene.items()[place].entries) {
            const Key *key = key_of("failure." + entry.first);
            if (key != NULL && !key->words.empty()) {
                words.push_back(label(key->path() + "." + unquoted(entry.second), unquoted(entry.second)));
            } else if (key != NULL) {
                rest += (rest.empty() ? "" : ", ") + narrow(label(key->path() + ".short", entry.first)) + " "
                        + app_.scene.items()[place].get(*key) + (key->unit.empty() ? "" : " " + key->unit);
            }
        }
        std::wstring what;
        for (const std::wstring &word : words) {
            what += (what.empty() ? L"" : L" ") + word;
        }
        row(IDC_FAILING, count, {std::to_wstring(count + 1), what, wide(rest)});
        count++;
    }
    keep_rows(IDC_FAILING, count);
}

/* Makes these the sections of the scene; the flight at hand hears of it. */
void FailureDialog::take(const Items &items)
{
    std::vector<Fault> faults;
    app_.scene.read(items, faults);
    std::wstring sentence = mark_faults(faults);
    if (faults.empty() && app_.flight() != NULL) {
        app_.flight()->plan(app_.scene);
    }
    app_.edited(sentence);
    set(IDC_MESSAGE, sentence);
    show_list();
}

void FailureDialog::on_command(int id, int code)
{
    Items items = app_.scene.items();
    std::vector<size_t> at = places();
    size_t chosen_row = (size_t)selected(IDC_FAILING);
    /* In flight a failure begins and ends with the next interval, not earlier: the scene then flies to the same bits again. */
    Flight *flying = app_.flight() != NULL && app_.flight()->status().state == Flight::FLYING ? app_.flight() : NULL;
    if (flying != NULL && (id == IDC_ADD || id == IDC_CLEAR)) {
        flying->pause(true);
        double from_s = 0, now_s = flying->status().time_s;
        if (id == IDC_ADD && (!number_of(narrow(get(IDC_FROM)), from_s) ? get(IDC_FROM).empty() : from_s < now_s)) {
            set(IDC_FROM, wide(shortest(now_s)));
        }
    }
    if (id == IDC_SENSOR && code == CBN_SELCHANGE) {
        set_fields();
    } else if (id == IDC_ADD) {
        Item failure = {"failure", {}};
        for (const Change &change : changes()) {
            failure.set(*key_of(change.path), change.value);
        }
        if (chosen(IDC_SENSOR) < 2) {
            failure.set(*key_of("failure.axis"), quoted(key_of("failure.axis")->words[(size_t)chosen(IDC_SENSOR_AXIS)]));
        }
        failure.set(*key_of("failure.sensor"), quoted(key_of("failure.sensor")->words[(size_t)chosen(IDC_SENSOR)]));
        if (!get(IDC_FROM).empty()) {
            failure.set(*key_of("failure.from_s"), toml(get(IDC_FROM)));
        }
        items.push_back(failure);
        take(items);
    } else if (id == IDC_REMOVE && chosen_row < at.size()) {
        items.erase(items.begin() + at[chosen_row]);
        take(items);
    } else if (id == IDC_CLEAR && chosen_row < at.size() && !now().empty()) {
        items[at[chosen_row]].set(*key_of("failure.until_s"), now());
        take(items);
    }
    if (flying != NULL && (id == IDC_ADD || id == IDC_CLEAR)) {
        flying->pause(false);
    }
}

void FailureDialog::on_notify(NMHDR *notice)
{
    if (notice->idFrom == IDC_FAILING && notice->code == (UINT)LVN_ITEMCHANGED) {
        enable(IDC_CLEAR, selected(IDC_FAILING) >= 0 && !now().empty());
        enable(IDC_REMOVE, selected(IDC_FAILING) >= 0);
    }
}

void edit_failures(App &app)
{
    FailureDialog(app).modal(app.window(), IDD_FAILURE);
}
