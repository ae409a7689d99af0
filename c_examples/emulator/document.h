/* What the pages and dialogs work on: the scene, its file and its flight. */
#pragma once
#include "flight.h"
#include "form.h"
#include "plot.h"

class Document {
public:
    virtual void edited(const std::wstring &fault) = 0;      /* the scene was: the sentence of a fault, or "" */
    virtual void say_line(const std::wstring &sentence) = 0; /* in the status line */
    virtual void command(int id) = 0;
    virtual void open_builtin(const std::string &name) = 0;
    fs::path folder() const { return path.parent_path(); }

    Scene scene{"simulation2"};
    fs::path path;
    std::unique_ptr<Flight> flight;

protected:
    ~Document() = default;
};

/* A page of the main window: its fields go into the scene as soon as they are left. */
class Page : public Form {
public:
    explicit Page(Document &document) : Form(document.scene), document_(document) {}
    /* Shows the scene; all_is_new: what was typed wrong goes too. */
    virtual void refresh(bool all_is_new) { load(all_is_new); }

protected:
    void on_change(int, int) override {
        if (!changes().empty() || has_marks())
            document_.edited(save());
    }

    void on_refusal(const std::wstring &sentence) override { document_.say_line(sentence); }

    Document &document_;
};

/* The items of a list of the scene: the number of each, its words, as "gyro x stuck", and its values. */
inline Rows rows_of(const Scene &scene, const std::string &list) {
    Rows rows;
    const size_t count = scene.items(list).size();
    for (size_t index = 0; index < count; index++) {
        std::wstring words, values;
        auto get = [&](const std::string &name) { return scene.get(Scene::place(list, index) + "." + name); };
        for (const Key &key : keys()) {
            if (key.section != list || !key.applies([&get](const std::string &name) { return unquoted(get(name)); }))
                continue;
            std::string value = get(key.name);
            if (key.is_choice()) {
                words += (words.empty() ? L"" : L" ") + key.word_label(unquoted(value));
            } else if (value != key.default_value) {
                values += (values.empty() ? L"" : L", ") + label(key.path() + ".short", key.name) + L" ";
                values += wide(value) + (*key.unit ? L" " + wide(key.unit) : L"");
            }
        }
        rows.push_back({{std::to_wstring(index + 1), words, values}});
    }
    return rows;
}
