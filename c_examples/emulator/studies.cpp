/* Studies of the flight at hand: the options that it needs, and the budget of its errors. A worker thread
 * computes. */
#include "app.h"

#include <cmath>

/* Samples that sins_recommend() takes, and those of a budget that fit into memory. */
static const size_t RECOMMEND_SAMPLES = 360000, BUDGET_SAMPLES = 2000000;

/* A computation: what it needs and what it finds, shared by its thread and the dialog. */
struct Study {
    Scene scene;
    std::wstring folder;
    double from_s, to_s;
    size_t most;
    sins_requirement requirement = sized<sins_requirement>();
    sins_budget_request request = sized<sins_budget_request>();
    sins_options options = sized<sins_options>();
    sins_cost cost = sized<sins_cost>();
    std::vector<sins_budget_row> rows;
    sins_budget budget = sized<sins_budget>();
    sins_status (*call)(Study &, const sins_sim *, const std::vector<sins_flight_sample> &);
    sins_status status = SINS_OK;
    std::wstring sentence; /* why it failed */
    std::atomic<bool> is_cancelled{false}, is_done{false};

    void compute();
};

/* The one study that runs. A call of the library cannot be interrupted: after a cancel, and when the dialog
 * is closed, it ends by itself; the next study waits for that, so that no more than one takes memory and
 * time. */
static std::shared_ptr<Study> running;

/* The samples of the piece, then the call. */
void Study::compute()
{
    Samples flight;
    Handle<sins_sim> sim;
    status = SINS_ERROR_INVALID_ARGUMENT; /* until the library has another */
    if (!flight.open(scene, folder, sentence)) {
        return;
    }
    size_t first = (size_t)std::fmin(from_s / flight.period_s + 1e-6, (double)flight.count);
    size_t last = (size_t)std::fmin(to_s / flight.period_s + 1e-6, (double)flight.count - 1);
    if (last <= first || last - first >= most) {
        sentence = last <= first ? text("no_piece", {shown(flight.duration_s, 10)})
                                 : text("too_long", {std::to_wstring(most)});
        return;
    }
    std::vector<sins_flight_sample> samples(last - first + 1, sized<sins_flight_sample>());
    status = lib.sins_scene_create_simulator(scene.handle(), &sim);
    for (size_t k = 0; k < samples.size() && status >= 0 && !is_cancelled; k++) {
        status = flight.get(first + k, &samples[k]);
        if (status >= 0) { /* its temperature: no failures here */
            status = lib.sins_scene_prepare(scene.handle(), sim, flight.start_s, &samples[k]);
        }
    }
    if (status >= 0 && !is_cancelled) {
        status = call(*this, sim, samples);
    }
    sentence = status < 0 ? last_error() : L"";
}

class StudyDialog : public Dialog {
public:
    StudyDialog(App &app, size_t most) : app_(app), most_(most) {}
    ~StudyDialog() override { cancel(); }

protected:
    virtual void begin(Study &study) = 0;
    virtual void show_result(const Study &study) = 0;
    virtual void adopt() {}

    void on_init() override
    {
        Samples samples;
        std::wstring why;
        double length_s = samples.open(app_.scene, app_.folder(), why) ? samples.duration_s : 0;
        set(IDC_FROM, L"0");
        set(IDC_TO, shown(min(length_s, 600.0), 10));
        set(IDC_STATE, why);
        enable(IDC_ADOPT, false);
        SetTimer(window_, 1, 100, NULL);
    }

    void on_command(int id, int) override
    {
        if (id == IDC_COMPUTE && study_ != NULL) {
            cancel();
            set(IDC_STATE, text("cancelled"));
            set(IDC_COMPUTE, text("&Compute"));
        } else if (id == IDC_COMPUTE || id == IDOK) {
            start();
        } else if (id == IDC_ADOPT) {
            adopt();
        }
    }

    void on_timer() override
    {
        if (running != NULL && running->is_done) {
            running.reset();
        }
        if (study_ != NULL && !study_->is_done && running == NULL) {
            running = study_;
            set(IDC_STATE, text("computing"));
            std::thread([own = running] {
                own->compute();
                own->is_done = true;
            }).detach();
        } else if (study_ != NULL && study_->is_done) {
            set(IDC_COMPUTE, text("&Compute"));
            set(IDC_STATE, study_->sentence);
            if (study_->status >= 0) {
                show_result(*study_);
            }
            study_.reset();
        }
    }

    /* A number of a field, 0 where it is empty. What is none is marked. */
    double number(int id)
    {
        double value = 0;
        std::string typed = narrow(get(id));
        bool is_number = typed.empty() || (number_of(typed, value) && value >= 0);
        mark(item(id), is_number ? L"" : text("not_valid", {wide(typed)}));
        return is_number ? value : 0;
    }

    App &app_;

private:
    void start()
    {
        auto study = std::make_shared<Study>();
        if (study_ != NULL) {
            return;
        }
        study->scene.read(app_.scene.text());
        study->folder = app_.folder();
        study->from_s = number(IDC_FROM);
        study->to_s = number(IDC_TO);
        study->most = most_;
        begin(*study);
        if (has_marks()) {
            set(IDC_STATE, text("field_not_valid"));
            return;
        }
        study_ = study;
        set(IDC_STATE, text("waiting"));
        set(IDC_COMPUTE, text("&Cancel"));
        on_timer();
    }

    void cancel()
    {
        if (study_ != NULL) {
            study_->is_cancelled = true;
            study_.reset();
        }
    }

    size_t most_;
    std::shared_ptr<Study> study_; /* the one that is waited for */
};

class RecommendDialog : public StudyDialog {
public:
    explicit RecommendDialog(App &app) : StudyDialog(app, RECOMMEND_SAMPLES) {}

protected:
    void on_init() override
    {
        StudyDialog::on_init();
        columns(IDC_RESULT, "columns_recommend", {240, 170});
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
        columns(IDC_RESULT, "columns_budget", {176, 110, 84, 84, 84});
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
