/* General parameters, and every effect of the sensors and their surroundings: panel (b) of the paper's figure 2. */
#include "app.h"

/* Sections of the list, in the order of IDS_SECTIONS. */
static const char *const SECTIONS[] = {"gyro", "accelerometer", "altimeter", "gravity", "mounting", "start", "options", "flight", "output"};

static std::vector<Field> general_fields()
{
    return {{IDC_RATE, "flight.rate_hz", 0}, {IDC_HOURS, "flight.hours", 0}, {IDC_EARTH, "options.earth", 0},
            {IDC_GRAVITY, "options.gravity", 0}, {IDC_SCHEME, "options.scheme", 0}, {IDC_FRAME, "options.frame", 0},
            {IDC_SUBSAMPLES, "options.subsamples", 0}, {IDC_UPDATES, "options.updates_per_sample", 0},
            {IDC_VERTICAL, "options.vertical", 0}, {IDC_MODEL, "options.error_model", 0}, {IDC_SIGNAL, "options.signal", 0},
            {IDC_AXES, "options.axes", 0}, {IDC_SEED, "options.seed", 0}, {IDC_RUN, "options.run", 0}};
}

void GeneralPage::on_init()
{
    exchange(general_fields());
    fill(IDC_SECTION, parts(IDS_SECTIONS));
    std::vector<std::wstring> grades = {text(IDS_PRESET)};
    for (const std::string &word : key_of("gyro.preset")->words) {
        grades.push_back(label("preset." + word, word));
    }
    fill(IDC_PRESET, grades);
    columns(IDC_EFFECTS, parts(IDS_COLUMNS_EFFECTS), {252, 150, 90});
    grow(IDC_EFFECTS, 0, 0, 1, 1);
    for (int id : {IDC_EFFECT, IDC_WORD, IDC_UNIT, IDC_SAME, IDC_OFF}) {
        grow(id, 0, 1, 0, 0);
    }
    for (int id = IDC_VALUE; id < IDC_VALUE + 9; id++) {
        grow(id, 0, 1, 0, 0);
    }
}

std::string GeneralPage::section() const
{
    return SECTIONS[max(0, chosen(IDC_SECTION))];
}

const Key *GeneralPage::effect() const
{
    size_t row = (size_t)selected(IDC_EFFECTS);
    return row < effects_.size() ? effects_[row] : NULL;
}

void GeneralPage::refresh(bool all_is_new)
{
    std::string own = section();
    bool is_other = effects_.empty() || effects_[0]->section != own;
    int count = 0;
    effects_.clear();
    enable(IDC_PRESET, own == "gyro" || own == "accelerometer");
    for (const Key &key : keys()) {
        if (key.section != own || key.name == "preset") {
            continue;
        }
        std::string value = unquoted(app_.scene.get(key.path())), list;
        double number;
        if (key.count > 0 && !value.empty()) {
            for (const std::string &element : numbers(value, key)) {
                list += (list.empty() ? "" : ", ") + (number_of(element, number) ? narrow(shown(number, 12)) : element.empty() ? "0" : element);
            }
            value = value[0] == '[' ? list : number_of(value, number) ? narrow(shown(number, 12)) : value;
        }
        std::wstring seen = value.empty() ? text(IDS_OFF) : key.words.empty() ? wide(value) : label(key.path() + "." + value, value);
        effects_.push_back(&key);
        row(IDC_EFFECTS, count++, {label(key.path(), key.doc), seen, value.empty() ? L"" : wide(key.unit)});
    }
    keep_rows(IDC_EFFECTS, count);
    if (is_other) {
        select(IDC_EFFECTS, 0);
    }
    choose_effect();
    Page::refresh(all_is_new);
    sins_scene_setup setup = app_.scene.setup();
    cue(IDC_RATE, shown(setup.rate_hz, 6));
    cue(IDC_HOURS, shown(setup.flown_s / 3600, 6));
    Handle<sins_sim> sim;
    sins_options options;
    SINS_INIT(options);
    if (lib.sins_scene_create_simulator(app_.scene.handle(), &sim) == SINS_OK && lib.sins_get_options(sim, &options) == SINS_OK) {
        cue(IDC_SUBSAMPLES, std::to_wstring(options.subsamples));
        cue(IDC_UPDATES, std::to_wstring(options.updates_per_sample));
    }
}

