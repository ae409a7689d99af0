// Flies a built-in scene in Node: node fly.mjs patrol. The package "sins" is installed, or SINS_MODULE names its sins.mjs.

const { load, SinsError } = await import(process.env.SINS_MODULE ?? "sins");
const sins = await load();
try {
    const scene = sins.scene_create_builtin(process.argv[2] ?? "patrol");
    const { flown_s, rate_hz } = sins.scene_get_setup(scene);
    const sim = sins.scene_create_simulator(scene);
    const flight = sins.scene_create_flight(scene);
    const sample = new sins.flight_sample();
    for (let k = 0; k <= Math.floor(flown_s * rate_hz + 1e-6); k++) {
        sins.flight_sample_at(flight, Math.min(k / rate_hz, flown_s), sample);
        sins.scene_prepare(scene, sim, 0, sample); // temperature, failures and updates of the scene
        sins.push_sample(sim, sample);
        sins.step(sim);
    }
    const { position_enu_m, velocity_enu_m_s, misalignment_enu_rad } = sins.get_errors(sim, sins.ERRORS_NAVIGATION);
    console.log("errors at the end, navigation - truth, east-north-up");
    console.log("position m      ", ...position_enu_m);
    console.log("velocity m/s    ", ...velocity_enu_m_s);
    console.log("misalignment rad", ...misalignment_enu_rad);
} catch (error) {
    console.error(`fly.mjs: ${error.message} (${error instanceof SinsError ? sins.status_string(error.status) : error.name})`);
    process.exitCode = 1;
}
