// Points of the curves in memory of a fixed size: when it is full, every second point is dropped. The paths of the map keep all, because
// a path turns between points that are dropped.

/** Most points. */
const MOST = 4096;
/** Samples of a flight that become points, before points are dropped. */
const LEAST = 20000;

/** Triples of numbers at each point: in the record, and in the last interval of the sensors. */
const OF_RECORD = {
    position2: "navigation_errors.position_enu_m",
    velocity2: "navigation_errors.velocity_enu_m_s",
    misalignment2: "navigation_errors.misalignment_enu_rad",
    attitude2: "navigation_errors.roll_rad",
    position1: "model_errors.position_enu_m",
    velocity1: "model_errors.velocity_enu_m_s",
    misalignment1: "model_errors.misalignment_enu_rad",
    attitude1: "model_errors.roll_rad",
    true_place: "truth.latitude_rad",
    true_velocity: "truth.velocity_enu_m_s",
    true_attitude: "truth.roll_rad",
    place: "navigation.latitude_rad",
    velocity: "navigation.velocity_enu_m_s",
    attitude: "navigation.roll_rad",
};
const OF_IMU = { rate: "measured_rate_rad_s", force: "measured_force_m_s2" };

/** The numbers of an array, by a view that is kept: making one takes longer than a sample. It is empty once the library's memory has grown. */
export function numbers_of(array) {
    let view = array.numbers;
    return () => (view.length > 0 ? view : (view = array.numbers));
}

export class Points {
    constructor(records, imu, count) {
        const of_records = (this.of_records = numbers_of(records)), of_imu = numbers_of(imu);
        this.every = Math.max(1, Math.floor(count / LEAST));
        const places = (array, numbers, paths) => Object.entries(paths).map(([name, path]) => [name, numbers, array.offset(path)]);
        this.triples = [...places(records, of_records, OF_RECORD), ...places(imu, of_imu, OF_IMU)];
        this.time = records.offset("time_s");
        this.columns = Array.from({ length: 1 + 3 * this.triples.length }, () => new Float64Array(MOST));
        [this.count, this.stride, this.seen] = [0, 1, 0];
        // Latitude and longitude of the truth and of the INS.
        this.of_path = [OF_RECORD.true_place, OF_RECORD.place].flatMap((path) => [0, 1].map((k) => records.offset(path) + k));
        [this.path, this.places] = [this.of_path.map(() => new Float64Array(2 * LEAST + 1)), 0];
    }

    is_due(index, is_last) {
        return is_last || index % this.every === 0;
    }

    /** Adds the record and the interval as a point, if its turn has come. */
    add(start_s, is_last) {
        const record = this.of_records();
        this.of_path.forEach((offset, k) => (this.path[k][this.places] = record[offset]));
        this.places++;
        if (this.seen++ % this.stride !== 0 && !is_last) return;
        if (this.count === MOST) this.halve();
        const at = this.count++;
        this.columns[0][at] = record[this.time] - start_s;
        this.triples.forEach(([, numbers, offset], triple) => {
            const own = numbers();
            for (let k = 0; k < 3; k++) this.columns[1 + 3 * triple + k][at] = own[offset + k];
        });
    }

    halve() {
        for (const column of this.columns) {
            for (let k = 0; k < MOST / 2; k++) column[k] = column[2 * k];
        }
        this.count = MOST / 2;
        this.stride *= 2;
    }

    /** A copy: the times, by the names of the triples three columns each, and the paths. */
    copy() {
        const [time, ...others] = this.columns.map((column) => column.slice(0, this.count));
        const triples = this.triples.map(([name], triple) => [name, others.slice(3 * triple, 3 * triple + 3)]);
        const [latitude, longitude, ...path] = this.path.map((column) => column.slice(0, this.places));
        return { time, ...Object.fromEntries(triples), true_path: [latitude, longitude], path };
    }
}
