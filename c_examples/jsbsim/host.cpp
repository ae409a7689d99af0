/* A live flight simulator as host: JSBSim flies a script, and an INS navigates on each of its frames. The properties ins/... of the
 * script define the events of the INS (pause, slew, replay, failure): see flight.xml.
 *
 *   host JSBSIM_FOLDER SCRIPT OUT [PROPERTY=VALUE]...
 *
 * OUT.csv gets the truth and the errors of the navigation once a second. OUT_truth.csv gets each frame as a flight log, which "sins
 * fly" accepts if the flight has no slew. */

#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "flight_simulator.hpp"

namespace {

struct CloseFile {
    void operator()(std::FILE *file) const { std::fclose(file); }
};
typedef std::unique_ptr<std::FILE, CloseFile> File;

File create_file(const std::string &path)
{
    File file(std::fopen(path.c_str(), "w"));
    if (!file) {
        throw std::runtime_error(path + " cannot be written");
    }
    return file;
}

sins_options options_for(FlightSimulator &simulator)
{
    auto options = sins::make<sins_options>();
    options.axes = SINS_AXES_FORWARD_RIGHT_DOWN;
    options.sample_period_s = simulator.get("simulation/dt"); /* JSBSim sums its steps, with a rounding each time */
    return options;
}

/* The INS and the actions of the instructor. */
class Ins {
public:
    Ins(FlightSimulator &simulator, const std::string &out)
        : simulator_(simulator), sim_(options_for(simulator)), signals_(static_cast<int>(simulator.get("ins/signals"))),
          records_(create_file(out + ".csv")), truth_(create_file(out + "_truth.csv"))
    {
        const auto grade = static_cast<int32_t>(simulator.get("ins/grade"));
        if (grade != 0) {
            sim_.set_gyro(sins::gyro_preset(grade));
            sim_.set_accel(sins::accel_preset(grade));
        }
        std::fprintf(truth_.get(), "time_s,latitude_rad,longitude_rad,height_m,velocity_east_m_s,velocity_north_m_s,"
                                   "velocity_up_m_s,roll_rad,pitch_rad,heading_rad\n");
        std::fprintf(records_.get(), "time_s,latitude_rad,longitude_rad,height_m,position_error_east_m,"
                                     "position_error_north_m,position_error_up_m,velocity_error_east_m_s,"
                                     "velocity_error_north_m_s,velocity_error_up_m_s,misalignment_east_rad,"
                                     "misalignment_north_rad,misalignment_up_rad\n");
        std::printf("%8s %10s %9s %11s %11s %11s\n", "time s", "height m", "heading", "east m", "north m", "up m");
    }

    /* One frame of the flight simulator. */
    void frame()
    {
        const double flight_s = simulator_.get("simulation/sim-time-sec");
        const sins_flight_sample sample = simulator_.sample(flight_s + paused_s_, signals_);
        fail_gyro(flight_s);
        if (simulator_.take("ins/slewed") != 0.0) {
            std::printf("%8.2f the aircraft is moved, and the INS keeps its errors\n", flight_s);
            sim_.move_truth(sample);
        } else {
            fly(sample, flight_s);
        }
        if (simulator_.take("ins/save") != 0.0) {
            std::printf("%8.2f saved\n", flight_s);
            saved_ = sim_.snapshot_save();
            flown_.clear();
        }
        if (simulator_.take("ins/replay") != 0.0) {
            replay(flight_s);
        }
        const double pause_s = simulator_.take("ins/pause-s");
        if (pause_s > 0.0) {
            pause(flight_s, pause_s);
        }
        force_before_ = simulator_.specific_force_m_s2();
        write(flight_s, sample);
    }

    /* Writes the last record and prints the differences of navigation and truth. */
    void finish()
    {
        record();
        auto accuracy = sins::make<sins_accuracy>();
        if (!sim_.get_accuracy(accuracy)) {
            throw std::runtime_error("the script ends before the INS has started");
        }
        const auto row = [](const char *what, const double *enu) {
            std::printf("%-22s %13.3e %13.3e %13.3e\n", what, enu[0], enu[1], enu[2]);
        };
        std::printf("%-22s %13s %13s %13s\n", "", "east", "north", "up");
        row("closure m", accuracy.closure_position_enu_m);
        row("of it the truth's m", accuracy.host_position_enu_m);
        row("closure m/s", accuracy.closure_velocity_enu_m_s);
        row("of it the truth's m/s", accuracy.host_velocity_enu_m_s);
        row("velocity - position m", accuracy.inconsistency_enu_m);
        const JSBSim::FGColumnVector3 ned = force_surplus_ / static_cast<double>(accuracy.intervals);
        const double surplus[3] = {ned(2), ned(1), -ned(3)};
        row("JSBSim's force m/s2", surplus);
        std::printf("%lu intervals, %lu of them inconsistent, %lu samples refused\n",
                    static_cast<unsigned long>(accuracy.intervals),
                    static_cast<unsigned long>(accuracy.inconsistent_samples), refused_);
    }

private:
    /* A rejected sample changes nothing, and the next sample ends a gap. */
    void fly(const sins_flight_sample &sample, double flight_s)
    {
        try {
            if (!sim_.push_sample(sample)) {
                std::printf("%8.2f a gap before this sample\n", flight_s);
            }
        } catch (const sins::Error &error) {
            std::printf("%8.2f refused: %s\n", flight_s, error.what());
            refused_++;
            return;
        }
        if (sim_.step()) { /* false: it was the first sample */
            compare_force();
        }
        flown_.push_back(sample);
    }

