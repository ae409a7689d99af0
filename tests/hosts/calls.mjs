// The same calls as in calls.c.

const { load, SinsError } = await import(process.env.SINS_MODULE);
const sins = await load();
const show = (label, value) => console.log(label, value);

const name = sins.scene_builtin_name(1);
show(name, name.length + 1);

const straight = { kind: sins.MANOEUVRE_STRAIGHT, duration_s: 5 };
const roll = { kind: sins.MANOEUVRE_ROLL, duration_s: 10, turns: 1 };
const flight = sins.flight_create({ latitude_rad: 0.7, speed_m_s: 100 }, [straight, roll]);
const samples = sins.array(sins.flight_sample, 121);
for (let k = 0; k < samples.length; k++) {
    sins.flight_sample_at(flight, k / 8, samples.at(k));
}

const options = new sins.options({ scheme: sins.SCHEME_POLYNOMIAL, subsamples: 3 });
const sim = sins.create(options);
const gyro = new sins.gyro_params();
gyro.misalignment_rad[1] = 1e-3; // row 0, column 1
gyro.misalignment_rad[6] = 2e-3; // row 2, column 0
sins.set_gyro(sim, gyro);
const records = sins.array(sins.record, 5);
const written = sins.run(sim, samples, 30, records);
show("written", written);
for (let k = 0; k < written; k++) {
    const { time_s, navigation_errors } = records.at(k);
    show("time", time_s);
    show("velocity", navigation_errors.velocity_enu_m_s[1]);
    show("misalignment", records.numbers[k * records.stride + records.offset("navigation_errors.misalignment_enu_rad") + 2]);
}

const saved = sins.snapshot(sim);
show("snapshot", saved.length);
const second = sins.create(options);
sins.snapshot_load(second, saved);
show("quaternion", sins.get_navigation(second).quaternion_nb[3]);

gyro.misalignment_rad[7] = 2; // row 2, column 1
try {
    sins.set_gyro(sim, gyro);
} catch (error) {
    if (error instanceof SinsError) {
        show("refused", error.status);
        show(error.info.field, Number(error.info.index));
    }
}
