// What TypeScript accepts of sins.d.ts, and what it does not.

import { load, SinsError, type Sins } from "sins";

const sins: Sins = await load();
const sim = sins.create(null);
const gyro = new sins.gyro_params({ bias_rad_s: [1, 2, 3] });
gyro.bias_rad_s = [1, 2, 3];
gyro.bias_rad_s[0] += 0.01 * sins.DEG_PER_HOUR;
sins.set_gyro(sim, gyro);
const errors = sins.get_errors(sim, sins.ERRORS_NAVIGATION);
export const east: number = errors?.position_enu_m[0] ?? 0;
const records = sins.array(sins.record, 10);
export const written: number = sins.run(sim, [{ time_s: 0 }, new sins.flight_sample({ time_s: 1 })], 1, records);
export const north: number = records.at(0).navigation_errors.position_enu_m[1];
const options = new sins.options({ seed: 5, scheme: sins.SCHEME_EXACT });
options.seed = 3;
export const seed: bigint = options.seed;
const [log, fault] = sins.log_parse("x", null);
export const sentence: string = fault.sentence + sins.log_get_info(log).title;
export const text: string = sins.scene_write(sins.scene_parse("x"));
try {
    sins.step(sim);
} catch (error) {
    if (error instanceof SinsError) console.log(error.status, error.info?.field);
}
sim.close();

// @ts-expect-error a simulator is not a flight
sins.flight_duration(sim);
// @ts-expect-error no such field
new sins.gyro_params({ bias: [1, 2, 3] });
// @ts-expect-error no such function
sins.fly(sim);
// @ts-expect-error there may be no errors yet
sins.get_errors(sim, 0).time_s;
// @ts-expect-error a text is no number
sins.move_time(sim, "1");
// @ts-expect-error a handle is made by a call
new sins.sim(1);
