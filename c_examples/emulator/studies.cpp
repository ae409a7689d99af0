/* Studies of the flight at hand: the options that it needs, and the budget of its errors. A worker thread computes. */
#include "app.h"

#include <cmath>

static const UINT DONE = WM_APP + 1;
/* Samples that sins_recommend() takes, and those of a budget that fit into memory. */
static const size_t RECOMMEND_SAMPLES = 360000, BUDGET_SAMPLES = 2000000;

/* A computation of its own: it lives on after a cancel, until the library returns. */
struct Study {
    HWND window;
    Handle<sins_sim> sim;
    std::vector<sins_flight_sample> samples;
    sins_requirement requirement;
    sins_budget_request request;
    sins_options options;
    sins_cost cost;
    std::vector<sins_budget_row> rows;
    sins_budget budget;
    sins_status status;
    std::string sentence;
    std::function<sins_status(Study &)> compute;
};

static DWORD WINAPI study_thread(void *pointer)
{
    Study *study = (Study *)pointer;
    study->status = study->compute(*study);
    study->sentence = study->status < 0 ? last_error() : "";
    if (!PostMessageW(study->window, DONE, 0, (LPARAM)study)) {
        delete study; /* the dialog was closed */
    }
    return 0;
}

class StudyDialog : public Dialog {
public:
    explicit StudyDialog(App &app) : app_(app) {}

protected:
    void on_init() override;
    void on_command(int id, int code) override;
    void on_message(UINT message, WPARAM wparam, LPARAM lparam) override;
    virtual size_t most() const = 0;
    virtual void begin(Study &study) = 0;
    virtual void show(const Study &study) = 0;
    virtual void adopt() {}
    double number(int id);
    App &app_;

private:
    void compute();
    Study *study_ = NULL; /* the one that is waited for */
};

void StudyDialog::on_init()
{
    Samples samples;
    std::wstring why;
    double length_s = samples.open(app_.scene, app_.folder(), why) ? samples.duration_s : 0;
    set(IDC_FROM, L"0");
    set(IDC_TO, shown(min(length_s, 600.0), 10));
    set(IDC_STATE, why);
    enable(IDC_ADOPT, false);
}

/* A number of a field, 0 where it is empty; -1 marks it. */
double StudyDialog::number(int id)
{
    double value = 0;
    std::string typed = narrow(get(id));
    bool is_number = typed.empty() || (number_of(typed, value) && value >= 0);
    mark(id, is_number ? L"" : text(IDS_NOT_VALID, wide(typed)));
    return is_number ? value : -1;
}

void StudyDialog::compute()
{
    Samples samples;
    std::wstring why;
    double from_s = number(IDC_FROM), to_s = number(IDC_TO);
    Study *study = new Study();
    study->window = window_;
    if (!samples.open(app_.scene, app_.folder(), why) || lib.sins_scene_create_simulator(app_.scene.handle(), &study->sim) < 0) {
        set(IDC_STATE, why.empty() ? wide(last_error()) : why);
        delete study;
        return;
    }
    begin(*study);
    size_t first = (size_t)std::fmin(from_s / samples.period_s + 1e-6, (double)samples.count);
    size_t last = (size_t)std::fmin(to_s / samples.period_s + 1e-6, (double)samples.count - 1);
    bool is_long = last >= first && last - first >= most();
    if (has_marks() || from_s >= to_s || is_long) {
        set(IDC_STATE, is_long ? text(IDS_TOO_LONG, std::to_wstring(most())) : text(IDS_NOT_VALID, get(IDC_FROM) + L" - " + get(IDC_TO)));
        delete study;
        return;
    }
    study->samples.resize(last - first + 1);
    for (size_t k = first; k <= last; k++) {
        sins_flight_sample &sample = study->samples[k - first];
        SINS_INIT(sample);
        samples.get(k, &sample);
        lib.sins_scene_prepare(app_.scene.handle(), study->sim, samples.start_s, &sample); /* its temperature: no failures here */
    }
    study_ = study;
    set(IDC_STATE, text(IDS_COMPUTING, std::to_wstring(study->samples.size())));
    set(IDC_COMPUTE, parts(IDS_CANCELLED)[1]);
    CloseHandle(CreateThread(NULL, 0, study_thread, study, 0, NULL));
}

