/* The items of the lists of a scene: its manoeuvres and its failures. */
#pragma once
#include "document.h"

/* A row for each item: its number, its words such as "gyro x stuck", and its values. */
inline Rows rows_of(const Scene &scene, const std::string &list) {
    Rows rows;
    const size_t count = scene.items(list).size();
    for (size_t index = 0; index < count; index++) {
        std::wstring words, values;
        auto get = [&](const std::string &name) { return unquoted(scene.get(place(list, index) + "." + name)); };
        for (const Key &key : keys()) {
            if (key.section != list || !key.applies(get))
                continue;
            std::string value = get(key.name);
            if (key.is_choice())
                words += key.word_label(value) + L" ";
            else if (value != key.default_value)
                values += (values.empty() ? L"" : L", ") + label(key.path() + ".short", key.name) + L" " + wide(value) +
                          (*key.unit ? L" " + wide(key.unit) : L"");
        }
        rows.push_back({{std::to_wstring(index + 1), words, values}});
    }
    return rows;
}

/* A dialog with the fields of one item. */
class ItemDialog : public Form {
protected:
    ItemDialog(Scene &scene, const std::string &list) : Form(scene), list_(list) {}

    void on_change(int, int code) override {
        if (code == CBN_SELCHANGE)
            enable_used();
    }

    /* Sets item `index` from the fields, or adds an item. */
    Faults take(size_t index) {
        std::vector<std::string> all = scene_.items(list_);
        all.resize(max(all.size(), index + 1));
        item_ = place(list_, index);
        all[index] = item_text();
        Faults faults = scene_.set_items(list_, all);
        set(IDC_MESSAGE, mark_faults(faults));
        return faults;
    }

private:
    std::string list_;
};

class ManoeuvreDialog : public ItemDialog {
public:
    ManoeuvreDialog(Scene &draft, size_t index) : ItemDialog(draft, "manoeuvre"), index_(index) {}

protected:
    void on_init() override {
        item_ = place("manoeuvre", index_);
        load(true);
        enable_used();
    }

    void on_command(int id, int) override {
        if (id == IDOK && take(index_).empty())
            finish(IDOK);
    }

private:
    size_t index_;
};

/* The failures that the scene plans. In flight, failures begin and end with the next interval, not earlier. Therefore
 * the scene flies to the same bits again. */
class FailureDialog : public ItemDialog {
public:
    explicit FailureDialog(Document &document) : ItemDialog(document.scene, "failure"), document_(document) {}

protected:
    void on_init() override {
        choose(IDC_KIND, 1);
        enable_used();
        set(IDC_FROM, now());
        rows(IDC_ITEMS, rows_of(scene_, "failure"));
    }

    void on_command(int id, int) override {
        std::vector<std::string> all = scene_.items("failure");
        size_t row = selected(IDC_ITEMS);
        bool has_row = row < all.size();
        Flight *flight = document_.flight.get();
        std::unique_lock<std::recursive_mutex> held;
        if (flight != NULL)
            held = flight->hold();
        if (id == IDC_ITEMS) {
            enable(IDC_CLEAR, has_row && flight != NULL);
            enable(IDC_REMOVE, has_row);
        } else if (id == IDC_ADD) {
            double from_s = 0;
            bool has_from = number_of(narrow(get(IDC_FROM)), from_s) || get(IDC_FROM).empty();
            if (flight != NULL && flight->is_under_way() && has_from && from_s < flight->status().time_s)
                set(IDC_FROM, now());
            show_list(take(all.size()));
        } else if (id == IDC_REMOVE && has_row) {
            all.erase(all.begin() + row);
            show_list(scene_.set_items("failure", all));
        } else if (id == IDC_CLEAR && has_row && flight != NULL) {
            show_list(scene_.set({{place("failure", row) + ".until_s", narrow(now())}}));
        }
    }

private:
    /* The time of the current flight, rounded up to milliseconds, or "". */
    std::wstring now() const {
        Flight *flight = document_.flight.get();
        return flight == NULL ? L"" : wide(shortest(std::ceil(flight->status().time_s * 1000) / 1000));
    }

    /* Shows the list after a change. The current flight gets the change too. */
    void show_list(const Faults &faults) {
        if (faults.empty() && document_.flight != NULL)
            document_.flight->plan(scene_);
        document_.edited(told(faults));
        set(IDC_MESSAGE, told(faults));
        rows(IDC_ITEMS, rows_of(scene_, "failure"));
    }

    Document &document_;
};
