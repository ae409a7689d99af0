/* A dialog whose fields are values of a scene. A label names the keys of the fields behind it,
 * "L&atitude [deg]|flight.latitude_deg"; load() and save() exchange them, as UpdateData() and
 * DoDataExchange() of MFC. */
#pragma once
#include "dialog.h"
#include "scene.h"

class Form : public Dialog {
protected:
    struct Field {
        HWND control;
        std::string path; /* as the label has it, with the element of several numbers behind it */
        const Key *key;
        bool is_in_si;      /* for now */
        std::string loaded; /* the whole value, of which the control shows 15 digits */
        std::wstring shown;
        bool is_nested() const { return path.starts_with("manoeuvre.sinusoid"); }
        /* A sinusoid's channel: there may be no such item. */
        bool has_none() const { return is_nested() && key->is_choice(); }
    };

    /* item: of which list item the keys are, "manoeuvre[3]"; "": of none. */
    explicit Form(Scene &scene, const std::string &item = "") : scene_(scene), item_(item) {}

    void on_control(HWND control, const std::string &paths) override {
        if (is_of_class(control, L"Static")) {
            next_.clear();
            for (const std::string &path : split(paths, " ")) {
                const Key *key = key_of(path);
                for (int k = 0; key != NULL && k < max(1, key->elements); k++)
                    next_.push_back(key->elements > 1 ? Scene::place(path, k) : path);
            }
        } else if (!next_.empty()) {
            bind(control, next_[0]);
            next_.erase(next_.begin());
        }
    }

    /* Fills a combo box with the words, gives the tool tip, and shows grey what an empty field stands for. */
    void bind(HWND control, const std::string &path, bool is_in_si = false) {
        unbind(control);
        fields_.push_back({control, path, key_of(path), is_in_si, "", L""});
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

    void unbind(HWND control) {
        std::erase_if(fields_, [control](const Field &field) { return field.control == control; });
        mark(control, L"");
    }

    void enable_fields(const std::string &begin, bool enabled) const /* whose paths begin so */
    {
        for (const Field &field : fields_)
            if (field.path.starts_with(begin))
                EnableWindow(field.control, enabled);
    }

    /* The fields that the words of other fields exclude are empty and off. */
    void enable_used() const {
        for (const Field &field : fields_) {
            bool is_used = applies(field);
            EnableWindow(field.control, is_used);
            if (!is_used && field.key->is_choice())
                SendMessageW(field.control, CB_SETCURSEL, 0, 0);
            else if (!is_used)
                SetWindowTextW(field.control, L"");
        }
    }

    /* From the scene to the controls. What a user typed wrong stays while it is marked, unless all is new. */
    void load(bool all_is_new) {
        for (Field &field : fields_) {
            if (marked_.count(field.control) != 0 && !all_is_new)
                continue;
            double number;
            mark(field.control, L"");
            field.loaded = scene_.get(path_of(field, field.is_in_si));
            std::string own = unquoted(field.loaded);
            if (field.key->is_choice()) {
                std::vector<std::string> words = field.key->choices();
                size_t index = std::find(words.begin(), words.end(), own) - words.begin();
                index = index < words.size() ? index + field.has_none() : 0;
                SendMessageW(field.control, CB_SETCURSEL, index, 0);
            } else {
                bool is_whole = own.find_first_not_of("0123456789") == own.npos || !number_of(own, number);
                std::wstring text = field.loaded == field.key->default_number() ? L""
                                    : is_whole                                  ? wide(own)
                                                                                : ::shown(number, 15);
                if (text != window_text(field.control))
                    SetWindowTextW(field.control, text.c_str());
            }
            field.shown = wide(now(field));
        }
    }

    /* What the user changed since the load. */
    std::vector<Change> changes() const {
        std::vector<Change> changes;
        for (const Field &field : fields_)
            if (wide(now(field)) != field.shown)
                changes.push_back({path_of(field, field.is_in_si), now(field)});
        return changes;
    }

    /* From the controls to the scene. */
    std::wstring save() { return mark_faults(scene_.set_valid(changes())); }

    /* All fields as an item of a list, as it stands in the text of a scene. */
    std::string item_text() const {
        std::string text, owner;
        for (const Field &field : fields_) {
            std::string own = now(field), before = field.path.substr(0, field.path.rfind('.'));
            double number;
            if (own.empty() || !IsWindowEnabled(field.control))
                continue;
            if (before != owner) {
                text += std::string("[[") + field.key->section + "]]\n";
                owner = before;
            }
            bool is_number = number_of(own, number);
            own = wide(own) == field.shown ? field.loaded : is_number ? shortest(number) : in_quotes(own);
            text += std::string(field.key->name) + " = " + own + "\n";
        }
        return text;
    }

    /* Marks the fields at fault, each with its sentence as tool tip; the first sentence, "" if there is none.
     */
    std::wstring mark_faults(const Faults &faults) {
        for (const Field &field : fields_) {
            std::wstring sentence;
            for (const sins_fault &fault : faults)
                sentence = is_about(fault, path_of(field)) ? told(fault) : sentence;
            mark(field.control, sentence);
            tip(field.control, sentence.empty() ? field.key->tip() : sentence);
        }
        return told(faults);
    }

    /* Whether this notification says that a field has a new value. */
    bool is_change(HWND control, int code) const override {
        return std::any_of(fields_.begin(), fields_.end(), [control, code](const Field &field) {
            int change = field.key->is_choice() ? (int)CBN_SELCHANGE : (int)EN_KILLFOCUS;
            return field.control == control && code == change;
        });
    }

    Scene &scene_;
    std::string item_;
    std::vector<Field> fields_;

private:
    std::string path_of(const Field &field, bool in_si = false) const {
        std::string path = item_.empty() ? field.path : item_ + field.path.substr(field.path.find('.'));
        return in_si ? path.replace(path.rfind('.') + 1, strlen(field.key->name), field.key->si_name) : path;
    }

    /* What a control shows now: its text or the word. */
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

    /* Whether the item can have a key; a sinusoid has a channel. */
    bool applies(const Field &field) const {
        std::string owner = field.path.substr(0, field.path.rfind('.') + 1);
        bool is_sinusoid =
            now("manoeuvre.kind") == "sinusoids" && (field.key->is_choice() || !now(owner + "channel").empty());
        return (is_sinusoid || !field.is_nested()) &&
               field.key->applies([&](const std::string &name) { return now(owner + name); });
    }

    std::vector<std::string> next_; /* paths of the label before, not bound yet */
};
