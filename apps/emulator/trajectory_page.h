/* Initial conditions of the trajectory: panel (a) of the paper's figure 2. */
#pragma once
#include "items.h"

class TrajectoryPage : public Page {
public:
    using Page::Page;

    void refresh(bool all_is_new) override {
        const int kind = source(), flight = scene_.setup().flight;
        bool is_path = kind == MANOEUVRES, is_log = kind == LOG;
        std::wstring builtin = wide(scene_.text(SINS_SCENE_TEXT_BUILTIN));
        if (flight != SINS_SCENE_FLIGHT_BUILTIN) {
            Page::refresh(all_is_new);
        } else { /* the start of the built-in flight */
            Scene same(scene_);
            make_manoeuvres(same);
            load(all_is_new, same);
        }
        choose(IDC_SOURCE, kind);
        load_live(all_is_new);
        if (!builtin.empty() && (all_is_new || wide(flight_of(this->builtin())) != builtin)) /* two scenes may have one flight */
            choose(IDC_BUILTIN, std::find(builtins_.begin(), builtins_.end(), builtin) - builtins_.begin());
        enable_fields("flight.", is_path);
        enable_fields("flight.title", true);
        enable_fields("flight.file", is_log);
        enable(IDC_BROWSE, is_log);
        enable(IDC_BUILTIN, kind == BUILTIN);
        enable(IDC_PORT, document_.is_live);
        enable(IDC_RATE, kind == LIVE_NATIVE);
        for (int id = IDC_ITEMS; id <= IDC_DOWN; id++)
            enable(id, is_path);
        rows(IDC_ITEMS, rows_of(scene_, "manoeuvre"));
        if (previewed_ != preview_key())
            preview();
    }

protected:
    void on_init() override {
        fill(item(IDC_SOURCE), parts("sources"));
        Texts names;
        for (const std::wstring &name : builtins_)
            names.push_back(label("builtin." + narrow(name), narrow(name)));
        fill(item(IDC_BUILTIN), names);
        for (int id : {IDC_PORT, IDC_RATE})
            SendMessageW(item(id), EM_SETCUEBANNER, FALSE, (LPARAM)shown(live_field(id).otherwise, 6).c_str());
        track_.attach(item(IDC_TRACK));
        profile_.attach(item(IDC_PROFILE));
    }

    void on_command(int id, int code) override {
        if (id == IDC_SOURCE)
            on_source(code);
        else if (code == CBN_SELCHANGE && id == IDC_BUILTIN)
            set_source(BUILTIN);
        else if (code == EN_KILLFOCUS && (id == IDC_PORT || id == IDC_RATE))
            set_live(id);
        else if (id == IDC_BROWSE)
            set_source(LOG);
        else if (id == IDC_TAKE)
            document_.open_builtin(builtin());
        else if (id >= IDC_ADD && id <= IDC_DOWN)
            edit(id);
        else if (id == IDC_ITEMS && code == (int)NM_DBLCLK)
            edit(IDC_EDIT);
    }

private:
    /* Sources of a flight, in the order of the text "sources": built-in flights first, like in the paper. */
    enum Source { BUILTIN, MANOEUVRES, LOG, LIVE_NATIVE, LIVE_LINES };

    Source source() const {
        int flight = scene_.setup().flight;
        if (document_.is_live)
            return document_.live_source.has_time ? LIVE_LINES : LIVE_NATIVE;
        return flight == SINS_SCENE_FLIGHT_LOG ? LOG : flight == SINS_SCENE_FLIGHT_MANOEUVRES ? MANOEUVRES : BUILTIN;
    }

    /* Arrow keys pass over the sources and change nothing: the one at which they stop is taken when the list loses the focus. */
    void on_source(int code) {
        static const int KEYS[] = {VK_UP, VK_DOWN, VK_LEFT, VK_RIGHT, VK_PRIOR, VK_NEXT, VK_HOME, VK_END};
        const bool by_key = std::any_of(std::begin(KEYS), std::end(KEYS), [](int key) { return GetKeyState(key) < 0; });
        const Source wanted = (Source)chosen(IDC_SOURCE);
        if (code == CBN_SELCHANGE)
            passes_ = by_key;
        if ((code == CBN_SELCHANGE && !by_key) || (code == CBN_KILLFOCUS && std::exchange(passes_, false) && wanted != source()))
            set_source(wanted);
    }

