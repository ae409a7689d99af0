/*
 * sins.hpp - the C interface of sins.h for C++11 and later: RAII handles; failures throw.
 *
 *   sins::Simulator sim;                                      recommended options
 *   auto gyro = sins::make<sins_gyro_params>();               all zero, struct_size set
 *   gyro.bias_rad_s[0] = 0.01 * SINS_DEG_PER_HOUR;
 *   sim.set_gyro(gyro);
 *   while (...) {
 *       sim.push_sample(sample);
 *       if (sim.step())                                       false: push the next sample first
 *           sim.get_navigation(navigation);
 *   }
 *
 * The functions of sins.h are members here, without handle and status; sins.h documents them. Names are the same, with three
 * exceptions. Constructors replace sins_create(), sins_scene_parse() and the like. Functions that return settings by value have
 * no get_: gyro() calls sins_get_gyro(). Functions that return lists have names in the plural: faults(), failures(), keys(). A
 * negative status is thrown as sins::Error with the library's sentence. (Exceptions: set_values() and set_items() of a scene
 * return false if the values have faults.) With a positive status, which is not an error, a function returns false. The output
 * is then unchanged (SINS_NEED_SAMPLE) or written (SINS_REQUIREMENT_NOT_MET), or everything was done (SINS_GAP). A Scene is
 * also made of a text that has faults: see faults(). Structs and constants are those of sins.h.
 * The wrapper needs exceptions. A std::string with a NUL, where C takes a terminated text, throws SINS_ERROR_INVALID_ARGUMENT. If
 * two threads share a Simulator, its sentence is that of the last failure of either: lock around calls that may fail.
 * Beside it: sins_flight.hpp, sins_analysis.hpp, sins_unit.hpp, sins_ensemble.hpp, sins_scene.hpp, each for the C header of its name.
 * The wrapper is these headers only: each function makes the call and checks its status.
 */

#ifndef SINS_HPP
#define SINS_HPP

#include "sins_handle.hpp"

namespace sins {

/* Version of the interface of the loaded library: compare it with SINS_HEADER_ABI. */
inline uint32_t abi_version() noexcept { return sins_abi_version(); }

/* Release of the loaded library, such as "0.1.0". */
inline const char *version_string() noexcept { return sins_version_string(); }

/* grade is of enum sins_grade. */
inline sins_gyro_params gyro_preset(int32_t grade) {
    sins_gyro_params params = make<sins_gyro_params>();
    detail::done(sins_gyro_preset(grade, &params), nullptr);
    return params;
}

inline sins_accel_params accel_preset(int32_t grade) {
    sins_accel_params params = make<sins_accel_params>();
    detail::done(sins_accel_preset(grade, &params), nullptr);
    return params;
}

inline sins_initial_errors initial_preset(int32_t grade) {
    sins_initial_errors errors = make<sins_initial_errors>();
    detail::done(sins_initial_preset(grade, &errors), nullptr);
    return errors;
}

/* A simulator. It can be moved, but not copied; a call on a moved-from object throws SINS_ERROR_BAD_HANDLE. */
class Simulator : public detail::Owner<sins_sim> {
public:
    Simulator() : Simulator(detail::given<sins_sim *>(nullptr, sins_create, nullptr)) {}

    explicit Simulator(const sins_options &options)
        : Simulator(detail::given<sins_sim *>(nullptr, sins_create, &options)) {}

    /* Takes ownership of a handle that a function of sins.h made. */
    explicit Simulator(sins_sim *sim) noexcept : Owner(sim) {}

    void set_gyro(const sins_gyro_params &params) { done(sins_set_gyro(handle_, &params)); }
    void set_accel(const sins_accel_params &params) { done(sins_set_accel(handle_, &params)); }
    void set_altimeter(const sins_altimeter_params &params) { done(sins_set_altimeter(handle_, &params)); }

    /* sensor is of enum sins_sensor, axis is 0, 1, 2 for x, y, z. */
    void set_failure(int32_t sensor, int32_t axis, const sins_failure &failure) {
        done(sins_set_failure(handle_, sensor, axis, &failure));
    }

    void set_mounting(const sins_mounting &mounting) { done(sins_set_mounting(handle_, &mounting)); }
    void set_gravity_disturbance(const sins_gravity_params &params) {
        done(sins_set_gravity_disturbance(handle_, &params));
    }
    void set_initial_errors(const sins_initial_errors &errors) { done(sins_set_initial_errors(handle_, &errors)); }

    /* Returns true without a gap. Returns false if the sample was accepted and ended a gap (SINS_GAP). */
    bool push_sample(const sins_flight_sample &sample) { return done(sins_push_sample(handle_, &sample)); }

    /* False: no complete interval yet. */
    bool step() { return done(sins_step(handle_)); }

    void move_time(double time_s) { done(sins_move_time(handle_, time_s)); }
    void move_truth(const sins_flight_sample &sample) { done(sins_move_truth(handle_, &sample)); }
    void reposition(const sins_flight_sample &sample) { done(sins_reposition(handle_, &sample)); }
    void reset() { done(sins_reset(handle_)); }

