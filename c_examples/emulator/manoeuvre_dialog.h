/* A manoeuvre with its sinusoids. */
#pragma once
#include "document.h"

class ManoeuvreDialog : public Form {
public:
    ManoeuvreDialog(Scene &draft, size_t index) : Form(draft, Scene::place("manoeuvre", index)), index_(index) {}

protected:
    void on_init() override {
        load(true);
        enable_used();
    }

    void on_command(int id, int) override {
        if (id == IDOK) {
            std::vector<std::string> all = scene_.items("manoeuvre");
            all[index_] = item_text();
            Faults faults = scene_.set_items("manoeuvre", all);
            set(IDC_MESSAGE, mark_faults(faults));
            if (faults.empty())
                finish(IDOK);
        }
    }

    void on_change(int, int code) override {
        if (code == CBN_SELCHANGE)
            enable_used();
    }

private:
    size_t index_;
};
