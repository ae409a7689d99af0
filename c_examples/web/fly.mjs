// Flies a built-in scene in Node: node fly.mjs patrol. The package "sins" is installed, or SINS_MODULE names its sins.mjs.

const { load, SinsError } = await import(process.env.SINS_MODULE ?? "sins");
const sins = await load();
try {
    const scene = sins.scene_create_builtin(process.argv[2] ?? "patrol");
    const play = sins.play_create(scene, null); // simulator, unit and samples, and what the scene plans
    while (sins.play_next(play) !== sins.PLAY_END);
    const sim = sins.play_get_simulator(play);
    const { position_enu_m, velocity_enu_m_s, misalignment_enu_rad } = sins.get_errors(sim, sins.ERRORS_NAVIGATION);
    console.log("errors at the end, navigation - truth, east-north-up");
    console.log("position m      ", ...position_enu_m);
    console.log("velocity m/s    ", ...velocity_enu_m_s);
    console.log("misalignment rad", ...misalignment_enu_rad);
} catch (error) {
    const kind = error instanceof SinsError ? sins.status_string(error.status) : error.name;
    console.error(`fly.mjs: ${error.message} (${kind})`);
    process.exitCode = 1;
}
