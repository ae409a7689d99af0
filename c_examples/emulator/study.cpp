/* The studies: the options that the flight needs, and the budget of its errors. A worker thread computes. */
#include "app.h"

/* What a study finds. */
struct Result {
    Rows rows;
    std::wstring sentence;
    bool has_options = false;
    sins_options options;
};

/* Limits of the errors; the last number is the duration [s], or the runs. */
struct Limits {
    double position_m, velocity_m_s, attitude_rad, last;
};

/* One kind of study: its texts and columns, the samples that the library takes, and its call. */
struct Kind {
    const char *title, *last, *columns;
    std::vector<int> widths;
    size_t most;
    void (*call)(const sins_sim *sim, const std::vector<sins_flight_sample> &samples, const Limits &limits,
                 Result &result);
};

/* The options that meet the limits. */
static void find_options(const sins_sim *sim, const std::vector<sins_flight_sample> &samples,
                         const Limits &limits, Result &result)
{
    sins_requirement requirement = sized<sins_requirement>();
    sins_cost cost = sized<sins_cost>();
    const Key &scheme = *key_of("options.scheme");
    requirement.position_m = limits.position_m;
    requirement.velocity_m_s = limits.velocity_m_s;
    requirement.attitude_rad = limits.attitude_rad;
    requirement.duration_s = limits.last;
    result.options = sized<sins_options>();
    sins_status status =
        check(lib.sins_recommend(sim, samples.data(), samples.size(), &requirement, &result.options, &cost));
    const Texts names = parts("recommend_rows");
    const Texts values = {scheme.word_label(scheme.words[result.options.scheme]),
                          std::to_wstring(result.options.subsamples),
                          std::to_wstring(result.options.updates_per_sample),
                          shown(cost.position_m, 4) + L" m",
                          shown(cost.velocity_m_s, 4) + L" m/s",
                          shown(cost.attitude_rad / SINS_ARCSEC, 4) + L" \u2033",
                          shown(cost.instructions_per_step, 6),
                          shown(cost.ns_per_step, 4) + L" ns",
                          std::to_wstring(cost.tried)};
    for (size_t k = 0; k < names.size(); k++) {
        result.rows.push_back({{names[k], values[k]}});
    }
    result.sentence = parts("met")[status == SINS_REQUIREMENT_NOT_MET ? 1 : 0];
    result.has_options = true;
}

static std::wstring name_of(const sins_budget_row &row)
{
    std::string field = row.field;
    const Key *key = key_of(field.starts_with("accel.") ? "accelerometer" + field.substr(5) : field);
    std::wstring name = label(std::string("effect.") + row.effect, row.effect);
    if (key != NULL && is_chinese()) {
        name = label("section." + key->section, key->section) + L"\u00b7" + label(key->path, row.effect);
    }
    name += (row.flags & SINS_BUDGET_RANDOM) != 0 ? L" (1\u03c3)" : L"";
    return name + ((row.flags & SINS_BUDGET_CAN_BE_LEFT_OUT) != 0 ? L" *" : L"");
}

/* The share of each error; a bar is of the largest in position. */
static void find_shares(const sins_sim *sim, const std::vector<sins_flight_sample> &samples,
                        const Limits &limits, Result &result)
{
    sins_budget_request request = sized<sins_budget_request>();
    sins_budget budget = sized<sins_budget>();
    size_t count = 0;
    double largest = 1e-300;
    request.runs = (uint64_t)limits.last;
    request.position_m = limits.position_m;
    request.velocity_m_s = limits.velocity_m_s;
    request.attitude_rad = limits.attitude_rad;
    auto call = [&](sins_budget_row *rows, size_t capacity) {
        return lib.sins_error_budget(sim, samples.data(), samples.size(), &request, rows, capacity, &count,
                                     &budget);
    };
    call(NULL, 0);
    std::vector<sins_budget_row> rows(count + 1, sized<sins_budget_row>());
    check(call(rows.data(), rows.size()));
    rows.resize(count);
    for (const sins_budget_row &row : rows) {
        largest = max(largest, row.position_m);
    }
    auto add = [&](const std::wstring &name, const auto &errors, double bar) {
        std::wstring attitude = shown(errors.attitude_rad / SINS_ARCSEC, 4);
        result.rows.push_back(
            {{name, L"", shown(errors.position_m, 4), shown(errors.velocity_m_s, 4), attitude}, false, bar});
    };
    for (const sins_budget_row &row : rows) {
        add(name_of(row), row, row.position_m / largest);
    }
    add(text("budget_total"), budget, 0);
}

static const Kind RECOMMEND = {
    "Recommended options", "For the &duration [s]", "columns_recommend", {240, 0}, 360000, find_options};
static const Kind BUDGET = {"Error budget",       "&Runs", "columns_budget",
                            {0, 110, 84, 84, 84}, 2000000, find_shares};

/* A computation: what it needs and what it finds, shared by its thread and the dialog. */
struct Study {
    const Kind &kind;
    Scene scene;
    fs::path folder;
    double from_s, to_s;
    Limits limits;
    Result result;
    std::atomic<bool> is_cancelled{false}, is_done{false};

