/* sins.hpp for sins_scene.h: scenes and flight logs. */

#ifndef SINS_SCENE_HPP
#define SINS_SCENE_HPP

#include "sins_ensemble.hpp"
#include "sins_flight.hpp"
#include "sins_scene.h"
#include "sins_unit.hpp"

namespace sins {

namespace detail {
template <> struct Destroyer<sins_scene> {
    static void destroy(sins_scene *scene) noexcept { sins_scene_destroy(scene); }
};
template <> struct Destroyer<sins_play> {
    static void destroy(sins_play *play) noexcept { sins_play_destroy(play); }
};
template <> struct Destroyer<sins_log> {
    static void destroy(sins_log *log) noexcept { sins_log_destroy(log); }
};
} // namespace detail

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
        return Scene(detail::given<sins_scene *>(nullptr, sins_scene_create_builtin, detail::terminated(name, "name")));
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
        return detail::text(sins_scene_get_value, handle_, detail::terminated(path, "path"));
    }

    /* Sets values. Each line is path = value. False: the scene stays as it was, and faults() has the reasons. */
    bool set_values(const std::string &values) {
        return changed(sins_scene_set_values(handle_, detail::terminated(values, "values")));
    }

    /* Sets all items of a list, "manoeuvre", "failure" or "update", by their text. False: as set_values(). */
    bool set_items(const std::string &list, const std::string &items) {
        const char *const text = detail::terminated(items, "items");
        return changed(sins_scene_set_items(handle_, detail::terminated(list, "list"), text));
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

    /* The unit of the scene, and its update after each step: what is planned at its panel, then Unit::update(). */
    Unit unit() const { return Unit(detail::given<sins_unit *>(nullptr, sins_scene_create_unit, handle_)); }
    void update_unit(Unit &unit, Simulator &sim, double flight_start_s) const {
        done(sins_scene_update_unit(handle_, unit.handle(), sim.handle(), flight_start_s));
    }

    void prepare(Ensemble &ensemble, double flight_start_s, sins_flight_sample &sample) const {
        done(sins_scene_prepare_ensemble(handle_, ensemble.handle(), flight_start_s, &sample));
    }

    sins_options options() const { return read_back<sins_options>(sins_scene_get_options); }
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


    /* which is of enum sins_scene_text. */
    std::string text(int32_t which) const { return detail::text(sins_scene_get_text, handle_, which); }
    void set_text(int32_t which, const std::string &text) {
        done(sins_scene_set_text(handle_, which, detail::terminated(text, "text")));
    }

    /* The names of the files beside the log, each of which give_log_file() gives before Log(scene, text) joins them. */
    std::vector<std::string> log_file_names() const {
        std::vector<std::string> names;
        std::size_t needed = 0;
        while (sins_scene_log_file_name(handle_, names.size(), nullptr, 0, &needed) == SINS_OK) {
            std::vector<char> name(needed);
            done(sins_scene_log_file_name(handle_, names.size(), name.data(), name.size(), nullptr));
            names.push_back(name.data());
        }
        return names;
    }
    void give_log_file(const std::string &name, const std::string &text) {
        done(sins_scene_give_log_file(handle_, detail::terminated(name, "name"), text.data(), text.size()));
    }

    std::vector<sins_planned_failure> failures() const {
        std::size_t count = 0;
        done(sins_scene_get_failure_count(handle_, &count));
        std::vector<sins_planned_failure> failures(count, make<sins_planned_failure>());
        for (std::size_t index = 0; index < count; index++)
            done(sins_scene_get_failure(handle_, index, &failures[index]));
        return failures;
    }

private:
    explicit Scene(sins_scene *scene) noexcept : Owner(scene) {}

    bool changed(sins_status status) const {
        if (status >= 0)
            return detail::done(status, nullptr);
        /* faults() ends with a call that fails. */
        const Error error = detail::error_of(status, nullptr);
        if (status == SINS_ERROR_INVALID_ARGUMENT && !faults().empty())
            return false;
        throw error;
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
    explicit Log(const std::string &text) : Owner(parsed(nullptr, text)) {}

    /* The log of a text, read by the [log] of the scene that flies it. */
    Log(const Scene &scene, const std::string &text) : Owner(parsed(scene.handle(), text)) {}

    /* The log of samples in memory. */
    explicit Log(const std::vector<sins_flight_sample> &samples)
        : Owner(detail::given<sins_log *>(nullptr, sins_log_create, samples.data(), samples.size())) {}

    sins_log_info info() const { return detail::filled<sins_log_info>(nullptr, sins_log_get_info, handle_); }

    /* What a judge finds in the samples, the worst first. */
    std::vector<sins_finding> findings() const {
        const Judge judge;
        detail::done(sins_judge_push_log(judge.handle(), handle_), nullptr);
        return judge.findings();
    }

    /* line, if not NULL, gets the line of the text on which the sample stands. */
    sins_flight_sample sample(std::size_t index, uint64_t *line = nullptr) const {
        sins_flight_sample sample = make<sins_flight_sample>();
        detail::done(sins_log_get_sample(handle_, index, &sample, line), nullptr);
        return sample;
    }

private:
    static sins_log *parsed(const sins_scene *scene, const std::string &text) {
        sins_log *log = nullptr;
        detail::done(sins_log_parse(text.data(), text.size(), scene, &log, nullptr), nullptr);
        return log;
    }
};

/*
 * A scene in flight: its simulator, its unit if the scene has one, its samples, and the place in its plan. It can be moved, but not
 * copied; a call on a moved-from object throws SINS_ERROR_BAD_HANDLE. Errors have the time of the sample, and its line in the log.
 */
class Play : public detail::Owner<sins_play> {
public:
    /* A handle of the play under the wrapper of its kind, which does not own it. */
    template <class Wrapper> class Lent {
    public:
        template <class Handle> explicit Lent(Handle *handle) noexcept : wrapper_(handle) {}
        Lent(const Lent &) = delete;
        Lent &operator=(const Lent &) = delete;
        ~Lent() { wrapper_.release(); }
        Wrapper *operator->() noexcept { return &wrapper_; }
        const Wrapper *operator->() const noexcept { return &wrapper_; }
        Wrapper &operator*() noexcept { return wrapper_; }

    private:
        Wrapper wrapper_;
    };

    /* log: if the flight of the scene is a log, that log, or nothing for samples of the host. */
    explicit Play(const Scene &scene, const sins_log *log = nullptr)
        : Owner(detail::given<sins_play *>(nullptr, sins_play_create, scene.handle(), log)) {}
    Play(const Scene &scene, const Log &log) : Play(scene, log.handle()) {}

    /* Flies to the next sample of the scene: SINS_OK, SINS_GAP, or SINS_PLAY_END. */
    sins_status next() { return checked(sins_play_next(handle_)); }

    /* Flies to a sample of the host: SINS_OK or SINS_GAP. */
    sins_status push(const sins_flight_sample &sample) { return checked(sins_play_push(handle_, &sample)); }

    /* Takes over temperature, failures, updates and panel of another scene, from the next interval on. */
    void set_plan(const Scene &scene) { checked(sins_play_set_plan(handle_, scene.handle())); }

    /* The next records, at most `most`; fewer, or none: the flight is over. */
    std::vector<sins_record> run(std::size_t most) {
        std::vector<sins_record> records(most, make<sins_record>());
        std::size_t written = 0;
        checked(sins_play_run(handle_, records.data(), most, &written));
        records.resize(written);
        return records;
    }

    /* The signals of the next intervals, at most `most`; fewer, or none: the flight is over. */
    std::vector<sins_imu> run_imu(std::size_t most) {
        std::vector<sins_imu> imu(most, make<sins_imu>());
        std::size_t written = 0;
        checked(sins_play_run_imu(handle_, imu.data(), most, &written));
        imu.resize(written);
        return imu;
    }

    /* Flies to the end without records. */
    void finish() { checked(sins_play_run(handle_, nullptr, 0, nullptr)); }

    /* The handles that the object owns; they end with it. Play::Lent<Simulator> sim(play.simulator()); sim->get_record(record); */
    sins_sim *simulator() const { return detail::given<sins_sim *>(nullptr, sins_play_get_simulator, handle_); }
    sins_unit *unit() const { return detail::given<sins_unit *>(nullptr, sins_play_get_unit, handle_); }

    /* Truth, navigation and errors now. */
    sins_record record() const {
        sins_sim *const sim = simulator();
        return detail::filled<sins_record>(sim, sins_get_record, sim);
    }

    /* What the INS shows; false: no interval was flown. */
    bool shown(sins_unit_status &status, sins_unit_navigation &navigation) const {
        status = make<sins_unit_status>();
        navigation = make<sins_unit_navigation>();
        return checked(sins_play_get_shown(handle_, &status, &navigation)) == SINS_OK;
    }

    /* The whole as bytes, and back into an object of the same scene on the same samples. */
    std::vector<unsigned char> save() const {
        std::vector<unsigned char> bytes(SINS_PLAY_SNAPSHOT_MAX_SIZE);
        std::size_t size = 0;
        checked(sins_play_snapshot_save(handle_, bytes.data(), bytes.size(), &size));
        bytes.resize(size);
        return bytes;
    }
    void load(const std::vector<unsigned char> &snapshot) {
        checked(sins_play_snapshot_load(handle_, snapshot.data(), snapshot.size()));
    }

private:
    static sins_status checked(sins_status status) {
        detail::done(status, nullptr);
        return status;
    }
};

} // namespace sins

#endif /* SINS_SCENE_HPP */
