/* Initial conditions of the trajectory: panel (a) of the paper's figure 2. */
#include "app.h"

void Page::refresh(bool all_is_new)
{
    load([this](const std::string &path) { return app_.scene.get(path); }, all_is_new);
}

void Page::on_command(int id, int code)
{
    if (is_change(id, code)) {
        before_store(id);
        std::vector<Change> made = changes();
        if (!made.empty() || has_marks()) {
            app_.edited(mark_faults(app_.scene.change(made)));
        }
    }
}

/* Where the manoeuvres stand among the sections; each has its sinusoids behind it. */
static std::vector<size_t> places(const Items &items)
{
    std::vector<size_t> result;
    for (size_t k = 0; k < items.size(); k++) {
        if (items[k].section == "manoeuvre") {
            result.push_back(k);
        }
    }
    return result;
}

static size_t end_of(const Items &items, size_t at)
{
    do {
        at++;
    } while (at < items.size() && items[at].section == "manoeuvre.sinusoid");
    return at;
}

void TrajectoryPage::on_init()
{
    std::vector<std::wstring> names;
    char name[64];
    for (size_t k = 0; lib.sins_scene_builtin_name(k, name, sizeof name, NULL) == SINS_OK; k++) {
        names.push_back(wide(name));
    }
    exchange({{IDC_LATITUDE, "flight.latitude_deg", 0}, {IDC_LONGITUDE, "flight.longitude_deg", 0}, {IDC_HEIGHT, "flight.height_m", 0},
              {IDC_SPEED, "flight.speed_m_s", 0}, {IDC_COURSE, "flight.heading_deg", 0}, {IDC_ROLL, "flight.roll_deg", 0},
              {IDC_PITCH, "flight.pitch_deg", 0}, {IDC_REPEAT, "flight.repeat", 0}, {IDC_TITLE, "flight.title", 0},
              {IDC_LOG, "flight.file", 0}});
    cue(IDC_REPEAT, L"1");
    fill(IDC_SOURCE, parts(IDS_SOURCES));
    fill(IDC_BUILTIN, names);
    columns(IDC_MANOEUVRES, parts(IDS_COLUMNS_MANOEUVRES), {28, 90, 190});
    track_.attach(item(IDC_TRACK));
    profile_.attach(item(IDC_PROFILE));
    grow(IDC_TRACK, 0, 0, 1, 2);
    grow(IDC_PROFILE, 0, 2, 1, 2);
    grow(IDC_MANOEUVRES, 0, 0, 0, 1);
    for (int id = IDC_ADD; id <= IDC_DOWN; id++) {
        grow(id, 0, 1, 0, 0);
    }
}

void TrajectoryPage::refresh(bool all_is_new)
{
    int source = app_.scene.setup().flight, row_count = 0;
    bool is_path = source == SINS_SCENE_FLIGHT_MANOEUVRES;
    const Items &items = app_.scene.items();
    Page::refresh(all_is_new);
    /* The list begins with built-in flights, as the paper's simulations are. */
    choose(IDC_SOURCE, source == SINS_SCENE_FLIGHT_BUILTIN ? 0 : is_path ? 1 : 2);
    std::wstring builtin = wide(app_.scene.words(SINS_SCENE_TEXT_BUILTIN));
    if (!builtin.empty()) {
        SendMessageW(item(IDC_BUILTIN), CB_SELECTSTRING, (WPARAM)-1, (LPARAM)builtin.c_str());
    }
    for (int id = IDC_LATITUDE; id <= IDC_DOWN; id++) {
        if (item(id) != NULL) {
            enable(id, is_path);
        }
    }
    enable(IDC_BUILTIN, source == SINS_SCENE_FLIGHT_BUILTIN);
    enable(IDC_LOG, source == SINS_SCENE_FLIGHT_LOG);
    enable(IDC_BROWSE, source == SINS_SCENE_FLIGHT_LOG);
    for (size_t place : places(items)) {
        std::string words;
        for (const auto &entry : items[place].entries) {
            const Key *key = key_of("manoeuvre." + entry.first);
            if (entry.first != "kind" && key != NULL) {
                words += (words.empty() ? "" : ", ") + narrow(label(key->path() + ".short", entry.first)) + " " + items[place].get(*key)
                         + (key->unit.empty() ? "" : " " + key->unit);
            }
        }
        std::string kind = unquoted(items[place].get(*key_of("manoeuvre.kind")));
        row(IDC_MANOEUVRES, row_count, {std::to_wstring(row_count + 1), label("manoeuvre.kind." + kind, kind), wide(words)});
        row_count++;
    }
    keep_rows(IDC_MANOEUVRES, row_count);
    preview();
}

/* The ground track and the height of the flight, from 3000 samples of it. */
void TrajectoryPage::preview()
{
    Samples samples;
    std::wstring why, seen = wide(app_.scene.text()) + app_.folder();
    if (seen == previewed_) {
        return;
    }
    previewed_ = seen;
    Panel track = {text(IDS_TRACK), DEGREES, {}, {{L"", RGB(0, 90, 180), false, {}}}};
    Panel profile = {text(IDS_HEIGHT_OVER_TIME), LENGTH, {}, {{L"", RGB(0, 90, 180), false, {}}}};
    if (samples.open(app_.scene, app_.folder(), why)) {
        size_t step = samples.count / 3000 + 1;
        sins_flight_sample sample;
        SINS_INIT(sample);
        for (size_t k = 0; k < samples.count && samples.get(k, &sample) == SINS_OK; k += step) {
            track.x.push_back(sample.longitude_rad);
            track.traces[0].cells.push_back({sample.latitude_rad, sample.latitude_rad, sample.latitude_rad});
            profile.x.push_back(sample.time_s - samples.start_s);
            profile.traces[0].cells.push_back({sample.height_m, sample.height_m, sample.height_m});
        }
    } else {
        app_.say_line(why);
    }
    track_.show({track}, DEGREES, false, label("plot.longitude", "longitude"));
    profile_.show({profile}, DURATION, false, text(IDS_TIME));
}

