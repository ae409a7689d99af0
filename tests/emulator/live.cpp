/* Packets as SINS_Emulator takes them: ideal sensors return to the truth in them, wrong ones are named and not flown, and what passes is
 * accepted by the simulator. */
#include <cstdio>
#include <cstdlib>
#include <map>

#include "../../apps/emulator/live.h"
#include "sins_scene.hpp"

static const double RATE_HZ = 50;
static const LiveSource NATIVE = {false, 5500, RATE_HZ}, LINES = {true, 5500, RATE_HZ};

static void require(bool holds, const char *what) {
    if (!holds) {
        std::fprintf(stderr, "live: %s\n", what);
        std::exit(1);
    }
}

/* FlightGear's packet from the layout of its header. */
static std::string native(const sins_flight_sample &sample) {
    std::string packet(408, '\0');
    auto put = [&packet](size_t at, auto value) {
        for (size_t k = 0; k < sizeof value; k++)
            packet[at + k] = reinterpret_cast<const char *>(&value)[sizeof value - 1 - k];
    };
    const double FOOT_M = 0.3048, *v = sample.velocity_enu_m_s;
    put(0, (uint32_t)24);
    put(8, sample.longitude_rad);
    put(16, sample.latitude_rad);
    put(24, sample.height_m);
    put(36, (float)sample.roll_rad);
    put(40, (float)sample.pitch_rad);
    put(44, (float)sample.heading_rad);
    put(76, (float)(v[1] / FOOT_M));
    put(80, (float)(v[0] / FOOT_M));
    put(84, (float)(-v[2] / FOOT_M));
    return packet;
}

static std::string line(const sins_flight_sample &sample) {
    char text[400];
    const double *v = sample.velocity_enu_m_s, D = SINS_DEG;
    std::snprintf(text, sizeof text, "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g, +%.17g ,%.17g\r\n", sample.time_s,
                  sample.latitude_rad / D, sample.longitude_rad / D, sample.height_m, v[0], v[1], v[2], sample.roll_rad / D,
                  sample.pitch_rad / D + 360, sample.heading_rad / D);
    return text;
}

static sins_options options(const LiveSource &source) {
    sins_options options = sins::make<sins_options>();
    options.sample_period_s = source.has_time ? 0 : 1 / source.rate_hz;
    return sins::Simulator(options).options();
}

/* A minute of aerobatics of 4 g, in which every tenth packet may be lost: position error of ideal sensors [m]. source: NULL for the
 * samples themselves, otherwise they come as packets. */
static double closure_m(const sins::Flight &flight, const LiveSource *source, bool loses) {
    const LiveSource &own = source == nullptr ? LINES : *source;
    Intake intake(own, options(own));
    sins::Simulator sim(options(own));
    for (int tick = 0; tick <= 60 * RATE_HZ; tick++) {
        sins_flight_sample sample = flight.sample_at(tick / RATE_HZ);
        if (loses && tick % 10 == 7)
            continue;
        if (source != nullptr)
            require(intake.take(own.has_time ? line(sample) : native(sample), 1, sample).has_value(), "a packet is refused");
        require(std::fabs(sample.time_s - tick / RATE_HZ) < 1e-9, "a packet has another time");
        sim.push_sample(sample);
        sim.step();
    }
    sins_errors errors = sins::make<sins_errors>();
    sim.get_errors(SINS_ERRORS_NAVIGATION, errors);
    const double *p = errors.position_enu_m;
    return std::hypot(p[0], p[1], p[2]);
}

/* What becomes of packets: "BF.j" for one that begins a flight, one that follows, one of a pause, and one that jumps. */
struct Trace {
    Intake intake;
    std::string letters;
    sins_flight_sample sample = sins::make<sins_flight_sample>();

    explicit Trace(const LiveSource &source) : intake(source, options(source)) {}

    void send(const std::string &packet, uint64_t sender = 1) {
        const Traffic before = intake.traffic;
        const auto passed = intake.take(packet, sender, sample);
        for (size_t k = 0; k < (size_t)Why::COUNT; k++)
            if (intake.traffic.refused[k] > before.refused[k])
                letters += "alvsnrtpj"[k]; /* in the order of Why */
        if (passed)
            letters += passed == Passed::BEGINS ? 'B' : passed == Passed::FOLLOWS ? 'F' : '.';
    }

    void expect(const std::string &expected, double time_s, const char *what) {
        if (letters != expected || std::fabs(sample.time_s - time_s) > 1e-9)
            std::fprintf(stderr, "live: %s at %.9g s, not %s at %.9g s\n", letters.c_str(), sample.time_s, expected.c_str(), time_s);
        require(letters == expected && std::fabs(sample.time_s - time_s) < 1e-9, what);
    }
};