    /* written, if not NULL, gets the number of records, also if the call throws. False: all was flown, with a gap (SINS_GAP). */
    bool run(const sins_flight_sample *samples, std::size_t count, std::size_t every = 0,
             sins_record *records = nullptr, std::size_t capacity = 0, std::size_t *written = nullptr) {
        return done(sins_run(handle_, samples, count, every, records, capacity, written));
    }

    /* The caller sets struct_size first: make<T>() does it. False: there is no sample, or no interval, yet. */
    bool get_truth(sins_navigation &truth) const { return done(sins_get_truth(handle_, &truth)); }
    bool get_navigation(sins_navigation &navigation) const { return done(sins_get_navigation(handle_, &navigation)); }
    bool get_imu(sins_imu &imu) const { return done(sins_get_imu(handle_, &imu)); }
    /* Removes errors that the host estimated; see sins_correct(). */
    void correct(const sins_correction &correction) { done(sins_correct(handle_, &correction)); }
    void get_compensation(sins_compensation &compensation) const { done(sins_get_compensation(handle_, &compensation)); }
    bool get_imu_update(int32_t update, sins_imu_increment &increment) const {
        return done(sins_get_imu_update(handle_, update, &increment));
    }
    bool get_errors(int32_t source, sins_errors &errors) const {
        return done(sins_get_errors(handle_, source, &errors));
    }
    bool get_accuracy(sins_accuracy &accuracy) const { return done(sins_get_accuracy(handle_, &accuracy)); }
    bool get_truth_summary(sins_truth_summary &summary) const {
        return done(sins_get_truth_summary(handle_, &summary));
    }
    bool get_covariance(sins_covariance &covariance) const { return done(sins_get_covariance(handle_, &covariance)); }
    bool get_record(sins_record &record) const { return done(sins_get_record(handle_, &record)); }

    /* A record as a line of a file of records; sensor_errors are six numbers or none, covariance may be NULL. */
    static std::string record_line(const sins_record &record, const std::vector<double> &sensor_errors = {},
                                   const sins_covariance *covariance = nullptr) {
        return detail::text(sins_record_line, &record, sensor_errors.data(), sensor_errors.size(), covariance);
    }

    /* The first line of a file of records: the names of the columns. */
    static std::string record_head(bool has_covariance = false) {
        sins_covariance covariance = make<sins_covariance>();
        return detail::text(sins_record_line, nullptr, nullptr, std::size_t(0), has_covariance ? &covariance : nullptr);
    }

    /* The options in effect, defaults in place of 0. */
    sins_options options() const { return read_back<sins_options>(sins_get_options); }

    /* These return what was set last: to show it, or to change one field and set it again. */
    sins_gyro_params gyro() const { return read_back<sins_gyro_params>(sins_get_gyro); }
    sins_accel_params accel() const { return read_back<sins_accel_params>(sins_get_accel); }
    sins_altimeter_params altimeter() const { return read_back<sins_altimeter_params>(sins_get_altimeter); }
    sins_initial_errors initial_errors() const { return read_back<sins_initial_errors>(sins_get_initial_errors); }
    sins_mounting mounting() const { return read_back<sins_mounting>(sins_get_mounting); }
    sins_gravity_params gravity_disturbance() const {
        return read_back<sins_gravity_params>(sins_get_gravity_disturbance);
    }

    /* sensor is of enum sins_sensor, axis is 0, 1, 2 for x, y, z. */
    sins_failure failure(int32_t sensor, int32_t axis) const {
        return detail::filled<sins_failure>(handle_, sins_get_failure, handle_, sensor, axis);
    }

    void start_navigation(const sins_navigation &navigation) { done(sins_start_navigation(handle_, &navigation)); }
    void push_imu(const sins_imu_increment &increment) { done(sins_push_imu(handle_, &increment)); }

    std::size_t snapshot_size() const { return detail::given<std::size_t>(handle_, sins_snapshot_size, handle_); }

    /* Returns the number of bytes that were written. */
    std::size_t snapshot_save(void *buffer, std::size_t capacity) const {
        return detail::given<std::size_t>(handle_, sins_snapshot_save, handle_, buffer, capacity);
    }

    std::vector<unsigned char> snapshot_save() const {
        std::vector<unsigned char> bytes(snapshot_size());
        bytes.resize(snapshot_save(bytes.data(), bytes.size()));
        return bytes;
    }

    void snapshot_load(const void *snapshot, std::size_t size) { done(sins_snapshot_load(handle_, snapshot, size)); }
    void snapshot_load(const std::vector<unsigned char> &snapshot) { snapshot_load(snapshot.data(), snapshot.size()); }

private:
    bool done(sins_status status) const { return detail::done(status, handle_); }

    template <class Params> Params read_back(sins_status(SINS_CALL *get)(sins_sim *, Params *)) const {
        return detail::filled<Params>(handle_, get, handle_);
    }
};

} // namespace sins

#endif /* SINS_HPP */
