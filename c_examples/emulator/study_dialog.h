/* The studies: the options that the flight needs, and the budget of its errors. A worker thread computes. */
#pragma once
#include "document.h"

/* What a study finds. */
struct Result {
    Rows rows;
    std::wstring sentence;
    std::optional<sins_options> options;
};

/* Limits of the errors; the last number is the duration [s], or the runs. */
struct Limits {
    double position_m, velocity_m_s, attitude_rad, last;
};

typedef std::vector<sins_flight_sample> Piece;

/* One kind of study: its texts, the samples that the library takes, and its call. */
struct Kind {
    const char *title, *last, *last_tip, *columns;
    size_t most;
    Result (*call)(const sins::Simulator &sim, const Piece &piece, const Limits &limits);
};

/* The options that meet the limits. */
inline Result find_options(const sins::Simulator &sim, const Piece &piece, const Limits &limits) {
    Result result;
    sins_requirement requirement = sins::make<sins_requirement>();
    sins_cost cost = sins::make<sins_cost>();
    sins_options options = sins::make<sins_options>();
    const Key &scheme = *key_of("options.scheme");
    requirement.position_m = limits.position_m;
    requirement.velocity_m_s = limits.velocity_m_s;
    requirement.attitude_rad = limits.attitude_rad;
    requirement.duration_s = limits.last;
    bool is_met = sim.recommend(piece.data(), piece.size(), requirement, options, cost);
    const Texts names = parts("recommend_rows");
    const Texts values = {scheme.word_label(scheme.choices()[options.scheme]),
                          std::to_wstring(options.subsamples),
                          std::to_wstring(options.updates_per_sample),
                          shown(cost.position_m, 4) + L" m",
                          shown(cost.velocity_m_s, 4) + L" m/s",
                          shown(cost.attitude_rad / SINS_ARCSEC, 4) + L" \u2033",
                          shown(cost.instructions_per_step, 6),
                          shown(cost.ns_per_step, 4) + L" ns",
                          std::to_wstring(cost.tried)};
    for (size_t k = 0; k < names.size(); k++)
        result.rows.push_back({{names[k], values[k]}});
    result.sentence = parts("met")[is_met ? 0 : 1];
    result.options = options;
    return result;
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

/* The share of each error; a bar is of the largest in position. */
inline Result find_shares(const sins::Simulator &sim, const Piece &piece, const Limits &limits) {
    Result result;
    sins_budget_request request = sins::make<sins_budget_request>();
    std::vector<sins_budget_row> rows;
    double largest = 1e-300;
    request.runs = (uint64_t)limits.last;
    request.position_m = limits.position_m;
    request.velocity_m_s = limits.velocity_m_s;
    request.attitude_rad = limits.attitude_rad;
    sins_budget budget = sim.error_budget(piece.data(), piece.size(), request, rows);
    auto add = [&](const std::wstring &name, const auto &errors, double bar) {
        std::wstring attitude = shown(errors.attitude_rad / SINS_ARCSEC, 4);
        result.rows.push_back(
            {{name, L"", shown(errors.position_m, 4), shown(errors.velocity_m_s, 4), attitude}, false, bar});
    };
    for (const sins_budget_row &row : rows)
        largest = max(largest, row.position_m);
    for (const sins_budget_row &row : rows)
        add(name_of(row), row, row.position_m / largest);
    add(text("budget_total"), budget, 0);
    return result;
}

inline const Kind RECOMMEND = {
    "Recommended options", "For the &duration [s]", "tip_duration", "columns_recommend", 360000, find_options};
inline const Kind BUDGET = {"Error budget", "&Runs", "tip_runs", "columns_budget", 2000000, find_shares};

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
    void compute() {
        Samples flight(scene, folder);
        sins::Simulator sim = scene->create_simulator();
        size_t first = (size_t)min(from_s / flight.all.period_s + 1e-6, (double)flight.all.count);
        size_t last = (size_t)min(to_s / flight.all.period_s + 1e-6, (double)flight.all.count - 1);
        if (last <= first || last - first >= kind.most) {
            throw Refusal(last <= first ? text("no_piece", {shown(flight.all.duration_s, 10)})
                                        : text("too_long", {std::to_wstring(kind.most)}));
        }
        Piece piece;
        for (size_t k = first; k <= last && !is_cancelled; k++) {
            piece.push_back(flight.get(k)); /* and its temperature: no failures here */
            scene->prepare(sim, flight.all.start_s, piece.back());
        }
        if (!is_cancelled)
            result = kind.call(sim, piece, limits);
    }
};

