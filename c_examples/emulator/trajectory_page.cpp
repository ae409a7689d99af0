/* Initial conditions of the trajectory: panel (a) of the paper's figure 2. */
#include "app.h"

class TrajectoryPage : public Page {
public:
    using Page::Page;

    void refresh(bool all_is_new) override
    {
        int source = app_.scene.setup().flight;
        bool is_path = source == SINS_SCENE_FLIGHT_MANOEUVRES, is_log = source == SINS_SCENE_FLIGHT_LOG;
        std::wstring builtin = wide(app_.scene.words(SINS_SCENE_TEXT_BUILTIN));
        std::vector<Texts> lines;
        Page::refresh(all_is_new);
        choose(IDC_SOURCE, is_path  ? 1
                           : is_log ? 2
                                    : 0); /* built-in flights first, as the paper's simulations are */
        if (!builtin.empty()) {
            SendMessageW(item(IDC_BUILTIN), CB_SELECTSTRING, (WPARAM)-1, (LPARAM)builtin.c_str());
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
            lines.push_back({std::to_wstring(lines.size() + 1), words[0], words[1]});
        }
        rows(IDC_MANOEUVRES, lines);
        preview();
    }

protected:
    void on_init() override
    {
        cue("flight.repeat", L"1");
        fill(item(IDC_SOURCE), parts("sources"));
        fill(item(IDC_BUILTIN), app_.builtins());
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
        std::wstring why, seen = wide(app_.scene.text()) + app_.folder();
        const COLORREF BLUE = RGB(0, 90, 180);
        if (seen == previewed_) {
            return;
        }
        previewed_ = seen;
        Panel track = {text("track"), DEGREES, {}, {{L"", BLUE, false, {}}}};
        Panel profile = {text("height_over_time"), LENGTH, {}, {{L"", BLUE, false, {}}}};
        if (!samples.open(app_.scene, app_.folder(), why)) {
            app_.say_line(why);
        }
        sins_flight_sample sample = sized<sins_flight_sample>();
        for (size_t k = 0; k < samples.count && samples.get(k, &sample) == SINS_OK;
             k += samples.count / 3000 + 1) {
            track.x.push_back(sample.longitude_rad);
            track.traces[0].cells.push_back({sample.latitude_rad, sample.latitude_rad, sample.latitude_rad});
            profile.x.push_back(sample.time_s - samples.start_s);
            profile.traces[0].cells.push_back({sample.height_m, sample.height_m, sample.height_m});
        }
        track_.show({track}, DEGREES, false, label("plot.longitude", "longitude"));
        profile_.show({profile}, DURATION, false, text("time"));
    }

    void set_source(int source)
    {
        Scene &scene = app_.scene;
        if (source == 0) {
            /* The paper's simulations are scenes with the flight of another. */
            std::string name = narrow(get(IDC_BUILTIN)), other = Scene(name).words(SINS_SCENE_TEXT_BUILTIN);
            app_.edited(scene.set_text(SINS_SCENE_TEXT_BUILTIN, other.empty() ? name : other));
        } else if (source == 1) {
            app_.edited(make_manoeuvres());
        } else {
            std::wstring path = ask_file(window_, false, "filter_log", L"csv"), folder = app_.folder();
            if (!folder.empty() && path.compare(0, folder.size(), folder) == 0) {
                path = path.substr(folder.size()); /* as seen from the scene */
            }
            app_.edited(path.empty() ? L"" : scene.set_text(SINS_SCENE_TEXT_LOG, narrow(path)));
        }
    }

    /* A built-in flight becomes manoeuvres that can be edited; a log the default flight. */
    std::wstring make_manoeuvres()
    {
        std::vector<sins_manoeuvre> manoeuvres(4096, sized<sins_manoeuvre>());
        sins_flight_start start = sized<sins_flight_start>();
        size_t count = 0, repeat = 1;
        Scene rest, &scene = app_.scene;
        sins_scene *from = scene.setup().flight == SINS_SCENE_FLIGHT_LOG ? rest.handle() : scene.handle();
        sins_status status =
            lib.sins_scene_get_manoeuvres(from, &start, manoeuvres.data(), 4096, &count, &repeat);
        return scene.taken(status < 0 ? status
                                      : lib.sins_scene_set_manoeuvres(scene.handle(), &start,
                                                                      manoeuvres.data(), count, repeat));
    }

    /* Adds, edits, moves or removes a manoeuvre. */
    void edit(int id)
    {
        Items all = app_.scene.list("manoeuvre");
        size_t row = (size_t)selected(IDC_MANOEUVRES), next = id == IDC_UP     ? row - 1
                                                              : id == IDC_DOWN ? row + 1
                                                                               : row;
        if (id == IDC_ADD) {
            next = row < all.size() ? row + 1 : all.size();
            Item fresh = {"manoeuvre", {{"kind", "\"straight\""}, {"duration_s", "60"}}, {}};
            all.insert(all.begin() + (ptrdiff_t)next, fresh);
        } else if (row >= all.size() || next >= all.size()) {
            return;
        } else if (id == IDC_REMOVE) {
            all.erase(all.begin() + (ptrdiff_t)row);
        } else {
            std::swap(all[row], all[next]);
        }
        if (id != IDC_ADD && id != IDC_EDIT) {
            app_.edited(told(app_.scene.set_list("manoeuvre", all)));
        } else if (edit_manoeuvre(app_, all, next)) {
            app_.edited(L"");
        }
        select(IDC_MANOEUVRES, next);
    }

    Plot track_, profile_;
    std::wstring previewed_; /* the scene that the preview shows */
};

Page *trajectory_page(App &app)
{
    return new TrajectoryPage(app);
}
