/* Initial conditions of the trajectory: panel (a) of the paper's figure 2. */
#include "app.h"

/* Where a flight comes from, in the order of the text "sources": as the paper, built-in flights first. */
static const int SOURCES[] = {SINS_SCENE_FLIGHT_BUILTIN, SINS_SCENE_FLIGHT_MANOEUVRES, SINS_SCENE_FLIGHT_LOG};

class TrajectoryPage : public Page {
public:
    using Page::Page;

    void refresh(bool all_is_new) override
    {
        int source = app_.scene.setup().flight;
        bool is_path = source == SINS_SCENE_FLIGHT_MANOEUVRES, is_log = source == SINS_SCENE_FLIGHT_LOG;
        std::wstring builtin = wide(app_.scene.words(SINS_SCENE_TEXT_BUILTIN));
        Rows lines;
        Page::refresh(all_is_new);
        choose(IDC_SOURCE, std::find(SOURCES, std::end(SOURCES), source) - SOURCES);
        if (!builtin.empty()) {
            SendMessageW(item(IDC_BUILTIN), CB_SELECTSTRING, -1, (LPARAM)builtin.c_str());
        }
        enable_fields("flight.", is_path);
        enable_fields("flight.title", true);
        enable_fields("flight.file", is_log);
        enable(IDC_BROWSE, is_log);
        enable(IDC_BUILTIN, !is_path && !is_log);
        for (int id = IDC_MANOEUVRES; id <= IDC_DOWN; id++) {
            enable(id, is_path);
        }
        for (const Item &manoeuvre : app_.scene.list("manoeuvre")) {
            Texts words = manoeuvre.described();
            lines.push_back({{std::to_wstring(lines.size() + 1), words[0], words[1]}});
        }
        rows(IDC_MANOEUVRES, lines);
        if (previewed_ != app_.scene.text() + narrow(app_.folder())) {
            preview();
        }
    }

protected:
    void on_init() override
    {
        cue("flight.repeat", L"1");
        fill(item(IDC_SOURCE), parts("sources"));
        fill(item(IDC_BUILTIN), app_.builtins);
        columns(IDC_MANOEUVRES, "columns_manoeuvres", {28, 90, 0});
        track_.attach(item(IDC_TRACK));
        profile_.attach(item(IDC_PROFILE));
        grow({IDC_TRACK}, 0, 0, 1, 2);
        grow({IDC_PROFILE}, 0, 2, 1, 2);
        grow({IDC_MANOEUVRES}, 0, 0, 0, 1);
        grow({IDC_ADD, IDC_EDIT, IDC_REMOVE, IDC_UP, IDC_DOWN}, 0, 1, 0, 0);
    }

    void on_command(int id, int code) override
    {
        if (code == CBN_SELCHANGE && (id == IDC_SOURCE || id == IDC_BUILTIN)) {
            set_source(id == IDC_BUILTIN ? 0 : chosen(IDC_SOURCE));
        } else if (id == IDC_BROWSE) {
            set_source(2);
        } else if (id == IDC_TAKE) {
            app_.open_builtin(narrow(get(IDC_BUILTIN)));
        } else if (id >= IDC_ADD && id <= IDC_DOWN) {
            edit(id);
        }
    }

    void on_notify(NMHDR *notice) override
    {
        if (notice->idFrom == IDC_MANOEUVRES && notice->code == (UINT)NM_DBLCLK) {
            edit(IDC_EDIT);
        }
    }

private:
    /* The ground track and the height of the flight, from 3000 samples of it. */
    void preview()
    {
        Samples samples;
        sins_flight_sample sample = sized<sins_flight_sample>();
        const COLORREF BLUE = RGB(0, 90, 180);
        Panel track = {text("track"), DEGREES, {}, {{L"", BLUE, false, {}}}};
        Panel profile = {text("height_over_time"), LENGTH, {}, {{L"", BLUE, false, {}}}};
        previewed_ = app_.scene.text() + narrow(app_.folder());
        try {
            samples.open(app_.scene, app_.folder());
        } catch (const Refusal &refusal) {
            app_.say_line(refusal.sentence);
        }
        size_t every = samples.count / 3000 + 1;
        for (size_t k = 0; k < samples.count && samples.get(k, &sample) == SINS_OK; k += every) {
            track.x.push_back(sample.longitude_rad);
            track.traces[0].cells.push_back({sample.latitude_rad, sample.latitude_rad, sample.latitude_rad});
            profile.x.push_back(sample.time_s - samples.start_s);
            profile.traces[0].cells.push_back({sample.height_m, sample.height_m, sample.height_m});
        }
        track_.show({track}, DEGREES, false);
        profile_.show({profile}, DURATION, false);
    }

    void set_source(int source)
    {
        Scene &scene = app_.scene;
        if (source == 0) {
            /* The paper's simulations are scenes with the flight of another. */
            std::string name = narrow(get(IDC_BUILTIN)), other = Scene(name).words(SINS_SCENE_TEXT_BUILTIN);
            scene.set_text(SINS_SCENE_TEXT_BUILTIN, other.empty() ? name : other);
        } else if (source == 1) {
            make_manoeuvres();
        } else {
            fs::path path = ask_file(window_, false, "filter_log", L"csv"),
                     seen = path.lexically_relative(app_.folder());
            bool is_below = !seen.empty() && *seen.begin() != L".."; /* then as seen from the scene */
            if (!path.empty()) {
                scene.set_text(SINS_SCENE_TEXT_LOG, narrow(is_below ? seen : path));
            }
        }
        app_.edited(L"");
    }

    /* A built-in flight becomes manoeuvres that can be edited; a log the default flight. */
    void make_manoeuvres()
    {
        std::vector<sins_manoeuvre> manoeuvres(4096, sized<sins_manoeuvre>());
        sins_flight_start start = sized<sins_flight_start>();
        size_t count = 0, repeat = 1;
        Scene rest, &scene = app_.scene;
        sins_scene *from = scene.setup().flight == SINS_SCENE_FLIGHT_LOG ? rest.handle() : scene.handle(),
                   *to = scene.handle();
        ::check(lib.sins_scene_get_manoeuvres(from, &start, manoeuvres.data(), 4096, &count, &repeat));
        scene.taken(lib.sins_scene_set_manoeuvres(to, &start, manoeuvres.data(), count, repeat));
    }

    /* Adds, edits, moves or removes a manoeuvre. */
    void edit(int id)
    {
        Items all = app_.scene.list("manoeuvre");
        size_t row = selected(IDC_MANOEUVRES), next = row + (id == IDC_DOWN) - (id == IDC_UP);
        if (id == IDC_ADD) {
            next = row < all.size() ? row + 1 : all.size();
            all.insert(all.begin() + next,
                       {"manoeuvre", {{"kind", "\"straight\""}, {"duration_s", "60"}}, {}});
        } else if (row >= all.size() || next >= all.size()) {
            return;
        } else if (id == IDC_REMOVE) {
            all.erase(all.begin() + row);
        } else {
            std::swap(all[row], all[next]);
        }
        bool is_edited = id == IDC_ADD || id == IDC_EDIT;
        if (!is_edited || edit_manoeuvre(app_, all, next)) {
            app_.edited(is_edited ? L"" : told(app_.scene.set_list("manoeuvre", all)));
        }
        select(IDC_MANOEUVRES, next);
    }

    Plot track_, profile_;
    std::string previewed_; /* the scene that the preview shows */
};

Page *trajectory_page(App &app)
{
    return new TrajectoryPage(app);
}
