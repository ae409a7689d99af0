/* General parameters, and every effect of the sensors and their surroundings: panel (b) of the paper's figure 2. */
#pragma once
#include "document.h"

class GeneralPage : public Page {
public:
    using Page::Page;

    void refresh(bool all_is_new) override {
        Rows lines;
        std::vector<const Key *> before = std::exchange(effects_, {});
        for (int id : {IDC_PRESET, IDC_APPLY})
            enable(id, section() == "gyro" || section() == "accelerometer" || section() == "start");
        for (const Key &key : keys()) {
            if (key.section == section() && key.name != std::string("preset")) {
                std::string value = scene_.get(key.path());
                bool is_off = value == key.default_value;
                effects_.push_back(&key);
                std::wstring unit = wide(is_off ? "" : key.unit);
                lines.push_back({{key.meaning(), is_off ? text("off") : seen(key, value), unit}, is_off});
            }
        }
        rows(IDC_EFFECTS, lines);
        if (effects_ != before)
            select(IDC_EFFECTS, 0);
        show_effect(all_is_new);
        if (all_is_new)
            choose(IDC_PRESET, 0); /* a grade that is not applied is no grade of another scene */
        std::wstring whole = shown(scene_.setup().flown_s / 3600, 6);
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
        if (id == IDC_EFFECTS && effect() != NULL && effect() != bound_) {
            is_in_si_ = false;
            show_effect(false);
        } else if ((id == IDC_SECTION || id == IDC_UNIT) && code == CBN_SELCHANGE) {
            choose(IDC_PRESET, 0);
            is_in_si_ = id == IDC_UNIT && chosen(IDC_UNIT) == 1;
            refresh(true);
        } else if (id == IDC_APPLY && chosen(IDC_PRESET) > 0) {
            change(section() + ".preset", grades_[chosen(IDC_PRESET) - 1]);
            choose(IDC_PRESET, 0);
        } else if (id == IDC_OFF && effect() != NULL) {
            change(effect()->path(), "");
        }
    }

    /* With one number for all axes, a field sets all axes. */
    void on_change(int id, int code) override {
        if (id >= IDC_VALUE && id < IDC_VALUE + 9 && checked(IDC_SAME) && !changes().empty())
            change(bound_->path(is_in_si_), narrow(get(id)));
        else
            Page::on_change(id, code);
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

    /* Sets a value and drops the input in the fields of the effect. Input in other fields stays, also with faults. */
    void change(const std::string &path, const std::string &value) {
        Changes all = changes();
        std::erase_if(all, [this](auto &other) { return other.first.starts_with(bound_->path(is_in_si_)); });
        all[path] = value;
        document_.edited(mark_faults(scene_.set_valid(all)));
    }

    /* A value in the form of the list: a word, a text, or numbers. */
    static std::wstring seen(const Key &key, const std::string &value) {
        if (key.is_choice() || key.kind == SINS_SCENE_KEY_TEXT)
            return key.word_label(unquoted(value));
        double number;
        std::wstring list;
        for (const std::string &element : split(std::regex_replace(value, std::regex("[\\[\\] ]"), ""), ','))
            list += (list.empty() ? L"" : L", ") + (number_of(element, number) ? shown(number, 12) : wide(element));
        return list;
    }

    /* Shows the fields of the effect that is selected in the list: one, three or nine numbers, or a word. */
    void show_effect(bool all_is_new) {
        const Key *key = effect();
        if (key != NULL && (key != bound_ || all_is_new))
            bind_effect(*key);
        bool has_one = bound_->spread != 0 && bound_->elements > 1;
        show(IDC_SAME, has_one);
        check(IDC_SAME, has_one && !scene_.get(bound_->path()).starts_with("["));
        load(all_is_new);
    }

    void bind_effect(const Key &key) {
        const std::vector<std::string> paths = elements_of(key.path());
        Texts units = {wide(key.unit)};
        if (*key.si_name)
            units.push_back(wide(key.si_unit));
        bound_ = &key;
        set(IDC_EFFECT, key.meaning());
        bind_again(item(IDC_WORD), key.is_choice() ? paths[0] : "", false);
        for (size_t k = 0; k < 9; k++)
            bind_again(item(IDC_VALUE + k), !key.is_choice() && k < paths.size() ? paths[k] : "", is_in_si_);
        show(IDC_UNIT, *key.unit);
        fill(item(IDC_UNIT), units);
        choose(IDC_UNIT, is_in_si_);
    }

    const std::vector<std::string> grades_ = key_of("gyro.preset")->choices();
    std::vector<const Key *> effects_;
    const Key *bound_ = &keys()[0]; /* the effect in the fields */
    bool is_in_si_ = false;         /* whether its fields use SI */
};