class StudyDialog : public Dialog {
public:
    StudyDialog(Document &document, const Kind &kind) : document_(document), kind_(kind) {}
    ~StudyDialog() override { cancel(); }

protected:
    void on_init() override {
        SetWindowTextW(window_, text(kind_.title).c_str());
        set(IDC_LAST_LABEL, text(kind_.last));
        add_columns(item(IDC_RESULT), kind_.columns);
        show(IDC_ADOPT, &kind_ == &RECOMMEND);
        enable(IDC_ADOPT, false);
        set(IDC_LIMIT_POSITION, &kind_ == &RECOMMEND ? L"1" : L"");
        set(IDC_FROM, L"0");
        SetTimer(window_, 1, 100, NULL);
        for (int id : {IDC_LIMIT_POSITION, IDC_LIMIT_VELOCITY, IDC_LIMIT_ATTITUDE})
            tip(item(id), text("tip_limit"));
        tip(item(IDC_LAST), text(kind_.last_tip));
        double duration_s = Samples(document_.scene, document_.folder()).all.duration_s;
        for (int id : {IDC_FROM, IDC_TO})
            tip(item(id), text("range", {L"0", shown(duration_s, 10)}));
        set(IDC_TO, shown(min(duration_s, 600.0), 10));
    }

    void on_refusal(const std::wstring &sentence) override { set(IDC_STATE, sentence); }

    void on_command(int id, int) override {
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

    bool on_message(UINT message, WPARAM, LPARAM) override {
        if (message != WM_TIMER)
            return false;
        if (running_ != NULL && running_->is_done)
            running_.reset();
        if (study_ != NULL && !study_->is_done && running_ == NULL) {
            running_ = study_;
            set(IDC_STATE, text("computing"));
            std::thread([own = running_] {
                try {
                    own->compute();
                } catch (const std::exception &error) {
                    own->result.sentence = told(error);
                }
                own->is_done = true;
            }).detach();
        } else if (study_ != NULL && study_->is_done) {
            result_ = study_->result;
            set(IDC_COMPUTE, text("&Compute"));
            set(IDC_STATE, result_.sentence);
            rows(IDC_RESULT, result_.rows);
            enable(IDC_ADOPT, result_.options.has_value());
            study_.reset();
        }
        return true;
    }

private:
    /* A number of a field, 0 where it is empty. What is none is marked. */
    double number(int id) {
        double value = 0;
        std::string typed = narrow(get(id));
        bool is_number = typed.empty() || (number_of(typed, value) && value >= 0);
        mark(item(id), is_number ? L"" : text("not_valid", {wide(typed)}));
        return is_number ? value : 0;
    }

    void start() {
        Limits limits = {number(IDC_LIMIT_POSITION), number(IDC_LIMIT_VELOCITY),
                         number(IDC_LIMIT_ATTITUDE) * SINS_ARCSEC, number(IDC_LAST)};
        std::shared_ptr<Study> study(
            new Study{kind_, Scene(document_.scene), document_.folder(), number(IDC_FROM), number(IDC_TO), limits, {}});
        if (has_marks())
            throw Refusal(text("field_not_valid"));
        study_ = study;
        set(IDC_STATE, text("waiting"));
        set(IDC_COMPUTE, text("&Cancel"));
        on_message(WM_TIMER, 0, 0);
    }

    void cancel() {
        if (study_ != NULL) {
            study_->is_cancelled = true;
            study_.reset();
        }
    }

    /* The recommended options for the scene. The simulator's sample period is that of the flight, and stays
     * out. */
    void adopt() {
        const sins_options &options = *result_.options;
        Faults faults =
            document_.scene.set({{"options.scheme", key_of("options.scheme")->choices()[options.scheme]},
                                 {"options.subsamples", std::to_string(options.subsamples)},
                                 {"options.updates_per_sample", std::to_string(options.updates_per_sample)}});
        document_.edited(told(faults));
    }

    /* The one study that runs. A call of the library cannot be interrupted: after a cancel, and when the
     * dialog is closed, it ends by itself; the next study waits for that, so that no more than one takes
     * memory and time. */
    inline static std::shared_ptr<Study> running_;

    Document &document_;
    const Kind &kind_;
    std::shared_ptr<Study> study_; /* the one that is waited for */
    Result result_;
};
