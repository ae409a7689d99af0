/* sins.hpp for sins_flight.h: embedded flights, and judges of samples. */

#ifndef SINS_FLIGHT_HPP
#define SINS_FLIGHT_HPP

#include "sins_flight.h"
#include "sins_handle.hpp"

namespace sins {

namespace detail {
template <> struct Destroyer<sins_flight> {
    static void destroy(sins_flight *flight) noexcept { sins_flight_destroy(flight); }
};
template <> struct Destroyer<sins_judge> {
    static void destroy(sins_judge *judge) noexcept { sins_judge_destroy(judge); }
};
} // namespace detail

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

/* A judge of the samples of a flight. It can be moved, but not copied; a call on a moved-from object throws SINS_ERROR_BAD_HANDLE. */
class Judge : public detail::Owner<sins_judge> {
public:
    Judge() : Owner(detail::given<sins_judge *>(nullptr, sins_judge_create, nullptr)) {}

    explicit Judge(const sins_options &options)
        : Owner(detail::given<sins_judge *>(nullptr, sins_judge_create, &options)) {}

    void push(const sins_flight_sample &sample) { detail::done(sins_judge_push(handle_, &sample), nullptr); }

    /* What was found so far, the worst first. */
    std::vector<sins_finding> findings() const {
        std::vector<sins_finding> found(SINS_FINDINGS_MAX, make<sins_finding>());
        std::size_t count = 0;
        detail::done(sins_judge_get_findings(handle_, found.data(), found.size(), &count), nullptr);
        found.resize(count);
        return found;
    }
};

} // namespace sins

#endif /* SINS_FLIGHT_HPP */
