/* JSBSim, its script, and its state as a flight sample. */

#ifndef FLIGHT_SIMULATOR_HPP
#define FLIGHT_SIMULATOR_HPP

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>

#include <FGFDMExec.h>
#include <models/FGAccelerations.h>
#include <models/FGPropagate.h>

#include "sins.hpp"

class FlightSimulator {
public:
    FlightSimulator(const std::string &folder, const std::string &script)
    {
        fdm.SetDebugLevel(0);
        fdm.SetRootDir(SGPath(folder));
        fdm.SetAircraftPath(SGPath("aircraft"));
        fdm.SetEnginePath(SGPath("engine"));
        fdm.SetSystemsPath(SGPath("systems"));
        if (!fdm.LoadScript(SGPath(std::filesystem::absolute(script).string()))) { /* relative paths start in its folder */
            throw std::runtime_error(script + ": no script of JSBSim's");
        }
    }

    /* Sets a property from PROPERTY=VALUE of the command line. */
    void set(const std::string &assignment)
    {
        const std::size_t equals = assignment.find('=');
        const std::string name = assignment.substr(0, equals);
        if (equals == std::string::npos || !fdm.GetPropertyManager()->HasNode(name)) {
            throw std::runtime_error(assignment + ": expected PROPERTY=VALUE with a property of JSBSim or of the script");
        }
        const char *text = assignment.c_str() + equals + 1;
        char *end = nullptr;
        const double value = std::strtod(text, &end);
        if (end == text || *end != '\0') {
            throw std::runtime_error(assignment + ": expected a number");
        }
        if (!fdm.GetPropertyManager()->GetNode(name)->setDoubleValue(value)) {
            throw std::runtime_error(assignment + ": the property can only be read");
        }
    }

    /* Runs a frame at its time. False: the script has ended. */
    bool run()
    {
        const double pace = get("ins/pace");
        if (pace > 0.0) {
            const std::chrono::duration<double> step(get("simulation/dt") / pace);
            next_frame_ += std::chrono::duration_cast<Clock::duration>(step);
            std::this_thread::sleep_until(next_frame_);
        }
        return fdm.Run();
    }

    void set(const std::string &name, double value) { fdm.SetPropertyValue(name, value); }
    double get(const std::string &name) { return fdm.GetPropertyValue(name); }

    /* Returns the value of a property that is a command, and sets the property to 0. */
    double take(const std::string &name)
    {
        const double value = get(name);
        set(name, 0.0);
        return value;
    }

    /* JSBSim's position is that of the centre of gravity, its local frame belongs to the WGS-84 ellipsoid, and its
     * body axes are forward-right-down. */
    sins_flight_sample sample(double time_s, int signals)
    {
        auto sample = sins::make<sins_flight_sample>();
        sample.time_s = time_s;
        sample.latitude_rad = get("position/lat-geod-rad");
        sample.longitude_rad = get("position/long-gc-rad");
        sample.height_m = get("position/geod-alt-ft") * FOOT_M;
        sample.velocity_enu_m_s[0] = get("velocities/v-east-fps") * FOOT_M;
        sample.velocity_enu_m_s[1] = get("velocities/v-north-fps") * FOOT_M;
        sample.velocity_enu_m_s[2] = -get("velocities/v-down-fps") * FOOT_M;
        sample.roll_rad = get("attitude/phi-rad");
        sample.pitch_rad = get("attitude/theta-rad");
        sample.heading_rad = get("attitude/psi-rad");
        if (signals >= 1) {
            sample.flags |= SINS_SAMPLE_ANGULAR_RATE;
            sample.angular_rate_rad_s[0] = get("velocities/pi-rad_sec");
            sample.angular_rate_rad_s[1] = get("velocities/qi-rad_sec");
            sample.angular_rate_rad_s[2] = get("velocities/ri-rad_sec");
        }
        if (signals >= 2) {
            const JSBSim::FGColumnVector3 force = specific_force_m_s2();
            sample.flags |= SINS_SAMPLE_SPECIFIC_FORCE;
            for (int i = 0; i < 3; i++) {
                sample.specific_force_m_s2[i] = force(i + 1);
            }
        }
        return sample;
    }

    JSBSim::FGColumnVector3 specific_force_m_s2() const { return fdm.GetAccelerations()->GetBodyAccel() * FOOT_M; }

    JSBSim::FGFDMExec fdm;

private:
    static constexpr double FOOT_M = 0.3048; /* exact */

    typedef std::chrono::steady_clock Clock;
    Clock::time_point next_frame_ = Clock::now();
};

#endif
