//! Kinds of logs that a path must not take for something else: climbs over one place, stairs of heights, filters that jump, attitudes that
//! are live beside slow fixes, slow vehicles without an attitude, and the start of a path.

use nalgebra::Vector3;
use sins::earth::Earth;
use sins::judge::Judge;
use sins::log::smooth::{SmoothOptions, Smoothed};
use sins::math::{Euler, wrap_angle};
use sins::truth::FlightSample;

use crate::judge::faults::{Draws, each, float32, move_by, noisy};
use crate::judge::flights::{Good, Samples, drone_over_one_place, scene, vehicle, without_velocities};
use crate::support::DEG;

fn smoothed(samples: &[FlightSample]) -> Smoothed {
    Smoothed::new(&Earth::default(), samples, &SmoothOptions::default()).unwrap()
}

fn coordinated(samples: &[FlightSample]) -> Smoothed {
    let options = SmoothOptions { coordinated_attack_rad: Some(0.0), ..SmoothOptions::default() };
    Smoothed::new(&Earth::default(), samples, &options).unwrap()
}

/// Root mean squares of what `error` gives for the path and the truth at its times.
fn rms<const N: usize>(
    truth: &Samples,
    path: &Smoothed,
    error: impl Fn(&FlightSample, &FlightSample) -> [f64; N],
) -> [f64; N] {
    let [start_s, end_s] = path.span_s();
    let (mut sums, mut count) = ([0.0; N], 0.0);
    for truth in truth.iter().filter(|truth| (start_s..=end_s).contains(&truth.time_s)) {
        for (sum, error) in sums.iter_mut().zip(error(&path.sample_at(truth.time_s).unwrap(), truth)) {
            *sum += error * error;
        }
        count += 1.0;
    }
    sums.map(|sum: f64| (sum / count).sqrt())
}

/// Horizontal and vertical distance [m] and velocity [m/s].
fn apart(path: &FlightSample, truth: &FlightSample) -> [f64; 3] {
    let (d_e, axes) = Earth::default().displacement(&path.place, &truth.place);
    let [east, north] = [0, 1].map(|axis| axes[axis].dot(&d_e));
    let v = path.v_n.unwrap() - truth.v_n.unwrap();
    [east.hypot(north), path.place.height_m - truth.place.height_m, v.norm()]
}

/// Root mean square error of the acceleration to the east, north and up, 3 s from the ends [m/s²].
fn acceleration(truth: &Samples, path: &Smoothed) -> Vector3<f64> {
    let ([start_s, end_s], h) = (path.span_s(), 0.05);
    let (mut sum, mut count) = (Vector3::zeros(), 0.0);
    for three in truth.windows(3) {
        let time_s = three[1].time_s;
        if time_s < start_s + 3.0 || time_s > end_s - 3.0 {
            continue;
        }
        let v = |time_s: f64| path.sample_at(time_s).unwrap().v_n.unwrap();
        let of_truth = (three[2].v_n.unwrap() - three[0].v_n.unwrap()) / (three[2].time_s - three[0].time_s);
        let error = (v(time_s + h) - v(time_s - h)) / (2.0 * h) - of_truth;
        sum += error.component_mul(&error);
        count += 1.0;
    }
    (sum / count).map(f64::sqrt)
}

fn stepped(samples: &[FlightSample], degrees: f64, up_m: f64) -> Samples {
    let round =
        |angle: f64| if degrees > 0.0 { (angle / DEG / degrees).round() * degrees * DEG } else { angle };
    each(samples, |_, sample| {
        sample.place.latitude_rad = round(sample.place.latitude_rad);
        sample.place.longitude_rad = round(sample.place.longitude_rad);
        if up_m > 0.0 {
            sample.place.height_m = (sample.place.height_m / up_m).round() * up_m;
        }
    })
}

/// A drone rests, climbs over one place, flies, and lands below another: no row of it repeats a fix.
#[test]
fn a_climb_over_one_place_is_flown() {
    let flight = drone_over_one_place(10.0);
    for (degrees, up_m, limits) in
        [(0.0, 0.0, [0.05, 0.05, 0.1]), (1e-7, 0.001, [0.05, 0.05, 0.1]), (1e-5, 0.01, [1.2, 0.1, 0.5])]
    {
        let rows = stepped(&without_velocities(&flight.samples), degrees, up_m);
        let path = smoothed(&rows);
        let [place, height, velocity] = rms(&flight.samples, &path, apart);
        println!("{degrees} deg: {place:.4} m, height {height:.4} m, {velocity:.4} m/s, {:?}", path.span_s());
        let [start_s, end_s] = path.span_s();
        let [first_s, last_s] = [rows[0].time_s, rows[rows.len() - 1].time_s];
        assert!(start_s - first_s < 0.021 * last_s && last_s - end_s < 0.021 * last_s, "{degrees} deg");
        assert!(place < limits[0] && height < limits[1] && velocity < limits[2], "{degrees} deg");
    }
}

