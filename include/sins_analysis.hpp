/* sins.hpp for sins_analysis.h: which options a flight needs, which effects matter, and which errors real sensors have. */

#ifndef SINS_ANALYSIS_HPP
#define SINS_ANALYSIS_HPP

#include "sins.hpp"
#include "sins_analysis.h"
#include "sins_handle.hpp"

namespace sins {

namespace detail {
template <> struct Destroyer<sins_identify> {
    static void destroy(sins_identify *identify) noexcept { sins_identify_destroy(identify); }
};
} // namespace detail

/*
 * The errors of real sensors, from a record and the true path of the same motion. It can be moved, but not copied; a call on a
 * moved-from object throws SINS_ERROR_BAD_HANDLE.
 */
class Identification : public detail::Owner<sins_identify> {
public:
    Identification() : Owner(detail::given<sins_identify *>(nullptr, sins_identify_create, nullptr, nullptr)) {}

    Identification(const sins_options &options, const sins_identify_request &request)
        : Owner(detail::given<sins_identify *>(nullptr, sins_identify_create, &options, &request)) {}

    /* False: a sample ended a gap. */
    bool push(const sins_flight_sample *samples, std::size_t count) {
        return detail::done(sins_identify_push_samples(handle_, samples, count), nullptr);
    }

    void push(const sins_recorded_increment *increments, std::size_t count) {
        detail::done(sins_identify_push_increments(handle_, increments, count), nullptr);
    }

    sins_identified solve() { return detail::filled<sins_identified>(nullptr, sins_identify_solve, handle_); }

    /* All that was found. */
    std::vector<sins_identified_parameter> parameters() const {
        return detail::all(make<sins_identified_parameter>(), sins_identify_get_parameter, handle_);
    }

    /* Identifies the first half and checks the other one; request.flags had SINS_IDENTIFY_STATES. */
    sins_identified_check check(const sins_identify_check_request &request) {
        return detail::filled<sins_identified_check>(nullptr, sins_identify_check, handle_, &request);
    }

    /* All durations of the check. */
    std::vector<sins_identified_span> spans() const {
        return detail::all(make<sins_identified_span>(), sins_identify_get_span, handle_);
    }

    /* A scene whose sensors have what was found. */
    std::string scene() const { return detail::text(sins_identify_get_scene, handle_); }
};

/*
 * Recommends options for a simulator that is configured as sim. options and cost need struct_size. False: no options meet the
 * requirement, and options and cost are those of the options that come closest.
 */
inline bool recommend(const Simulator &sim, const sins_flight_sample *samples, std::size_t count,
                      const sins_requirement &requirement, sins_options &options, sins_cost &cost) {
    sim.snapshot_size(); /* throws without a handle, for which sins_recommend() would use the recommended simulator */
    return detail::done(sins_recommend(sim.handle(), samples, count, &requirement, &options, &cost), nullptr);
}

/* Recommends options for the recommended simulator with its sensors at the reference point, likewise. */
inline bool recommend(const sins_flight_sample *samples, std::size_t count, const sins_requirement &requirement,
                      sins_options &options, sins_cost &cost) {
    return detail::done(sins_recommend(nullptr, samples, count, &requirement, &options, &cost), nullptr);
}

/* Error budget of all errors of a simulator. rows gets the first row and one row for each effect. */
inline sins_budget error_budget(const Simulator &sim, const sins_flight_sample *samples, std::size_t count,
                                const sins_budget_request &request, std::vector<sins_budget_row> &rows) {
    sim.snapshot_size(); /* throws without a handle, for which sins_error_budget() would use the recommended simulator */
    sins_budget budget = make<sins_budget>();
    std::size_t number = 0;
    const auto ask = [&] {
        return sins_error_budget(sim.handle(), samples, count, &request, rows.empty() ? nullptr : rows.data(),
                                 rows.size(), &number, &budget);
    };
    rows.clear();
    if (ask() == SINS_ERROR_BUFFER_TOO_SMALL)
        rows.assign(number, make<sins_budget_row>());
    detail::done(ask(), nullptr);
    return budget;
}

} // namespace sins

#endif /* SINS_ANALYSIS_HPP */