/* The fields of the effect that is chosen in the list: one, three or nine. */
void GeneralPage::choose_effect()
{
    const Key *key = effect();
    std::vector<Field> fields = general_fields();
    if (key == NULL) {
        return;
    }
    bool is_word = !key->words.empty();
    int count = is_word ? 0 : max(1, key->count);
    std::string value = app_.scene.get(key->path());
    set(IDC_EFFECT, label(key->path(), key->doc));
    for (int k = 0; k < 9; k++) {
        show(IDC_VALUE + k, k < count);
        if (k < count) {
            fields.push_back({IDC_VALUE + k, key->path(), k});
        }
    }
    show(IDC_WORD, is_word);
    show(IDC_UNIT, !is_word && !key->unit.empty());
    show(IDC_SAME, key->count > 1);
    CheckDlgButton(window_, IDC_SAME, value.empty() || value[0] != '[' ? BST_CHECKED : BST_UNCHECKED);
    if (is_word) {
        fields.push_back({IDC_WORD, key->path(), 0});
    }
    std::vector<std::wstring> units = {wide(key->unit)};
    if (!key->si_name.empty()) {
        units.push_back(wide(key->si_unit()));
    }
    bool is_si = si_path_ == key->path();
    fill(IDC_UNIT, units);
    choose(IDC_UNIT, is_si ? 1 : 0);
    si_path_ = is_si ? si_path_ : "";
    for (int k = 0; k < 9; k++) {
        if (!has_faults() || !is_marked(IDC_VALUE + k)) {
            mark(IDC_VALUE + k, L"");
        }
    }
    exchange(fields);
}

/* One number for all axes: the first field speaks for all. */
void GeneralPage::before_store(int id)
{
    const Key *key = effect();
    if (key != NULL && id >= IDC_VALUE && id < IDC_VALUE + 9 && key->count > 1 && checked(IDC_SAME)) {
        std::wstring typed = get(id);
        for (int k = 0; k < key->count; k++) {
            set(IDC_VALUE + k, key->single_sets(k) ? typed : L"");
        }
    }
}

void GeneralPage::on_command(int id, int code)
{
    const Key *key = effect();
    if (id == IDC_SECTION && code == CBN_SELCHANGE) {
        si_path_ = "";
        refresh(true);
    } else if (id == IDC_PRESET && code == CBN_SELCHANGE && chosen(IDC_PRESET) > 0) {
        Items items = app_.scene.items();
        std::vector<Fault> faults;
        for (size_t k = items.size(); k-- > 0;) {
            if (items[k].section == section()) {
                items.erase(items.begin() + k);
            }
        }
        std::string word = key_of("gyro.preset")->words[(size_t)chosen(IDC_PRESET) - 1];
        items.push_back({section(), {{"preset", quoted(word)}}});
        app_.scene.read(items, faults);
        choose(IDC_PRESET, 0);
        app_.edited(faults.empty() ? L"" : wide(faults[0].sentence));
    } else if (id == IDC_UNIT && code == CBN_SELCHANGE && key != NULL) {
        si_path_ = chosen(IDC_UNIT) == 1 ? key->path() : "";
        refresh(true);
    } else if (id == IDC_OFF && key != NULL) {
        for (int k = 0; k < 9; k++) {
            mark(IDC_VALUE + k, L"");
        }
        app_.edited(mark_faults(app_.scene.change({{key->path(), "", false}})));
    } else {
        Page::on_command(id, code);
    }
}

void GeneralPage::on_notify(NMHDR *notice)
{
    if (notice->idFrom != IDC_EFFECTS) {
        return;
    }
    if (notice->code == (UINT)LVN_ITEMCHANGED && (((NMLISTVIEW *)notice)->uNewState & LVIS_SELECTED) != 0) {
        for (int k = 0; k < 9; k++) {
            mark(IDC_VALUE + k, L"");
        }
        si_path_ = "";
        choose_effect();
        load([this](const std::string &path) { return app_.scene.get(path); }, false);
    } else if (notice->code == (UINT)NM_CUSTOMDRAW) {
        /* What is off is grey. */
        NMLVCUSTOMDRAW *draw = (NMLVCUSTOMDRAW *)notice;
        LRESULT result = draw->nmcd.dwDrawStage == CDDS_PREPAINT ? CDRF_NOTIFYITEMDRAW : CDRF_DODEFAULT;
        if (draw->nmcd.dwDrawStage == CDDS_ITEMPREPAINT && draw->nmcd.dwItemSpec < effects_.size()) {
            bool is_off = app_.scene.get(effects_[draw->nmcd.dwItemSpec]->path()).empty();
            draw->clrText = is_off ? RGB(150, 150, 150) : RGB(0, 0, 0);
        }
        SetWindowLongPtrW(window_, DWLP_MSGRESULT, result);
    }
}
