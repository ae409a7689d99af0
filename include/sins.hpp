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
 * also made of a text that has faults: see faults(). Structs and constants are those of sins.h. The wrapper is this header
 * only: each function makes the call and checks its status.
 */

#ifndef SINS_HPP
#define SINS_HPP

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sins.h"

namespace sins {

/* A call that failed. what() is the sentence of sins_last_error(), info() the data of sins_last_error_info(). */
class Error : public std::runtime_error {
public:
    Error(sins_status status, const std::string &sentence, const sins_error_info &info)
        : std::runtime_error(sentence), status_(status), info_(info) {}

    sins_status status() const noexcept { return status_; }
    const sins_error_info &info() const noexcept { return info_; }

private:
    sins_status status_;
    sins_error_info info_;
};

/* A struct of sins.h that is zero except for struct_size: all effects are off, all options have their defaults. */
template <typename T> T make() noexcept {
    T zeroed = T();
    zeroed.struct_size = sizeof(T);
    return zeroed;
}

/* The name of a status, such as "SINS_ERROR_TIME_ORDER". */
inline const char *status_string(sins_status status) noexcept { return sins_status_string(status); }

/* The sentence of the last failed call on sim; NULL: of the last failed call of this thread without a simulator. */
inline std::string last_error(const sins_sim *sim) {
    char sentence[1024];
    const sins_status status = sins_last_error(sim, sentence, sizeof sentence, nullptr);
    return status == SINS_OK || status == SINS_ERROR_BUFFER_TOO_SMALL ? sentence : status_string(status);
}

/* Not for hosts. */
namespace detail {

[[noreturn]] inline void fail(sins_status status, const sins_sim *sim) {
    /* The failure of a call whose handle was rejected is kept for the thread. */
    sins_error_info info = make<sins_error_info>();
    if (sins_last_error_info(sim, &info) < 0)
        sins_last_error_info(sim = nullptr, &info);
    throw Error(status, last_error(sim), info);
}

/* True for SINS_OK, false for a positive status. Throws an error. */
inline bool done(sins_status status, const sins_sim *sim) {
    if (status < 0)
        fail(status, sim);
    return status == SINS_OK;
}

/* The text that a function writes, in a buffer of the size that it asks for. */
template <class Function, class... Arguments> std::string text(Function write, Arguments... arguments) {
    std::size_t needed = 0;
    done(write(arguments..., nullptr, 0, &needed), nullptr);
    std::vector<char> buffer(needed);
    done(write(arguments..., buffer.data(), needed, &needed), nullptr);
    return std::string(buffer.data(), needed - 1);
}

/* The struct that a function fills in. */
template <class T, class Function, class... Arguments>
T filled(const sins_sim *sim, Function fill, Arguments... arguments) {
    T value = make<T>();
    done(fill(arguments..., &value), sim);
    return value;
}

/* The number, or the handle, that a function gives. */
template <class T, class Function, class... Arguments>
T given(const sins_sim *sim, Function give, Arguments... arguments) {
    T value = T();
    done(give(arguments..., &value), sim);
    return value;
}

/* The structs that a function has, by their index from 0, until there is no more. */
template <class T, class Function, class... Arguments> std::vector<T> all(T one, Function get, Arguments... arguments) {
    std::vector<T> values;
    sins_status status;
    while ((status = get(arguments..., values.size(), &one)) == SINS_OK)
        values.push_back(one);
    if (status != SINS_ERROR_INVALID_ARGUMENT)
        done(status, nullptr);
    return values;
}

inline void destroy(sins_sim *sim) { sins_destroy(sim); }
inline void destroy(sins_flight *flight) { sins_flight_destroy(flight); }
inline void destroy(sins_ensemble *ensemble) { sins_ensemble_destroy(ensemble); }
inline void destroy(sins_scene *scene) { sins_scene_destroy(scene); }
inline void destroy(sins_log *log) { sins_log_destroy(log); }

/* Owns a handle. It can be moved, but not copied. */
template <class T> class Owner {
public:
    explicit Owner(T *handle) noexcept : handle_(handle) {}

    Owner(Owner &&other) noexcept : handle_(other.handle_) { other.handle_ = nullptr; }

    Owner &operator=(Owner &&other) noexcept {
        Owner taken(std::move(other));
        std::swap(handle_, taken.handle_);
        return *this;
    }

    Owner(const Owner &) = delete;
    Owner &operator=(const Owner &) = delete;

    ~Owner() {
        if (handle_ != nullptr)
            destroy(handle_);
    }

    /* The handle, for functions of sins.h. This object still owns it. */
    T *handle() const noexcept { return handle_; }

protected:
    T *handle_;
};

} // namespace detail

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

/*
 * Recommends options for a simulator with default options and its sensors at the reference point. See Simulator::recommend().
 */
inline bool recommend(const sins_flight_sample *samples, std::size_t count, const sins_requirement &requirement,
                      sins_options &options, sins_cost &cost) {
    return detail::done(sins_recommend(nullptr, samples, count, &requirement, &options, &cost), nullptr);
}

/* An embedded flight. It can be moved, but not copied; a call on a moved-from object throws SINS_ERROR_BAD_HANDLE. */
class Flight : public detail::Owner<sins_flight> {
public:
    Flight(const sins_flight_start &start, const sins_manoeuvre *manoeuvres, std::size_t count)
        : Owner(detail::given<sins_flight *>(nullptr, sins_flight_create, &start, manoeuvres, count)) {}