/// A receiver of 1 Hz in rows of 25 Hz, whose attitude is live and oscillates at 2 Hz: the attitude keeps its own bandwidth.
#[test]
fn a_live_attitude_keeps_its_bandwidth() {
    let flight = vehicle("light aircraft", 25.0, |t| {
        let heading = 0.6 * (0.05 * t).sin();
        let roll = 5.0 * DEG * (4.0 * core::f64::consts::PI * t).sin();
        (Vector3::new(45.0 * heading.sin(), 45.0 * heading.cos(), 0.5), Euler { roll, pitch: 0.03, heading })
    });
    let mut last = flight.samples[0].place;
    let rows = each(&without_velocities(&flight.samples), |k, sample| {
        if k % 25 == 0 {
            last = sample.place;
        }
        sample.place = last;
    });
    let path = smoothed(&rows);
    let [roll] = rms(&flight.samples, &path, |path, truth| [wrap_angle(path.euler.roll - truth.euler.roll)]);
    let [place, ..] = rms(&flight.samples, &path, apart);
    println!("{:.3} deg, {place:.3} m", roll / DEG);
    assert!(roll < 0.1 * DEG && place < 1.0);
}

/// Heights in steps: of 25 ft, and of 5 m, which few logs have; of aeroplanes, and of a ship, whose heave does not show. The acceleration
/// is that of the flight, and the steps are said as noise.
#[test]
fn stairs_of_heights_are_no_motion() {
    let ship = vehicle("ship", 10.0, |t| {
        (
            Vector3::new(3.0, 5.0, (0.9 * t).cos()),
            Euler { roll: 0.1 * (0.7 * t).sin(), pitch: 0.0, heading: 0.5 },
        )
    });
    let climbs = vehicle("light aircraft", 10.0, |t| {
        let (heading, climb) = (0.5 * (0.03 * t).sin(), 3.0 * (0.05 * t).sin());
        (
            Vector3::new(45.0 * heading.sin(), 45.0 * heading.cos(), climb),
            Euler { roll: 0.0, pitch: 0.05, heading },
        )
    });
    // Its height crosses one edge or two.
    let hover = vehicle("hover", 10.0, |t| {
        let v =
            Vector3::new(0.3 * (0.2 * t).sin() + 1.0, 0.2 * (0.3 * t).cos(), 0.015 * (0.01 * t).cos() + 0.01);
        (v, Euler { roll: 0.02 * (0.7 * t).cos(), pitch: 0.0, heading: 0.3 })
    });
    for flight in [scene("commuter", 10.0), scene("aerobatics", 10.0), climbs, ship, hover] {
        for (rate_hz, up_m) in [(10.0, 7.62), (10.0, 5.0), (1.0, 7.62)] {
            // Its rolls turn by more than 90 degrees a second, which is refused.
            if rate_hz == 1.0 && flight.name == "aerobatics" {
                continue;
            }
            let truth = flight.at(rate_hz);
            let rows = stepped(&without_velocities(&truth), 0.0, up_m);
            let path = smoothed(&rows);
            let error = acceleration(&truth, &path).z;
            let still: f64 = acceleration(&truth, &coordinated_still(&truth)).z;
            let noise = path.height().noise;
            println!("{} {rate_hz} Hz {up_m} m: {error:.3} of {still:.3} m/s2, {noise:.2} m", flight.name);
            // The motion of the height may be lost, and steps leave a quarter of a metre a second squared.
            assert!(error < still.hypot(0.25), "{} {rate_hz} Hz {up_m} m: {error}", flight.name);
            // A heave that crosses no edge leaves a constant.
            let has_edges = rows.iter().any(|row| row.place.height_m != rows[0].place.height_m);
            assert!(!has_edges || noise > 0.9 * up_m / 12f64.sqrt(), "{} {noise}", flight.name);
        }
    }
}

/// The path at a constant height, whose error of acceleration is the acceleration of the flight itself.
fn coordinated_still(truth: &Samples) -> Smoothed {
    smoothed(&each(truth, |_, sample| sample.place.height_m = 1000.0))
}

/// The path of a filter: its error drifts, and a share of it is taken away at each fix.
fn filtered(samples: &[FlightSample], every: usize, seed: u64) -> Samples {
    let mut draws = Draws(seed);
    let mut three = |sigma: f64| Vector3::from_fn(|_, _| sigma * draws.normal());
    let (mut drift, mut error) = (three(0.3), three(0.5));
    let dt = samples[1].time_s - samples[0].time_s;
    each(&without_velocities(samples), |k, sample| {
        if k % every == 0 && k > 0 {
            let innovation = error + three(0.5);
            error -= innovation * 0.6;
            drift += three(0.1) - innovation * 0.4;
        }
        error += drift * dt;
        move_by(sample, error.x, error.y, error.z);
    })
}

