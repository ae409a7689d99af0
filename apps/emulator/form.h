/* A dialog whose fields are values of a scene. A label names the keys of the fields after it, "L&atitude [deg]|
 * flight.latitude_deg". load() and save() exchange the values, like UpdateData() and DoDataExchange() of MFC. */
#pragma once
#include "dialog.h"
#include "scene.h"

class Form : public Dialog {
protected:
    struct Field {
        HWND control, label;
        std::string path; /* path in the label, with the number of the element if there are several */
        const Key *key;
        bool is_in_si;      /* whether the field currently uses SI */
        bool is_hidden;     /* hidden in the layout: shown only while used, because fields may share a place */
        std::string loaded; /* the exact value; the control shows 15 digits */
        std::wstring shown;
        std::string owner() const { return path.substr(0, path.rfind('.') + 1); }
        bool is_nested() const { return path.starts_with("manoeuvre.sinusoid"); }
        bool has_none() const { return is_nested() && key->is_choice(); } /* no channel: no sinusoid */
    };

    /* item: the list item of the keys, "manoeuvre[3]", or "". */
    explicit Form(Scene &scene, const std::string &item = "") : scene_(scene), item_(item) {}

    void on_control(HWND control, const std::string &paths) override {
        if (is_of_class(control, L"Static")) {
            label_ = control;
            next_.clear();
            for (const std::string &path : split(paths, ' '))
                for (const std::string &element : elements_of(path))
                    next_.push_back(element);
        } else if (!next_.empty()) {
            bind(control, next_[0]);
            next_.erase(next_.begin());
        }
    }

    void enable_fields(const std::string &begin, bool enabled) const { /* the fields whose paths begin with `begin` */
        for (const Field &field : fields_)
            if (field.path.starts_with(begin))
                EnableWindow(field.control, enabled);
    }

    /* Empties and disables the fields that the words of other fields exclude. */
    void enable_used() const {
        for (const Field &field : fields_) {
            bool is_used = applies(field);
            EnableWindow(field.control, is_used);
            if (!is_used)
                put(field, "");
            for (HWND window : {field.control, field.label})
                if (field.is_hidden)
                    ShowWindow(window, is_used ? SW_SHOW : SW_HIDE);
        }
    }

    /* Copies values from the scene to the controls. Marked input with a fault stays, unless all is new. */
    void load(bool all_is_new) { load(all_is_new, scene_); }

    void load(bool all_is_new, const Scene &from) {
        for (Field &field : fields_) {
            if (marked_.count(field.control) != 0 && !all_is_new)
                continue;
            mark(field.control, false);
            field.loaded = from.get(path_of(field, field.is_in_si));
            std::string value = unquoted(field.loaded);
            double number;
            if (!field.key->is_choice() && field.loaded == field.key->default_number())
                value = "";
            else if (value.find_first_not_of("0123456789") != value.npos && number_of(value, number))
                value = narrow(::shown(number, 15));
            put(field, value);
            field.shown = wide(now(field));
        }
    }

    /* Changes of the user since load(). */
    Changes changes() const {
        Changes changes;
        for (const Field &field : fields_)
            if (wide(now(field)) != field.shown)
                changes[path_of(field, field.is_in_si)] = now(field);
        return changes;
    }

    /* Copies changes from the controls to the scene. */
    std::wstring save() { return mark_faults(scene_.set_valid(changes())); }

    /* All fields as a list item in the text format of a scene. */
    std::string item_text() const {
        std::string text, owner;
        for (const Field &field : fields_) {
            std::string value = now(field);
            double number;
            if (value.empty() || !IsWindowEnabled(field.control))
                continue;
            if (field.owner() != owner)
                text += std::string("[[") + field.key->section + "]]\n";
            owner = field.owner();
            bool is_number = number_of(value, number);
            value = wide(value) == field.shown ? field.loaded : is_number ? shortest(number) : in_quotes(value);
            text += std::string(field.key->name) + " = " + value + "\n";
        }
        return text;
    }

