/* sins.hpp for sins_unit.h: the unit, an INS as the rest of an aircraft knows it. */

#ifndef SINS_UNIT_HPP
#define SINS_UNIT_HPP

#include "sins.hpp"
#include "sins_unit.h"

namespace sins {

namespace detail {
template <> struct Destroyer<sins_unit> {
    static void destroy(sins_unit *unit) noexcept { sins_unit_destroy(unit); }
};
} // namespace detail

/* The words of ARINC 429 that are due after from_s and not after to_s; see sins_bus_words(). inputs may be NULL. */
inline std::vector<sins_bus_word> bus_words(const sins_unit_status &status, const sins_unit_navigation &navigation,
                                            const sins_bus_inputs *inputs, double from_s, double to_s) {
    std::size_t count = 0;
    const sins_status asked = sins_bus_words(&status, &navigation, inputs, from_s, to_s, nullptr, 0, &count);
    if (asked != SINS_ERROR_BUFFER_TOO_SMALL)
        detail::done(asked, nullptr);
    std::vector<sins_bus_word> words(count, make<sins_bus_word>());
    detail::done(sins_bus_words(&status, &navigation, inputs, from_s, to_s, words.data(), count, &count), nullptr);
    return words;
}

/* The table of labels. */
inline std::vector<sins_bus_label> bus_labels() { return detail::all(make<sins_bus_label>(), sins_bus_get_label); }

/* Label, value and status of a word; flags is 0, or SINS_BUS_REVERSED_LABEL. The value counts only with SINS_BUS_NORMAL. */
inline sins_bus_label bus_decode(uint32_t word, uint32_t flags = 0) {
    return detail::filled<sins_bus_label>(nullptr, sins_bus_decode, word, flags);
}

/* A unit beside a simulator. It can be moved, but not copied; a call on a moved-from object throws SINS_ERROR_BAD_HANDLE. */
class Unit : public detail::Owner<sins_unit> {
public:
    using Owner::Owner;

    /* mode is SINS_UNIT_OFF, or SINS_UNIT_NAV for a unit that navigates already. */
    explicit Unit(const sins_unit_params &params = make<sins_unit_params>(), int32_t mode = SINS_UNIT_OFF)
        : Owner(detail::given<sins_unit *>(nullptr, sins_unit_create, &params, mode)) {}

    void set_params(const sins_unit_params &params) { done(sins_unit_set_params(handle_, &params)); }
    sins_unit_params params() const { return detail::filled<sins_unit_params>(nullptr, sins_unit_get_params, handle_); }

    /* The panel; the unit follows with the next update(). */
    void select(int32_t mode) { done(sins_unit_select(handle_, mode)); }
    void set_power(int32_t power) { done(sins_unit_set_power(handle_, power)); }
    void set_alignment(int32_t kind) { done(sins_unit_set_alignment(handle_, kind)); }
    void press_test() { done(sins_unit_press_test(handle_)); }
    void enter_position(double latitude_rad, double longitude_rad) {
        done(sins_unit_enter_position(handle_, latitude_rad, longitude_rad));
    }
    void enter_heading(double heading_rad) { done(sins_unit_enter_heading(handle_, heading_rad)); }
    void set_stored(double latitude_rad, double longitude_rad, double heading_rad) {
        done(sins_unit_set_stored(handle_, latitude_rad, longitude_rad, heading_rad));
    }

    /* After each step of its simulator. */
    void update(Simulator &simulator) { done(sins_unit_update(handle_, simulator.handle())); }

    /* After an update: a fix of another sensor, for an alignment in flight. */
    void push_fix(Simulator &simulator, const sins_unit_fix &fix) { done(sins_unit_push_fix(handle_, simulator.handle(), &fix)); }

    sins_unit_status status() const { return detail::filled<sins_unit_status>(nullptr, sins_unit_get_status, handle_); }
    sins_unit_navigation navigation(const Simulator &simulator) const {
        return detail::filled<sins_unit_navigation>(nullptr, sins_unit_get_navigation, handle_, simulator.handle());
    }

    std::vector<unsigned char> snapshot_save() const {
        std::vector<unsigned char> bytes(SINS_UNIT_SNAPSHOT_MAX_SIZE);
        void *const buffer = bytes.data();
        bytes.resize(detail::given<std::size_t>(nullptr, sins_unit_snapshot_save, handle_, buffer, bytes.size()));
        return bytes;
    }

    void snapshot_load(const std::vector<unsigned char> &snapshot) {
        done(sins_unit_snapshot_load(handle_, snapshot.data(), snapshot.size()));
    }

private:
    static bool done(sins_status status) { return detail::done(status, nullptr); }
};

} // namespace sins

#endif /* SINS_UNIT_HPP */