    /* Takes ownership of a handle that a function of sins.h made. */
    explicit Flight(sins_flight *flight) noexcept : Owner(flight) {}

    double duration() const { return detail::given<double>(nullptr, sins_flight_duration, handle_); }

    sins_flight_sample sample_at(double time_s) const {
        return detail::filled<sins_flight_sample>(nullptr, sins_flight_sample_at, handle_, time_s);
    }

    /* Reads the sample at time_s into a struct with struct_size set. */
    void sample_at(double time_s, sins_flight_sample &sample) const {
        detail::done(sins_flight_sample_at(handle_, time_s, &sample), nullptr);
    }
};

/* A simulator. It can be moved, but not copied; a call on a moved-from object throws SINS_ERROR_BAD_HANDLE. */
class Simulator : public detail::Owner<sins_sim> {
public:
    Simulator() : Simulator(detail::given<sins_sim *>(nullptr, sins_create, nullptr)) {}

    explicit Simulator(const sins_options &options)
        : Simulator(detail::given<sins_sim *>(nullptr, sins_create, &options)) {}

    /* Takes ownership of a handle that a function of sins.h made. */
    explicit Simulator(sins_sim *sim) noexcept : Owner(sim) {}

    /*
     * Recommends options for a simulator that is configured as this one. options and cost need struct_size. False: no options meet
     * the requirement, and options and cost are those of the options that come closest.
     */
    bool recommend(const sins_flight_sample *samples, std::size_t count, const sins_requirement &requirement,
                   sins_options &options, sins_cost &cost) const {
        snapshot_size(); /* throws without a handle, for which sins_recommend() would use the recommended simulator */
        return detail::done(sins_recommend(handle_, samples, count, &requirement, &options, &cost), nullptr);
    }

    /* Error budget of all errors of this simulator. rows gets the first row and one row for each effect. */
    sins_budget error_budget(const sins_flight_sample *samples, std::size_t count, const sins_budget_request &request,
                             std::vector<sins_budget_row> &rows) const {
        snapshot_size(); /* throws without a handle, for which sins_error_budget() would use the recommended simulator */
        sins_budget budget = make<sins_budget>();
        std::size_t number = 0;
        const auto ask = [&] {
            return sins_error_budget(handle_, samples, count, &request, rows.empty() ? nullptr : rows.data(),
                                     rows.size(), &number, &budget);
        };
        rows.clear();
        if (ask() == SINS_ERROR_BUFFER_TOO_SMALL)
            rows.assign(number, make<sins_budget_row>());
        detail::done(ask(), nullptr);
        return budget;
    }

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

/* Adds the runs of other to those of into. make<sins_statistics>() makes a struct without runs. */
inline void statistics_merge(sins_statistics &into, const sins_statistics &other) {
    detail::done(sins_statistics_merge(&into, &other), nullptr);
}

inline sins_figures statistics_figures(const sins_statistics &statistics) {
    return detail::filled<sins_figures>(nullptr, sins_statistics_figures, &statistics);
}

/* An ensemble of runs. It can be moved, but not copied; a call on a moved-from object throws SINS_ERROR_BAD_HANDLE. */
class Ensemble : public detail::Owner<sins_ensemble> {
public:
    /* The runs first_run to first_run + runs - 1 of a simulator that was set up and has taken no sample. */
    Ensemble(const Simulator &configured, uint64_t first_run, std::size_t runs)
        : Owner(detail::given<sins_ensemble *>(nullptr, sins_ensemble_create, configured.handle(), first_run, runs)) {}

