#include "study.h"

#include <cmath>

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

void StudyDialog::on_init()
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

void StudyDialog::on_command(int id, int)
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

void StudyDialog::on_timer()
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

double StudyDialog::number(int id)
{
    double value = 0;
    std::string typed = narrow(get(id));
    bool is_number = typed.empty() || (number_of(typed, value) && value >= 0);
    mark(item(id), is_number ? L"" : text("not_valid", {wide(typed)}));
    return is_number ? value : 0;
}

void StudyDialog::start()
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

void StudyDialog::cancel()
{
    if (study_ != NULL) {
        study_->is_cancelled = true;
        study_.reset();
    }
}
