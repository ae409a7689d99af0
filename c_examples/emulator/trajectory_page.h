/* Initial conditions of the trajectory: panel (a) of the paper's figure 2. */
#pragma once
#include "items.h"

class TrajectoryPage : public Page {
public:
    using Page::Page;

    void refresh(bool all_is_new) override {
        int source = scene_.setup().flight;
        bool is_path = source == SINS_SCENE_FLIGHT_MANOEUVRES, is_log = source == SINS_SCENE_FLIGHT_LOG;
        std::wstring builtin = wide(scene_.text(SINS_SCENE_TEXT_BUILTIN));
        if (is_path || is_log) {
            Page::refresh(all_is_new);
        } else { /* the start of the built-in flight */
            Scene same(scene_);
            make_manoeuvres(same);
            load(all_is_new, same);
        }
        choose(IDC_SOURCE, std::find(SOURCES, std::end(SOURCES), source) - SOURCES);
        if (!builtin.empty())
            choose(IDC_BUILTIN, std::find(builtins_.begin(), builtins_.end(), builtin) - builtins_.begin());
        enable_fields("flight.", is_path);
        enable_fields("flight.title", true);
        enable_fields("flight.file", is_log);
        enable(IDC_BROWSE, is_log);
        enable(IDC_BUILTIN, !is_path && !is_log);
        for (int id = IDC_ITEMS; id <= IDC_DOWN; id++)
            enable(id, is_path);
        rows(IDC_ITEMS, rows_of(scene_, "manoeuvre"));
        if (previewed_ != scene_.write() + narrow(document_.folder()))
            preview();
    }

protected:
    void on_init() override {
        fill(item(IDC_SOURCE), parts("sources"));
        Texts names;
        for (const std::wstring &name : builtins_)
            names.push_back(label("builtin." + narrow(name), narrow(name)));
        fill(item(IDC_BUILTIN), names);
        track_.attach(item(IDC_TRACK));
        profile_.attach(item(IDC_PROFILE));
    }

    void on_command(int id, int code) override {
        if (code == CBN_SELCHANGE && id == IDC_SOURCE)
            set_source(SOURCES[chosen(IDC_SOURCE)]);
        else if (code == CBN_SELCHANGE && id == IDC_BUILTIN)
            set_source(SINS_SCENE_FLIGHT_BUILTIN);
        else if (id == IDC_BROWSE)
            set_source(SINS_SCENE_FLIGHT_LOG);
        else if (id == IDC_TAKE)
            document_.open_builtin(builtin());
        else if (id >= IDC_ADD && id <= IDC_DOWN)
            edit(id);
        else if (id == IDC_ITEMS && code == (int)NM_DBLCLK)
            edit(IDC_EDIT);
    }

private:
    /* Sources of a flight, in the order of the text "sources": built-in flights first, like in the paper. */
    static constexpr int SOURCES[] = {SINS_SCENE_FLIGHT_BUILTIN, SINS_SCENE_FLIGHT_MANOEUVRES, SINS_SCENE_FLIGHT_LOG};

    std::string builtin() const { return narrow(builtins_[chosen(IDC_BUILTIN)]); } /* the selected scene */

    /* Draws the ground track and the height of the flight from at most 3000 samples. */
    void preview() {
        const COLORREF BLUE = RGB(0, 90, 180);
        Panel track = {text("track"), DEGREES, {}, {{L"", BLUE, false, {}}}};
        Panel profile = {text("height_over_time"), LENGTH, {}, {{L"", BLUE, false, {}}}};
        previewed_ = scene_.write() + narrow(document_.folder());
        try {
            Samples samples(scene_, document_.folder());
            for (size_t k = 0; k < samples.all.count; k += samples.all.count / 3000 + 1) {
                sins_flight_sample sample = samples.get(k);
                track.x.push_back(Cell(sample.longitude_rad));
                track.traces[0].cells.push_back(Cell(sample.latitude_rad));
                profile.x.push_back(Cell(sample.time_s - samples.all.start_s));
                profile.traces[0].cells.push_back(Cell(sample.height_m));
            }
        } catch (const std::exception &error) {
            document_.say_line(told(error));
        }
        track_.show({track}, DEGREES, false);
        profile_.show({profile}, DURATION, false);
    }

    void set_source(int source) {
        if (source == SINS_SCENE_FLIGHT_BUILTIN) {
            /* The paper's simulations are scenes that use the flight of another scene. */
            std::string name = builtin();
            std::string other = sins::Scene::builtin(name).text(SINS_SCENE_TEXT_BUILTIN);
            document_.edited(told(scene_.set({{"flight.builtin", other.empty() ? name : other}})));
        } else if (source == SINS_SCENE_FLIGHT_MANOEUVRES) {
            make_manoeuvres(scene_);
            document_.edited(L"");
        } else {
            fs::path path = ask_file(window_, false, "filter_log", L"csv");
            if (path.empty())
                document_.edited(L"");
            else
                document_.fly_log(path);
        }
    }

    /* Changes a built-in flight into manoeuvres that can be edited, and a log into the default flight. */
    static void make_manoeuvres(Scene &scene) {
        sins_flight_start start = sins::make<sins_flight_start>();
        size_t repeat = 1;
        bool is_log = scene.setup().flight == SINS_SCENE_FLIGHT_LOG;
        std::vector<sins_manoeuvre> all = (is_log ? Scene() : scene).manoeuvres(start, repeat);
        scene.set_manoeuvres(start, all, repeat);
    }

    /* Adds, edits, moves or removes a manoeuvre. */
    void edit(int id) {
        Scene draft(scene_);
        std::vector<std::string> all = scene_.items("manoeuvre");
        size_t row = min(selected(IDC_ITEMS), all.size()), next = row;
        if (id == IDC_ADD) {
            next = row < all.size() ? row + 1 : row;
            all.insert(all.begin() + next, "[[manoeuvre]]\nkind = \"straight\"\nduration_s = 60\n");
        } else if (row == all.size()) {
            return;
        } else if (id == IDC_REMOVE) {
            all.erase(all.begin() + row);
        } else if (id != IDC_EDIT) {
            next = id == IDC_UP ? max(row, (size_t)1) - 1 : min(row + 1, all.size() - 1);
            std::swap(all[row], all[next]);
        }
        Faults faults = draft.set_items("manoeuvre", all);
        bool is_edited = faults.empty() && (id == IDC_ADD || id == IDC_EDIT);
        HWND owner = GetAncestor(window_, GA_ROOT);
        if (!is_edited || ManoeuvreDialog(draft, next).modal(owner, IDD_MANOEUVRE) == IDOK) {
            scene_ = std::move(draft);
            document_.edited(told(faults));
            select(IDC_ITEMS, next);
        }
    }

    const Texts builtins_ = Document::builtins(); /* names of scenes; the list shows them in the user's language */
    Plot track_, profile_;
    std::string previewed_; /* the scene that the preview shows */
};
