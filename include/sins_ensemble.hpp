/* sins.hpp for sins_ensemble.h: ensembles of runs, and their statistics. */

#ifndef SINS_ENSEMBLE_HPP
#define SINS_ENSEMBLE_HPP

#include "sins.hpp"
#include "sins_ensemble.h"

namespace sins {

namespace detail {
template <> struct Destroyer<sins_ensemble> {
    static void destroy(sins_ensemble *ensemble) noexcept { sins_ensemble_destroy(ensemble); }
};
} // namespace detail

/* Adds one run. make<sins_statistics>() makes a struct without runs. */
inline void statistics_add(sins_statistics &statistics, const sins_errors &errors) {
    detail::done(sins_statistics_add(&statistics, &errors), nullptr);
}

/* Adds the runs of other to those of into. make<sins_statistics>() makes a struct without runs. */
inline void statistics_merge(sins_statistics &into, const sins_statistics &other) {
    detail::done(sins_statistics_merge(&into, &other), nullptr);
}

inline sins_figures statistics_figures(const sins_statistics &statistics) {
    return detail::filled<sins_figures>(nullptr, sins_statistics_figures, &statistics);
}

/* Whether percent of the runs are within this horizontal radius. */
inline sins_verdict meets(const sins_statistics &statistics, double radius_m, double percent) {
    return detail::filled<sins_verdict>(nullptr, sins_meets, &statistics, radius_m, percent);
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
    /* Removes errors that the host estimated from a run; see sins_ensemble_correct(). */
    void correct(uint64_t run, const sins_correction &correction) {
        done(sins_ensemble_correct(handle_, run, &correction));
    }
    void get_compensation(uint64_t run, sins_compensation &compensation) const {
        done(sins_ensemble_get_compensation(handle_, run, &compensation));
    }
    bool get_errors(uint64_t run, int32_t source, sins_errors &errors) const {
        return done(sins_ensemble_get_errors(handle_, run, source, &errors));
    }
    /* The errors of all runs; struct_size of the first element is set. */
    bool get_all_errors(int32_t source, sins_errors *errors, std::size_t capacity) const {
        return done(sins_ensemble_get_all_errors(handle_, source, errors, capacity));
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

} // namespace sins

#endif /* SINS_ENSEMBLE_HPP */
