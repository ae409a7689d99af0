/* The failures that the scene plans. In flight they begin and end with the next interval, not earlier: the
 * scene then flies to the same bits again. */
#pragma once
#include "document.h"

class FailureDialog : public Form {
public:
    explicit FailureDialog(Document &document) : Form(document.scene), document_(document) {}

protected:
    void on_init() override {
        choose(IDC_KIND, 1);
        choose_sensor();
        set(IDC_FROM, now());
        rows(IDC_FAILING, rows_of(scene_, "failure"));
    }

    void on_change(int id, int code) override {
        if (id == IDC_SENSOR)
            choose_sensor();
        else if (code == CBN_SELCHANGE)
            enable_used();
    }

    void on_command(int id, int) override {
        std::vector<std::string> all = scene_.items("failure");
        size_t row = selected(IDC_FAILING);
        Flight *flight = document_.flight.get();
        bool is_flying = flight != NULL && flight->status().state == Flight::FLYING;
        if (is_flying)
            flight->pause(true);
        if (id == IDC_ADD) {
            double from_s = 0, now_s = 0;
            bool has_from = number_of(narrow(get(IDC_FROM)), from_s) || get(IDC_FROM).empty();
            if (is_flying && number_of(narrow(now()), now_s) && has_from && from_s < now_s)
                set(IDC_FROM, now());
            item_ = Scene::place("failure", all.size());
            all.push_back(item_text());
            take(scene_.set_items("failure", all));
        } else if (id == IDC_REMOVE && row < all.size()) {
            all.erase(all.begin() + row);
            take(scene_.set_items("failure", all));
        } else if (id == IDC_CLEAR && row < all.size() && flight != NULL) {
            take(scene_.set({{Scene::place("failure", row) + ".until_s", narrow(now())}}));
        }
        if (is_flying)
            flight->pause(false);
    }

    void on_notify(NMHDR *notice) override {
        if (notice->idFrom == IDC_FAILING && notice->code == (UINT)LVN_ITEMCHANGED) {
            bool has_row = selected(IDC_FAILING) < scene_.items("failure").size();
            enable(IDC_CLEAR, has_row && document_.flight != NULL);
            enable(IDC_REMOVE, has_row);
        }
    }

private:
    /* The time of the flight at hand, rounded up to milliseconds; "": none flies. */
    std::wstring now() const {
        Flight *flight = document_.flight.get();
        return flight == NULL ? L"" : wide(shortest(std::ceil(flight->status().time_s * 1000) / 1000));
    }

    /* Size and density have units of the sensor that is chosen. */
    void choose_sensor() {
        static const char *const SIZES[] = {"failure.size_deg_h", "failure.size_micro_g", "failure.size_m"};
        static const char *const DENSITIES[] = {"failure.density_deg_sqrt_h", "failure.density_micro_g_sqrt_hz",
                                                "failure.density_m_sqrt_hz"};
        int sensor = chosen(IDC_SENSOR);
        bind(item(IDC_FAILURE_SIZE), SIZES[sensor]);
        bind(item(IDC_DENSITY), DENSITIES[sensor]);
        set(IDC_SIZE_UNIT, wide(key_of(SIZES[sensor])->unit));
        set(IDC_DENSITY_UNIT, wide(key_of(DENSITIES[sensor])->unit));
        enable_used();
    }

    /* After a change of the list: for the flight at hand too. */
    void take(const Faults &faults) {
        std::wstring sentence = mark_faults(faults);
        if (faults.empty() && document_.flight != NULL)
            document_.flight->plan(scene_);
        document_.edited(sentence);
        set(IDC_MESSAGE, sentence);
        rows(IDC_FAILING, rows_of(scene_, "failure"));
    }

    Document &document_;
};
