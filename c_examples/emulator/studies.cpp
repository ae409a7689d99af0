/* The studies: the options that the flight needs, and the budget of its errors. */
#include <cmath>

#include "study.h"

/* Samples that sins_recommend() takes, and those of a budget that fit into memory. */
static const size_t RECOMMEND_SAMPLES = 360000, BUDGET_SAMPLES = 2000000;

class RecommendDialog : public StudyDialog {
public:
    explicit RecommendDialog(App &app) : StudyDialog(app, RECOMMEND_SAMPLES) {}

protected:
    void on_init() override
    {
        StudyDialog::on_init();
        columns(IDC_RESULT, "columns_recommend", {240, 0});
        set(IDC_LIMIT_POSITION, L"1");
    }

    void begin(Study &study) override
    {
        study.requirement.position_m = number(IDC_LIMIT_POSITION);
        study.requirement.velocity_m_s = number(IDC_LIMIT_VELOCITY);
        study.requirement.attitude_rad = number(IDC_LIMIT_ATTITUDE) * SINS_ARCSEC;
        study.requirement.duration_s = number(IDC_FOR);
        study.call = [](Study &own, const sins_sim *sim, const std::vector<sins_flight_sample> &samples) {
            return lib.sins_recommend(sim, samples.data(), samples.size(), &own.requirement, &own.options,
                                      &own.cost);
        };
    }

    void show_result(const Study &study) override
    {
        const sins_cost &cost = study.cost;
        const Key &scheme = *key_of("options.scheme");
        const Texts names = parts("recommend_rows");
        const Texts values = {scheme.word_label(scheme.words[(size_t)study.options.scheme]),
                              std::to_wstring(study.options.subsamples),
                              std::to_wstring(study.options.updates_per_sample),
                              shown(cost.position_m, 4) + L" m",
                              shown(cost.velocity_m_s, 4) + L" m/s",
                              shown(cost.attitude_rad / SINS_ARCSEC, 4) + L" \u2033",
                              shown(cost.instructions_per_step, 6),
                              shown(cost.ns_per_step, 4) + L" ns",
                              std::to_wstring(cost.tried)};
        std::vector<Texts> lines;
        for (size_t k = 0; k < min(names.size(), values.size()); k++) {
            lines.push_back({names[k], values[k]});
        }
        rows(IDC_RESULT, lines);
        set(IDC_STATE, parts("met")[study.status == SINS_REQUIREMENT_NOT_MET ? 1 : 0]);
        options_ = study.options;
        enable(IDC_ADOPT, true);
    }

    /* The recommended options for the scene. The simulator's sample period is that of the flight, and stays
     * out. */
    void adopt() override
    {
        sins_options options = sized<sins_options>();
        lib.sins_scene_get_options(app_.scene.handle(), &options);
        options.scheme = options_.scheme;
        options.subsamples = options_.subsamples;
        options.updates_per_sample = options_.updates_per_sample;
        app_.edited(app_.scene.taken(lib.sins_scene_set_options(app_.scene.handle(), &options)));
    }

private:
    sins_options options_;
};

class BudgetDialog : public StudyDialog {
public:
    explicit BudgetDialog(App &app) : StudyDialog(app, BUDGET_SAMPLES) {}

protected:
    void on_init() override
    {
        StudyDialog::on_init();
        columns(IDC_RESULT, "columns_budget", {0, 110, 84, 84, 84});
    }

    void begin(Study &study) override
    {
        study.request.runs = (uint64_t)number(IDC_RUNS);
        study.request.position_m = number(IDC_LIMIT_POSITION);
        study.request.velocity_m_s = number(IDC_LIMIT_VELOCITY);
        study.request.attitude_rad = number(IDC_LIMIT_ATTITUDE) * SINS_ARCSEC;
        study.call = [](Study &own, const sins_sim *sim, const std::vector<sins_flight_sample> &samples) {
            auto call = [&](sins_budget_row *rows, size_t capacity, size_t *count) {
                return lib.sins_error_budget(sim, samples.data(), samples.size(), &own.request, rows,
                                             capacity, count, &own.budget);
            };
            size_t count = 0;
            call(NULL, 0, &count);
            own.rows.assign(count + 1, sized<sins_budget_row>());
            sins_status status = call(own.rows.data(), own.rows.size(), &count);
            own.rows.resize(count);
            return status;
        };
    }

    void show_result(const Study &study) override
    {
        std::vector<Texts> lines;
        double largest = 1e-300;
        for (const sins_budget_row &own : study.rows) {
            largest = std::fmax(largest, own.position_m);
        }
        shares_.clear();
        auto add = [&](const std::wstring &name, double position_m, double velocity_m_s,
                       double attitude_rad) {
            lines.push_back({name, L"", shown(position_m, 4), shown(velocity_m_s, 4),
                             shown(attitude_rad / SINS_ARCSEC, 4)});
        };
        for (const sins_budget_row &own : study.rows) {
            bool is_accel = begins(own.field, "accel.");
            const Key *key = key_of(is_accel ? "accelerometer." + std::string(own.field + 6) : own.field);
            std::wstring name = label(std::string("effect.") + own.effect, own.effect);
            if (key != NULL && is_chinese()) {
                name = label("section." + key->section, key->section) + L"\u00b7" +
                       label(key->path(), own.effect);
            }
            name += (own.flags & SINS_BUDGET_RANDOM) != 0 ? L" (1\u03c3)" : L"";
            name += (own.flags & SINS_BUDGET_CAN_BE_LEFT_OUT) != 0 ? L" *" : L"";
            shares_.push_back(own.position_m / largest);
            add(name, own.position_m, own.velocity_m_s, own.attitude_rad);
        }
        shares_.push_back(0);
        add(text("budget_total"), study.budget.position_m, study.budget.velocity_m_s,
            study.budget.attitude_rad);
        rows(IDC_RESULT, lines);
    }

    /* The second column is a bar. */
    void on_notify(NMHDR *notice) override
    {
        NMLVCUSTOMDRAW *draw = (NMLVCUSTOMDRAW *)notice;
        if (notice->idFrom != IDC_RESULT || notice->code != (UINT)NM_CUSTOMDRAW) {
            return;
        }
        DWORD stage = draw->nmcd.dwDrawStage;
        size_t row = draw->nmcd.dwItemSpec;
        LRESULT result = stage == CDDS_PREPAINT       ? CDRF_NOTIFYITEMDRAW
                         : stage == CDDS_ITEMPREPAINT ? CDRF_NOTIFYPOSTPAINT
                                                      : CDRF_DODEFAULT;
        if (stage == CDDS_ITEMPOSTPAINT && row < shares_.size()) {
            RECT bar;
            ListView_GetSubItemRect(notice->hwndFrom, (int)row, 1, LVIR_BOUNDS, &bar);
            InflateRect(&bar, -3, -3);
            bar.right = bar.left + (LONG)((bar.right - bar.left) * shares_[row]);
            SetDCBrushColor(draw->nmcd.hdc, RGB(0, 110, 200));
            FillRect(draw->nmcd.hdc, &bar, (HBRUSH)GetStockObject(DC_BRUSH));
        }
        SetWindowLongPtrW(window_, DWLP_MSGRESULT, result);
    }

private:
    std::vector<double> shares_; /* of the largest position: the bars */
};

void recommend(App &app)
{
    RecommendDialog(app).modal(app.window(), IDD_RECOMMEND);
}

void error_budget(App &app)
{
    BudgetDialog(app).modal(app.window(), IDD_BUDGET);
}