    uint64_t first_run() const {
        uint64_t first_run = 0;
        done(sins_ensemble_get_runs(handle_, &first_run, nullptr));
        return first_run;
    }

    std::size_t runs() const { return detail::given<std::size_t>(nullptr, sins_ensemble_get_runs, handle_, nullptr); }

    /* Returns true without a gap. Returns false if the sample was accepted and ended a gap (SINS_GAP). */
    bool push_sample(const sins_flight_sample &sample) { return done(sins_ensemble_push_sample(handle_, &sample)); }

    /* False: no complete interval yet. */
    bool step() { return done(sins_ensemble_step(handle_)); }

    /* False: all was flown, with a gap (SINS_GAP). */
    bool run(const sins_flight_sample *samples, std::size_t count) {
        return done(sins_ensemble_run(handle_, samples, count));
    }

    void reposition(const sins_flight_sample &sample) { done(sins_ensemble_reposition(handle_, &sample)); }
    void reset() { done(sins_ensemble_reset(handle_)); }

    /* sensor is of enum sins_sensor, axis is 0, 1, 2 for x, y, z. */
    void set_failure(int32_t sensor, int32_t axis, const sins_failure &failure) {
        done(sins_ensemble_set_failure(handle_, sensor, axis, &failure));
    }

    /* The caller sets struct_size first: make<T>() does it. False: there is no sample, or no interval, yet. */
    bool get_truth(sins_navigation &truth) const { return done(sins_ensemble_get_truth(handle_, &truth)); }
    bool get_navigation(uint64_t run, sins_navigation &navigation) const {
        return done(sins_ensemble_get_navigation(handle_, run, &navigation));
    }
    bool get_imu(uint64_t run, sins_imu &imu) const { return done(sins_ensemble_get_imu(handle_, run, &imu)); }
    bool get_errors(uint64_t run, int32_t source, sins_errors &errors) const {
        return done(sins_ensemble_get_errors(handle_, run, source, &errors));
    }
    bool get_statistics(int32_t source, sins_statistics &statistics) const {
        return done(sins_ensemble_get_statistics(handle_, source, &statistics));
    }

    /* The numbers of the runs that have diverged. */
    std::vector<uint64_t> diverged() const { return detail::all(uint64_t(0), sins_ensemble_get_diverged, handle_); }

    std::vector<unsigned char> snapshot_save() const {
        std::vector<unsigned char> bytes(detail::given<std::size_t>(nullptr, sins_ensemble_snapshot_size, handle_));
        void *const buffer = bytes.data();
        bytes.resize(detail::given<std::size_t>(nullptr, sins_ensemble_snapshot_save, handle_, buffer, bytes.size()));
        return bytes;
    }

    void snapshot_load(const std::vector<unsigned char> &snapshot) {
        done(sins_ensemble_snapshot_load(handle_, snapshot.data(), snapshot.size()));
    }

private:
    static bool done(sins_status status) { return detail::done(status, nullptr); }
};

/* A scene. It can be moved, but not copied; a call on a moved-from object throws SINS_ERROR_BAD_HANDLE. */
class Scene : public detail::Owner<sins_scene> {
public:
    /* The default scene. */
    Scene() : Scene(detail::given<sins_scene *>(nullptr, sins_scene_create)) {}