static void orders(const sins::Flight &flight) {
    for (const LiveSource &source : {NATIVE, LINES}) {
        auto packet = [&](double time_s, double east_deg = 0, double later_s = 0) {
            sins_flight_sample sample = flight.sample_at(time_s);
            sample.longitude_rad += east_deg * SINS_DEG;
            sample.time_s += later_s;
            return source.has_time ? line(sample) : native(sample);
        };
        Trace order(source); /* 100 ms are lost; one is late, one repeated */
        for (double time_s : {10.0, 10.02, 10.12, 10.1, 10.12, 10.14})
            order.send(packet(time_s));
        order.expect("BFFt.F", source.has_time ? 10.14 : 0.14, "packets out of order");

        Trace pause(source); /* of ten minutes, in which the clock runs on */
        pause.send(packet(10));
        pause.send(packet(10.02));
        pause.send(packet(10.02, 0, 1));
        pause.send(packet(10.02, 0, 600));
        pause.send(packet(10.04, 0, 600));
        pause.expect("BF..F", source.has_time ? 10.04 : 0.04, "the time of a pause is not left out");

        Trace jump(source); /* one far packet is wrong, the third begins another flight */
        for (double east_deg : {0, 0, 5, 0, 5, 5, 5, 5})
            jump.send(packet(10 + 0.02 * (double)jump.letters.size(), east_deg));
        jump.expect("BFjFjjBF", source.has_time ? 10.14 : 0.02, "a jump");

        Trace gap(source); /* beyond max_gap_s */
        for (double time_s : {10.0, 10.02, 14.0, 14.02, 14.04, 14.06})
            gap.send(packet(time_s));
        gap.expect("BFjjBF", source.has_time ? 14.06 : 0.02, "a long gap");

        Trace sender(source);
        sender.send(packet(10), 1);
        sender.send(packet(10.02), 2);
        sender.send(packet(10.02), 1);
        sender.expect("BaF", source.has_time ? 10.02 : 0.02, "a second sender");
    }
}

static void wrong(const sins::Flight &flight) {
    const std::string good = native(flight.sample_at(10));
    auto with = [&good](size_t at, std::string bytes) { return std::string(good).replace(at, bytes.size(), bytes); };
    const std::string NANS("\x7f\xc0\0\0\0\0\0\0", 8);
    Trace packets(NATIVE);
    const std::string little_endian("\x18\0\0\0", 4);
    for (const std::string &packet : {good.substr(1), std::string(), good + good, with(3, "\x19"), with(0, little_endian)})
        packets.send(packet);
    for (size_t at : {8, 16, 24}) /* a NaN of eight bytes, then of four */
        packets.send(with(at, "\x7f\xf8" + NANS.substr(2)));
    for (size_t at : {36, 40, 44, 76, 80, 84})
        packets.send(with(at, NANS.substr(0, 4)));
    packets.send(with(16, std::string("\x40\0", 2))); /* a latitude of more than 2 rad */
    packets.expect("lllvvnnnnnnnnnr", packets.sample.time_s, "wrong native packets");
    Trace lines(LINES);
    for (const char *text : {"1,2,3", "", "1,2,3,4,5,6,7,8,9,10,11", "1,2,3,nan,5,6,7,8,9,10", "1,2,3,4,5,six,7,8,9,10",
                             "1,2,3,,5,6,7,8,9,10", "1,2,3,4,5,6,7,8,9,10\n1,2,3,4,5,6,7,8,9,10", "1,2,3,4,5,6,7,8,9,inf",
                             "1,91,3,4,5,6,7,8,9,10", "\xff\xfe,,,,,,,,,"})
        lines.send(text);
    lines.expect("lslnsssnrs", lines.sample.time_s, "wrong lines");
}

/* Good packets with random bytes in them: what passes, the simulator flies. */
static void damaged(const sins::Flight &flight) {
    for (const LiveSource &source : {NATIVE, LINES}) {
        Trace trace(source);
        sins::Simulator sim(options(source));
        uint64_t state = 20261125;
        auto random = [&state](size_t below) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            return (size_t)(state >> 33) % below;
        };
        for (int tick = 0; tick < 3000; tick++) {
            sins_flight_sample truth = flight.sample_at(tick / RATE_HZ);
            std::string packet = source.has_time ? line(truth) : native(truth);
            if (random(3) == 0)
                packet[random(packet.size())] = (char)random(256);
            if (random(20) == 0)
                packet.resize(random(packet.size()));
            trace.send(packet);
            if (trace.letters.back() == 'B')
                sim.reset();
            if (trace.letters.back() == 'B' || trace.letters.back() == 'F') {
                sim.push_sample(trace.sample); /* throws otherwise */
                sim.step();
            }
        }
        std::map<char, int> counts;
        for (char letter : trace.letters)
            counts[letter]++;
        require(counts['F'] > 1500 && counts['l'] > 10, "damaged packets are not told from good ones");
        std::printf("live: %s, a third of them damaged: %d flown, %d refused\n", source.has_time ? "lines" : "native packets", counts['F'],
                    3000 - counts['F'] - counts['B'] - counts['.']);
    }
}

int main() {
    sins::Flight flight = sins::Scene::builtin("aerobatics").create_flight();
    for (bool loses : {false, true}) {
        double samples_m = closure_m(flight, nullptr, loses);
        double native_m = closure_m(flight, &NATIVE, loses), lines_m = closure_m(flight, &LINES, loses);
        std::printf("live: ideal sensors%s: %.2e m, by native packets %.2e m, by lines %.2e m\n", loses ? ", every tenth packet lost" : "",
                    samples_m, native_m, lines_m);
        /* A velocity of 190 m/s as a float is off by at most half a unit in the last place, 9.3e-6 m/s, for a minute; degrees have
         * roundings of the last place. */
        require(std::fabs(native_m - samples_m) < 60 * 9.3e-6, "ideal sensors do not return to the truth of native packets");
        require(std::fabs(lines_m - samples_m) < 1e-6, "ideal sensors do not return to the truth of lines");
    }
    orders(flight);
    wrong(flight);
    damaged(flight);
    return 0;
}
