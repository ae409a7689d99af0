/* sins.hpp: what it adds to sins.h. Ownership, errors as exceptions with the right sentence, positive statuses as false. */

#include <cstring>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "check.h"
#include "sins_analysis.hpp"
#include "sins_scene.hpp"

template <class Call> sins::Error error_of(Call call) {
    try {
        call();
    } catch (const sins::Error &error) {
        return error;
    }
    std::fprintf(stderr, "no exception\n");
    std::exit(1);
}

static bool names(const sins::Error &error, const char *words) {
    return std::string(error.what()).find(words) != std::string::npos;
}

static sins_flight_sample at(double time_s) {
    auto sample = sins::make<sins_flight_sample>();
    sample.time_s = time_s;
    sample.latitude_rad = 40 * SINS_DEG;
    return sample;
}

/* Each call on a moved-from object throws, and not with the sentence of an earlier call. */
template <class Call> void rejects_no_handle(Call call) {
    error_of([] { sins::gyro_preset(99); });
    error_of([] { sins::initial_preset(99); });
    const sins::Error error = error_of(call);
    CHECK(error.status() == SINS_ERROR_BAD_HANDLE);
    CHECK(error.info().status == SINS_ERROR_BAD_HANDLE);
    CHECK(names(error, "SINS_ERROR_BAD_HANDLE") || names(error, "configured: is null, made up, destroyed"));
}

static void moved_objects() {
    static_assert(!std::is_copy_constructible<sins::Simulator>::value, "a handle has one owner");
    sins::Simulator sim, other(std::move(sim));
    sins::Scene scene, kept(std::move(scene));
    sins::Ensemble ensemble(other, 0, 3), runs(std::move(ensemble));
    sins::Unit unit(sins::make<sins_unit_params>(), SINS_UNIT_NAV), aligned(std::move(unit));
    auto options = sins::make<sins_options>();
    auto cost = sins::make<sins_cost>();
    auto requirement = sins::make<sins_requirement>();
    std::vector<sins_budget_row> rows;
    const sins_flight_sample samples[2] = {at(0), at(1)};

    requirement.position_m = 1;
    CHECK(other.handle() != nullptr && sim.handle() == nullptr);
    rejects_no_handle([&] { sim.step(); });
    rejects_no_handle([&] { sim.options(); });
    rejects_no_handle([&] { sins::recommend(sim, samples, 2, requirement, options, cost); });
    rejects_no_handle([&] { sins::error_budget(sim, samples, 2, sins::make<sins_budget_request>(), rows); });
    rejects_no_handle([&] { scene.write(); });
    rejects_no_handle([&] { scene.faults(); });
    rejects_no_handle([&] { scene.set_values("gyro.preset = tactical"); });
    rejects_no_handle([&] { ensemble.diverged(); });
    rejects_no_handle([&] { ensemble.runs(); });
    rejects_no_handle([&] { unit.select(SINS_UNIT_NAV); });
    CHECK(aligned.status().state == SINS_UNIT_STATE_NAVIGATION);

    sim = std::move(other); /* and back */
    CHECK(!sim.step() && runs.runs() == 3 && runs.diverged().empty() && kept.faults().empty());
}

