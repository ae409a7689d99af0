/* General parameters, and every effect of the sensors and their surroundings: panel (b) of the paper's
 * figure 2. */
#include "app.h"

/* Sections of the list, in the order of the text "sections". */
static const char *const SECTIONS[] = {"gyro",  "accelerometer", "altimeter", "gravity", "mounting",
                                       "start", "options",       "flight",    "output"};

class GeneralPage : public Page {
public:
    using Page::Page;

    void refresh(bool all_is_new) override
    {
        std::string own = section();
        bool is_other = effects_.empty() || effects_[0]->section != own;
        Rows lines;
        effects_.clear();
        enable(IDC_PRESET, own == "gyro" || own == "accelerometer");
        for (const Key &key : keys()) {
            if (key.section == own && key.name != "preset") {
                std::string value = app_.scene.get(key.path);
                bool is_off = value.empty();
                effects_.push_back(&key);
                lines.push_back({{label(key.path, key.doc), is_off ? text("off") : seen(key, value),
                                  wide(is_off ? "" : key.unit)},
                                 is_off});
            }
        }
        rows(IDC_EFFECTS, lines);
        if (is_other) {
            select(IDC_EFFECTS, 0);
        }
        choose_effect();
        Page::refresh(all_is_new);
        show_defaults();
    }

protected:
    void on_init() override
    {
        Texts grades = {text("preset")};
        for (const std::string &word : preset_.words) {
            grades.push_back(label("preset." + word, word));
        }
        fill(item(IDC_SECTION), parts("sections"));
        fill(item(IDC_PRESET), grades);
        columns(IDC_EFFECTS, "columns_effects", {0, 130, 90});
        grow({IDC_EFFECTS}, 0, 0, 1, 1);
        grow({IDC_EFFECT, IDC_WORD, IDC_UNIT, IDC_SAME, IDC_OFF}, 0, 1, 0, 0);
        for (int k = 0; k < 9; k++) {
            grow({IDC_VALUE + k}, 0, 1, 0, 0);
        }
    }

    void on_command(int id, int code) override
    {
        const Key *key = effect();
        if (id == IDC_SECTION && code == CBN_SELCHANGE) {
            si_path_ = "";
            refresh(true);
        } else if (id == IDC_PRESET && code == CBN_SELCHANGE && chosen(IDC_PRESET) > 0) {
            take_preset(preset_.words[chosen(IDC_PRESET) - 1]);
        } else if (id == IDC_UNIT && code == CBN_SELCHANGE && key != NULL) {
            si_path_ = chosen(IDC_UNIT) == 1 ? key->path : "";
            refresh(true);
        } else if (id == IDC_OFF && key != NULL) {
            unbind_values();
            app_.edited(mark_faults(app_.scene.change({{key->path, "", 0, false}})));
        }
    }

    /* One number for all axes: the first field speaks for all. */
    void on_change(int id, int code) override
    {
        const Key *key = effect();
        if (key != NULL && id >= IDC_VALUE && id < IDC_VALUE + 9 && key->count > 1 && checked(IDC_SAME)) {
            std::wstring typed = get(id);
            for (size_t k = 0; k < key->count; k++) {
                set(IDC_VALUE + k, key->single_sets(k) ? typed : L"");
            }
        }
        Page::on_change(id, code);
    }

    void on_notify(NMHDR *notice) override
    {
        bool is_selection = notice->idFrom == IDC_EFFECTS && notice->code == (UINT)LVN_ITEMCHANGED;
        if (is_selection && (((NMLISTVIEW *)notice)->uNewState & LVIS_SELECTED) != 0) {
            si_path_ = "";
            unbind_values();
            choose_effect();
            Page::refresh(false);
        }
    }

private:
    std::string section() const { return SECTIONS[chosen(IDC_SECTION)]; }

    const Key *effect() const
    {
        size_t row = selected(IDC_EFFECTS);
        return row < effects_.size() ? effects_[row] : NULL;
    }

    /* A value as the list shows it: a word, one number, or the elements. */
    static std::wstring seen(const Key &key, const std::string &value)
    {
        double number;
        std::wstring list;
        if (key.count == 0) {
            return key.is_text() ? wide(unquoted(value)) : key.word_label(unquoted(value));
        }
        for (const std::string &element : value[0] == '[' ? numbers(value, key) : std::vector(1, value)) {
            bool is_number = number_of(element, number);
            list += (list.empty() ? L"" : L", ") + (is_number         ? shown(number, 12)
                                                    : element.empty() ? L"0"
                                                                      : wide(element));
        }
        return list;
    }

    /* What the simulator takes where the scene says nothing. */
    void show_defaults()
    {
        sins_scene_setup setup = app_.scene.setup();
        Handle<sins_sim> sim;
        sins_options options = sized<sins_options>();
        cue("flight.rate_hz", shown(setup.rate_hz, 6));
        cue("flight.hours", shown(setup.flown_s / 3600, 6));
        if (lib.sins_scene_create_simulator(app_.scene.handle(), &sim) == SINS_OK &&
            lib.sins_get_options(sim, &options) == SINS_OK) {
            cue("options.subsamples", std::to_wstring(options.subsamples));
            cue("options.updates_per_sample", std::to_wstring(options.updates_per_sample));
        }
    }

    void unbind_values()
    {
        for (int k = 0; k < 9; k++) {
            unbind(item(IDC_VALUE + k));
        }
        unbind(item(IDC_WORD));
    }

    /* The fields of the effect that is chosen in the list: one, three or nine, or a word. */
    void choose_effect()
    {
        const Key *key = effect();
        if (key == NULL) {
            return;
        }
        bool is_word = !key->words.empty();
        Texts units = {wide(key->unit), key->si_unit()};
        units.resize(key->si_name.empty() ? 1 : 2);
        set(IDC_EFFECT, label(key->path, key->doc));
        for (size_t k = 0; k < 9; k++) {
            bool is_used = !is_word && k < max((size_t)1, key->count);
            show(IDC_VALUE + k, is_used);
            if (is_used) {
                bind(item(IDC_VALUE + k), key->path, k);
            }
        }
        if (is_word) {
            bind(item(IDC_WORD), key->path);
        }
        show(IDC_WORD, is_word);
        show(IDC_UNIT, !is_word && !key->unit.empty());
        show(IDC_SAME, key->count > 1);
        check(IDC_SAME, !app_.scene.get(key->path).starts_with("["));
        fill(item(IDC_UNIT), units);
        choose(IDC_UNIT, si_path_ == key->path ? 1 : 0);
    }

    void take_preset(const std::string &word)
    {
        Items items = app_.scene.items();
        std::string own = section();
        std::erase_if(items, [&](const Item &item) { return item.section == own; });
        items.push_back({own, {{"preset", in_quotes(word)}}, {}});
        choose(IDC_PRESET, 0);
        app_.edited(told(app_.scene.read(items)));
    }

    const Key &preset_ = *key_of("gyro.preset");
    std::vector<const Key *> effects_;
};

Page *general_page(App &app)
{
    return new GeneralPage(app);
}
