/* The studies: the options that the flight needs, and the budget of its errors. A worker thread computes. */
#pragma once
#include "document.h"

/* Result of a study. */
struct Result {
    Rows rows;
    std::wstring sentence;
    std::optional<sins_options> options;
};

typedef std::vector<sins_flight_sample> Piece;

/* One kind of study: its texts, the largest number of samples, and its call. `last` is a duration or a number of runs. */
struct Kind {
    const char *title, *last, *last_tip, *columns;
    size_t most;
    Result (*call)(const sins::Simulator &sim, const Piece &piece, sins_requirement limits, double last);
};

/* Finds the options that meet the limits. */
inline Result find_options(const sins::Simulator &sim, const Piece &piece, sins_requirement limits, double duration_s) {
    sins_cost cost = sins::make<sins_cost>();
    sins_options options = sins::make<sins_options>();
    const Key &scheme = *key_of("options.scheme");
    limits.duration_s = duration_s;
    auto at = [](double value, const wchar_t *unit, double time_s) {
        return shown(value, 4) + unit + L" @ " + shown(time_s, 8) + L" s";
    };
    bool is_met = sins::recommend(sim, piece.data(), piece.size(), limits, options, cost);
    Rows rows = rows_of("recommend_rows", {scheme.word_label(scheme.choices()[options.scheme]),
                                           std::to_wstring(options.subsamples),
                                           std::to_wstring(options.updates_per_sample),
                                           shown(cost.position_m, 4) + L" m",
                                           shown(cost.velocity_m_s, 4) + L" m/s",
                                           shown(cost.attitude_rad / SINS_ARCSEC, 4) + L" \u2033",
                                           shown(cost.instructions_per_step, 6),
                                           std::to_wstring(cost.tried),
                                           at(cost.rate_max_rad_s / SINS_DEG, L"\u00b0/s", cost.rate_max_at_s),
                                           at(cost.force_max_m_s2, L" m/s\u00b2", cost.force_max_at_s),
                                           at(cost.vibration_max_rad_s2 / SINS_DEG, L"\u00b0/s\u00b2",
                                              cost.vibration_max_at_s)});
    return {rows, parts("met")[is_met ? 0 : 1], options};
}

inline std::wstring name_of(const sins_budget_row &row) {
    std::string field = row.field;
    const Key *key = key_of(field.starts_with("accel.") ? "accelerometer" + field.substr(5) : field);
    std::wstring name = label(std::string("effect.") + row.effect, row.effect);
    if (key != NULL && language == 1)
        name = label(std::string("section.") + key->section, key->section) + L"\u00b7" + key->meaning();
    name += (row.flags & SINS_BUDGET_RANDOM) != 0 ? L" (1\u03c3)" : L"";
    return name + ((row.flags & SINS_BUDGET_CAN_BE_LEFT_OUT) != 0 ? L" *" : L"");
}

/* Finds the share of each error. A bar shows its position error relative to the largest one. */
inline Result find_shares(const sins::Simulator &sim, const Piece &piece, sins_requirement limits, double runs) {
    sins_budget_request request = sins::make<sins_budget_request>();
    std::vector<sins_budget_row> shares;
    request.runs = (uint64_t)runs;
    request.position_m = limits.position_m;
    request.velocity_m_s = limits.velocity_m_s;
    request.attitude_rad = limits.attitude_rad;
    sins_budget budget = sins::error_budget(sim, piece.data(), piece.size(), request, shares);
    double largest = 1e-300;
    for (const sins_budget_row &row : shares)
        largest = max(largest, row.position_m);
    auto row_of = [](const std::wstring &name, const auto &errors, double bar) {
        std::wstring attitude = shown(errors.attitude_rad / SINS_ARCSEC, 4);
        return Row{{name, L"", shown(errors.position_m, 4), shown(errors.velocity_m_s, 4), attitude}, false, bar};
    };
    Result result;
    for (const sins_budget_row &row : shares)
        result.rows.push_back(row_of(name_of(row), row, row.position_m / largest));
    result.rows.push_back(row_of(text("budget_total"), budget, 0));
    return result;
}

inline const Kind RECOMMEND = {
    "Recommended options", "For the &duration [s]", "tip_duration", "columns_recommend", 360000, find_options};
inline const Kind BUDGET = {"Error budget", "&Runs", "tip_runs", "columns_budget", 2000000, find_shares};

/* A computation with its input and result, shared by its thread and the dialog. */
struct Study {
    const Kind &kind;
    Scene scene;
    fs::path folder;
    double from_s, to_s, last;
    sins_requirement limits;
    Result result;
    std::atomic<const char *> state{"waiting"}; /* name of the text of the state; NULL: done */
    std::atomic<bool> is_cancelled{false};

    /* Runs one study at a time. A call of the library cannot be interrupted: after a cancel, or when the dialog is
     * closed, it runs to its end. The next study waits for this, so that only one study uses memory and time. */
    void run() {
        static std::mutex one;
        std::lock_guard<std::mutex> guard(one);
        state = "computing";
        try {
            compute();
        } catch (const std::exception &error) {
            result.sentence = told(error);
        }
        state = NULL;
    }

