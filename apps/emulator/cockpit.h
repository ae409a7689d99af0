/* A flight by stick and throttle: the aircraft, the simulator of a scene, and the INS as a box with its panel, in steps of one sample. */
#pragma once
#include <optional>

#include "aircraft.h"
#include "curves.h"
#include "samples.h"

class Cockpit {
public:
    /* Begins where the flight of the scene begins. A scene without a unit has one that navigates at once. */
    Cockpit(const Scene &scene, const fs::path &folder)
        : play_(with_unit(scene), Samples(scene, folder).log()), sim_(play_.simulator()), unit_(play_.unit()),
          aircraft_(Samples(scene, folder).get(0)) {
        double period_s = sim_->options().sample_period_s;
        step_s = period_s > 0 ? period_s : 0.02;
        stick.throttle = aircraft_.throttle();
        next();
    }

    /* Flies one sample. */
    void step() {
        aircraft_.fly(stick, step_s);
        count_++;
        next();
        sins_record record = sins::make<sins_record>();
        if (!sim_->get_record(record))
            return;
        errors = record.navigation_errors;
        curves.put(POSITION_ERROR, errors.position_enu_m);
        curves.put(VELOCITY_ERROR, errors.velocity_enu_m_s);
        curves.put(ATTITUDE_ERROR, &errors.roll_rad);
        curves.end_point(time_s());
    }

    double time_s() const { return (double)count_ * step_s; }
    sins_flight_sample truth() const { return aircraft_.sample(time_s()); }
    double speed_m_s() const { return aircraft_.speed_m_s(); }
    sins_unit_status status() const { return unit_->status(); }
    sins_unit_navigation shown() const { return unit_->navigation(*sim_); }
    sins::Unit &unit() { return *unit_; }

    Stick stick = {0, 0, 0};
    double step_s;
    sins_record_errors errors = {};
    Curves curves;

private:
    static Scene with_unit(Scene scene) {
        if (scene.get("unit.start") == "\"none\"")
            scene.set({{"unit.start", "\"nav\""}});
        return scene;
    }

    /* Takes the truth now. */
    void next() { play_.push(truth()); }

    sins::Play play_;
    mutable sins::Play::Lent<sins::Simulator> sim_;
    sins::Play::Lent<sins::Unit> unit_;
    Aircraft aircraft_;
    uint64_t count_ = 0;
};