    /* The scene of a text. If the text has faults, only faults() can be used. */
    explicit Scene(const std::string &text)
        : Scene(detail::given<sins_scene *>(nullptr, sins_scene_parse, text.data(), text.size())) {}

    /* A built-in scene by its name. */
    static Scene builtin(const std::string &name) {
        return Scene(detail::given<sins_scene *>(nullptr, sins_scene_create_builtin, name.c_str()));
    }

    /* The names of the built-in scenes. */
    static std::vector<std::string> builtin_names() {
        std::vector<std::string> names;
        char name[64];
        while (sins_scene_builtin_name(names.size(), name, sizeof name, nullptr) == SINS_OK)
            names.push_back(name);
        return names;
    }

    /* The faults of the text, or of the last set_values() or set_items(); empty if that call succeeded. */
    std::vector<sins_fault> faults() const { return detail::all(make<sins_fault>(), sins_scene_get_fault, handle_); }

    /* The scene as TOML. */
    std::string write() const { return detail::text(sins_scene_write, handle_); }

    /* The value at a path, "gyro.bias_deg_h[1]", as it stands in the text of a scene; or all lines of an item, "failure[0]". */
    std::string value(const std::string &path) const {
        return detail::text(sins_scene_get_value, handle_, path.c_str());
    }

    /* Sets values. Each line is path = value. False: the scene stays as it was, and faults() has the reasons. */
    bool set_values(const std::string &values) { return changed(sins_scene_set_values(handle_, values.c_str())); }

    /* Sets all items of a list, "manoeuvre" or "failure", by their text. False: as set_values(). */
    bool set_items(const std::string &list, const std::string &items) {
        return changed(sins_scene_set_items(handle_, list.c_str(), items.c_str()));
    }

    /* The keys of the scene format. */
    static std::vector<sins_scene_key> keys() { return detail::all(make<sins_scene_key>(), sins_scene_get_key); }

    /* Every section and key of a scene, one in a line. */
    static std::string write_keys() { return detail::text(sins_scene_write_keys); }

    /* Describes the samples that the scene flies. If the flight of the scene is a log, give that log; otherwise nothing. */
    sins_scene_samples samples(const sins_log *log = nullptr) const {
        return detail::filled<sins_scene_samples>(nullptr, sins_scene_get_samples, handle_, log);
    }

    Simulator create_simulator() const {
        return Simulator(detail::given<sins_sim *>(nullptr, sins_scene_create_simulator, handle_));
    }

    Flight create_flight() const {
        return Flight(detail::given<sins_flight *>(nullptr, sins_scene_create_flight, handle_));
    }

    void prepare(Simulator &sim, double flight_start_s, sins_flight_sample &sample) const {
        done(sins_scene_prepare(handle_, sim.handle(), flight_start_s, &sample));
    }

    void prepare(Ensemble &ensemble, double flight_start_s, sins_flight_sample &sample) const {
        done(sins_scene_prepare_ensemble(handle_, ensemble.handle(), flight_start_s, &sample));
    }

    sins_options options() const { return read_back<sins_options>(sins_scene_get_options); }
    sins_gyro_params gyro() const { return read_back<sins_gyro_params>(sins_scene_get_gyro); }
    sins_accel_params accel() const { return read_back<sins_accel_params>(sins_scene_get_accel); }
    sins_altimeter_params altimeter() const { return read_back<sins_altimeter_params>(sins_scene_get_altimeter); }
    sins_initial_errors initial_errors() const { return read_back<sins_initial_errors>(sins_scene_get_initial_errors); }
    sins_mounting mounting() const { return read_back<sins_mounting>(sins_scene_get_mounting); }
    sins_gravity_params gravity_disturbance() const {
        return read_back<sins_gravity_params>(sins_scene_get_gravity_disturbance);
    }
    /*
     * The manoeuvres of the flight. start, with struct_size set, gets the start of the flight, and repeat how many times all
     * manoeuvres are flown.
     */
    std::vector<sins_manoeuvre> manoeuvres(sins_flight_start &start, std::size_t &repeat) const {
        std::size_t count = 0;
        done(sins_scene_get_manoeuvres(handle_, nullptr, nullptr, 0, &count, nullptr));
        std::vector<sins_manoeuvre> manoeuvres(count, make<sins_manoeuvre>());
        done(sins_scene_get_manoeuvres(handle_, &start, manoeuvres.data(), count, &count, &repeat));
        return manoeuvres;
    }
    void set_manoeuvres(const sins_flight_start &start, const std::vector<sins_manoeuvre> &manoeuvres,
                        std::size_t repeat = 1) {
        done(sins_scene_set_manoeuvres(handle_, &start, manoeuvres.data(), manoeuvres.size(), repeat));
    }