void TrajectoryPage::set_source(int source)
{
    Scene &scene = app_.scene;
    bool done = true;
    if (source == 0) {
        /* The paper's simulations are scenes with the flight of another. */
        std::string name = narrow(get(IDC_BUILTIN)), other = Scene(name).words(SINS_SCENE_TEXT_BUILTIN);
        done = scene.take(lib.sins_scene_set_text(scene.handle(), SINS_SCENE_TEXT_BUILTIN, (other.empty() ? name : other).c_str()));
    } else if (source == 1) {
        /* A built-in flight becomes manoeuvres that can be edited; a log the default flight. */
        static sins_manoeuvre manoeuvres[4096];
        sins_flight_start start;
        size_t count = 0, repeat = 1;
        Scene rest;
        SINS_INIT(start);
        SINS_INIT(manoeuvres[0]);
        manoeuvres[0].struct_size = sizeof manoeuvres[0];
        sins_scene *from = scene.setup().flight == SINS_SCENE_FLIGHT_LOG ? rest.handle() : scene.handle();
        done = lib.sins_scene_get_manoeuvres(from, &start, manoeuvres, 4096, &count, &repeat) == SINS_OK
               && scene.take(lib.sins_scene_set_manoeuvres(scene.handle(), &start, manoeuvres, count, repeat));
    } else {
        std::wstring path = ask_file(window_, false, IDS_FILTER_LOG, L"csv");
        std::wstring folder = app_.folder();
        if (!path.empty() && !folder.empty() && path.compare(0, folder.size(), folder) == 0) {
            path = path.substr(folder.size()); /* as seen from the scene */
        }
        done = path.empty() || scene.take(lib.sins_scene_set_text(scene.handle(), SINS_SCENE_TEXT_LOG, narrow(path).c_str()));
    }
    app_.edited(done ? L"" : wide(last_error()));
}

/* Adds, edits, moves or removes a manoeuvre. */
void TrajectoryPage::edit(int id)
{
    Items items = app_.scene.items();
    std::vector<size_t> at = places(items);
    size_t chosen_row = (size_t)selected(IDC_MANOEUVRES), next = at.size();
    std::vector<Fault> faults;
    auto cut = [&](size_t row) { return Items(items.begin() + at[row], items.begin() + end_of(items, at[row])); };
    if (chosen_row >= at.size() && id != IDC_ADD) {
        return;
    }
    if (id == IDC_ADD || id == IDC_EDIT) {
        size_t from = id == IDC_EDIT ? at[chosen_row] : chosen_row < at.size() ? end_of(items, at[chosen_row]) : items.size();
        size_t to = id == IDC_EDIT ? end_of(items, from) : from;
        Items manoeuvre = id == IDC_EDIT ? cut(chosen_row) : Items{{"manoeuvre", {{"kind", "\"straight\""}, {"duration_s", "60"}}}};
        next = id == IDC_EDIT ? chosen_row : chosen_row < at.size() ? chosen_row + 1 : at.size();
        if (!edit_manoeuvre(app_, manoeuvre, [&](const Items &edited) {
                Items all(items.begin(), items.begin() + from);
                all.insert(all.end(), edited.begin(), edited.end());
                all.insert(all.end(), items.begin() + to, items.end());
                std::vector<Fault> found;
                app_.scene.read(all, found);
                for (Fault &fault : found) {
                    fault.item -= from;
                }
                return found;
            })) {
            return;
        }
    } else {
        size_t other = id == IDC_UP ? chosen_row - 1 : id == IDC_DOWN ? chosen_row + 1 : chosen_row;
        if (other >= at.size()) {
            return;
        }
        size_t low = min(chosen_row, other), high = max(chosen_row, other);
        Items first = cut(low), second = cut(high), all(items.begin(), items.begin() + at[low]);
        if (id != IDC_REMOVE) {
            all.insert(all.end(), second.begin(), second.end());
            all.insert(all.end(), first.begin(), first.end());
        }
        all.insert(all.end(), items.begin() + end_of(items, at[high]), items.end());
        next = other;
        app_.scene.read(all, faults);
    }
    app_.edited(faults.empty() ? L"" : wide(faults[0].sentence));
    select(IDC_MANOEUVRES, (int)next);
}

void TrajectoryPage::on_command(int id, int code)
{
    if (code == CBN_SELCHANGE && (id == IDC_SOURCE || id == IDC_BUILTIN)) {
        set_source(id == IDC_BUILTIN ? 0 : chosen(IDC_SOURCE));
    } else if (id == IDC_BROWSE) {
        set_source(2);
    } else if (id == IDC_TAKE) {
        app_.open_builtin(narrow(get(IDC_BUILTIN)));
    } else if (id >= IDC_ADD && id <= IDC_DOWN) {
        edit(id);
    } else {
        Page::on_command(id, code);
    }
}

void TrajectoryPage::on_notify(NMHDR *notice)
{
    if (notice->idFrom == IDC_MANOEUVRES && notice->code == (UINT)NM_DBLCLK) {
        edit(IDC_EDIT);
    }
}