/// Jumps of decimetres at each fix, which come once a second, or five times: what is flown is the motion below the rate of the fixes.
#[test]
fn jumps_of_a_filter_are_taken_out() {
    let flight: Good = vehicle("light aircraft", 25.0, |t| {
        let heading = 0.3 + 0.8 * (0.06 * t).sin();
        let v = Vector3::new(45.0 * heading.sin(), 45.0 * heading.cos(), (0.1 * t).sin());
        (v, Euler { roll: 0.2 * (0.06 * t).cos(), pitch: 0.03, heading })
    });
    for seed in 1..4 {
        let rows = filtered(&flight.samples[..3000], 25, seed);
        let path = smoothed(&rows);
        let (count, interval_s) = path.corrections.unwrap();
        let error = acceleration(&flight.samples, &path);
        println!("{count} jumps, {interval_s} s: {error:?}");
        assert!((100..=125).contains(&count) && (interval_s - 1.0).abs() < 0.05, "{count}, {interval_s} s");
        assert!(error.max() < 0.4, "{error:?}");
        let mut judge = Judge::new(Earth::default(), 2000.0).unwrap();
        let [start_s, end_s] = path.span_s();
        (0..=((end_s - start_s) * 50.0) as u32)
            .try_for_each(|k| judge.push(&path.sample_at(start_s + f64::from(k) / 50.0).unwrap()))
            .unwrap();
        assert_eq!(judge.findings().count(), 0);
    }
    for rows in [noisy(&flight.samples, 0.5), without_velocities(&flight.samples)] {
        assert_eq!(smoothed(&rows).corrections, None);
    }
}

/// A filter whose latitudes and longitudes are 32-bit floats: their steps hide the jumps, which the heights show.
#[test]
fn jumps_of_heights_are_taken_out_beside_coarse_positions() {
    let flight: Good = vehicle("unmanned aircraft", 50.0, |t| {
        let heading = 0.3 + 0.8 * (0.06 * t).sin();
        let v = Vector3::new(20.0 * heading.sin(), 20.0 * heading.cos(), (0.1 * t).sin());
        (v, Euler { roll: 0.1 * (0.06 * t).cos(), pitch: 0.03, heading })
    });
    for seed in 1..4 {
        let rows = float32(&filtered(&flight.samples[..6000], 50, seed));
        let path = smoothed(&rows);
        let (count, interval_s) = path.corrections.unwrap();
        let error = acceleration(&flight.samples, &path);
        println!("{count} jumps, {interval_s} s: {error:?}");
        assert!((100..=125).contains(&count) && (interval_s - 1.0).abs() < 0.05, "{count}, {interval_s} s");
        assert!(error.z < 0.4, "{error:?}");
    }
}

/// Vehicles without an attitude: the course is the heading, however slow they are.
#[test]
fn the_course_of_a_slow_vehicle_is_its_heading() {
    for (speed, sigma_m, limit_deg) in [(7.9, 0.0, 1.0), (3.0, 0.0, 1.0), (0.5, 0.0, 1.0), (6.0, 1.0, 5.0)] {
        let flight = vehicle("ship", 1.0, |t| {
            let heading = 0.5 + 0.01 * (t - 100.0).clamp(0.0, 200.0);
            let v = Vector3::new(speed * heading.sin(), speed * heading.cos(), 0.0);
            (v, Euler { roll: 0.0, pitch: 0.0, heading })
        });
        let rows = each(&noisy(&flight.samples, sigma_m), |_, sample| sample.euler = Euler::default());
        let path = coordinated(&rows);
        let [heading] =
            rms(&flight.samples, &path, |path, truth| [wrap_angle(path.euler.heading - truth.euler.heading)]);
        println!("{speed} m/s, {sigma_m} m: {:.2} deg", heading / DEG);
        assert!(heading < limit_deg * DEG, "{speed} m/s, {sigma_m} m: {} deg", heading / DEG);
    }
}

/// A drone without an attitude that climbs and sinks over one place, faster than an aeroplane begins to bank, stays level.
#[test]
fn what_climbs_over_one_place_is_level() {
    for climb in [5.0, 10.0, 18.0] {
        let flight = vehicle("drone", 1.0, |t| {
            let up = climb
                * ((0.05 * (t - 100.0)).clamp(0.0, 3.0) - (0.05 * (t - 200.0)).clamp(0.0, 6.0)
                    + (0.05 * (t - 400.0)).clamp(0.0, 3.0))
                .clamp(-1.0, 1.0);
            let forward = 3.0 * (0.02 * (t - 450.0)).clamp(0.0, 1.0);
            (Vector3::new(0.0, forward, up), Euler { roll: 0.0, pitch: 0.0, heading: 0.0 })
        });
        let path = coordinated(&each(&flight.samples, |_, sample| sample.euler = Euler::default()));
        let [tilt] = rms(&flight.samples, &path, |path, _| [path.euler.roll.hypot(path.euler.pitch)]);
        assert!(tilt < 0.5 * DEG, "{climb} m/s: {} deg", tilt / DEG);
    }
}

