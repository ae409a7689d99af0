/* A dialog whose fields are keys of a scene. A label names the keys of the fields behind it, as
 * DoDataExchange() of MFC would: "L&atitude [deg]|flight.latitude_deg". A key in brackets,
 * "[manoeuvre.sinusoid.channel]", belongs to an item within the item: its first label to the first such item,
 * its second label to the second. */
#pragma once
#include <set>

#include "dialog.h"
#include "scene.h"

class Form : public Dialog {
protected:
    struct Field {
        const Key *key;
        size_t element, nested; /* of a key of several numbers; as in a fault */
        std::string loaded;     /* the whole value, of which the control shows 15 digits */
        std::wstring shown;
        bool is_choice() const { return !key->words.empty(); }
    };

    void on_control(HWND control, const std::string &behind) override
    {
        WCHAR kind[16] = L"";
        GetClassNameW(control, kind, 16);
        if (lstrcmpiW(kind, L"Static") == 0) {
            next_.clear();
            for (const std::string &path : split(behind, " ")) {
                bool is_nested = path.starts_with("[");
                const Key *key = key_of(is_nested ? path.substr(1, path.size() - 2) : path);
                size_t nested = is_nested ? ++nested_[path] : 0;
                for (size_t k = 0; key != NULL && k < max((size_t)1, key->count); k++) {
                    next_.push_back({key, k, nested, "", L""});
                }
            }
        } else if (!next_.empty()) {
            bind(control, next_[0].key->path, next_[0].element, next_[0].nested);
            next_.erase(next_.begin());
        }
    }

    /* Fills a combo box with the words, and gives the tool tip. */
    void bind(HWND control, const std::string &path, size_t element = 0, size_t nested = 0)
    {
        const Key *key = key_of(path);
        fields_[control] = {key, element, nested, "", L""};
        if (!key->words.empty()) {
            Texts words = key->word_labels();
            words.insert(words.begin(), nested > 0, L"-"); /* there may be no such item */
            fill(control, words);
        }
        SendMessageW(control, EM_SETCUEBANNER, FALSE, (LPARAM)(key->count > 0 ? L"0" : L""));
        tip(control, key->tip());
    }

    void unbind(HWND control)
    {
        fields_.erase(control);
        mark(control, L"");
    }

    /* What an empty field stands for, shown grey. */
    void cue(const std::string &path, const std::wstring &text) const
    {
        for (const auto &[control, field] : fields_) {
            if (field.key->path == path) {
                SendMessageW(control, EM_SETCUEBANNER, FALSE, (LPARAM)text.c_str());
            }
        }
    }

    void enable_fields(const std::string &begin, bool enabled) const /* whose paths begin so */
    {
        for (const auto &[control, field] : fields_) {
            if (field.key->path.starts_with(begin)) {
                EnableWindow(control, enabled);
            }
        }
    }

    /* From keys to controls. What a user typed wrong stays while it is marked, unless all is new. */
    void load(const std::function<std::string(const Field &)> &value, bool all_is_new)
    {
        for (auto &[control, field] : fields_) {
            const Key &key = *field.key;
            std::string own = value(field);
            double number;
            if (marked_.count(control) != 0 && !all_is_new) {
                continue;
            }
            mark(control, L"");
            if (field.is_choice()) {
                bool has_none = field.nested > 0;
                SendMessageW(control, CB_SETCURSEL,
                             has_none && own.empty() ? 0 : key.index_of(own) + has_none, 0);
            } else {
                own = key.count > 0 ? numbers(own, key)[field.element] : own;
                bool has_number = key.count > 0 && number_of(own, number);
                if (has_number && key.path == si_path_) {
                    own = shortest(number /= key.units_per_si());
                }
                bool is_whole = own.find_first_not_of("0123456789") == std::string::npos;
                std::wstring text = has_number && !is_whole ? shown(number, 15) : wide(unquoted(own));
                if (text != window_text(control)) {
                    SetWindowTextW(control, text.c_str());
                }
            }
            field.loaded = own;
            field.shown = text_of(control, field);
        }
    }

    /* What the user changed since the load. */
    std::vector<Change> changes() const
    {
        std::vector<Change> changes;
        std::set<std::pair<const Key *, size_t>> done;
        for (const auto &[control, field] : fields_) {
            const Key *key = field.key;
            if (text_of(control, field) != field.shown && done.insert({key, field.nested}).second) {
                std::vector<std::string> elements(max((size_t)1, key->count));
                for (const auto &[other_control, other] : fields_) {
                    if (other.key == key && other.nested == field.nested) {
                        elements[other.element] = value_of(other_control, other);
                    }
                }
                std::string value = key->count > 1 ? list_of(elements) : elements[0];
                changes.push_back({key->path, value, field.nested, key->path == si_path_});
            }
        }
        return changes;
    }

    /* Marks the fields at fault, each with its sentence as tool tip; the first sentence, "" if there is none.
     */
    std::wstring mark_faults(const Faults &faults)
    {
        for (const auto &[control, field] : fields_) {
            std::wstring sentence;
            for (const Fault &fault : faults) {
                if (key_of(fault.path) == field.key && fault.nested == field.nested &&
                    is_of(fault, control, field)) {
                    sentence = told(fault.sentence);
                }
            }
            mark(control, sentence);
            tip(control, sentence.empty() ? field.key->tip() : sentence);
        }
        return told(faults);
    }

    /* Whether this notification says that a field has a new value. */
    bool is_change(HWND control, int code) const override
    {
        auto found = fields_.find(control);
        return found != fields_.end() &&
               code == (found->second.is_choice() ? (int)CBN_SELCHANGE : (int)EN_KILLFOCUS);
    }

    /* What a control shows, as a value of the scene. */
    static std::string typed(HWND control, const Field &field)
    {
        std::wstring now = text_of(control, field);
        bool is_quoted =
            !now.empty() && !field.key->is_switch() && (field.is_choice() || field.key->is_text());
        return is_quoted ? in_quotes(narrow(now)) : field.key->is_switch() ? narrow(now) : toml(now);
    }

    std::map<HWND, Field> fields_;
    std::string si_path_; /* the key whose fields are in SI units now; "": none */

private:
    /* What a control shows now: its text or the word. */
    static std::wstring text_of(HWND control, const Field &field)
    {
        if (!field.is_choice()) {
            return window_text(control);
        }
        int word = (int)SendMessageW(control, CB_GETCURSEL, 0, 0) - (field.nested > 0);
        return word < 0 ? L"" : wide(field.key->words[word]);
    }

    /* The value of a control: as it was loaded, unless it was changed. */
    static std::string value_of(HWND control, const Field &field)
    {
        return text_of(control, field) == field.shown ? field.loaded : typed(control, field);
    }

    /* Of the elements of a key that one which the fault names: "bias_deg_h[1]"; else those that are no
     * numbers. */
    static bool is_of(const Fault &fault, HWND control, const Field &field)
    {
        std::string name = field.key->name + "[", typed = narrow(window_text(control));
        size_t bracket = fault.sentence.find(name);
        double number;
        if (bracket != std::string::npos) {
            return (size_t)atoi(&fault.sentence[bracket + name.size()]) == field.element;
        }
        return field.key->count < 2 || !(typed.empty() || number_of(typed, number));
    }

    std::vector<Field> next_;              /* of the label before, not bound yet */
    std::map<std::string, size_t> nested_; /* how many of a key in brackets */
};