    /* The samples of the piece, then the call. */
    void compute()
    {
        Samples flight;
        Handle<sins_sim> sim;
        flight.open(scene, folder);
        size_t first = (size_t)std::fmin(from_s / flight.period_s + 1e-6, (double)flight.count);
        size_t last = (size_t)std::fmin(to_s / flight.period_s + 1e-6, (double)flight.count - 1);
        if (last <= first || last - first >= kind.most) {
            throw Refusal{last <= first ? text("no_piece", {shown(flight.duration_s, 10)})
                                        : text("too_long", {std::to_wstring(kind.most)})};
        }
        std::vector<sins_flight_sample> samples(last - first + 1, sized<sins_flight_sample>());
        check(lib.sins_scene_create_simulator(scene.handle(), &sim));
        for (size_t k = 0; k < samples.size() && !is_cancelled; k++) {
            check(flight.get(first + k, &samples[k])); /* and its temperature: no failures here */
            check(lib.sins_scene_prepare(scene.handle(), sim, flight.start_s, &samples[k]));
        }
        if (!is_cancelled) {
            kind.call(sim, samples, limits, result);
        }
    }
};

/* The one study that runs. A call of the library cannot be interrupted: after a cancel, and when the dialog
 * is closed, it ends by itself; the next study waits for that, so that no more than one takes memory and
 * time. */
static std::shared_ptr<Study> running;

class StudyDialog : public Dialog {
public:
    StudyDialog(App &app, const Kind &kind) : app_(app), kind_(kind) {}
    ~StudyDialog() override { cancel(); }

protected:
    void on_init() override
    {
        SetWindowTextW(window_, text(kind_.title).c_str());
        set(IDC_LAST_LABEL, text(kind_.last));
        columns(IDC_RESULT, kind_.columns, kind_.widths);
        show(IDC_ADOPT, &kind_ == &RECOMMEND);
        enable(IDC_ADOPT, false);
        set(IDC_LIMIT_POSITION, &kind_ == &RECOMMEND ? L"1" : L"");
        set(IDC_FROM, L"0");
        SetTimer(window_, 1, 100, NULL);
        Samples samples;
        samples.open(app_.scene, app_.folder());
        set(IDC_TO, shown(min(samples.duration_s, 600.0), 10));
    }

    void on_refusal(const std::wstring &sentence) override { set(IDC_STATE, sentence); }

    void on_command(int id, int) override
    {
        if (id == IDC_COMPUTE && study_ != NULL) {
            cancel();
            set(IDC_STATE, text("cancelled"));
            set(IDC_COMPUTE, text("&Compute"));
        } else if ((id == IDC_COMPUTE || id == IDOK) && study_ == NULL) {
            start();
        } else if (id == IDC_ADOPT) {
            adopt();
        }
    }

    bool on_message(UINT message, WPARAM, LPARAM) override
    {
        if (message != WM_TIMER) {
            return false;
        }
        if (running != NULL && running->is_done) {
            running.reset();
        }
        if (study_ != NULL && !study_->is_done && running == NULL) {
            running = study_;
            set(IDC_STATE, text("computing"));
            std::thread([own = running] {
                try {
                    own->compute();
                } catch (const Refusal &refusal) {
                    own->result.sentence = refusal.sentence;
                }
                own->is_done = true;
            }).detach();
        } else if (study_ != NULL && study_->is_done) {
            result_ = study_->result;
            set(IDC_COMPUTE, text("&Compute"));
            set(IDC_STATE, result_.sentence);
            rows(IDC_RESULT, result_.rows);
            enable(IDC_ADOPT, result_.has_options);
            study_.reset();
        }
        return true;
    }

private:
    /* A number of a field, 0 where it is empty. What is none is marked. */
    double number(int id)
    {
        double value = 0;
        std::string typed = narrow(get(id));
        bool is_number = typed.empty() || (number_of(typed, value) && value >= 0);
        mark(item(id), is_number ? L"" : text("not_valid", {wide(typed)}));
        return is_number ? value : 0;
    }

    void start()
    {
        Limits limits = {number(IDC_LIMIT_POSITION), number(IDC_LIMIT_VELOCITY),
                         number(IDC_LIMIT_ATTITUDE) * SINS_ARCSEC, number(IDC_LAST)};
        auto study = std::shared_ptr<Study>(
            new Study{kind_, Scene(), app_.folder(), number(IDC_FROM), number(IDC_TO), limits, {}});
        if (has_marks()) {
            throw Refusal{text("field_not_valid")};
        }
        study->scene.read(app_.scene.text());
        study_ = study;
        set(IDC_STATE, text("waiting"));
        set(IDC_COMPUTE, text("&Cancel"));
        on_message(WM_TIMER, 0, 0);
    }

    void cancel()
    {
        if (study_ != NULL) {
            study_->is_cancelled = true;
            study_.reset();
        }
    }

    /* The recommended options for the scene. The simulator's sample period is that of the flight, and stays
     * out. */
    void adopt()
    {
        sins_options options = sized<sins_options>();
        lib.sins_scene_get_options(app_.scene.handle(), &options);
        options.scheme = result_.options.scheme;
        options.subsamples = result_.options.subsamples;
        options.updates_per_sample = result_.options.updates_per_sample;
        app_.scene.taken(lib.sins_scene_set_options(app_.scene.handle(), &options));
        app_.edited(L"");
    }

    App &app_;
    const Kind &kind_;
    std::shared_ptr<Study> study_; /* the one that is waited for */
    Result result_;
};

void recommend(App &app)
{
    StudyDialog(app, RECOMMEND).modal(app.window(), IDD_STUDY);
}

void error_budget(App &app)
{
    StudyDialog(app, BUDGET).modal(app.window(), IDD_STUDY);
}