    /* A field of the packets: its meaning, its limits, and its default, which an empty field has. */
    struct LiveField {
        std::wstring name;
        double least, most, otherwise;
    };

    static LiveField live_field(int id) {
        const Key &rate = *key_of("flight.rate_hz");
        if (id == IDC_PORT)
            return {text("live_port"), 1, 65535, (double)LiveSource().port};
        return {text("live_rate"), rate.minimum, rate.maximum, LiveSource().rate_hz};
    }

    /* Shows port and rate. Marked input stays, unless all is new. */
    void load_live(bool all_is_new) {
        for (int id : {IDC_PORT, IDC_RATE}) {
            if (marked_.count(item(id)) != 0 && !all_is_new)
                continue;
            const LiveField field = live_field(id);
            mark(item(id), false);
            tip(item(id), field.name + L"\n" + text("range", {shown(field.least, 6), shown(field.most, 6)}));
            set(id, live_text(id));
        }
    }

    std::wstring live_text(int id) const {
        double value = id == IDC_PORT ? document_.live_source.port : document_.live_source.rate_hz;
        return value == live_field(id).otherwise ? L"" : shown(value, 15);
    }

    /* Takes port or rate from its field. */
    void set_live(int id) {
        const LiveField field = live_field(id);
        double value = field.otherwise;
        if (get(id) == live_text(id) && marked_.count(item(id)) == 0)
            return;
        bool is_valid = get(id).empty() || number_of(narrow(get(id)), value);
        is_valid = is_valid && value >= field.least && value <= field.most && (id != IDC_PORT || value == std::round(value));
        mark(item(id), !is_valid);
        if (is_valid && id == IDC_PORT)
            document_.live_source.port = (int)value;
        else if (is_valid)
            document_.live_source.rate_hz = value;
        const char *limits = id == IDC_PORT ? "whole_limits" : "limits";
        const std::wstring fault = text(limits, {field.name, get(id), shown(field.least, 6), shown(field.most, 6)});
        document_.edited(is_valid ? L"" : fault);
        if (!is_valid)
            tip(item(id), fault);
    }

    /* The built-in scene whose flight a built-in scene uses: the paper's simulations fly a patrol. */
    static std::string flight_of(const std::string &builtin) {
        std::string other = sins::Scene::builtin(builtin).text(SINS_SCENE_TEXT_BUILTIN);
        return other.empty() ? builtin : other;
    }

    std::string builtin() const { return narrow(builtins_[chosen(IDC_BUILTIN)]); } /* the selected scene */

    std::string preview_key() const { return scene_.write() + narrow(document_.folder()) + (document_.is_live ? "live" : ""); }

    /* Draws the ground track and the height of the flight from at most 3000 samples. */
    void preview() {
        const COLORREF BLUE = RGB(0, 90, 180);
        Panel track = {text("track"), DEGREES, {}, {{L"", BLUE, false, {}}}};
        Panel profile = {text("height_over_time"), LENGTH, {}, {{L"", BLUE, false, {}}}};
        previewed_ = preview_key();
        try {
            Samples samples = document_.is_live ? Samples() : Samples(scene_, document_.folder());
            if (document_.is_live) /* not known before */
                samples.all.count = 0;
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

    void set_source(Source source) {
        document_.is_live = source == LIVE_NATIVE || source == LIVE_LINES || (document_.is_live && source == LOG);
        if (source == LIVE_NATIVE || source == LIVE_LINES) {
            document_.live_source.has_time = source == LIVE_LINES;
            document_.edited(L"");
        } else if (source == BUILTIN) {
            document_.edited(told(scene_.set({{"flight.builtin", flight_of(builtin())}})));
        } else if (source == MANOEUVRES) {
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
    bool passes_ = false;   /* whether arrow keys pass over the sources */
};