    sins_scene_setup setup() const { return read_back<sins_scene_setup>(sins_scene_get_setup); }

    void set_options(const sins_options &options) { done(sins_scene_set_options(handle_, &options)); }
    void set_gyro(const sins_gyro_params &params) { done(sins_scene_set_gyro(handle_, &params)); }
    void set_accel(const sins_accel_params &params) { done(sins_scene_set_accel(handle_, &params)); }
    void set_altimeter(const sins_altimeter_params &params) { done(sins_scene_set_altimeter(handle_, &params)); }
    void set_initial_errors(const sins_initial_errors &errors) {
        done(sins_scene_set_initial_errors(handle_, &errors));
    }
    void set_mounting(const sins_mounting &mounting) { done(sins_scene_set_mounting(handle_, &mounting)); }
    void set_gravity_disturbance(const sins_gravity_params &params) {
        done(sins_scene_set_gravity_disturbance(handle_, &params));
    }
    void set_setup(const sins_scene_setup &setup) { done(sins_scene_set_setup(handle_, &setup)); }

    /* which is of enum sins_scene_text. */
    std::string text(int32_t which) const { return detail::text(sins_scene_get_text, handle_, which); }
    void set_text(int32_t which, const std::string &text) { done(sins_scene_set_text(handle_, which, text.c_str())); }

    std::vector<sins_planned_failure> failures() const {
        std::size_t count = 0;
        done(sins_scene_get_failure_count(handle_, &count));
        std::vector<sins_planned_failure> failures(count, make<sins_planned_failure>());
        for (std::size_t index = 0; index < count; index++)
            done(sins_scene_get_failure(handle_, index, &failures[index]));
        return failures;
    }
    void add_failure(const sins_planned_failure &failure) { done(sins_scene_add_failure(handle_, &failure)); }
    void clear_failures() { done(sins_scene_clear_failures(handle_)); }

private:
    explicit Scene(sins_scene *scene) noexcept : Owner(scene) {}

    bool changed(sins_status status) const {
        return !(status == SINS_ERROR_INVALID_ARGUMENT && !faults().empty()) && detail::done(status, nullptr);
    }

    static void done(sins_status status) { detail::done(status, nullptr); }

    template <class Params> Params read_back(sins_status(SINS_CALL *get)(const sins_scene *, Params *)) const {
        return detail::filled<Params>(nullptr, get, handle_);
    }
};

/* A flight log in memory. It can be moved, but not copied; a call on a moved-from object throws SINS_ERROR_BAD_HANDLE. */
class Log : public detail::Owner<sins_log> {
public:
    /* The log of a text. If the text has faults, what() of the error has the first one and its place. */
    explicit Log(const std::string &text) : Owner(parsed(text)) {}

    sins_log_info info() const { return detail::filled<sins_log_info>(nullptr, sins_log_get_info, handle_); }

    /* line, if not NULL, gets the line of the text on which the sample stands. */
    sins_flight_sample sample(std::size_t index, uint64_t *line = nullptr) const {
        sins_flight_sample sample = make<sins_flight_sample>();
        detail::done(sins_log_get_sample(handle_, index, &sample, line), nullptr);
        return sample;
    }

private:
    static sins_log *parsed(const std::string &text) {
        sins_log *log = nullptr;
        detail::done(sins_log_parse(text.data(), text.size(), &log, nullptr), nullptr);
        return log;
    }
};

} // namespace sins

#endif /* SINS_HPP */