    /* Makes the samples of the piece, then calls the library. */
    void compute() {
        Samples flight(scene, folder);
        sins::Simulator sim = scene.create_simulator();
        size_t first = (size_t)min(from_s / flight.all.period_s + 1e-6, (double)flight.all.count);
        size_t end = (size_t)min(to_s / flight.all.period_s + 1e-6, (double)flight.all.count - 1);
        if (end <= first)
            throw Refusal(text("no_piece", {shown(flight.all.duration_s, 10)}));
        if (end - first >= kind.most)
            throw Refusal(text("too_long", {std::to_wstring(kind.most)}));
        Piece piece;
        for (size_t k = first; k <= end && !is_cancelled; k++) {
            piece.push_back(flight.get(k)); /* prepare() sets its temperature; failures have no effect here */
            scene.prepare(sim, flight.all.start_s, piece.back());
        }
        if (!is_cancelled)
            result = kind.call(sim, piece, limits, last);
    }
};

class StudyDialog : public Dialog {
public:
    StudyDialog(Document &document, const Kind &kind) : document_(document), kind_(kind) {}
    ~StudyDialog() override { cancel(); }

protected:
    void on_init() override {
        Samples samples(document_.scene, document_.folder());
        double duration_s = samples.all.duration_s, most_s = (kind_.most - 1.0) * samples.all.period_s;
        SetWindowTextW(window_, text(kind_.title).c_str());
        set(IDC_LAST_LABEL, text(kind_.last));
        add_columns(item(IDC_RESULT), kind_.columns);
        show(IDC_ADOPT, &kind_ == &RECOMMEND);
        enable(IDC_ADOPT, false);
        set(IDC_LIMIT, &kind_ == &RECOMMEND ? L"1" : L"");
        set(IDC_FROM, L"0");
        set(IDC_TO, shown(min(duration_s, &kind_ == &RECOMMEND ? most_s : 600.0), 10));
        for (int id : {IDC_FROM, IDC_TO})
            tip(item(id), text("range", {L"0", shown(duration_s, 10)}));
        for (int id : {IDC_LIMIT, IDC_LIMIT + 1, IDC_LIMIT + 2})
            tip(item(id), text("tip_limit"));
        tip(item(IDC_LAST), text(kind_.last_tip));
        SetTimer(window_, 1, 100, NULL);
    }

    void on_refusal(const std::wstring &sentence) override { set(IDC_STATE, sentence); }

    void on_command(int id, int) override {
        if (id == IDC_COMPUTE && study_ != NULL) {
            cancel();
            set(IDC_STATE, text("cancelled"));
        } else if (id == IDC_COMPUTE || id == IDOK) {
            start();
        } else if (id == IDC_ADOPT) {
            adopt();
        }
    }

    bool on_message(UINT message, WPARAM, LPARAM) override {
        if (message != WM_TIMER || study_ == NULL)
            return false;
        const char *state = study_->state;
        set(IDC_STATE, state != NULL ? text(state) : study_->result.sentence);
        if (state == NULL) {
            options_ = study_->result.options;
            rows(IDC_RESULT, study_->result.rows);
            enable(IDC_ADOPT, options_.has_value());
            cancel();
        }
        return true;
    }

private:
    /* The number in a field; 0 for an empty field. A field without a valid number is marked. */
    double number(int id) {
        double value = 0;
        std::string typed = narrow(get(id));
        bool is_number = typed.empty() || (number_of(typed, value) && value >= 0);
        mark(item(id), !is_number);
        return is_number ? value : 0;
    }

    void start() {
        sins_requirement limits = sins::make<sins_requirement>();
        limits.position_m = number(IDC_LIMIT);
        limits.velocity_m_s = number(IDC_LIMIT + 1);
        limits.attitude_rad = number(IDC_LIMIT + 2) * SINS_ARCSEC;
        std::shared_ptr<Study> study(new Study{kind_, document_.scene, document_.folder(), number(IDC_FROM),
                                               number(IDC_TO), number(IDC_LAST), limits, {}});
        if (has_marks())
            throw Refusal(text("field_not_valid"));
        study_ = study;
        set(IDC_COMPUTE, text("&Cancel"));
        std::thread([study] { study->run(); }).detach();
    }

    /* Cancels the study; the dialog no longer waits for it. */
    void cancel() {
        if (study_ != NULL)
            study_->is_cancelled = true;
        study_.reset();
        set(IDC_COMPUTE, text("&Compute"));
    }

    /* Sets the recommended options in the scene. The sample period is not set, because it belongs to the flight. */
    void adopt() {
        Changes changes = {{"options.scheme", key_of("options.scheme")->choices()[options_->scheme]},
                           {"options.subsamples", std::to_string(options_->subsamples)},
                           {"options.updates_per_sample", std::to_string(options_->updates_per_sample)}};
        document_.edited(told(document_.scene.set(changes)));
    }

    Document &document_;
    const Kind &kind_;
    std::shared_ptr<Study> study_; /* the study that the dialog waits for */
    std::optional<sins_options> options_;
};
