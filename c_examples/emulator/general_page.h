/* General parameters, and every effect of the sensors and their surroundings: panel (b) of the paper's
 * figure 2. */
#pragma once
#include "document.h"

class GeneralPage : public Page {
public:
    using Page::Page;

    void refresh(bool all_is_new) override {
        bool is_other = effects_.empty() || effects_[0]->section != section();
        Rows lines;
        effects_.clear();
        enable(IDC_PRESET, section() == "gyro" || section() == "accelerometer");
        for (const Key &key : keys()) {
            if (key.section == section() && key.name != std::string("preset")) {
                std::string value = scene_.get(key.path());
                bool is_off = value == key.default_value;
                effects_.push_back(&key);
                lines.push_back(
                    {{key.meaning(), is_off ? text("off") : seen(key, value), wide(is_off ? "" : key.unit)}, is_off});
            }
        }
        rows(IDC_EFFECTS, lines);
        if (is_other)
            select(IDC_EFFECTS, 0);
        choose_effect();
        load(all_is_new);
        std::wstring whole = shown(scene_->setup().flown_s / 3600, 6);
        SendMessageW(item(IDC_HOURS), EM_SETCUEBANNER, FALSE, (LPARAM)whole.c_str());
    }

protected:
    void on_init() override {
        Texts grades = {text("preset")};
        for (const std::string &word : grades_)
            grades.push_back(label("preset." + word, word));
        fill(item(IDC_SECTION), parts("sections"));
        fill(item(IDC_PRESET), grades);
    }

    void on_command(int id, int code) override {
        const Key *key = effect();
        if (id == IDC_SECTION && code == CBN_SELCHANGE) {
            is_in_si_ = false;
            refresh(true);
        } else if (id == IDC_PRESET && code == CBN_SELCHANGE && chosen(IDC_PRESET) > 0) {
            change(section() + ".preset", grades_[chosen(IDC_PRESET) - 1]);
            choose(IDC_PRESET, 0);
        } else if (id == IDC_UNIT && code == CBN_SELCHANGE) {
            is_in_si_ = chosen(IDC_UNIT) == 1;
            refresh(true);
        } else if (id == IDC_OFF && key != NULL) {
            change(key->path(), "");
        }
    }

    /* One number for all axes: the field speaks for all. */
    void on_change(int id, int code) override {
        if (id >= IDC_VALUE && id < IDC_VALUE + 9 && checked(IDC_SAME) && !changes().empty()) {
            const Key &key = *effect();
            change(is_in_si_ ? std::string(key.section) + "." + key.si_name : key.path(), narrow(get(id)));
        } else {
            Page::on_change(id, code);
        }
    }

    void on_notify(NMHDR *notice) override {
        bool is_selection = notice->idFrom == IDC_EFFECTS && notice->code == (UINT)LVN_ITEMCHANGED;
        if (is_selection && (((NMLISTVIEW *)notice)->uNewState & LVIS_SELECTED) != 0) {
            is_in_si_ = false;
            choose_effect();
            load(false);
        }
    }

private:
    std::string section() const {
        /* In the order of the text "sections". */
        static const char *const SECTIONS[] = {"gyro",  "accelerometer", "altimeter", "gravity", "mounting",
                                               "start", "options",       "flight",    "output"};
        return SECTIONS[chosen(IDC_SECTION)];
    }

    const Key *effect() const {
        size_t row = selected(IDC_EFFECTS);
        return row < effects_.size() ? effects_[row] : NULL;
    }

    void change(const std::string &path, const std::string &value) {
        document_.edited(mark_faults(scene_.set({{path, value}})));
    }

    /* A value as the list shows it: a word, a text, or numbers. */
    static std::wstring seen(const Key &key, const std::string &value) {
        double number;
        std::wstring list;
        if (!key.is_number())
            return key.is_choice() ? key.word_label(unquoted(value)) : wide(unquoted(value));
        for (const std::string &element : split(std::regex_replace(value, std::regex("[\\[\\]]"), ""), ", ")) {
            list += list.empty() ? L"" : L", ";
            list += number_of(element, number) ? shown(number, 12) : wide(element);
        }
        return list;
    }

    /* The fields of the effect that is chosen in the list: one, three or nine, or a word. */
    void choose_effect() {
        const Key *key = effect();
        if (key == NULL)
            return;
        bool is_choice = key->is_choice();
        Texts units = {wide(key->unit)};
        set(IDC_EFFECT, key->meaning());
        unbind(item(IDC_WORD));
        for (int k = 0; k < 9; k++) {
            bool is_used = !is_choice && k < max(1, key->elements);
            show(IDC_VALUE + k, is_used);
            if (is_used)
                bind(item(IDC_VALUE + k), key->elements > 1 ? Scene::place(key->path(), k) : key->path(), is_in_si_);
            else
                unbind(item(IDC_VALUE + k));
        }
        if (is_choice)
            bind(item(IDC_WORD), key->path());
        if (*key->si_name)
            units.push_back(wide(key->si_unit));
        show(IDC_WORD, is_choice);
        show(IDC_UNIT, *key->unit);
        show(IDC_SAME, key->spread != 0 && key->elements > 1);
        check(IDC_SAME, key->spread != 0 && key->elements > 1 && !scene_.get(key->path()).starts_with("["));
        fill(item(IDC_UNIT), units);
        choose(IDC_UNIT, is_in_si_);
    }

    const std::vector<std::string> grades_ = key_of("gyro.preset")->choices();
    std::vector<const Key *> effects_;
    bool is_in_si_ = false; /* the fields of the effect */
};