/* A change that is rejected for another reason than faults throws the sentence of that reason. */
static void texts_of_scenes() {
    sins::Scene scene;
    const std::string nul("gyro.bias_deg_h = 1\0gyro.bias_deg_h = 2", 39);
    CHECK(!scene.set_values("\xff") && scene.faults().size() == 1);
    const sins::Error no_list = error_of([&] { scene.set_items("\xff", ""); });
    CHECK(names(no_list, "list: must be UTF-8") && no_list.status() == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(names(error_of([&] { scene.set_values(nul); }), "values: must not have a NUL"));
    CHECK(names(error_of([&] { scene.set_items("failure", nul); }), "items: must not have a NUL"));
    CHECK(names(error_of([&] { scene.set_text(SINS_SCENE_TEXT_TITLE, nul); }), "text: must not have a NUL"));
    CHECK(names(error_of([&] { scene.value(nul); }), "path: must not have a NUL"));
    CHECK(names(error_of([&] { sins::Scene::builtin(nul); }), "name: must not have a NUL"));
    CHECK(scene.value("gyro.bias_deg_h") == "0");
}

static void errors() {
    sins::Simulator sim, second;
    auto gyro = sins::make<sins_gyro_params>();

    gyro.bias_rad_s[1] = 1e9;
    const sins::Error error = error_of([&] { sim.set_gyro(gyro); });
    CHECK(error.status() == SINS_ERROR_INVALID_ARGUMENT && names(error, "gyro.bias_rad_s[1]"));
    CHECK(std::string(error.info().field) == "gyro.bias_rad_s" && error.info().index == 1 && error.info().value == 1e9);
    CHECK(sins::last_error(sim.handle()) == error.what());
    CHECK(sins::last_error(second.handle()) == "no error");
    CHECK(sim.gyro().bias_rad_s[1] == 0);
}

static void positive_statuses() {
    sins::Simulator sim;
    auto truth = sins::make<sins_navigation>();

    CHECK(!sim.get_truth(truth) && !sim.step());
    for (double time_s : {0.0, 0.1, 0.2})
        CHECK(sim.push_sample(at(time_s)));
    CHECK(!sim.push_sample(at(1.2))); /* a gap */
    CHECK(sim.step() && sim.step() && sim.step() && !sim.step());
    CHECK(sim.get_truth(truth) && truth.time_s == 1.2);
}

static void scenes() {
    sins::Scene broken("[flight]\nbuiltin = \"patrol\"\n[gyro]\nbais_deg_h = 1\n"), scene;
    CHECK(broken.faults().size() == 1);
    CHECK(error_of([&] { broken.write(); }).status() == SINS_ERROR_BAD_STATE);

    const std::string before = scene.write();
    CHECK(!scene.set_values("gyro.bias_deg_h = x\ngyro.scale_factor_ppm = 1e9\n"));
    CHECK(scene.faults().size() == 2 && scene.write() == before);
    CHECK(scene.set_values("gyro.bias_deg_h = 1\ngyro.preset = tactical\n") && scene.faults().empty());
    const sins_gyro_params gyro = scene.create_simulator().gyro();
    CHECK(gyro.bias_rad_s[2] == 1 * SINS_DEG_PER_HOUR);
    CHECK(gyro.bias_sigma_rad_s[0] > 0); /* the preset, below the value that was set */
    CHECK(!scene.set_items("manoeuvre", "[[manoeuvre]]\nkind = \"leap\"\n") && !scene.faults().empty());
    CHECK(!scene.set_items("sensor", "") && !scene.faults().empty());
    CHECK(error_of([&] { scene.value("gyro.none"); }).status() == SINS_ERROR_INVALID_ARGUMENT);

    sins::Scene joined("[flight]\nfile = \"log.csv\"\n[log]\nroll = { col = \"r\", file = \"other.csv\" }\n");
    CHECK(joined.log_file_names() == std::vector<std::string>(1, "other.csv"));
    const std::string log = "time_s,latitude_deg,longitude_deg,height_m\n0,48,11,0\n1,48,11,0\n";
    CHECK(names(error_of([&] { sins::Log(joined, log); }), "other.csv is not given"));
    joined.give_log_file("other.csv", "time_s,r,pitch_deg,heading_deg\n0,1,0,0\n1,2,0,0\n");
    CHECK(sins::Log(joined, log).info().samples == 2);
    CHECK(error_of([&] { joined.give_log_file("log.csv", log); }).status() == SINS_ERROR_INVALID_ARGUMENT);
}

static void snapshots() {
    sins::Simulator sim, other;
    sim.push_sample(at(0));
    const std::vector<unsigned char> saved = sim.snapshot_save();
    CHECK(saved.size() == sim.snapshot_size());
    other.snapshot_load(saved);
    CHECK(other.snapshot_save() == saved);
    const sins::Error error = error_of([&] { other.snapshot_load({1, 2, 3}); });
    CHECK(error.status() == SINS_ERROR_SNAPSHOT && other.snapshot_save() == saved);
}

static bool same_navigation(const sins::Play &one, const sins::Play &other) {
    const sins_record_solution navigation = one.record().navigation, found = other.record().navigation;
    return std::memcmp(&navigation, &found, sizeof navigation) == 0;
}

/* A scene in flight: samples of its own and of the host, what it shows, snapshots, a new plan, lent handles. */
static void plays() {
    sins::Scene scene("[flight]\nbuiltin = \"patrol\"\nrate_hz = 10\nhours = 0.01\n[unit]\nstart = \"nav\"\n"
                      "[output]\nevery_s = 9\n[gyro]\npreset = \"tactical\"\n");
    sins::Play play(scene), other(scene);
    sins_unit_status status;
    sins_unit_navigation shown;
    CHECK(!play.shown(status, shown) && play.next() == SINS_OK && play.next() == SINS_OK);
    CHECK(play.shown(status, shown) && status.state == SINS_UNIT_STATE_NAVIGATION && shown.time_s == 0.1);
    other.load(play.save());
    CHECK(play.run(2).size() == 2 && play.run(9).size() == 2 && play.next() == SINS_PLAY_END);
    other.finish();
    CHECK(same_navigation(play, other));
    CHECK(error_of([&] { other.push(at(1)); }).status() == SINS_ERROR_TIME_ORDER);
    {
        sins::Play::Lent<sins::Simulator> sim(other.simulator());
        sins::Play::Lent<sins::Unit> unit(other.unit());
        CHECK(sim->options().run == 0 && unit->status().state == SINS_UNIT_STATE_NAVIGATION);
    }
    CHECK(other.record().time_s == 36); /* the handles that it lent are alive */

    sins::Scene failing;
    CHECK(failing.set_items("failure", "[[failure]]\nsensor = \"gyro\"\naxis = \"x\"\nkind = \"dead\"\nfrom_s = 0\n"));
    sins::Play planned(scene);
    planned.set_plan(failing);
    planned.finish();
    CHECK(!same_navigation(play, planned));
}

/* A minute at rest with tactical sensors. */
static void identifications() {
    const sins_options options = sins::make<sins_options>();
    sins_identify_request request = sins::make<sins_identify_request>();
    request.flags = SINS_IDENTIFY_STATES;
    sins::Identification identification(options, request);
    sins::Simulator sim;
    sins_imu imu = sins::make<sins_imu>();
    sins_recorded_increment measured = sins::make<sins_recorded_increment>();
    sim.set_gyro(sins::gyro_preset(SINS_GRADE_TACTICAL));
    sim.set_accel(sins::accel_preset(SINS_GRADE_TACTICAL));
    CHECK(error_of([&] { identification.solve(); }).status() < 0);
    CHECK(error_of([&] { identification.scene(); }).status() == SINS_ERROR_BAD_STATE);
    for (int k = 0; k < 600; ++k) {
        const sins_flight_sample sample = at(0.1 * k);
        CHECK(identification.push(&sample, 1));
        sim.push_sample(sample);
        if (sim.step() && sim.get_imu(imu)) {
            measured.time_s = imu.time_s;
            measured.interval_s = imu.interval_s;
            std::memcpy(measured.angle_rad, imu.measured_angle_rad, sizeof measured.angle_rad);
            std::memcpy(measured.velocity_m_s, imu.measured_velocity_m_s, sizeof measured.velocity_m_s);
            identification.push(&measured, 1);
        }
    }
    const sins_identified found = identification.solve();
    CHECK(found.increments == 599 && found.used_s > 50.0);
    const std::vector<sins_identified_parameter> parameters = identification.parameters();
    CHECK(parameters.size() == SINS_IDENTIFIED_PARAMETERS && std::string(parameters[5].name) == "gyro bias x");
    CHECK(sins::Scene(identification.scene()).faults().empty());
    CHECK(error_of([&] { identification.spans(); }).status() == SINS_ERROR_BAD_STATE);
    sins_identify_check_request of_check = sins::make<sins_identify_check_request>();
    of_check.twins = 40;
    const sins_identified_check checked = identification.check(of_check);
    const std::vector<sins_identified_span> spans = identification.spans();
    CHECK(checked.twins == 40 && checked.spans == spans.size() && spans.size() == 1 && spans[0].duration_s == 10.0);
    of_check.twins = 39;
    CHECK(error_of([&] { identification.check(of_check); }).status() == SINS_ERROR_INVALID_ARGUMENT);
    request.axes[0] = 1;
    CHECK(error_of([&] { sins::Identification(options, request); }).status() == SINS_ERROR_INVALID_ARGUMENT);
}

int main() {
    identifications();
    plays();
    moved_objects();
    texts_of_scenes();
    errors();
    positive_statuses();
    scenes();
    snapshots();
    return 0;
}