    /* JSBSim's specific force minus that of perfect accelerometers: the difference of two gravity models, if axes and units are
     * right. */
    void compare_force()
    {
        auto imu = sins::make<sins_imu>();
        sim_.get_imu(imu);
        JSBSim::FGColumnVector3 surplus = (force_before_ + simulator_.specific_force_m_s2()) / 2.0;
        for (int i = 0; i < 3; i++) {
            surplus(i + 1) -= imu.ideal_force_m_s2[i];
        }
        force_surplus_ += simulator_.fdm.GetPropagate()->GetTb2l() * surplus;
    }

    void fail_gyro(double flight_s)
    {
        const double step_rad_s = simulator_.get("ins/gyro-z-step-rad_sec");
        if (step_rad_s == failure_rad_s_) {
            return;
        }
        auto failure = sins::make<sins_failure>();
        failure.kind = step_rad_s == 0.0 ? SINS_FAILURE_NONE : SINS_FAILURE_BIAS_STEP;
        failure.size = step_rad_s;
        sim_.set_failure(SINS_SENSOR_GYRO, 2, failure);
        std::printf("%8.2f yaw gyro: %+.1f deg/h\n", flight_s, step_rad_s / SINS_DEG_PER_HOUR);
        failure_rad_s_ = step_rad_s;
    }

    /* Goes back to the saved moment and flies the samples since then again. This gives the same bits if there were only samples: a
     * pause, a slew or a failure since then would have to be stored and called again too. */
    void replay(double flight_s)
    {
        const std::vector<unsigned char> now = sim_.snapshot_save();
        sim_.snapshot_load(saved_);
        sim_.run(flown_.data(), flown_.size());
        std::printf("%8.2f %lu frames again, %s\n", flight_s, static_cast<unsigned long>(flown_.size()),
                    sim_.snapshot_save() == now ? "to the same bits" : "to OTHER bits");
    }

    /* JSBSim's clock stops and the host's clock continues: later samples have later stamps. */
    void pause(double flight_s, double pause_s)
    {
        const double step_s = simulator_.get("simulation/dt");
        simulator_.fdm.Hold();
        for (double held_s = 0.0; held_s < pause_s; held_s += step_s) {
            simulator_.run();
        }
        simulator_.fdm.Resume();
        paused_s_ += pause_s;
        sim_.move_time(flight_s + paused_s_);
        std::printf("%8.2f paused for %g s\n", flight_s, pause_s);
    }

    void write(double flight_s, const sins_flight_sample &s)
    {
        std::fprintf(truth_.get(), "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", flight_s, s.latitude_rad,
                     s.longitude_rad, s.height_m, s.velocity_enu_m_s[0], s.velocity_enu_m_s[1], s.velocity_enu_m_s[2],
                     s.roll_rad, s.pitch_rad, s.heading_rad);
        flight_s_ = flight_s;
        if (flight_s >= next_record_s_) {
            record();
            next_record_s_ = flight_s + 1.0 - 1e-6;
        }
    }

    void record()
    {
        auto truth = sins::make<sins_navigation>();
        auto errors = sins::make<sins_errors>();
        if (!sim_.get_truth(truth) || !sim_.get_errors(SINS_ERRORS_NAVIGATION, errors)) {
            return;
        }
        std::fprintf(records_.get(), "%.17g,%.17g,%.17g,%.17g", flight_s_, truth.latitude_rad, truth.longitude_rad,
                     truth.height_m);
        for (const double *three : {errors.position_enu_m, errors.velocity_enu_m_s, errors.misalignment_enu_rad}) {
            std::fprintf(records_.get(), ",%.17g,%.17g,%.17g", three[0], three[1], three[2]);
        }
        std::fprintf(records_.get(), "\n");
        if (records_written_++ % 30 == 0) {
            std::printf("%8.2f %10.1f %9.2f %11.3g %11.3g %11.3g\n", flight_s_, truth.height_m, truth.heading_rad / SINS_DEG,
                        errors.position_enu_m[0], errors.position_enu_m[1], errors.position_enu_m[2]);
        }
    }

    FlightSimulator &simulator_;
    sins::Simulator sim_;
    const int signals_;
    File records_;
    File truth_;
    double paused_s_ = 0.0;
    double failure_rad_s_ = 0.0;
    double flight_s_ = 0.0;
    double next_record_s_ = 0.0;
    unsigned long records_written_ = 0;
    unsigned long refused_ = 0;
    JSBSim::FGColumnVector3 force_before_;
    JSBSim::FGColumnVector3 force_surplus_; /* sum over all intervals, north-east-down */
    std::vector<unsigned char> saved_;
    std::vector<sins_flight_sample> flown_; /* since the snapshot */
};

} // namespace

int main(int count, char **words)
{
    try {
        if (count < 4) {
            throw std::runtime_error("usage: host JSBSIM_FOLDER SCRIPT OUT [PROPERTY=VALUE]...");
        }
        FlightSimulator simulator(words[1], words[2]);
        for (int i = 4; i < count; i++) {
            simulator.set(words[i]);
        }
        if (!simulator.fdm.RunIC()) {
            throw std::runtime_error("JSBSim cannot begin the flight");
        }
        Ins ins(simulator, words[3]);
        const double start_s = simulator.get("ins/start-s");
        while (simulator.run()) {
            if (simulator.get("simulation/sim-time-sec") >= start_s) {
                ins.frame();
            }
        }
        ins.finish();
    } catch (const std::exception &error) {
        std::fprintf(stderr, "host: %s\n", error.what());
        return 1;
    }
    return 0;
}