void StudyDialog::on_command(int id, int)
{
    if (id == IDC_COMPUTE && study_ != NULL) {
        study_ = NULL; /* the answer that comes is not waited for */
        set(IDC_STATE, parts(IDS_CANCELLED)[0]);
        set(IDC_COMPUTE, parts(IDS_CANCELLED)[2]);
    } else if (id == IDC_COMPUTE || id == IDOK) {
        compute();
    } else if (id == IDC_ADOPT) {
        adopt();
    }
}

void StudyDialog::on_message(UINT message, WPARAM, LPARAM lparam)
{
    if (message != DONE) {
        return;
    }
    Study *study = (Study *)lparam;
    if (study == study_) {
        study_ = NULL;
        set(IDC_COMPUTE, parts(IDS_CANCELLED)[2]);
        set(IDC_STATE, wide(study->sentence));
        if (study->status >= 0) {
            show(*study);
        }
    }
    delete study;
}

class RecommendDialog : public StudyDialog {
public:
    using StudyDialog::StudyDialog;

protected:
    void on_init() override;
    size_t most() const override { return RECOMMEND_SAMPLES; }
    void begin(Study &study) override;
    void show(const Study &study) override;
    void adopt() override;

private:
    sins_options options_;
};

void RecommendDialog::on_init()
{
    StudyDialog::on_init();
    columns(IDC_RESULT, parts(IDS_COLUMNS_RECOMMEND), {240, 170});
    set(IDC_LIMIT_POSITION, L"1");
}

void RecommendDialog::begin(Study &study)
{
    SINS_INIT(study.requirement);
    SINS_INIT(study.options);
    SINS_INIT(study.cost);
    study.requirement.position_m = number(IDC_LIMIT_POSITION);
    study.requirement.velocity_m_s = number(IDC_LIMIT_VELOCITY);
    study.requirement.attitude_rad = number(IDC_LIMIT_ATTITUDE) * SINS_ARCSEC;
    study.requirement.duration_s = number(IDC_FOR);
    study.compute = [](Study &own) {
        return lib.sins_recommend(own.sim, own.samples.data(), own.samples.size(), &own.requirement, &own.options, &own.cost);
    };
}

void RecommendDialog::show(const Study &study)
{
    const sins_cost &cost = study.cost;
    const Key *scheme = key_of("options.scheme");
    std::string word = scheme->words[(size_t)study.options.scheme];
    std::vector<std::wstring> names = parts(IDS_RECOMMEND_ROWS);
    const std::wstring values[] = {label("options.scheme." + word, word), std::to_wstring(study.options.subsamples),
                                   std::to_wstring(study.options.updates_per_sample), shown(cost.position_m, 4) + L" m",
                                   shown(cost.velocity_m_s, 4) + L" m/s", shown(cost.attitude_rad / SINS_ARCSEC, 4) + L" \u2033",
                                   shown(cost.instructions_per_step, 6), shown(cost.ns_per_step, 4) + L" ns", std::to_wstring(cost.tried)};
    for (size_t k = 0; k < names.size() && k < sizeof values / sizeof values[0]; k++) {
        row(IDC_RESULT, (int)k, {names[k], values[k]});
    }
    set(IDC_STATE, parts(IDS_MET)[study.status == SINS_REQUIREMENT_NOT_MET ? 1 : 0]);
    options_ = study.options;
    enable(IDC_ADOPT, true);
}

/* Makes the recommended options those of the scene. The simulator's sample period is that of the flight, and stays out. */
void RecommendDialog::adopt()
{
    sins_options options;
    SINS_INIT(options);
    lib.sins_scene_get_options(app_.scene.handle(), &options);
    options.scheme = options_.scheme;
    options.subsamples = options_.subsamples;
    options.updates_per_sample = options_.updates_per_sample;
    app_.edited(app_.scene.take(lib.sins_scene_set_options(app_.scene.handle(), &options)) ? L"" : wide(last_error()));
}

class BudgetDialog : public StudyDialog {
public:
    using StudyDialog::StudyDialog;

protected:
    void on_init() override;
    void on_notify(NMHDR *notice) override;
    size_t most() const override { return BUDGET_SAMPLES; }
    void begin(Study &study) override;
    void show(const Study &study) override;

private:
    std::vector<double> shares_; /* of the largest position: the bars */
};

void BudgetDialog::on_init()
{
    StudyDialog::on_init();
    columns(IDC_RESULT, parts(IDS_COLUMNS_BUDGET), {176, 110, 84, 84, 84});
}