/// The velocity and the roll with which an INS starts are within three times of those within the path.
#[test]
fn the_start_is_as_good_as_the_middle() {
    let flight = vehicle("S-turns", 1.0, |t| {
        let (heading, turn) = (0.9 * (0.15 * t + 0.7).sin(), 0.9 * 0.15 * (0.15 * t + 0.7).cos());
        let v = Vector3::new(60.0 * heading.sin(), 60.0 * heading.cos(), 0.0);
        (v, Euler { roll: (60.0 * turn / 9.81).atan(), pitch: 0.0, heading })
    });
    let mut starts = [0.0_f64; 2];
    let mut within = [0.0_f64; 2];
    for seed in 0..20 {
        let rows: Samples = flight.samples[20 * seed..20 * seed + 200].to_vec();
        let mut draws = Draws(7 + seed as u64);
        let rows = each(&without_velocities(&rows), |_, sample| {
            let [east, north, up] = [(); 3].map(|()| 2.0 * draws.normal());
            move_by(sample, east, north, up);
        });
        let path = coordinated(&rows);
        let [start_s, end_s] = path.span_s();
        let turn_of = |t: f64| 0.9 * 0.15 * (0.15 * t + 0.7).cos();
        let errors = |time_s: f64| {
            let sample = path.sample_at(time_s).unwrap();
            let heading = 0.9 * (0.15 * time_s + 0.7).sin();
            let v = sample.v_n.unwrap() - Vector3::new(60.0 * heading.sin(), 60.0 * heading.cos(), 0.0);
            [v.x.hypot(v.y), sample.euler.roll - (60.0 * turn_of(time_s) / 9.81).atan()]
        };
        for (time_s, is_start) in [(start_s, true)]
            .into_iter()
            .chain((1..=20).map(|k| (start_s + (end_s - start_s) * (0.2 + 0.03 * f64::from(k)), false)))
        {
            let sums = if is_start { &mut starts } else { &mut within };
            for (sum, error) in sums.iter_mut().zip(errors(time_s)) {
                *sum += error * error / if is_start { 20.0 } else { 400.0 };
            }
        }
    }
    let [starts, within] = [starts, within].map(|sums| sums.map(f64::sqrt));
    println!(
        "starts {:.2} m/s, {:.2} deg; within {:.2} m/s, {:.2} deg",
        starts[0],
        starts[1] / DEG,
        within[0],
        within[1] / DEG
    );
    assert!(starts[0] < 3.0 * within[0] && starts[1] < 3.0 * within[1]);
}

/// Exact rows without an attitude, from turns that begin in the bank: an INS is aligned in the first attitude of the path. The bank has
/// 30 degrees; where the path has rows on one side only, it is wrong by up to 18.
#[test]
fn the_first_bank_of_exact_rows_is_that_of_the_turns() {
    for period_s in [8.0, 16.0, 32.0, 60.0] {
        let (omega, slope) = (2.0 * core::f64::consts::PI / period_s, (30.0 * DEG).tan());
        let bank_of = |t: f64| (slope * (omega * t).cos()).atan();
        let flight = vehicle("S-turns", 50.0, |t| {
            let heading = 0.5 + slope * 9.81 / (60.0 * omega) * (omega * t).sin();
            let v = Vector3::new(60.0 * heading.sin(), 60.0 * heading.cos(), 0.0);
            (v, Euler { roll: bank_of(t), pitch: 0.0, heading })
        });
        for (every, phase) in
            [1, 2, 5, 10].into_iter().flat_map(|rate| [0.0, 0.2, 0.4].map(|p| (50 / rate, p)))
        {
            let first = (phase * period_s * 50.0) as usize;
            let rows: Samples =
                flight.samples[first..].iter().step_by(every).take(10_000 / every).copied().collect();
            let path = coordinated(&without_velocities(&rows));
            let [start_s, _] = path.span_s();
            let roll = path.sample_at(start_s).unwrap().euler.roll;
            let error = (roll - bank_of(start_s)) / DEG;
            println!("{period_s} s, {} Hz, {phase}: {error:.2} deg, {:.2} s cut", 50 / every, path.cut_s);
            assert!(error.abs() < 2.0, "{period_s} s, {} Hz, {phase}: {error} deg", 50 / every);
            assert!(path.cut_s <= 3.0);
        }
    }
}