    /* Marks the faulty fields, each with its sentence as tool tip. Returns the first sentence, or "". */
    std::wstring mark_faults(const Faults &faults) {
        for (const Field &field : fields_) {
            std::wstring sentence;
            for (const sins_fault &fault : faults)
                sentence = is_about(fault, path_of(field)) ? told(fault) : sentence;
            mark(field.control, !sentence.empty());
            tip(field.control, sentence.empty() ? field.key->tip() : sentence);
        }
        return told(faults);
    }

    /* Whether this notification reports a new value of a field. */
    bool is_change(HWND control, int code) const override {
        return std::any_of(fields_.begin(), fields_.end(), [control, code](const Field &field) {
            int change = field.key->is_choice() ? (int)CBN_SELCHANGE : (int)EN_KILLFOCUS;
            return field.control == control && code == change;
        });
    }

    /* Binds a control to another path. "": no path, the control is hidden. */
    void bind_again(HWND control, const std::string &path, bool is_in_si) {
        std::erase_if(fields_, [control](const Field &field) { return field.control == control; });
        mark(control, false);
        ShowWindow(control, path.empty() ? SW_HIDE : SW_SHOW);
        if (!path.empty())
            bind(control, path, is_in_si);
    }

    Scene &scene_;
    std::string item_;

private:
    /* Binds a control to a path: fills a combo box with the words, sets the tool tip, and shows the default
     * value of an empty field in grey. */
    void bind(HWND control, const std::string &path, bool is_in_si = false) {
        bool is_hidden = (GetWindowLongW(control, GWL_STYLE) & WS_VISIBLE) == 0;
        fields_.push_back({control, label_, path, key_of(path), is_in_si, is_hidden, "", L""});
        const Field &field = fields_.back();
        if (field.key->is_choice()) {
            Texts words(field.has_none(), L"-");
            for (const std::string &word : field.key->choices())
                words.push_back(field.key->word_label(word));
            fill(control, words);
        }
        SendMessageW(control, EM_SETCUEBANNER, FALSE, (LPARAM)wide(field.key->default_number()).c_str());
        tip(control, field.key->tip());
    }

    std::string path_of(const Field &field, bool in_si = false) const {
        std::string path = item_.empty() ? field.path : item_ + field.path.substr(field.path.find('.'));
        return in_si ? path.replace(path.rfind('.') + 1, strlen(field.key->name), field.key->si_name) : path;
    }

    /* Sets the text or the word of a control. */
    void put(const Field &field, const std::string &value) const {
        std::vector<std::string> words = field.key->choices();
        size_t index = std::find(words.begin(), words.end(), value) - words.begin();
        if (field.key->is_choice())
            SendMessageW(field.control, CB_SETCURSEL, index < words.size() ? index + field.has_none() : 0, 0);
        else if (wide(value) != window_text(field.control))
            SetWindowTextW(field.control, wide(value).c_str());
    }

    static std::string now(const Field &field) {
        if (!field.key->is_choice())
            return narrow(window_text(field.control));
        int word = (int)SendMessageW(field.control, CB_GETCURSEL, 0, 0) - field.has_none();
        return word < 0 ? "" : field.key->choices()[word];
    }

    std::string now(const std::string &path) const {
        auto own = std::find_if(fields_.begin(), fields_.end(), [&](auto &field) { return field.path == path; });
        return own == fields_.end() ? "" : now(*own);
    }

    /* Whether the item can have the key of a field. */
    bool applies(const Field &field) const {
        bool is_sinusoid = field.key->is_choice() || !now(field.owner() + "channel").empty();
        return (!field.is_nested() || (is_sinusoid && now("manoeuvre.kind") == "sinusoids")) &&
               field.key->applies([&](const std::string &name) { return now(field.owner() + name); });
    }

    std::vector<Field> fields_;
    std::vector<std::string> next_; /* paths of the last label that are not bound yet */
    HWND label_ = NULL;             /* the last label */
};