void BudgetDialog::begin(Study &study)
{
    SINS_INIT(study.request);
    SINS_INIT(study.budget);
    study.request.runs = (uint64_t)std::fmax(0, number(IDC_RUNS));
    study.request.position_m = number(IDC_LIMIT_POSITION);
    study.request.velocity_m_s = number(IDC_LIMIT_VELOCITY);
    study.request.attitude_rad = number(IDC_LIMIT_ATTITUDE) * SINS_ARCSEC;
    study.compute = [](Study &own) {
        sins_budget_row row;
        size_t count = 0;
        SINS_INIT(row);
        lib.sins_error_budget(own.sim, own.samples.data(), own.samples.size(), &own.request, NULL, 0, &count, NULL);
        own.rows.assign(count + 1, row);
        return lib.sins_error_budget(own.sim, own.samples.data(), own.samples.size(), &own.request, own.rows.data(), own.rows.size(),
                                     &count, &own.budget);
    };
}

void BudgetDialog::show(const Study &study)
{
    int count = 0;
    double largest = 1e-300;
    for (const sins_budget_row &own : study.rows) {
        largest = std::fmax(largest, own.position_m);
    }
    shares_.clear();
    for (const sins_budget_row &own : study.rows) {
        if (own.effect[0] == '\0') {
            continue;
        }
        const Key *key = key_of(std::string(own.field).find("accel.") == 0 ? "accelerometer." + std::string(own.field + 6) : own.field);
        std::wstring name = label(std::string("effect.") + own.effect, own.effect);
        if (key != NULL && language() == LANG_CHINESE) {
            name = label("section." + key->section, key->section) + L"\u00b7" + label(key->path(), own.effect);
        }
        shares_.push_back(own.position_m / largest);
        name += (own.flags & SINS_BUDGET_RANDOM) != 0 ? L" (1\u03c3)" : L"";
        name += (own.flags & SINS_BUDGET_CAN_BE_LEFT_OUT) != 0 ? L" *" : L"";
        row(IDC_RESULT, count++, {name, L"", shown(own.position_m, 4), shown(own.velocity_m_s, 4), shown(own.attitude_rad / SINS_ARCSEC, 4)});
    }
    const sins_budget &budget = study.budget;
    shares_.push_back(0);
    row(IDC_RESULT, count++, {text(IDS_BUDGET_TOTAL), L"", shown(budget.position_m, 4),
                              shown(budget.velocity_m_s, 4), shown(budget.attitude_rad / SINS_ARCSEC, 4)});
    keep_rows(IDC_RESULT, count);
}

/* The second column is a bar. */
void BudgetDialog::on_notify(NMHDR *notice)
{
    NMLVCUSTOMDRAW *draw = (NMLVCUSTOMDRAW *)notice;
    if (notice->idFrom != IDC_RESULT || notice->code != (UINT)NM_CUSTOMDRAW) {
        return;
    }
    LRESULT result = draw->nmcd.dwDrawStage == CDDS_PREPAINT       ? CDRF_NOTIFYITEMDRAW
                     : draw->nmcd.dwDrawStage == CDDS_ITEMPREPAINT ? CDRF_NOTIFYPOSTPAINT
                                                                   : CDRF_DODEFAULT;
    if (draw->nmcd.dwDrawStage == CDDS_ITEMPOSTPAINT && draw->nmcd.dwItemSpec < shares_.size()) {
        RECT bar = {LVIR_BOUNDS, 1, 0, 0};
        SendMessageW(notice->hwndFrom, LVM_GETSUBITEMRECT, draw->nmcd.dwItemSpec, (LPARAM)&bar);
        InflateRect(&bar, -3, -3);
        bar.right = bar.left + (LONG)((bar.right - bar.left) * shares_[draw->nmcd.dwItemSpec]);
        SetDCBrushColor(draw->nmcd.hdc, RGB(0, 110, 200));
        FillRect(draw->nmcd.hdc, &bar, (HBRUSH)GetStockObject(DC_BRUSH));
    }
    SetWindowLongPtrW(window_, DWLP_MSGRESULT, result);
}

void recommend(App &app)
{
    RecommendDialog(app).modal(app.window(), IDD_RECOMMEND);
}

void error_budget(App &app)
{
    BudgetDialog(app).modal(app.window(), IDD_BUDGET);
}
